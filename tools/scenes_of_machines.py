"""Scenes of machines: a walker, a clock, a robot, and a chain reaction."""

import math

import joints
from scene_writer import (BLUE, DARK_STONE, GREEN, ORANGE, PURPLE, RED, SKY, VIVID, WHITE, WOOD, YELLOW, Scene, blend,
                          multiply, rotate, turn)
from scenes_of_joints import along
from scenes_of_shapes import gear_tooth


# --- walker

# The lengths of Theo Jansen's leg, in its usual units: crank m, its height above the pivot l, the pivot's distance a.
A, B, C, D, E, F, G, H, I, J, K, L, M = 38, 41.5, 39.3, 40.1, 55.8, 39.4, 36.7, 65.7, 49, 50, 61.9, 7.8, 15


def meeting(p, from_p, q, from_q, above):
    """The point at these distances from p and q: of the two solutions, the one to the left of the direction from p to q
    if `above`, else the other."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    distance = math.hypot(dx, dy)
    t = (from_p**2 - from_q**2 + distance**2) / (2 * distance)
    h = math.sqrt(from_p**2 - t * t) * (1 if above else -1)
    return (p[0] + (t * dx - h * dy) / distance, p[1] + (t * dy + h * dx) / distance)


def jansen(phase):
    """The points of a leg to the left of the crank, whose axle is the origin."""
    crank, pivot = (M * math.cos(phase), M * math.sin(phase)), (-A, -L)
    upper = meeting(pivot, B, crank, J, True)
    lower = meeting(pivot, C, crank, K, False)
    left = meeting(pivot, D, upper, E, True)
    ankle = meeting(left, F, lower, G, False)
    foot = meeting(ankle, H, lower, I, False)
    return {"crank": crank, "pivot": pivot, "upper": upper, "lower": lower, "left": left, "ankle": ankle, "foot": foot}


def walker():
    s = Scene("Walker", "Eight legs of Theo Jansen's linkage, one motor. It walks by itself.",
              (0.6, 3.4, 9.6), (0, 0.9, 0), 42, sleep=False)
    s.ground(0.9, 0.0, "#C8B48A")
    unit, begin = 0.016, -4.2
    axle = 91.8 * unit + 0.062  # the lowest foot is on the ground
    bone, frame = s.material(0.9, 0.0, 450), s.material(0.5, 0.0, 600)
    s.meet("walker", never="walker")
    layers = [(-0.95, 0.0), (-0.45, math.pi), (0.45, math.pi), (0.95, 0.0)]
    deck = [(s.box(0.1, 0.1, 2.2), (sign * A * unit, axle - L * unit, 0), "#39424E") for sign in (-1, 1)]
    deck += [(s.box(2 * A * unit, 0.1, 0.12), (0, axle - L * unit, z), "#39424E") for z in (-0.2, 0.2)]
    deck += [(s.box(0.5, 0.3, 0.34), (0, axle - L * unit - 0.12, 0), ORANGE)]
    height = axle - L * unit
    body = s.compound([(shape, (x, y - height, z), color) for shape, (x, y, z), color in deck], frame,
                      (begin, height, 0), None,
                      "body")
    shaft = s.cylinder(0.04, 2.1)
    parts = [(shaft, (0, 0, 0), "#B9C0C6", turn("x", 90))]
    for z, phase in layers:
        end = (M * unit * math.cos(phase), M * unit * math.sin(phase), z)
        place, spin, length = along((0, 0, z), end)
        parts.append((s.capsule(0.045, length), place, RED, spin))
    crank = s.compound(parts, frame, (begin, axle, 0), None, "crank")
    s.joint(body, crank, joints.hinge(joints.control(velocity=-2.0, most=300), solver="direct"), (begin, axle, 0), "z",
            name="motor")
    for z, phase in layers:
        for side in (1, -1):
            leg(s, body, crank, z, phase, side, unit, (begin, axle), bone)
    s.meet(None)
    # Blocks in its path, light enough to be kicked aside.
    light, block = s.material(0.6, 0.0, 60), s.box(0.09, 0.09, 0.09)
    for k in range(24):
        row, column = divmod(k, 4)
        place = (-1.2 + 0.95 * row, 0.045, (column - 1.5) * 0.7 + 0.17 * (row % 2))
        s.body(block, light, place, turn("y", 37 * k % 90), None, VIVID[k % 7])
    return s


def leg(s, body, crank, z, phase, side, unit, axle, bone):
    # A leg to the right is the mirror image of one whose crank is at the mirrored angle.
    points = jansen(phase if side == 1 else math.pi - phase)
    points = {name: (side * x * unit + axle[0], y * unit + axle[1], z) for name, (x, y) in points.items()}
    name = f"{'left' if side == 1 else 'right'} leg {z}"

    def plate(corners, color, what, ends=()):
        middle = [sum(points[c][i] for c in corners) / len(corners) for i in range(3)]
        parts = []
        for first, second in zip(corners, corners[1:] + corners[:1] if len(corners) > 2 else corners[1:]):
            place, spin, length = along(points[first], points[second])
            parts.append((s.capsule(0.036, length), [p - m for p, m in zip(place, middle)], color, spin))
        for end in ends:
            parts.append((s.sphere(0.06), [p - m for p, m in zip(points[end], middle)], "#2A2E35"))
        return s.compound(parts, bone, middle, None, f"{what} {name}")

    thigh = plate(["pivot", "upper", "left"], "#E8D9B5", "thigh")
    shank = plate(["ankle", "lower", "foot"], "#E8D9B5", "shank", ["foot"])
    high, low = plate(["crank", "upper"], SKY, "high rod"), plate(["crank", "lower"], SKY, "low rod")
    link, strut = plate(["pivot", "lower"], "#C8864A", "link"), plate(["left", "ankle"], "#C8864A", "strut")
    for a, b, at in ((crank, high, "crank"), (crank, low, "crank"), (body, thigh, "pivot"), (body, link, "pivot"),
                     (high, thigh, "upper"), (low, shank, "lower"), (link, shank, "lower"), (thigh, strut, "left"),
                     (strut, shank, "ankle")):
        s.joint(a, b, joints.hinge(solver="direct"), points[at], "z", name=f"{at} {name}")


# --- clock

def clock():
    s = Scene("Clock", "A motor turns the minute hand in 12 s; two pairs of gears turn the hour hand 12 times slower.",
              (0.9, 3.1, 9.4), (0, 2.75, 0), 40, sleep=False)
    s.ground(0.6, 0.0, "#5B4A42")
    brass, wood = s.material(0.3, 0.0, 2000), s.material(0.5, 0.0, 700)
    high = 3.3
    s.meet("clock", never="clock")
    for k in range(48):
        a = 2 * math.pi * k / 48
        s.fixed(s.box(0.24, 0.345, 0.3), wood, (2.45 * math.sin(a), high + 2.45 * math.cos(a), 0),
                turn("z", 90 - math.degrees(a)), "rim", "#6B4426")
    for k in range(12):
        a = 2 * math.pi * k / 12
        long = 0.34 if k % 3 == 0 else 0.2
        s.fixed(s.box(long, 0.09, 0.06), wood, (2.1 * math.sin(a), high + 2.1 * math.cos(a), 0.16),
                turn("z", 90 - math.degrees(a)), "mark", WHITE)
    for x in (-1.5, 1.5):
        s.fixed(s.box(0.3, 1.6, 0.5), wood, (x, 0.8, 0), None, "foot", "#6B4426")
    s.fixed(s.box(4.2, 0.2, 0.9), wood, (0, 0.1, 0), None, "base", "#5A381F")

    thick = 0.1
    reach, lift = 1.2, math.radians(-60)
    center, side = (0.0, high), (reach * math.cos(lift), high + reach * math.sin(lift))
    fast = (-1.5 * math.cos(math.radians(40)), high - 1.5 * math.sin(math.radians(40)))

    def wheel(teeth, module, z, phase, color):
        """The parts of a gear about z. phase: where a tooth is, degrees."""
        tooth = s.hull(gear_tooth(module, teeth, thick, 0.006))
        root = module * teeth / 2 - 1.15 * module
        upright = turn("x", 90)
        made = [(s.cylinder(root, thick), (0, 0, z), color, upright)]
        return made + [(tooth, (0, 0, z), blend(color, "#FFFFFF", 0.2),
                        multiply(turn("z", phase + 360 / teeth * k), upright)) for k in range(teeth)]

    def hand(length, width, z, color):
        return [(s.box(width, length, 0.04), (0, length / 2 - 0.25, z), color),
                (s.cylinder(0.11, 0.05), (0, 0, z), color, turn("x", 90))]

    def mate(teeth, phase, teeth_b, direction):
        """The phase of a gear whose mate, in that direction, has a tooth at the given phase: a gap faces each tooth."""
        along_a = (direction - phase) * teeth / 360
        return direction + 180 - (0.5 - along_a) * 360 / teeth_b

    down, left = math.degrees(lift), 180 + 40
    minute = s.compound(wheel(48, 0.05, -0.25, 0, "#B08D3C") + wheel(12, 0.05, -0.1, 0, "#D2A94A")
                        + hand(2.15, 0.07, 0.34, "#F2EFE8")
                        + [(s.cylinder(0.05, 0.62), (0, 0, 0.04), "#8C8C94", turn("x", 90))],
                        brass, (*center, 0), None, "minute hand")
    hour = s.compound(wheel(48, 0.04, 0.05, 0, "#C77C4E") + hand(1.55, 0.11, 0.26, RED), brass, (*center, 0), None,
                      "hour hand")
    middle = s.compound(wheel(36, 0.05, -0.1, mate(12, 0, 36, down), "#8FA3AD")
                        + wheel(12, 0.04, 0.05, mate(48, 0, 12, down), "#B5C4CC")
                        + [(s.cylinder(0.04, 0.4), (0, 0, 0), "#8C8C94", turn("x", 90))], brass, (*side, 0), None,
                        "motion work")
    driver = s.compound(wheel(12, 0.05, -0.25, mate(48, 0, 12, left), SKY)
                        + [(s.cylinder(0.04, 0.3), (0, 0, -0.2), "#8C8C94", turn("x", 90))], brass, (*fast, 0), None,
                        "driver")
    turns = 2 * math.pi / 12
    for body, place, name, motor in ((minute, center, "minute", None), (hour, center, "hour", None),
                                     (middle, side, "motion work", None), (driver, fast, "motor", 4 * turns)):
        angle = joints.control(velocity=motor) if motor else None
        s.joint(None, body, joints.hinge(angle), (*place, 0), "z", name=name)
    for a, b, first, second, ratio in ((driver, minute, fast, center, 4), (minute, middle, center, side, 3),
                                       (middle, hour, side, center, 4)):
        s.joint(a, b, joints.gear(ratio), (*first, 0), "z", (*second, 0), name=f"gear 1 : {ratio}")
    s.meet(None)
    return s


# --- robot

def robot():
    s = Scene("Robot arm", "Six axes hold a tray level while the arm turns. Push it: the servos bring it back.",
              (3.3, 2.7, 4.2), (0, 1.0, 0), 42, sleep=False)
    s.ground(0.6, 0.0, "#58626B")
    steel, grip = s.material(0.5, 0.0, 1000), s.material(0.8, 0.0, 400)
    s.fixed(s.cylinder(0.45, 0.2), steel, (0, 0.1, 0), None, "stand", DARK_STONE)
    paint, dark = ORANGE, "#2F3840"
    # The initial positions of the arm, which it keeps: shoulder, elbow, wrist, hand.
    shoulder, elbow, wrist, hand = (0.15, 0.75, 0), (0.55, 1.65, 0), (1.35, 1.4, 0), (1.62, 1.4, 0)
    lying = turn("x", 90)

    def link(points, radius, name, mass, extra=()):
        place, spin, length = along(*points)
        parts = [(s.capsule(radius, length), (0, 0, 0), paint, spin)]
        parts += [(shape, [p - m for p, m in zip(at, place)], color, *how) for shape, at, color, *how in extra]
        return s.compound(parts, steel, place, None, name, mass=mass)

    s.meet("arm", never="arm")
    drum = s.cylinder(0.17, 0.36)
    base = link(((0, 0.4, 0), shoulder), 0.16, "base", 40,
                [(s.cylinder(0.3, 0.18), (0, 0.32, 0), dark), (drum, shoulder, dark, lying)])
    upper = link((shoulder, elbow), 0.11, "upper arm", 18, [(s.cylinder(0.14, 0.32), elbow, dark, lying)])
    mid = [0.45 * e + 0.55 * w for e, w in zip(elbow, wrist)]
    fore = link((elbow, mid), 0.1, "forearm", 9)
    roll = link((mid, wrist), 0.075, "roll", 5, [(s.cylinder(0.1, 0.24), wrist, dark, lying)])
    pitch = link((wrist, hand), 0.06, "wrist", 2.5)
    tray = s.compound([(s.cylinder(0.07, 0.1), (0, 0, 0), dark), (s.cylinder(0.34, 0.03), (0, 0.13, 0), "#C9CDD2"),
                       (s.cylinder(0.05, 0.14), (0, 0.06, 0), dark)], grip, hand, None, "tray", mass=2)
    way = along(elbow, wrist)
    forward = rotate(way[1], (0, 1, 0))
    servo = joints.hinge(joints.control(position=0, to=joints.spring(100000, 10000)))
    s.joint(None, base, joints.hinge(joints.control(velocity=0.6, most=60)), (0, 0.2, 0), "y", name="axis 1")
    for number, (a, b, at, axis) in enumerate(((base, upper, shoulder, "z"), (upper, fore, elbow, "z"),
                                               (fore, roll, mid, forward), (roll, pitch, wrist, "z"),
                                               (pitch, tray, hand, "y"))):
        s.joint(a, b, servo, at, axis, name=f"axis {number + 2}")
    s.meet(None)
    glass = s.material(0.6, 0.0, 500)
    top = hand[1] + 0.145
    for k, (x, z) in enumerate(((-0.11, -0.11), (0.11, -0.11), (-0.11, 0.11), (0.11, 0.11))):
        s.body(s.box(0.16, 0.16, 0.16), glass, (hand[0] + x, top + 0.08, hand[2] + z), None,
               f"cube {k + 1}", VIVID[k + 1])
    s.body(s.box(0.4, 0.04, 0.4), glass, (hand[0], top + 0.18, hand[2]), None, "board", WOOD)
    s.body(s.cylinder(0.12, 0.24, 0.0), glass, (hand[0], top + 0.32, hand[2]), None, "cone", RED)
    return s


# --- one thing sets off the next

def chain_reaction():
    s = Scene("Chain reaction", "A ball, dominoes, a seesaw, a hammer, a slide, a pan: the flag rises at the end.",
              (0.2, 3.3, 12.6), (0.2, 1.95, 0), 40)
    s.ground(0.6, 0.0, "#5E6F78")
    wood, slick = s.material(0.5, 0.0, 600), s.material(0.15, 0.0, 600)
    heavy = s.material(0.4, 0.0, 2500, rolling=0.002)
    # The shelf with a ramp at its left end.
    shelf, first = 3.2, -5.3
    s.fixed(s.box(4.1, 0.16, 0.7), wood, (first + 2.05, shelf - 0.08, 0), None, "shelf", WOOD)
    for x in (first + 0.2, first + 3.9):
        s.fixed(s.box(0.16, shelf - 0.16, 0.5), wood, (x, (shelf - 0.16) / 2, 0), None, "post", "#8A6239")
    lean = turn("z", -25)
    s.fixed(s.box(1.5, 0.1, 0.5), wood, (first - 0.66, shelf + 0.27, 0), lean, "ramp", WOOD)
    for z in (-0.28, 0.28):
        s.fixed(s.box(1.5, 0.24, 0.06), slick, (first - 0.66, shelf + 0.35, z), lean, "rail", "#8A6239")
    s.body(s.sphere(0.16), heavy, (first - 1.02, shelf + 0.66, 0), None, "first ball", RED)
    stone = s.material(0.4, 0.0, 1600)
    for k in range(11):
        s.body(s.box(0.08, 0.56, 0.3), stone, (first + 0.5 + 0.28 * k, shelf + 0.28, 0), None, f"domino {k + 1}",
               blend(YELLOW, RED, k / 10))
    light = s.material(0.5, 0.0, 1500, rolling=0.0003)
    s.body(s.sphere(0.2), light, (first + 3.82, shelf + 0.2, 0), None, "second ball", BLUE)
    # The seesaw: its right end is down until the ball arrives.
    pivot = (0.7, 1.35, 0)
    s.meet("seesaw", never="seesaw")
    s.fixed(s.hull([(x, y, z) for x, y in ((-0.45, 0), (0.45, 0), (0, pivot[1])) for z in (-0.3, 0.3)]), wood,
            (pivot[0], 0, 0), None, "stand", "#8A6239")
    tilt = turn("z", -14)
    plank = s.compound([(s.box(3.4, 0.1, 0.6), (0, 0, 0), GREEN), (s.box(0.4, 0.4, 0.5), (1.25, -0.25, 0), DARK_STONE),
                        (s.box(0.06, 0.4, 0.6), (-1.67, 0.2, 0), GREEN)]
                       + [(s.box(1.2, 0.3, 0.06), (-1.1, 0.2, z), GREEN) for z in (-0.27, 0.27)], wood, pivot, tilt,
                       "seesaw")
    s.joint(None, plank, joints.hinge(joints.control(0, math.radians(28))), pivot, "z", name="seesaw")
    s.meet(None)
    # The hammer leans to the left until the seesaw lifts its tail.
    axle, arm = (2.8, 2.0, 0), 1.1
    lean = turn("z", 6)
    place, spin, length = along((0, 0, 0), (-0.62, -0.4, 0))
    hammer = s.compound([(s.box(0.1, arm, 0.1), (0, arm / 2, 0), "#8A6239"),
                         (s.box(0.42, 0.26, 0.26), (0, arm, 0), DARK_STONE),
                         (s.capsule(0.05, length), place, "#8A6239", spin),
                         (s.cylinder(0.09, 0.64), (0, 0, 0), ORANGE, turn("x", 90))],
                        s.material(0.3, 0.0, 1200), axle, lean, "hammer")
    s.joint(None, hammer, joints.hinge(joints.control(math.radians(-98), 0)), axle, "z", name="hammer")
    for z in (-0.4, 0.4):
        s.fixed(s.box(0.14, axle[1] + 0.1, 0.1), wood, (axle[0], (axle[1] + 0.1) / 2, z), None, "post", "#8A6239")
    catch_ball(s, wood, heavy)
    return s


def catch_ball(s, wood, heavy):
    """The end of the chain reaction: a slide drops a ball into a pan, which pulls up a flag."""
    start, level, drop = 3.72, 1.85, 4.69
    way = joints.slider(joints.control(0, 0.6, friction=25))
    s.meet("slide", never="frame")
    slide = s.compound([(s.box(0.08, 0.75, 0.56), (0, 0.375, 0), PURPLE)]
                       + [(s.box(0.8, 0.06, 0.06), (0.4, 0.03, z), PURPLE) for z in (-0.27, 0.27)]
                       + [(s.box(0.85, 0.06, 0.6), (1.175, 0.03, 0), PURPLE)], s.material(0.1, 0.0, 300),
                       (start, level, 0), None, "slide")
    s.joint(None, slide, way, (start, level, 0), "x", name="slide")
    s.meet("frame", never="slide")
    for x in (drop - 0.24, drop + 0.24):
        s.fixed(s.box(0.06, 0.5, 0.5), wood, (x, level + 0.32, 0), None, "chute", WOOD)
    for z in (-0.28, 0.28):
        s.fixed(s.box(0.54, 0.3, 0.06), wood, (drop, level + 0.42, z), None, "chute", WOOD)
    s.fixed(s.box(2.0, 0.1, 0.1), wood, (start + 1.0, level + 0.03, -0.36), None, "rail", "#8A6239")
    s.fixed(s.box(0.12, level, 0.12), wood, (start + 1.9, level / 2, -0.36), None, "post", "#8A6239")
    s.meet(None)
    s.body(s.sphere(0.18), heavy, (drop, level + 0.24, 0), None, "third ball", SKY, mass=20)
    metal = s.material(0.5, 0.0, 300)
    mast, pole, pan_y, top = 5.75, 6.6, 1.3, 3.95
    s.meet("lift", never="lift")
    for x in (mast, pole):
        s.fixed(s.cylinder(0.04, top), wood, (x, top / 2, -0.1), None, "mast", WHITE)
        s.fixed(s.cylinder(0.14, 0.1), wood, (x, top + 0.05, 0), turn("x", 90), "pulley", ORANGE)
    s.fixed(s.box(pole - mast, 0.08, 0.08), wood, ((pole + mast) / 2, top + 0.05, -0.1), None, "yard", WHITE)
    pan = s.compound([(s.box(0.6, 0.06, 0.6), (0, 0, 0), RED)]
                     + [(s.box(0.06, 0.26, 0.6), (x, 0.13, 0), RED) for x in (-0.27, 0.27)]
                     + [(s.box(0.6, 0.26, 0.06), (0, 0.13, z), RED) for z in (-0.27, 0.27)]
                     + [(s.box(mast - drop - 0.2, 0.08, 0.08), ((mast - drop + 0.3) / 2, 0, 0), RED)],
                     metal, (drop, pan_y, 0), None, "pan", mass=20)
    flag = s.compound([(s.box(0.08, 0.5, 0.08), (0, 0, 0), WHITE), (s.box(0.75, 0.5, 0.04), (0.4, 0, 0), RED),
                       (s.box(0.76, 0.14, 0.05), (0.4, 0, 0), WHITE)], metal, (pole, 0.5, 0), None, "flag", mass=14)
    fall = pan_y - 0.2
    s.joint(None, pan, joints.slider(joints.control(-fall, 0, friction=4)), (mast, pan_y, 0), "y", name="pan")
    s.joint(None, flag, joints.slider(joints.control(0, 2 * fall + 0.1, friction=4)), (pole, 0.5, 0), "y", name="flag")
    pull = joints.pulley((mast, top, 0), (pole, top, 0), 0.5)
    s.joint(pan, flag, pull, (mast, pan_y, 0), "x", (pole, 0.5, 0), name="rope")
    s.meet(None)


# --- a walk

def stroll():
    s = Scene("Stroll", "Shift+arrows walk, Shift+Page up jumps. Stairs, a ramp, a carousel, a seesaw, crates to push.",
              (0.5, 6.2, 12.5), (0, 0.6, 0.5), 42)
    s.ground(0.6, 0.0, "#6F7B73")
    stone = s.material(0.7)
    for k in range(6):
        s.fixed(s.box(0.4, 0.2 * (k + 1), 2.4), stone, (-4.2 + 0.4 * k, 0.1 * (k + 1), -2.2), None, "step", "#B9B2A6")
    s.fixed(s.box(2.4, 1.2, 2.4), stone, (-0.8, 0.6, -2.2), None, "terrace", "#B9B2A6")
    tilt, length = 22, 1.2 / math.sin(math.radians(22))
    middle = rotate(turn("z", -tilt), (length / 2, -0.1, 0))
    s.fixed(s.box(length, 0.2, 2.4), stone, (0.4 + middle[0], 1.2 + middle[1], -2.2), turn("z", -tilt), "ramp", "#A8B2B8")
    posts = [rotate(turn("y", angle), (1.2, 0.53, 0)) for angle in (0, 120, 240)]
    s.compound([(s.cylinder(1.5, 0.16), (0, 0, 0), SKY)] + [(s.cylinder(0.08, 0.9), place, WHITE) for place in posts], stone,
               (-3.2, 0.08, 2.6), None, "carousel", isKinematic=True, angularVelocity=[0, 0.7, 0])
    s.fixed(s.box(0.2, 0.16, 0.9), stone, (2.6, 0.08, 2.6), None, "post", DARK_STONE)
    plank = s.body(s.box(4.0, 0.1, 0.8), s.material(0.7, 0.0, 400), (2.6, 0.24, 2.6), None, "seesaw", WOOD)
    s.joint(None, plank, joints.hinge(), (2.6, 0.24, 2.6), "z", name="pivot")
    crate = s.material(0.5, 0.0, 250)
    for k in range(3):
        for row in range(3 - k):
            s.body(s.box(0.5, 0.5, 0.5), crate, (4.4, 0.25 + 0.5 * k, 0.1 + 0.55 * (row + 0.5 * k)), None, "crate",
                   (ORANGE, YELLOW, GREEN)[k])
    s.character(s.capsule(0.3, 1.0), stone, (0, 0.82, 3.2), "walker", RED)
    return s
