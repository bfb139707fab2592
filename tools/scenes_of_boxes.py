"""The scenes of boxes and balls."""

import math
import random

import joints
from scene_writer import (BLACK, BLUE, DARK_STONE, GREEN, ORANGE, PURPLE, RED, SKY, STONE, VIVID, WALL, WHITE, WOOD,
                          YELLOW, Scene, any_turn, blend, multiply, rotate, short, turn)


def scatter(scene, rng, count, columns, spacing, bottom, material, sizes=(0.3, 0.6), jitter=0.1):
    """Boxes and balls on a loose grid about the vertical axis, layer by layer, without contact: the diagonal of the
    largest, 1.68 times its size, plus twice the jitter must not exceed the spacing."""
    assert 1.68 * sizes[1] + 2 * jitter <= spacing
    kinds = []
    for i in range(8):
        size = sizes[0] + (sizes[1] - sizes[0]) * i / 7
        if i % 2:
            kinds.append(scene.sphere(size * 0.55))
        else:
            kinds.append(scene.box(size, size * (0.7 + 0.1 * (i // 2)), size * 0.9))
    for i in range(count):
        layer, cell = divmod(i, columns * columns)
        row, column = divmod(cell, columns)
        place = [
            (column - (columns - 1) / 2) * spacing + rng.uniform(-jitter, jitter),
            bottom + layer * spacing + rng.uniform(-jitter, jitter),
            (row - (columns - 1) / 2) * spacing + rng.uniform(-jitter, jitter),
        ]
        scene.body(kinds[rng.randrange(8)], material, place, any_turn(rng), color=VIVID[i % 7])


def open_plane():
    s = Scene("Open plane", "Press U, I or O to drop more bodies, and drag one with the left mouse button.",
              (7.5, 5, 10), (0, 0.8, 0))
    rng = random.Random(1)
    s.ground(0.5, 0.3)
    scatter(s, rng, 27, 3, 1.8, 1.5, s.material(0.5, 0.3), (0.5, 0.9), 0.1)
    return s


def two_planes():
    s = Scene("Two planes", "Everything slides into the valley; hold keypad 4 or 6 to push it up one side.",
              (0, 8, 13), (0, 0.9, 0))
    rng = random.Random(2)
    material = s.material(0.4, 0.2)
    s.ground()
    angle, length, depth = 24, 7, 8
    slab = s.box(length, 0.3, depth)
    for name, sign in (("left plane", -1), ("right plane", 1)):
        tilt = turn("z", sign * angle)
        # The center of the upper face is half a length up the slope from the valley.
        up = rotate(tilt, (0, -0.15, 0))
        along = rotate(tilt, (sign * length / 2, 0, 0))
        s.fixed(slab, material, (along[0] + up[0], 0.4 + along[1] + up[1], 0), tilt, name, WALL)
    for name, sign in (("back wall", -1), ("front wall", 1)):
        s.fixed(s.box(4.4, 1, 0.2), material, (0, 0.5, sign * (depth / 2 - 0.1)), None, name, DARK_STONE)
    kinds = [s.sphere(0.3), s.box(0.5, 0.5, 0.5), s.sphere(0.42), s.box(0.8, 0.35, 0.5)]
    for i in range(32):
        column, row = i % 8, i // 8
        x = (column - 3.5) * 1.45
        y = 0.4 + abs(x) * math.tan(math.radians(angle)) + 0.9
        s.body(kinds[(column + row) % 4], material, (x, y + 0.2 * row, (row - 1.5) * 1.5 + rng.uniform(-0.1, 0.1)),
               any_turn(rng), color=VIVID[i % 7])
    return s


def big_walled_box():
    s = Scene("Big walled box", "Hold C to pull everything to the center, and Space to pause.",
              (9, 8.5, 12), (0, 0.4, 0))
    rng = random.Random(3)
    s.ground(0.5, 0.3)
    s.walls(10, 10, 1.4, 0.3, s.material(0.5, 0.3))
    scatter(s, rng, 98, 7, 1.3, 1.2, s.material(0.5, 0.3), (0.35, 0.65), 0.08)
    return s


def small_walled_box():
    s = Scene("Small walled box", "It is too small for all of them: some spill out onto the plane.",
              (5.2, 4.4, 7), (0, 0.7, 0))
    rng = random.Random(4)
    s.ground(0.5, 0.2)
    s.walls(2.4, 2.4, 0.9, 0.2, s.material(0.5, 0.2))
    scatter(s, rng, 128, 4, 0.72, 1.3, s.material(0.5, 0.2), (0.3, 0.4), 0.02)
    return s


def varied_masses():
    s = Scene("Varied masses", "Equal sizes, masses from 1 to 512 kg. Press Tab until the color shows the mass.",
              (6, 5.5, 10.5), (0, 0.5, 0))
    s.ground(0.5, 0.1)
    material = s.material(0.5, 0.3)
    s.walls(9, 6, 0.8, 0.25, material)
    box, ball, heavy = s.box(0.6, 0.6, 0.6), s.sphere(0.3), s.box(1.5, 0.5, 1.5)
    for i in range(10):
        color = blend("#2C7BB6", "#D7191C", i / 9)
        x = (i - 4.5) * 0.84
        s.body(box, material, (x, 0.3, -1.6), None, f"box of {2**i} kg", color, mass=2**i)
        s.body(ball, material, (x, 0.3, 1.9), None, f"ball of {2 ** (9 - i)} kg", blend("#2C7BB6", "#D7191C", (9 - i) / 9),
               mass=2 ** (9 - i), linearVelocity=[0, 0, -4])
    # A weight a hundred times heavier than each of the four boxes that carry it.
    for x in (-0.45, 0.45):
        for z in (-0.45, 0.45):
            s.body(box, material, (x * 1.0 + 3.2, 0.3, z + 0.3), None, "light box", SKY, mass=10)
    s.body(heavy, material, (3.2, 0.85, 0.3), None, "heavy slab", RED, mass=1000)
    return s


def slopes():
    s = Scene("Slopes", "Friction from 0.1 to 0.9 on a slope of 25 degrees: those below tan 25 = 0.47 slide.",
              (7, 6.6, 13.4), (-0.8, 0.9, 1.3))
    s.ground(0.6)
    angle, length, width = 25, 9, 11
    tilt = turn("x", angle)
    slope = s.material(0.0, 0.0, combine="maximum")
    # The lower edge of the upper face touches the ground at z = 4.
    middle = rotate(tilt, (0, -0.2, -length / 2))
    s.fixed(s.box(width, 0.4, length), slope, (0, middle[1], 4 + middle[2]), tilt, "slope", WALL)

    def on_slope(x, up, height):
        place = rotate(tilt, (0, height, -up))
        return (x, place[1], 4 + place[2])

    box, ball = s.box(0.6, 0.5, 0.7), s.sphere(0.28)
    for i in range(9):
        friction = (i + 1) / 10
        color = blend(YELLOW, BLUE, i / 8)
        material = s.material(friction, 0.0, combine="maximum")
        x = (i - 4) * 1.15
        s.body(box, material, on_slope(x, 7, 0.25), tilt, f"box, friction {friction}", color)
        s.body(ball, material, on_slope(x, 5.6, 0.28), tilt, f"ball, friction {friction}", color)
    return s


def pyramid():
    s = Scene("Pyramid", "210 boxes. Press P to shoot a box at it, or let it fall asleep and watch the time per step.",
              (4, 5.5, 18.5), (0, 4.6, 0))
    s.ground()
    box, material, size = s.box(0.5, 0.5, 0.5), s.material(), 0.5
    for row in range(20):
        for column in range(20 - row):
            x = (column - (19 - row) / 2) * (size + 0.02)
            s.body(box, material, (x, size * (row + 0.5), 0), color=blend(ORANGE, BLUE, row / 19))
    return s


def tower():
    s = Scene("Tower", "Forty cubes, one on another, and it stands. Pull one out with the mouse.",
              (9, 7, 21), (0, 9.5, 0), 55)
    s.ground()
    box, material = s.box(0.5, 0.5, 0.5), s.material()
    for i in range(40):
        s.body(box, material, (0, 0.25 + 0.5 * i, 0), name=f"cube {i + 1}", color=VIVID[i % 7])
    return s


def along_curve(points, spacing):
    """Points at equal distances along a smooth curve (Catmull-Rom) through points (x, z): x, z and the heading in
    degrees, measured from +z towards +x."""
    samples = []
    padded = [points[0], *points, points[-1]]
    for a, b, c, d in zip(padded, padded[1:], padded[2:], padded[3:]):
        for k in range(200):
            t = k / 200
            samples.append(tuple(
                0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - u) * t * t + (3 * q - p - 3 * r + u) * t**3)
                for p, q, r, u in zip(a, b, c, d)))
    places, travelled, due = [], 0.0, 0.0
    for (x0, z0), (x1, z1) in zip(samples, samples[1:]):
        travelled += math.hypot(x1 - x0, z1 - z0)
        if travelled >= due:
            places.append((x1, z1, math.degrees(math.atan2(x1 - x0, z1 - z0))))
            due += spacing
    return places


def dominoes():
    s = Scene("Dominoes", "One push, and a spiral of dominoes falls. Delete sets them up again.",
              (5.5, 6.5, 7.5), (0, 0, 0.2))
    s.ground(0.6)
    tile, material = s.box(0.28, 0.56, 0.08), s.material(0.35, 0.1, 700)
    spiral = []
    for k in range(0, 25):
        turns = k / 8
        radius = 3.6 - 0.95 * turns
        spiral.append((radius * math.sin(2 * math.pi * turns), radius * math.cos(2 * math.pi * turns)))
    places = along_curve(spiral, 0.24)
    for i, (x, z, heading) in enumerate(places):
        s.body(tile, material, (x, 0.28, z), turn("y", heading), name=f"domino {i + 1}",
               color=blend(SKY, RED, i / len(places)))
    x, z, heading = places[0]
    ahead = (math.sin(math.radians(heading)), math.cos(math.radians(heading)))
    s.body(s.sphere(0.22), s.material(0.5, 0.1, 1500), (x - ahead[0], 0.22, z - ahead[1]), name="ball", color=ORANGE,
           linearVelocity=[short(2.5 * ahead[0], 4), 0, short(2.5 * ahead[1], 4)])
    return s


def billiards():
    s = Scene("Billiards break", "A break at 6 m/s. Try slow motion with [ and ].", (0, 1.7, 2.1), (0, 0, 0.05), 40,
              time_step=1 / 240)
    cloth = s.material(0.2, 0.4)
    length, width, radius = 2.54, 1.27, 0.028575
    s.fixed(s.plane(), cloth, (0, 0, 0), name="cloth", color="#1E6B52")
    cushion = s.material(0.15, 0.9, combine="maximum")
    s.walls(length, width, 0.06, 0.1, cushion, "#6A4428")
    ball = s.sphere(radius)
    material = s.material(0.06, 0.95, combine="maximum", rolling=0.00015)
    numbered = [YELLOW, BLUE, RED, PURPLE, ORANGE, GREEN, SKY, BLACK]
    count = 0
    gap = 0.0002
    for row in range(5):
        for column in range(row + 1):
            x = 0.6 + row * (radius * 2 + gap) * math.sqrt(3) / 2
            z = (column - row / 2) * (radius * 2 + gap)
            s.body(ball, material, (x, radius, z), name=f"ball {count + 1}", color=numbered[count % 8], mass=0.17)
            count += 1
    s.body(ball, material, (-0.7, radius, 0.004), name="cue ball", color=WHITE, mass=0.17, linearVelocity=[6, 0, 0])
    return s


def newtons_cradle():
    s = Scene("Newton's cradle", "No friction and perfect bounces: one in, one out. Drag two balls back together.",
              (1.6, 1.9, 5.4), (0, 1.0, 0), 36, sleep=False, restitution_speed=0)
    smooth, wood = s.material(0, 1, 7800), s.material(0.5, 0)
    s.ground(0.5, 0, "#5C6670")
    height, width, radius, drop = 1.9, 0.6, 0.25, 1.3
    beam, leg, foot = s.capsule(0.04, 3.4), s.capsule(0.04, height), s.box(3.7, 0.08, 1.5)
    s.fixed(foot, wood, (0, 0.04, 0), None, "foot", "#4A3B30")
    for z in (-width, width):
        s.fixed(beam, wood, (0, height, z), turn((0, 0, 1), 90), "beam", "#9AA3AB")
        for x in (-1.7, 1.7):
            s.fixed(leg, wood, (x, height / 2, z), None, "leg", "#9AA3AB")
    ball, length = s.sphere(radius), math.hypot(drop, width)
    for i in range(5):
        rest = 2 * radius * (i - 2)
        angle = math.radians(-40) if i == 0 else 0
        x, y = rest + drop * math.sin(angle), height - drop * math.cos(angle)
        body = s.body(ball, smooth, (x, y, 0), name=f"ball {i + 1}", color=RED if i == 0 else SKY)
        for z in (-width, width):
            s.joint(None, body, joints.rope(round(length, 5)), (rest, height, z), place_b=(x, y, 0), color="#E8E4D8")
    return s


def t_handles():
    s = Scene("T-handles", "No gravity. Spin about the middle axis of inertia turns over again and again.",
              (0, 1.2, 6.5), (0, 0, 0), 40, gravity=[0, 0, 0], integrator="rk4", sleep=False)
    material = s.material(0.4, 0.2, 2700)
    bar, stem = s.box(1, 0.2, 0.2), s.box(0.2, 0.4, 0.2)
    # Moments of inertia: least about x (the bar), middle about y (the stem), greatest about z.
    spins = [("least", SKY, (8, 0.02, 0.01)), ("middle", RED, (0.01, 8, 0.02)), ("greatest", GREEN, (0.02, 0.01, 8))]
    for i, (name, color, spin) in enumerate(spins):
        s.compound([(bar, (0, 0, 0), color), (stem, (0, -0.3, 0), blend(color, "#FFFFFF", 0.4))], material,
                   ((i - 1) * 1.8, 0, 0), None, f"about the {name} axis", angularVelocity=list(spin))
    return s


def pile():
    s = Scene("Pile of 1,000", "A thousand bodies fall into a walled box. Press Tab twice to color them by speed.",
              (8.5, 8, 11.5), (0, 1.2, 0))
    rng = random.Random(13)
    s.ground(0.5, 0.1)
    s.walls(7, 7, 1.8, 0.4, s.material(0.5, 0.1))
    scatter(s, rng, 1000, 8, 0.84, 0.8, s.material(0.5, 0.1), (0.3, 0.45), 0.03)
    return s


def avalanche():
    s = Scene("Avalanche", "Rubble comes down a slope of 32 degrees towards three little towers.",
              (11, 7, 13), (0, 2.2, 1), 45)
    rng = random.Random(14)
    s.ground(0.7)
    angle, length, width = 32, 14, 8
    tilt = turn("x", angle)
    rough = s.material(0.45, 0.05)
    middle = rotate(tilt, (0, -0.25, -length / 2))
    s.fixed(s.box(width, 0.5, length), rough, (0, middle[1], 3 + middle[2]), tilt, "slope", WALL)

    def on_slope(x, up, height):
        place = rotate(tilt, (0, height, -up))
        return (x, place[1], 3 + place[2])

    for i, (x, up) in enumerate(((-2, 5), (2.1, 5.6), (0.2, 3.4), (-3.2, 3), (3.1, 2.6))):
        s.fixed(s.box(0.5, 2, 0.5), rough, on_slope(x, up, 0.7), tilt, f"post {i + 1}", DARK_STONE)
    for name, sign in (("left rim", -1), ("right rim", 1)):
        place = on_slope(sign * (width / 2 - 0.1), length / 2, 0.5)
        s.fixed(s.box(0.2, 1, length), rough, place, tilt, name, WALL)
    stone = s.material(0.45, 0.05, 2500)
    kinds = [s.sphere(0.2), s.box(0.4, 0.4, 0.4), s.sphere(0.28), s.box(0.6, 0.3, 0.4), s.box(0.3, 0.3, 0.55)]
    for i in range(320):
        layer, cell = divmod(i, 64)
        row, column = divmod(cell, 8)
        place = on_slope((column - 3.5) * 0.85 + rng.uniform(-0.03, 0.03), 7 + row * 0.82, 0.6 + layer * 0.8)
        s.body(kinds[rng.randrange(5)], stone, place, any_turn(rng), color=blend(STONE, VIVID[i % 7], 0.55))
    brick, wood = s.box(0.5, 0.3, 0.5), s.material(0.6, 0.0, 700)
    for x in (-2.2, 0, 2.2):
        for level in range(7):
            s.body(brick, wood, (x, 0.15 + 0.3 * level, 5.2), color=blend(WOOD, WHITE, level / 9))
    return s


def welcome():
    s = Scene("Cairn", "Press Delete to start over, 1 to 9 for more scenes, F1 for all keys; drag anything.",
              (4.6, 3.1, 9.2), (-0.25, 1.0, 0), 38)
    rng = random.Random(7)
    s.ground(0.7, 0.0, "#7A8578")
    stone = s.material(0.8, 0.0, 2600)
    # The cairn: slabs from large to small, each slightly offset from the one below.
    height, x, z = 0.0, -2.5, 0.0
    for i in range(11):
        t = i / 10
        size = (1.5 - 1.05 * t + rng.uniform(-0.1, 0.1), 0.30 - 0.12 * t + rng.uniform(-0.04, 0.04),
                1.15 - 0.8 * t + rng.uniform(-0.08, 0.08))
        shift = 0.05 * (1 - t)
        s.body(s.box(*(round(v, 3) for v in size)), stone,
               (x + rng.uniform(-shift, shift), height + round(size[1], 3) / 2, z + rng.uniform(-shift, shift)),
               turn("y", rng.uniform(-22, 22)), f"stone {i + 1}", blend(DARK_STONE, "#D8D2C4", rng.random()))
        height += round(size[1], 3)
    # A pyramid in the background.
    cube, plain, side = s.box(0.36, 0.36, 0.36), s.material(0.6), 0.36
    for row in range(10):
        for column in range(10 - row):
            place = (1.5 + (column - (9 - row) / 2) * (side + 0.015), side * (row + 0.5), -1.9)
            s.body(cube, plain, place, None, color=blend(RED, YELLOW, row / 9))
    # Dominoes along a curve, from the ramp on the right to a heap of small cubes on the left.
    tile, wood = s.box(0.24, 0.46, 0.07), s.material(0.35, 0.0, 700)
    curve = [(3.6, 0.3), (3.35, 1.5), (2.2, 2.3), (0.9, 1.9), (-0.1, 1.1), (-1.1, 1.4), (-1.9, 2.4), (-3.1, 2.5),
             (-3.9, 1.8)]
    places = along_curve(curve, 0.2)
    for i, (px, pz, heading) in enumerate(places):
        s.body(tile, wood, (px, 0.23, pz), turn("y", heading), f"domino {i + 1}", blend(SKY, BLUE, i / len(places)))
    brick = s.box(0.2, 0.2, 0.2)
    for level in range(4):
        for row in range(4 - level):
            for column in range(4 - level):
                place = (-4.25 + (column - (3 - level) / 2) * 0.21, 0.1 + 0.2 * level,
                         1.05 + (row - (3 - level) / 2) * 0.21)
                s.body(brick, wood, place, None, color=blend(GREEN, YELLOW, level / 4))
    # The ball on its ramp.
    tilt = turn("x", 22)
    x0, z0, _ = places[0]
    low = z0 - 0.45
    middle = rotate(tilt, (0, -0.06, -1.1))
    s.fixed(s.box(0.7, 0.12, 2.2), plain, (x0, middle[1] + 0.02, low + middle[2]), tilt, "ramp", WOOD)
    start = rotate(tilt, (0, 0.2, -1.85))
    s.body(s.sphere(0.2), s.material(0.6, 0.0, 2000), (x0, start[1] + 0.02, low + start[2]), None, "ball", ORANGE)
    return s


def bullets():
    s = Scene("Bullets", "Sixty balls at 30 to 120 m/s, steel plates of 6 mm on strings: none goes through one. Try [ for slow motion.",
              (-4.2, 2.6, 4.6), (0.5, 1.15, 0), 42, max_angular_speed=8000)
    rng = random.Random(33)
    s.ground(0.6, 0.1)
    iron, wood, light = s.material(0.3, 0.2, 7800), s.material(0.5, 0), s.material(0.4, 0.1, 1000, rolling=0.01)
    plate, post, beam = s.box(0.006, 1.0, 0.7), s.box(0.08, 2.4, 0.08), s.box(0.08, 0.08, 3.2)
    for row in range(3):
        x = 0.9 * row
        s.fixed(beam, wood, (x, 2.4, 0), None, "beam", WOOD)
        for z in (-1.6, 1.6):
            s.fixed(post, wood, (x, 1.2, z), None, "post", WOOD)
        for column in range(3):
            z = 0.95 * (column - 1)
            body = s.body(plate, iron, (x, 1.1, z), None, f"plate {3 * row + column + 1}",
                          blend("#8A949C", "#4E6478", row / 2))
            for side in (-0.3, 0.3):
                s.joint(None, body, joints.rope(0.8), (x, 2.4, z + side), place_b=(x, 1.6, z + side), color="#E8E4D8")
    s.fixed(s.box(0.3, 5, 9), wood, (5, 2.5, 0), None, "backstop", "#6B5A48")
    bullet = s.sphere(0.025)
    for i in range(60):
        speed = 30 * 4 ** (i / 59)
        s.body(bullet, light, (-1.2 - 0.6 * i, 1.1 + rng.uniform(-0.4, 0.4), rng.uniform(-1.2, 1.2)), None,
               f"bullet {i + 1}", blend(YELLOW, RED, i / 59), linearVelocity=[short(speed, 3), 0, 0])
    return s


def pinball():
    tilt = 12
    s = Scene("Pinball", "Three flippers turn steadily between bumpers of rubber. Drop more balls with J.",
              (0, 4.7, 3.7), (0, 0.6, 0.1), 42)
    s.ground(0.6, 0.1, "#39424A")
    slope = turn("x", tilt)
    steel, rubber, wood = s.material(0.1, 0.3, 7800), s.material(0.2, 0.95), s.material(0.2, 0.2)

    def on(x, y, z):
        """A position above the table, given in the table's axes."""
        px, py, pz = rotate(slope, (x, y, z))
        return (px, py + 0.9, pz)

    s.fixed(s.box(2.2, 0.1, 4), wood, on(0, -0.05, 0), slope, "table", "#2F5D50")
    for name, size, place in (("left rail", (0.1, 0.2, 4), (-1.05, 0.1, 0)), ("right rail", (0.1, 0.2, 4), (1.05, 0.1, 0)),
                              ("top rail", (2, 0.2, 0.1), (0, 0.1, -1.95))):
        s.fixed(s.box(*size), wood, on(*place), slope, name, WOOD)
    for name, side in (("left gutter", -1), ("right gutter", 1)):
        s.fixed(s.box(0.66, 0.2, 0.1), wood, on(0.7 * side, 0.1, 1.4), multiply(slope, turn("y", 25 * side)), name, WOOD)
    bumper, cap = s.cylinder(0.14, 0.2), s.cylinder(0.1, 0.04)
    for i, (x, z) in enumerate(((-0.5, -1.1), (0.5, -1.1), (0, -0.6), (-0.6, -0.1), (0.6, -0.1))):
        s.fixed(bumper, rubber, on(x, 0.1, z), slope, f"bumper {i + 1}", VIVID[i])
        s.fixed(cap, rubber, on(x, 0.22, z), slope, None, WHITE)
    flipper = s.box(0.7, 0.12, 0.07)
    for i, (x, z, spin) in enumerate(((-0.45, 0.75, -5), (0.45, 0.75, 5), (0, 1.45, 7))):
        s.body(flipper, rubber, on(x, 0.08, z), slope, f"flipper {i + 1}", ORANGE, isKinematic=True,
               angularVelocity=[0, spin, 0])
    ball = s.sphere(0.055)
    for i in range(14):
        s.body(ball, steel, on(-0.79 + 0.27 * (i % 7), 0.08, -1.75 + 0.16 * (i // 7)), None, f"ball {i + 1}",
               WHITE if i % 2 else SKY)
    return s
