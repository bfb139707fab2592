"""Colors, rotations, and a class that collects bodies and writes them as a scene file (docs/scene_format.md)."""

import base64
import json
import math
import struct

# Colors that can be distinguished with any kind of color vision (Okabe and Ito, 2008), and a few muted ones.
ORANGE, SKY, GREEN, YELLOW = "#E69F00", "#56B4E9", "#009E73", "#F0E442"
BLUE, RED, PURPLE = "#0072B2", "#D55E00", "#CC79A7"
STONE, DARK_STONE, WALL, WOOD, WHITE, BLACK = "#A9A59C", "#7D7A74", "#8FA3AD", "#B98A5A", "#F2EFE8", "#22262B"
VIVID = [ORANGE, SKY, GREEN, YELLOW, BLUE, RED, PURPLE]


def linear(color):
    """'#RRGGBB' to linear red, green and blue (IEC 61966-2-1)."""
    values = [int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    return [round(v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4, 3) for v in values]


def blend(first, second, t):
    """The color a fraction t of the way from one to another."""
    parts = [(int(first[i : i + 2], 16), int(second[i : i + 2], 16)) for i in (1, 3, 5)]
    return "#" + "".join(f"{round(a + (b - a) * t):02X}" for a, b in parts)


def turn(axis, degrees):
    """The quaternion (x, y, z, w) of a rotation about a unit axis or one of "x", "y", "z"."""
    axis = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}.get(axis, axis)
    half = math.radians(degrees) / 2
    return tuple(math.sin(half) * a for a in axis) + (math.cos(half),)


def multiply(p, q):
    """The product of two quaternions: first the rotation q, then p."""
    px, py, pz, pw = p
    qx, qy, qz, qw = q
    return (
        pw * qx + px * qw + py * qz - pz * qy,
        pw * qy - px * qz + py * qw + pz * qx,
        pw * qz + px * qy - py * qx + pz * qw,
        pw * qw - px * qx - py * qy - pz * qz,
    )


def rotate(q, v):
    """The vector v rotated by q."""
    x, y, z, w = multiply(multiply(q, (*v, 0.0)), (-q[0], -q[1], -q[2], q[3]))
    return (x, y, z)


def between(first, second):
    """The least rotation from one unit vector to another."""
    cross = [first[1] * second[2] - first[2] * second[1], first[2] * second[0] - first[0] * second[2],
             first[0] * second[1] - first[1] * second[0]]
    w = 1 + sum(a * b for a, b in zip(first, second))
    if w < 1e-9:  # half a turn about any perpendicular axis
        cross, w = ([0, first[2], -first[1]] if abs(first[0]) < 0.9 else [-first[2], 0, first[0]]), 0
    length = math.sqrt(sum(c * c for c in cross) + w * w)
    return tuple(c / length for c in cross) + (w / length,)


def any_turn(rng):
    """A random rotation."""
    z, angle = rng.uniform(-1, 1), rng.uniform(0, 2 * math.pi)
    r = math.sqrt(1 - z * z)
    return turn((r * math.cos(angle), r * math.sin(angle), z), rng.uniform(0, 180))


def short(value, digits):
    """Rounds a value, and writes it as an integer if it is one."""
    value = round(value, digits)
    return int(value) if value == int(value) else value


def dump(value):
    return json.dumps(value, separators=(",", ":"))


class Scene:
    """Collects bodies and writes them as one glTF file with one node per line."""

    def __init__(self, title, hint, camera, target, fov=40, **settings):
        self.world = {"title": title, "hint": hint}
        self.world.update(settings)
        self.world["camera"] = {"position": list(camera), "target": list(target), "vertical_fov_degrees": fov}
        self.nodes, self.roots, self.shapes, self.materials = [], [], [], []
        self.joints, self.filters, self.filter = [], [], None
        self.meshes, self.accessors, self.views, self.data = [], [], [], b""
        self.used = ["KHR_physics_rigid_bodies", "KHR_implicit_shapes", "CAIRN_world"]

    @staticmethod
    def _index(table, entry):
        if entry not in table:
            table.append(entry)
        return table.index(entry)

    def _use(self, extension):
        if extension not in self.used:
            self.used.append(extension)

    # Shapes. Each function returns the `shape` argument of the functions for bodies below.

    def sphere(self, radius):
        return self._index(self.shapes, {"type": "sphere", "sphere": {"radius": short(radius, 6)}})

    def box(self, x, y, z):
        return self._index(self.shapes, {"type": "box", "box": {"size": [short(s, 6) for s in (x, y, z)]}})

    def plane(self, x=None, z=None):
        size = {} if x is None else {"sizeX": x, "sizeZ": z}
        return self._index(self.shapes, {"type": "plane", "plane": size})

    def _round(self, kind, radius, height, top):
        size = {"height": short(height, 6), "radiusBottom": short(radius, 6),
                "radiusTop": short(radius if top is None else top, 6)}
        return self._index(self.shapes, {"type": kind, kind: size})

    def capsule(self, radius, height, top=None):
        """height: distance of the centers of its two balls. top: the radius of the upper ball, if it differs."""
        return self._round("capsule", radius, height, top)

    def cylinder(self, radius, height, top=None):
        """top: the radius of the upper end, if it differs; 0 for a cone."""
        return self._round("cylinder", radius, height, top)

    def height_field(self, columns, rows, spacing, height):
        """height(x, z), m, over a grid about the origin."""
        self._use("CAIRN_height_field")
        values = [height((c - (columns - 1) / 2) * spacing, (r - (rows - 1) / 2) * spacing)
                  for r in range(rows) for c in range(columns)]
        heights = self._accessor("f", 5126, [[round(v, 4)] for v in values], "SCALAR")
        own = {"columns": columns, "rows": rows, "spacing": [spacing, spacing], "heights": heights}
        return self._index(self.shapes, {"type": "CAIRN_height_field", "extensions": {"CAIRN_height_field": own}})

    def mesh(self, vertices, triangles):
        """A triangle surface, counterclockwise as seen from outside; for static and kinematic bodies."""
        return {"node": self._mesh_node(vertices, triangles)}

    def hull(self, vertices):
        """The convex hull of points."""
        # The file stores triangles, of which a hull only needs the vertices: all of them, in groups of three.
        count = len(vertices)
        triangles = [(i, (i + 1) % count, (i + 2) % count) for i in range(0, count, 3)]
        return {"node": self._mesh_node(vertices, triangles), "convexHull": True}

    def _mesh_node(self, vertices, triangles):
        vertices = [tuple(round(c, 5) for c in v) for v in vertices]
        corners = self._accessor("f", 5126, vertices, "VEC3")
        flat = [[i] for t in triangles for i in t]
        indices = self._accessor("H", 5123, flat, "SCALAR")
        self.meshes.append({"primitives": [{"attributes": {"POSITION": corners}, "indices": indices}]})
        self.nodes.append({"mesh": len(self.meshes) - 1})
        return len(self.nodes) - 1

    def _accessor(self, code, component, rows, kind):
        data = b"".join(struct.pack("<" + code * len(row), *row) for row in rows)
        self.data += b"\0" * (-len(self.data) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)})
        self.data += data
        entry = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(rows), "type": kind}
        if kind == "VEC3":
            # glTF requires the bounds of the values rounded to float.
            floats = [struct.unpack("<3f", struct.pack("<3f", *row)) for row in rows]
            entry["min"] = [min(column) for column in zip(*floats)]
            entry["max"] = [max(column) for column in zip(*floats)]
        self.accessors.append(entry)
        return len(self.accessors) - 1

    def material(self, friction=0.6, restitution=0.0, density=1000, combine=None, rolling=0.0, torsional=None,
                 belt=None):
        """combine: the rule for both friction and restitution; None for the average. belt: the surface velocity, in the
        axes of the collider."""
        entry = {"staticFriction": friction, "dynamicFriction": friction, "restitution": restitution}
        if combine:
            entry.update({"frictionCombine": combine, "restitutionCombine": combine})
        own = {}
        if density != 1000:
            own["density"] = density
        if rolling:
            own["rolling_friction"] = rolling
        if torsional is not None:
            own["torsional_friction"] = torsional
        if belt:
            own["surface_velocity"] = list(belt)
        if own:
            entry["extensions"] = {"CAIRN_material": own}
            self._use("CAIRN_material")
        return self._index(self.materials, entry)

    def meet(self, system, never=None):
        """Bodies created from now on are in a collision system, and do not collide with bodies in the system `never`.
        Without a system, they collide with all bodies."""
        entry = {"collisionSystems": [system], "notCollideWithSystems": [never]} if never else {
            "collisionSystems": [system]}
        self.filter = None if system is None else self._index(self.filters, entry)

    # Bodies.

    def _node(self, shape, material, position, rotation, name, color, motion, trigger=False):
        node = {}
        if name:
            node["name"] = name
        if any(position):
            node["translation"] = [short(p, 5) for p in position]
        if rotation is not None:
            node["rotation"] = [short(q, 7) for q in rotation]
        physics = {}
        if motion is not None:
            physics["motion"] = motion
        if shape is not None:
            geometry = dict(shape) if isinstance(shape, dict) else {"shape": shape}
            collider = {"geometry": geometry}
            if not trigger:
                collider["physicsMaterial"] = material
            if self.filter is not None:
                collider["collisionFilter"] = self.filter
            physics["trigger" if trigger else "collider"] = collider
        node["extensions"] = {"KHR_physics_rigid_bodies": physics}
        if color:
            node["extras"] = {"cairn_color": linear(color)}
        self.nodes.append(node)
        return len(self.nodes) - 1

    def fixed(self, shape, material, position, rotation=None, name=None, color=None):
        self.roots.append(self._node(shape, material, position, rotation, name, color, None))
        return self.roots[-1]

    def trigger(self, shape, position, rotation=None, name=None, color=None):
        self.roots.append(self._node(shape, None, position, rotation, name, color, None, True))

    def body(self, shape, material, position, rotation=None, name=None, color=None, **motion):
        """motion: members of the node's motion, for example mass or linearVelocity (in the node's axes)."""
        self.roots.append(self._node(shape, material, position, rotation, name, color, motion))
        return self.roots[-1]

    def character(self, shape, material, position, name=None, color=None, **members):
        """members: those of its CharacterDef that differ from the defaults."""
        index = self.body(shape, material, position, None, name, color, isKinematic=True)
        self._use("CAIRN_body")
        self.nodes[index]["extensions"]["CAIRN_body"] = {"character": members}
        return index

    def compound(self, parts, material, position, rotation=None, name=None, **motion):
        """parts: (shape, position, color) in the body's frame, and a rotation if the part has one."""
        index = self._node(None, None, position, rotation, name, None, motion)
        self.roots.append(index)
        self.nodes[index]["children"] = [
            self._node(shape, material, place, *(spin or [None]), None, color, None)
            for shape, place, color, *spin in parts
        ]
        return index

    def ground(self, friction=0.6, restitution=0.0, color="#6F7B73"):
        self.fixed(self.plane(), self.material(friction, restitution), (0, 0, 0), name="ground", color=color)

    def walls(self, inner_x, inner_z, height, thickness, material, color=WALL):
        """Four walls on the ground around a rectangle centered at the origin."""
        x, z, y = (inner_x + thickness) / 2, (inner_z + thickness) / 2, height / 2
        along_z = self.box(thickness, height, inner_z + 2 * thickness)
        along_x = self.box(inner_x, height, thickness)
        for side, sign in (("left", -1), ("right", 1)):
            self.fixed(along_z, material, (sign * x, y, 0), name=f"{side} wall", color=color)
        for side, sign in (("back", -1), ("front", 1)):
            self.fixed(along_x, material, (0, y, sign * z), name=f"{side} wall", color=color)

    # Joints.

    def joint(self, a, b, joint, place, axis="x", place_b=None, name=None, collide=False, color=None):
        """joint: what the module `joints` makes. a, b: what the bodies above return; None for the world. axis: the x
        axis of both frames, or a rotation of them. place, place_b: of their origins in the world, the same if there is
        one alone. color: it is drawn as a string of it."""
        self._use("CAIRN_joint")
        rotation = {"x": (0, 0, 0, 1)}.get(axis, axis)
        if len(rotation) < 4:
            axis = {"y": (0, 1, 0), "z": (0, 0, 1)}.get(axis, axis)
            rotation = between((1, 0, 0), axis)
        first = self._frame(a, place, rotation)
        second = self._frame(b, place if place_b is None else place_b, rotation)
        entry = {"connectedNode": second, "joint": self._index(self.joints, joint)}
        if collide:
            entry["enableCollision"] = True
        if name:
            self.nodes[first]["name"] = name
        if color:
            self.nodes[first]["extras"] = {"cairn_color": linear(color)}
        self.nodes[first]["extensions"] = {"KHR_physics_rigid_bodies": {"joint": entry}}

    def _frame(self, body, place, rotation):
        """A node at that place in the world, below that body."""
        siblings = self.roots
        if body is not None:
            above = self.nodes[body]
            siblings = above.setdefault("children", [])
            x, y, z, w = above.get("rotation", (0, 0, 0, 1))
            back = (-x, -y, -z, w)
            place = rotate(back, [p - q for p, q in zip(place, above.get("translation", (0, 0, 0)))])
            rotation = multiply(back, rotation)
        node = {}
        place, rotation = [short(p, 6) for p in place], [short(q, 8) for q in rotation]
        if any(place):
            node["translation"] = place
        if any(rotation[:3]):
            node["rotation"] = rotation
        self.nodes.append(node)
        siblings.append(len(self.nodes) - 1)
        return len(self.nodes) - 1

    def write(self, path):
        def lines(entries):
            return "[\n" + ",\n".join(dump(e) for e in entries) + "\n]"

        own = {"nodes": self.roots, "extensions": {"CAIRN_world": self.world}}
        data = ""
        if self.data:
            uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode("ascii")
            data = "".join(f'"{key}": {lines(entries)},\n' for key, entries in (
                ("meshes", self.meshes), ("accessors", self.accessors), ("bufferViews", self.views),
                ("buffers", [{"byteLength": len(self.data), "uri": uri}])) if entries)
        physics = f'"physicsMaterials": {lines(self.materials)}'
        for key, entries in (("collisionFilters", self.filters), ("physicsJoints", self.joints)):
            if entries:
                physics += f',\n"{key}": {lines(entries)}'
        path.write_text(
            '{\n"asset": {"version":"2.0","generator":"tools/make_scenes.py"},\n'
            f'"extensionsUsed": {dump(self.used)},\n"scene": 0,\n"scenes": {lines([own])},\n'
            f'"nodes": {lines(self.nodes)},\n{data}"extensions": {{\n'
            f'"KHR_implicit_shapes": {{"shapes": {lines(self.shapes)}}},\n'
            f'"KHR_physics_rigid_bodies": {{{physics}}}\n}}\n}}\n',
            encoding="utf-8",
        )
