"""Scenes of joints: ragdolls, a bridge, a chain, cars. The machines are in scenes_of_machines.py."""

import math
import random

import joints
from scene_writer import (BLUE, DARK_STONE, RED, STONE, VIVID, WOOD, YELLOW, Scene, between, blend, multiply, rotate,
                          short, turn)


def along(first, second):
    """The midpoint of two points, the rotation of y to the direction between them, and their distance."""
    way = [b - a for a, b in zip(first, second)]
    length = math.sqrt(sum(w * w for w in way))
    return [(a + b) / 2 for a, b in zip(first, second)], between((0, 1, 0), [w / length for w in way]), length


# --- ragdolls

# The two ends of each body part in meters, standing with the arms half raised: first the end at the joint.
LIMBS = {
    "upper arm": ((0.21, 1.42, 0), (0.43, 1.22, 0), 0.055),
    "lower arm": ((0.43, 1.22, 0), (0.63, 1.02, 0), 0.048),
    "upper leg": ((0.11, 0.9, 0), (0.16, 0.5, 0), 0.075),
    "lower leg": ((0.16, 0.5, 0), (0.19, 0.06, 0), 0.06),
}


def ragdoll(s, material, place, rotation, colors, velocity, number):
    """A figure of 11 bodies; place: that of its waist, 1.05 m above its feet."""
    shirt, trousers, skin = colors

    def at(point):
        return [p + q for p, q in zip(place, rotate(rotation, (point[0], point[1] - 1.05, point[2])))]

    def made(shape, position, spin, name, color):
        whole = multiply(rotation, spin)
        push = rotate((-whole[0], -whole[1], -whole[2], whole[3]), velocity)
        return s.body(shape, material, at(position), whole, f"{name} {number}", color,
                      linearVelocity=[short(v, 4) for v in push])

    lying = turn("z", 90)
    pelvis = made(s.capsule(0.12, 0.14), (0, 0.95, 0), lying, "pelvis", trousers)
    chest = made(s.capsule(0.14, 0.2, 0.15), (0, 1.26, 0), (0, 0, 0, 1), "chest", shirt)
    head = made(s.sphere(0.13), (0, 1.67, 0), (0, 0, 0, 1), "head", skin)

    def joined(a, b, joint, point, axis, name):
        s.joint(a, b, joint, at(point), rotate(rotation, axis), name=f"{name} {number}")

    joined(pelvis, chest, joints.ball(30, 25, 3), (0, 1.06, 0), (0, 1, 0), "waist")
    joined(chest, head, joints.ball(35, 50, 1), (0, 1.53, 0), (0, 1, 0), "neck")
    for side in (1, -1):
        parts = {}
        for name, (top, bottom, radius) in LIMBS.items():
            top, bottom = ((side * p[0], p[1], p[2]) for p in (top, bottom))
            middle, spin, length = along(top, bottom)
            color = {"upper arm": shirt, "upper leg": trousers, "lower leg": trousers}.get(name, skin)
            parts[name] = made(s.capsule(radius, length - 1.3 * radius), middle, spin, name, color)
            way = [(q - p) / length for p, q in zip(top, bottom)]
            if name == "upper arm":
                joined(chest, parts[name], joints.ball(80, 45, 1), top, way, "shoulder")
            elif name == "upper leg":
                joined(pelvis, parts[name], joints.ball(60, 20, 2), top, way, "hip")
            elif name == "lower arm":
                bend = joints.control(-2.3, 0, friction=0.6)
                joined(parts["upper arm"], parts[name], joints.hinge(bend), top, (1, 0, 0), "elbow")
            else:
                bend = joints.control(0, 2.3, friction=1)
                joined(parts["upper leg"], parts[name], joints.hinge(bend), top, (1, 0, 0), "knee")


def ragdolls():
    s = Scene("Ragdolls", "Twenty figures of eleven bodies tumble down the steps. Pull one up by its hand.",
              (6.0, 5.9, 9.4), (-0.8, 1.4, 0.2), 43)
    rng = random.Random(25)
    s.ground(0.7, 0.0, "#66727A")
    stone = s.material(0.5, 0.0)
    steps, rise, tread, width = 6, 0.4, 0.75, 5.0
    for k in range(steps):
        high, x = rise * (steps - k), -3.2 + tread * k
        long = tread if k else 3.4
        s.fixed(s.box(long, high, width), stone, (x + (0 if k else (tread - long) / 2), high / 2, 0), None, "step",
                blend("#B9B2A6", "#8E959B", k / (steps - 1)))
    cloth = s.material(0.5, 0.0, 950)
    for i in range(20):
        layer, cell = divmod(i, 8)
        tilt = multiply(turn("y", rng.uniform(0, 360)), turn("x", rng.uniform(-35, 35)))
        row, column = divmod(cell, 4)
        place = (-3.5 - 1.4 * row, rise * steps + 1.15 + 1.9 * layer, (column - 1.5) * 1.25)
        skin = blend("#F0C9A0", "#7A4E32", rng.random())
        shirt = VIVID[i % 7]
        ragdoll(s, cloth, place, tilt, (shirt, blend(shirt, "#1D2733", 0.7), skin), (2.6, 0, 0), i + 1)
    return s


# --- what hangs

def bridge():
    s = Scene("Suspension bridge", "The planks hang from two chains; a ball of 1.4 tons rolls across.",
              (2.2, 6.6, 18.5), (0.4, 3.2, 0), 41)
    s.ground(0.7, 0.0, "#4E7391")
    stone, steel, wood = s.material(0.7, 0.0, 2400), s.material(0.5, 0.0, 7800), s.material(0.7, 0.0, 700)
    planks, step, deck, wide = 24, 0.6, 2.6, 2.8
    half, side, top = planks * step / 2, 1.45, 6.0
    for sign in (-1, 1):
        long = 6 if sign < 0 else 1.2
        s.fixed(s.box(long, deck, 6), stone, (sign * (half + 0.03 + long / 2), deck / 2, 0), None, "bank", "#86906F")
        for z in (-side - 0.35, side + 0.35):
            s.fixed(s.box(0.5, top + 0.3, 0.4), stone, (sign * (half + 0.3), (top + 0.3) / 2, z), None, "tower", STONE)
        s.fixed(s.box(0.5, 0.35, 2 * side + 1.1), stone, (sign * (half + 0.3), top + 0.4, 0), None, "tower", STONE)

    def cable_height(x):
        return deck + 0.45 + (top - deck - 0.45) * (x / half) ** 2

    bodies = []
    kerb = s.box(step - 0.04, 0.16, 0.12)
    for i in range(planks):
        x = -half + (i + 0.5) * step
        color = blend(WOOD, "#8A6239", (i * 5 % 7) / 6)
        bodies.append(s.compound([(s.box(step - 0.02, 0.14, wide), (0, 0, 0), color)]
                                 + [(kerb, (0, 0.13, z * (wide / 2 - 0.06)), "#7A5A38") for z in (-1, 1)],
                                 wood, (x, deck - 0.07, 0), None, f"plank {i + 1}"))
    for i, (a, b) in enumerate(zip([None, *bodies], [*bodies, None])):
        s.joint(a, b, joints.hinge(), (-half + i * step, deck - 0.07, 0), "z", name=f"seam {i}")
    s.meet("cables", never="cables")
    for sign in (-1, 1):
        z, links = sign * side, []
        nodes = [(-half + i * step, cable_height(-half + i * step), z) for i in range(planks + 1)]
        for first, second in zip(nodes, nodes[1:]):
            middle, spin, length = along(first, second)
            links.append(s.body(s.capsule(0.06, length), steel, middle, spin, "cable", "#5A4A4A"))
        for i, (a, b) in enumerate(zip([None, *links], [*links, None])):
            s.joint(a, b, joints.ball(), nodes[i])
        for i in range(1, planks):
            low, high = (nodes[i][0], deck - 0.07, z), nodes[i]
            middle, spin, length = along(low, high)
            rod = s.body(s.capsule(0.03, length - 0.06), steel, middle, spin, "hanger", "#8E7B6B")
            s.joint(bodies[i], rod, joints.ball(), low)
            s.joint(rod, links[i], joints.ball(), high)
        for end in (-1, 1):
            low, high = (end * (half + 5), deck, z), (end * half, top, z)
            middle, spin, length = along(low, high)
            s.fixed(s.capsule(0.06, length), steel, middle, spin, "stay", "#5A4A4A")
    s.meet(None)
    rolling = s.material(0.7, 0.0, 500, rolling=0.004)
    s.body(s.sphere(0.875), rolling, (-half - 1.9, deck + 0.875, 0), None, "ball", RED, linearVelocity=[2.6, 0, 0],
           angularVelocity=[0, 0, short(-2.6 / 0.875, 4)])
    # A hollow for the ball on the other bank.
    mud = s.material(0.7, 0.0, rolling=0.15)
    s.fixed(s.box(3.6, deck - 0.35, 6), mud, (half + 3.03, (deck - 0.35) / 2, 0), None, "hollow", "#7A7252")
    s.fixed(s.box(0.4, 1.6, wide), stone, (half + 3.4, deck + 0.2, 0), None, "buffer", YELLOW)
    return s


def chain_link(s, length, thick, wide):
    """An oval ring of round bars along y: the parts of a compound."""
    bar, bend = s.capsule(thick, length - 2 * thick), s.capsule(thick, wide)
    return [(bar, (side * wide / 2, 0, 0)) for side in (-1, 1)], [(bend, (0, end * (length / 2 - thick), 0))
                                                                 for end in (-1, 1)]


def ball_and_chain():
    s = Scene("Ball and chain", "A ball of 3 tons on links of 34 kg each swings into a wall.",
              (-8.6, 5.0, 13.2), (-0.4, 3.9, 0), 42)
    s.ground(0.6, 0.0, "#7A756B")
    stone, steel, brick = s.material(0.6, 0.0, 2400), s.material(0.4, 0.0, 7800), s.material(0.6, 0.0, 1800)
    pivot, lean, count, step, radius = (0.0, 8.2, 0.0), 68, 18, 0.32, 0.7
    s.meet("chain", never="chain")
    s.fixed(s.box(2.4, 0.5, 2.4), stone, (0, 0.25, -4.2), None, "crane", DARK_STONE)
    s.fixed(s.box(0.7, 8.6, 0.7), stone, (0, 4.8, -4.2), None, "crane", YELLOW)
    s.fixed(s.box(0.5, 0.6, 6.6), stone, (0, 8.8, -2.6), None, "crane", YELLOW)
    s.fixed(s.box(0.9, 0.9, 0.9), stone, (0, 8.7, -5.4), None, "crane", DARK_STONE)
    s.fixed(s.cylinder(0.12, 0.5), stone, (0, 8.35, 0), None, "hook", DARK_STONE)
    a = math.radians(lean)
    way = (-math.sin(a), -math.cos(a), 0)
    spin = between((0, -1, 0), way)
    last, long, thick = None, step + 0.1, 0.035
    sides, ends = chain_link(s, long, thick, 0.13)
    for i in range(count):
        middle = [p + w * (i + 0.5) * step for p, w in zip(pivot, way)]
        color = "#54606B" if i % 2 else "#3B444D"
        parts = [(shape, place, color) for shape, place in sides]
        parts += [(shape, place, color, turn("z", 90)) for shape, place in ends]
        link = s.compound(parts, steel, middle, multiply(spin, turn("y", 90 * (i % 2))), f"link {i + 1}")
        s.joint(last, link, joints.ball(), [p + w * i * step for p, w in zip(pivot, way)], way, name=f"link {i + 1}")
        last = link
    at_end = [p + w * count * step for p, w in zip(pivot, way)]
    s.meet("ball", never="chain")
    middle = [p + w * (radius + 0.02) for p, w in zip(at_end, way)]
    ball = s.compound([(s.sphere(radius), (0, 0, 0), "#2B3036"), (s.cylinder(0.12, 0.16), (0, radius, 0), "#54606B")],
                      s.material(0.4, 0.0, 2100), middle, spin, "ball")
    s.joint(last, ball, joints.ball(), at_end, way, name="ball")
    s.meet(None)
    long, high, deep = 0.7, 0.35, 0.4
    for row in range(11):
        for k in range(5 if row % 2 == 0 else 6):
            # Half bricks at the ends of every other row.
            half = row % 2 == 1 and k in (0, 5)
            z = (k - 2) * long if row % 2 == 0 else (k - 2.5) * long + (0.25 * long if k == 0 else -0.25 * long) * half
            color = blend("#B5533C", "#8E3B2E", (row * 3 + k * 5) % 7 / 6)
            s.body(s.box(deep, high, (long / 2 if half else long) - 0.01), brick, (1.1, (row + 0.5) * high, z), None,
                   f"brick {row + 1}", color)
    return s


# --- wheels

def cars():
    s = Scene("Cars on springs", "Four wheels on springs, two of them driven. They drive in a circle over bumps.",
              (0.5, 11.5, 15.5), (0, 0.2, 0.8), 42, sleep=False)
    rise = 0.16

    def height(x, z):
        r = math.hypot(x, z)
        rim = 0.09 * max(r - 9.0, 0) ** 2
        hill = 1.6 * math.exp(-(r / 2.2) ** 2)
        bumps = rise * math.sin(1.5 * x + 0.4 * z) * math.cos(1.3 * z - 0.3 * x)
        return 0.4 + bumps + min(rim, 1.6) + hill

    soil = s.material(0.9, 0.0)
    s.ground(0.9, 0.0, "#6C7F5E")
    s.fixed(s.height_field(93, 93, 0.3, height), soil, (0, 0, 0), None, "hills", "#9AA36B")
    for number, (angle, color) in enumerate(((0, RED), (120, BLUE), (240, YELLOW))):
        a = math.radians(angle)
        radius = 6.3
        place, heading = (radius * math.cos(a), 1.35, -radius * math.sin(a)), turn("y", angle + 90)
        car(s, place, heading, color, number + 1, 17.5)
    return s


def car(s, place, heading, color, number, steer):
    """A car that drives along its x axis; steer: the steering angle to the left, degrees."""
    def at(point):
        return [p + q for p, q in zip(place, rotate(heading, point))]

    half_base, half_track, radius = 1.0, 0.68, 0.36
    dark, paint = "#2A2E35", s.material(0.4, 0.0, 300)
    body = s.compound([(s.box(2.7, 0.3, 1.0), (0, 0, 0), color), (s.box(1.2, 0.42, 0.94), (-0.2, 0.36, 0), "#DCE6EC"),
                       (s.box(1.1, 0.08, 0.96), (-0.2, 0.6, 0), color),
                       (s.box(0.1, 0.12, 1.1), (1.38, -0.06, 0), dark),
                       (s.box(0.1, 0.12, 1.1), (-1.38, -0.06, 0), dark)],
                      paint, place, heading, f"car {number}", mass=900, centerOfMass=[0, -0.15, 0],
                      inertiaDiagonal=[160, 700, 640])
    rubber = s.material(1.1, 0.0, 250, combine="maximum")
    for name, x, z in (("front left", 1, -1), ("front right", 1, 1), ("rear left", -1, -1), ("rear right", -1, 1)):
        hub = at((x * half_base, -0.25, z * half_track))
        # The wheel's y axis is the axle, and points to the right.
        parts = [(s.cylinder(radius, 0.26), (0, 0, 0), dark), (s.cylinder(0.2, 0.28), (0, 0, 0), "#B9C0C6"),
                 (s.box(0.32, 0.285, 0.06), (0, 0, 0), "#7C858D")]
        axle = multiply(heading, turn("x", 90))
        tire = s.compound(parts, rubber, hub, axle, f"{name} {number}", mass=25)
        suspension = joints.control(-0.16, 0.14, to=joints.spring(26000, 2400))
        drive = joints.control(velocity=-9.5, most=420) if x < 0 else joints.control(friction=2)
        steering = None
        if x > 0:
            turned = math.radians(steer + (1.5 if z < 0 else -1.5))
            steering = joints.control(position=turned, to=joints.spring(9000, 300))
        # The frame's x axis points up, its y axis to the right, its z axis forward.
        frame = multiply(heading, (0.5, 0.5, 0.5, 0.5))
        s.joint(body, tire, joints.wheel(suspension, drive, steering), hub, frame, name=f"{name} {number}")
