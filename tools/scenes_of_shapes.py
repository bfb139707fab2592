"""Scenes with every shape: height fields, meshes, hulls, compounds, round bodies, belts."""

import math
import random

from scene_writer import (BLUE, DARK_STONE, GREEN, ORANGE, PURPLE, RED, SKY, STONE, VIVID, WALL, WHITE, WOOD,
                          YELLOW, Scene, any_turn, blend, multiply, rotate, short, turn)
from solids import Triangles, on_circle, polyhedra, revolved, scaled


def smooth(t):
    """A smooth transition from 0 to 1 for t from 0 to 1."""
    t = min(max(t, 0.0), 1.0)
    return t * t * (3 - 2 * t)


def marble_run():
    s = Scene("Marble run", "Two valleys lead into one, and that into a bowl. Drag a marble back to the top.",
              (4.6, 12.0, 11.0), (0, 0.9, -0.3), 43)
    rng = random.Random(15)
    bowl_z = 4.4

    def height(x, z):
        bend = 1.1 * math.sin(0.75 * (z + 1)) * smooth((bowl_z - z) / 3)
        apart = 1.9 * smooth((1.2 - z) / 5.5)
        side = min(abs(x - bend - apart), abs(x - bend + apart))
        up = bowl_z - z
        land = (0.24 * up if up > 0 else -0.3 * up) + 1.6 * side * side / (1.6 + side * side)
        r = math.hypot(x, z - bowl_z)
        rim = 0.9 * smooth((abs(x) - 3.2) / 1.3) + 1.2 * smooth((z - 5.4) / 1.4) + 0.8 * smooth((-6.2 - z) / 0.8)
        return min(land + rim, -0.75 + 0.3 * r * r) + 1.0

    s.ground(color="#5F7A84")
    material = s.material(0.5, 0.25, 2500)
    s.fixed(s.height_field(73, 113, 0.125, height), material, (0, 0, 0), None, "valley", "#9DAA78")
    ball, large = s.sphere(0.1), s.sphere(0.14)
    glass = s.material(0.1, 0.3, 2500, rolling=0.001)
    for i in range(140):
        row, column = divmod(i, 20)
        x = (column - 9.5) * 0.36 + rng.uniform(-0.05, 0.05)
        z = -5.9 + row * 0.36 + rng.uniform(-0.05, 0.05)
        s.body(large if i % 5 == 0 else ball, glass, (x, height(x, z) + 0.35, z), None, color=VIVID[rng.randrange(7)])
    return s


def bowl_of_hulls():
    s = Scene("Bowl of polyhedra", "Regular solids and rocks fall into a bowl that is a triangle mesh.",
              (4.3, 6.2, 7.4), (0, 1.2, 0), 40)
    rng = random.Random(16)
    s.ground(0.6, 0.1, "#77706A")
    # The profile goes up the outside, over the rim, and down the inside. The wall is thicker than the falling bodies.
    inside = [(2.7 * t, 0.45 + 1.75 * t**2.2) for t in (i / 12 for i in range(12, -1, -1))]
    outside = [(2.2, 0.0), (2.35, 0.15), (2.9, 0.6), (3.4, 1.4), (3.55, 2.15), (3.45, 2.25), (2.9, 2.25)]
    bowl = revolved([*outside, *inside], 56)
    s.fixed(s.mesh(*bowl), s.material(0.5, 0.1), (0, 0, 0), None, "bowl", "#C9B79C")
    sizes, colors = (0.42, 0.36, 0.37, 0.32, 0.32), (RED, SKY, YELLOW, BLUE, GREEN)
    kinds = [(s.hull(scaled(points, size)), color) for points, size, color in zip(polyhedra(), sizes, colors)]
    for _ in range(3):
        rock = [rotate(any_turn(rng), (rng.uniform(0.24, 0.36), 0, 0)) for _ in range(15)]
        kinds.append((s.hull(rock), blend(STONE, DARK_STONE, rng.random())))
    material = s.material(0.5, 0.1, 1200)
    for i in range(128):
        layer, cell = divmod(i, 16)
        row, column = divmod(cell, 4)
        place = ((column - 1.5) * 0.86 + rng.uniform(-0.01, 0.01), 2.9 + layer * 0.86, (row - 1.5) * 0.86)
        shape, color = kinds[rng.randrange(8)]
        s.body(shape, material, place, any_turn(rng), color=color)
    return s


def wedge(inner, outer, height, count):
    """The vertices of one of `count` stones of a ring about x."""
    half = math.pi / count
    c, n = math.cos(half), math.sin(half)
    return [(r * c, y, side * r * n) for r in (inner, outer) for y in (-height / 2, height / 2) for side in (-1, 1)]


def wrecking_ball():
    s = Scene("Wrecking ball", "Two towers of wedges and a wall of bricks. Press P to shoot at what still stands.",
              (4.6, 3.2, 8.4), (-0.3, 1.25, 0), 42)
    s.ground(0.7, 0.0, "#74806F")
    stone = s.material(0.7, 0.0, 1900)
    high, sectors, inner, outer = 0.3, 12, 0.62, 0.95
    piece = s.hull(wedge(inner, outer, high, sectors))
    for tower, x in (("left", -2.9), ("right", 2.9)):
        for level in range(11):
            for k in range(sectors):
                if level == 10 and k % 2:
                    continue  # battlements
                s.body(piece, stone, (x, high * (level + 0.5), 0), turn("y", 360 / sectors * (k + 0.5 * (level % 2))),
                       color=blend("#B5A48B", "#8C7B66", ((7 * level + 5 * k) % 9) / 8))
    brick, half, width = s.box(0.56, high, 0.3), s.box(0.28, high, 0.3), 0.57
    for level in range(8):
        shift = 0.5 * (level % 2)
        for k in range(6):
            s.body(brick, stone, ((k + shift - 2.75) * width, high * (level + 0.5), 0),
                   color=blend("#B4694B", "#8E4A36", ((5 * level + 3 * k) % 7) / 6))
        s.body(half, stone, ((-3.125 if shift else 3.125) * width + 0, high * (level + 0.5), 0), color="#A0583F")
    iron = s.material(0.6, 0.0, 4000, rolling=0.15)
    s.body(s.sphere(0.5), iron, (0.6, 1.2, 8.5), None, "wrecking ball", "#33373D", linearVelocity=[0, 2.9, -13])
    s.body(s.sphere(0.5), iron, (-10.4, 1.6, 17), None, "second ball", "#4A3A34", linearVelocity=[5.1, 6.9, -11.5])
    return s


# Heights and diameters of a pin, inches (USBC Equipment Specifications).
PIN = [(0, 2.031), (0.75, 2.828), (2.25, 3.906), (3.375, 4.510), (4.5, 4.766), (5.875, 4.563), (7.25, 3.703),
       (8.625, 2.472), (10, 1.797), (10.875, 1.870), (11.75, 2.094), (12.625, 2.406), (13.5, 2.547), (14.4, 2.0),
       (14.85, 1.1), (15, 0.5)]


def bowling():
    s = Scene("Bowling", "One ball is straight, one hooks, one finds the gutter. Delete sets the pins up again.",
              (0.25, 1.5, 4.4), (0, 0.1, -0.4), 46, time_step=1 / 120)
    inch = 0.0254

    def pin_part(first, last, color):
        points = [p for height, width in PIN[first:last] for p in on_circle(width / 2 * inch, height * inch, 14)]
        return (s.hull(points), (0, 0, 0), color)

    neck = s.cylinder(3.703 / 2 * inch, 1.375 * inch, 2.472 / 2 * inch)
    collar = s.cylinder(2.472 / 2 * inch, 1.375 * inch, 1.797 / 2 * inch)
    pin = [pin_part(0, 7, WHITE), (neck, (0, 7.9375 * inch, 0), WHITE), (collar, (0, 9.3125 * inch, 0), RED),
           pin_part(8, 16, WHITE)]
    wood, maple = s.material(0.3, 0.3, 700), s.material(0.12, 0.2)
    urethane = s.material(0.12, 0.2)
    width, gutter, pitch, front, back = 1.0668, 0.24, 1.75, 11.0, -1.15
    length, middle = front - back, (front + back) / 2
    lane = s.box(width, 0.2, length)
    rounds = [(gutter / 2 * math.cos(math.pi * (1 + i / 10)), 0.11 * math.sin(math.pi * (1 + i / 10)))
              for i in range(11)]
    trough = Triangles()
    for (x0, y0), (x1, y1) in zip(rounds, rounds[1:]):
        trough.polygon([(x0, y0, length / 2), (x1, y1, length / 2), (x1, y1, -length / 2), (x0, y0, -length / 2)])
    trough = s.mesh(trough.vertices, trough.triangles)
    divider = s.box(pitch - width - 2 * gutter, 0.24, length)
    for i in range(3):
        x = (i - 1) * pitch
        s.fixed(lane, maple, (x, -0.1, middle), None, f"lane {i + 1}", "#C9975B")
        for sign in (-1, 1):
            s.fixed(trough, maple, (x + sign * (width + gutter) / 2, 0, middle), None, "gutter", "#555B60")
        for row in range(4):
            for column in range(row + 1):
                s.compound(pin, wood, (x + (column - row / 2) * 0.3048, 0, -row * 0.26396), None,
                           f"pin {row * (row + 1) // 2 + column + 1}", mass=1.55)
    s.fixed(s.plane(), wood, (0, -0.7, 0), None, "floor", "#4B4540")
    for i in range(4):
        s.fixed(divider, maple, ((i - 1.5) * pitch, -0.08, middle), None, "divider", "#3F464C")
        s.fixed(s.box(0.06, 0.9, 2.6), wood, ((i - 1.5) * pitch, 0.35, back + 0.1), None, "side", "#2C3238")
    s.fixed(s.box(3 * pitch + 0.1, 1.5, 0.15), s.material(0.6, 0.05), (0, 0.2, back - 1.05), None, "cushion", "#39414A")
    ball, radius = s.sphere(0.1085), 0.1085
    for i, (name, color, offset, aim, roll, hook) in enumerate((
            ("hook ball", PURPLE, 0.2, 0.3, 0.5, 20), ("straight ball", BLUE, 0.03, 0, 1, 0),
            ("gutter ball", GREEN, 0.2, 0.55, 1, 0))):
        speed = 7.5
        s.body(ball, urethane, ((i - 1) * pitch + offset, radius, 9.5), None, name, color, mass=6.8,
               linearVelocity=[aim, 0, -speed], angularVelocity=[-roll * speed / radius, 0, hook])
    return s


def eulers_disk():
    s = Scene("Euler's disk", "The lower a coin lies, the faster it runs around, until it stops at once.",
              (0, 2.1, 3.5), (0, 0.0, 0.1), 38)
    s.ground(0.6, 0.0, "#4A5560")
    glass = s.material(0.9, 0.0, combine="minimum")
    s.fixed(s.cylinder(1.75, 0.1), glass, (0, 0.05, 0), None, "base", "#27313B")
    metal = s.material(0.9, 0.0, 7800, combine="minimum", rolling=0.005, torsional=0.005)

    def disk(radius, thickness, lean, x, z, heading, name, color):
        # Steady motion of a thin disk whose center is at rest: it rotates about the diameter through the contact point,
        # which moves around with W^2 = 4 g / (radius sin lean) (Moffatt 2000).
        sine = math.sin(math.radians(lean))
        spin = math.sqrt(4 * 9.81 / (radius * sine)) * sine
        rotation = multiply(turn("y", heading), turn("z", lean))
        place = (x, 0.1 + radius * sine + thickness / 2 * math.cos(math.radians(lean)), z)
        s.body(s.cylinder(radius, thickness), metal, place, rotation, name, color,
               angularVelocity=[short(spin, 4), 0, 0])

    disk(0.5, 0.06, 40, 0, 0, 20, "disk", "#AEB9C4")
    for i in range(10):
        angle = 2 * math.pi * (i + 0.5) / 10
        disk(0.16 + 0.01 * (i % 3), 0.025, 25 + 5 * i, 1.25 * math.cos(angle), 1.25 * math.sin(angle), 36 * i,
             f"coin {i + 1}", (ORANGE, "#C87B4A", "#C9CDD2")[i % 3])
    return s


def tippe_tops():
    s = Scene("Tippe tops", "A top with a low center of mass that spins fast turns over, and rises on its stem.",
              (0.3, 1.7, 3.5), (0.3, 0.05, -0.15), 40, sleep=False)
    s.ground(0.5, 0.0, "#5D6B66")
    radius, mass = 0.16, 1.0
    ball, stem, knob = s.sphere(radius), s.cylinder(0.035, 0.1, 0.026), s.sphere(0.028)
    material = s.material(0.5, 0.0, rolling=0.0003)
    inertia = 0.4 * mass * radius * radius
    for i in range(12):
        row, column = divmod(i, 4)
        spin = (15, 50, 90, 130)[column]
        low = (0.0, 0.12, 0.25)[row]
        color = blend(YELLOW, RED, column / 3)
        tilt = turn("z", 6)
        up = rotate(tilt, (0, -low * radius, 0))
        s.compound([(ball, (0, 0, 0), color), (stem, (0, radius, 0), WOOD), (knob, (0, radius + 0.05, 0), WOOD)],
                   material, ((column - 1.5) * 0.85, radius, (row - 1) * 0.85), tilt,
                   f"top, {spin} rad/s, center {low} radii low", mass=mass,
                   centerOfMass=[0, short(-low * radius, 5), 0], inertiaDiagonal=[short(inertia, 6)] * 3,
                   angularVelocity=[0, spin, 0])
    return s


def gear_tooth(module, teeth, thickness, play):
    """The vertices of a tooth that points along x, of a gear about y: an involute with a pressure angle of 20 degrees,
    which is convex, so that its hull is exact. It ends 0.8 modules above the pitch circle."""
    pitch = module * teeth / 2
    base = pitch * math.cos(math.radians(20))

    def involute(r):
        ratio = base / r
        return math.sqrt(1 - ratio * ratio) / ratio - math.acos(ratio)

    at_pitch = math.pi / (2 * teeth) + involute(pitch) - play / pitch
    tip, root = pitch + 0.8 * module, pitch - 1.2 * module
    radii = [base + (tip - base) * (i / 5) ** 1.5 for i in range(6)]
    angles = [(r, at_pitch - involute(max(r, base))) for r in radii]
    if root < base:
        angles.append((root, at_pitch))
    return [(r * math.cos(a), y, side * r * math.sin(a)) for r, a in angles
            for y in (-thickness / 2, thickness / 2) for side in (-1, 1)]


def gears():
    s = Scene("Gears", "One gear is driven; the others lie in round bearings. Try to hold one with the mouse.",
              (2.2, 8.2, 8.0), (2.0, 0.2, -0.3), 42, sleep=False)
    s.ground(0.6, 0.0, "#66706C")
    module, thick, base = 0.14, 0.3, 0.3
    smooth_metal = s.material(0.0, 0.0, 800, combine="multiply")
    tube = s.mesh(*revolved([(0.5, 0), (0.5, base), (0.26, base), (0.26, 0)], 24))
    shaft = s.cylinder(0.25, base - 0.05)
    # Number of teeth, index of the mating gear, direction from that gear in degrees, color
    train = [(12, None, 0, RED), (24, 0, 200, SKY), (18, 0, 25, YELLOW), (12, 2, -50, GREEN), (30, 3, 0, PURPLE),
             (12, 1, 75, ORANGE), (16, 2, 95, BLUE)]
    placed = []
    for i, (teeth, mate, direction, color) in enumerate(train):
        x = z = phase = 0.0
        if mate is not None:
            mx, mz, mate_phase, mate_teeth = placed[mate]
            a = math.radians(direction)
            distance = module * (teeth + mate_teeth) / 2
            x, z = mx + distance * math.cos(a), mz - distance * math.sin(a)
            # Each tooth faces a gap of the mating gear.
            along = (direction - mate_phase) * mate_teeth / 360
            phase = direction + 180 - (0.5 - along) * 360 / teeth
        placed.append((x, z, phase, teeth))
        root = module * teeth / 2 - 1.1 * module
        tooth = s.hull(gear_tooth(module, teeth, thick, 0.004))
        parts = [(s.cylinder(root, thick), (0, 0, 0), color)]
        parts += [(tooth, (0, 0, 0), blend(color, "#FFFFFF", 0.25), turn("y", 360 / teeth * k)) for k in range(teeth)]
        rotation, place = turn("y", phase % 360), (x, base + thick / 2 + 0.001, z)
        if mate is None:
            s.compound(parts, smooth_metal, place, rotation, "driver", isKinematic=True, angularVelocity=[0, 1.2, 0])
            continue
        parts.append((shaft, (0, -thick / 2 - (base - 0.05) / 2, 0), DARK_STONE))
        s.compound(parts, smooth_metal, place, rotation, f"gear of {teeth}")
        s.fixed(tube, smooth_metal, (x, 0, z), None, "bearing", DARK_STONE)
    riders(s, placed[4][:2], base + thick)
    return s


def riders(s, middle, floor):
    """Small figures on a rotating round table."""
    wood = s.material(0.6, 0.0, 500)
    cone, block = s.cylinder(0.13, 0.4, 0.0), s.box(0.24, 0.24, 0.24)
    for k in range(16):
        a = 2 * math.pi * k / 16
        height = 0.2 if k % 2 else 0.12
        s.body(cone if k % 2 else block, wood, (middle[0] + 1.35 * math.cos(a), floor + height + 0.002,
                                               middle[1] + 1.35 * math.sin(a)), turn("y", -math.degrees(a)),
               color=VIVID[k % 7])


def staircase():
    s = Scene("Staircase", "A room that is one mesh: stairs, a ramp and a door. Who takes which way down?",
              (5.6, 6.8, 9.2), (-0.2, 0.9, 0.1), 42)
    rng = random.Random(22)
    s.ground(0.6, 0.1, "#6F7B73")
    room = Triangles()
    floor, high, steps = 0.1, 2.5, 8
    room.extruded([(-5, floor), (6, floor), (6, 0)], 3.2, -3.2)
    stairs = [(-5, high), (-3, high)]
    for k in range(steps):
        y, x = high - (high - floor) * (k + 1) / steps, -3 + 0.36 * k
        stairs += [(x, y), (x + 0.36, y)]
    room.extruded(stairs[:-1], 0.0, -3.0)
    room.extruded([(-5, high), (-3, high), (1.6, floor)], 3.0, 0.0)
    room.box((-5.2, 0, -3.2), (-5, 3.6, 3.2))
    room.box((-5, 0, -3.2), (5.2, 3.6, -3))
    room.extruded([(-5, high + 0.9), (-3, high + 0.9), (1.2, 0.9), (5.2, 0.9)], 3.2, 3.0)
    room.box((5, 0, -3), (5.2, 3.6, -1))
    room.box((5, 0, 1), (5.2, 3.6, 3))
    room.box((5, 2.4, -1), (5.2, 3.6, 1))
    s.fixed(s.mesh(room.vertices, room.triangles), s.material(0.45, 0.2), (0, 0, 0), None, "room", "#B9B2A6")
    kinds = [s.sphere(0.2), s.box(0.36, 0.36, 0.36), s.capsule(0.14, 0.3), s.cylinder(0.2, 0.3),
             s.hull(scaled(polyhedra()[3], 0.24)), s.cylinder(0.22, 0.36, 0.0), s.capsule(0.2, 0.2, 0.12)]
    material = s.material(0.45, 0.3, 600, rolling=0.03)
    for i in range(120):
        layer, cell = divmod(i, 30)
        row, column = divmod(cell, 3)
        place = (-4.6 + column * 0.62, high + 0.4 + layer * 0.6, (row - 4.5) * 0.6 + rng.uniform(-0.03, 0.03))
        # In the axes of the body, which is rotated.
        rotation = any_turn(rng)
        push = rotate((-rotation[0], -rotation[1], -rotation[2], rotation[3]), (2.4 + 0.3 * column, 0, 0))
        s.body(kinds[i % 7], material, place, rotation, color=VIVID[(i + i // 7) % 7],
               linearVelocity=[short(v, 4) for v in push])
    return s


def conveyor_loop():
    s = Scene("Conveyor loop",
              "Four belts carry goods around and around; the gate is a trigger. Drop more with J K L M.",
              (4.4, 5.0, 7.0), (-0.1, 0.4, 0.2), 40)
    rng = random.Random(23)
    s.ground(0.6, 0.0, "#6C7480")
    half_x, half_z, width, top, speed = 3.8, 2.6, 1.4, 0.7, 1.4
    guide = s.material(0.0, 0.0, combine="multiply")
    # Each belt begins at a corner and ends beside the next one: center x and z, size x and z, direction.
    belts = [
        ("front", -width / 2, half_z - width / 2, 2 * half_x - width, width, (1, 0)),
        ("right", half_x - width / 2, width / 2, width, 2 * half_z - width, (0, -1)),
        ("back", width / 2, -half_z + width / 2, 2 * half_x - width, width, (-1, 0)),
        ("left", -half_x + width / 2, -width / 2, width, 2 * half_z - width, (0, 1)),
    ]
    for name, x, z, size_x, size_z, (dx, dz) in belts:
        belt = s.material(0.7, 0.0, belt=(speed * dx, 0, speed * dz))
        s.fixed(s.box(size_x, 0.3, size_z), belt, (x, top - 0.15, z), None, f"{name} belt", "#3B4046")
    for sign in (-1, 1):
        rail, rim = s.box(2 * half_x + 0.2, 0.5, 0.1), s.box(0.1, 0.5, 2 * half_z)
        s.fixed(rail, guide, (0, top + 0.05, sign * (half_z + 0.05)), None, "guide", YELLOW)
        s.fixed(rim, guide, (sign * (half_x + 0.05), top + 0.05, 0), None, "guide", YELLOW)
    inner_x, inner_z = 2 * (half_x - width), 2 * (half_z - width)
    s.fixed(s.box(inner_x, 1.2, inner_z), guide, (0, top, 0), None, "island", WALL)
    s.trigger(s.box(0.3, 0.9, width), (0, top + 0.45, -half_z + width / 2), None, "gate", GREEN)
    kinds = [s.box(0.42, 0.36, 0.42), s.capsule(0.15, 0.3), s.cylinder(0.2, 0.36), s.box(0.3, 0.3, 0.3),
             s.cylinder(0.18, 0.3, 0.12)]
    goods = s.material(0.5, 0.0, 400, rolling=0.01)
    colors = ["#C49A6C", SKY, ORANGE, "#A67C52", GREEN]
    for number, (_, x, z, size_x, size_z, (dx, dz)) in enumerate(belts):
        count = int(max(size_x, size_z) / 0.65)
        for k in range(count + count // 2):
            layer, i = (0, k) if k < count else (1, 2 * (k - count))
            along, across = (i - (count - 1) / 2) * 0.65, rng.uniform(-0.2, 0.2)
            place = (x + abs(dx) * along + abs(dz) * across, top + 0.32 + 0.5 * layer,
                     z + abs(dz) * along + abs(dx) * across)
            kind = (i + 2 * layer + number) % 5
            rotation = turn("y", rng.uniform(-15, 15))
            if kind == 1:
                rotation = multiply(rotation, turn("z", 90))
            s.body(kinds[kind], goods, place, rotation, color=colors[kind])
    return s


def rolling_race():
    s = Scene("Rolling race", "Not size nor mass but shape decides who wins. Press Delete to watch again.",
              (6.4, 5.9, 13.6), (-0.7, 0.3, 1.7), 40)
    s.ground(0.6, 0.0, "#6F7B73")
    angle, length, lanes = 14, 11, 6
    tilt = turn("x", angle)
    # The ramp leaves the combine rule to the racers: "multiply" has the lowest priority.
    track = s.material(0.6, 0.0, 400, combine="multiply")
    foot = 3.6
    middle = rotate(tilt, (0, -0.15, -length / 2))
    s.fixed(s.box(lanes * 1.2 + 0.2, 0.3, length), track, (0, middle[1], foot + middle[2]), tilt, "ramp", "#A8B2B8")

    def on_ramp(x, up, height):
        place = rotate(tilt, (0, height, -up))
        return (x, place[1], foot + place[2])

    for i in range(lanes + 1):
        place = on_ramp((i - lanes / 2) * 1.2, length / 2, 0.015)
        s.fixed(s.box(0.05, 0.03, length), track, place, tilt, "line", WHITE)
    ice = s.material(0.0, 0.0, 400, combine="minimum")
    lying = turn("z", 90)
    for row, size in enumerate((0.8, 1.0, 1.25)):
        r, up = 0.24 * size, length - 0.5 - 1.2 * row

        def racer(lane, shape, color, name, material, rotation=None, rise=r, **motion):
            s.body(shape, material, on_ramp((lane - 2.5) * 1.2, up, rise),
                   tilt if rotation is None else multiply(tilt, rotation), f"{name} {row + 1}", color, **motion)

        box = s.box(2 * r, 2 * r, 2 * r)
        racer(0, box, BLUE, "box on ice", ice)
        racer(1, s.sphere(r), RED, "ball", track)
        racer(2, s.capsule(r, 2.0 * r), ORANGE, "capsule", track, lying)
        racer(3, s.cylinder(r, 3 * r), YELLOW, "cylinder", track, lying)
        mass = 3 * math.pi * 400 * r**3
        racer(4, s.cylinder(r, 3 * r), PURPLE, "tube", track, lying, mass=short(mass, 4),
              inertiaDiagonal=[short(mass * r * r * 1.25, 6), short(mass * r * r, 6), short(mass * r * r * 1.25, 6)])
        racer(5, box, DARK_STONE, "box", track)
    light = s.material(0.5, 0.1, 500)
    cube = s.box(0.26, 0.26, 0.26)
    for lane in range(lanes):
        for level in range(4):
            for k in range(3 if level % 2 == 0 else 2):
                x = (lane - 2.5) * 1.2 + (k - (1 if level % 2 == 0 else 0.5)) * 0.29
                s.body(cube, light, (x, 0.13 + 0.26 * level, foot + 2.2), color=blend(GREEN, WHITE, level / 5))
    return s
