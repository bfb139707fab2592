"""A scene with water."""

import math
import random

from scene_writer import ORANGE, RED, SKY, VIVID, WHITE, WOOD, YELLOW, Scene, any_turn, blend, turn
import joints


def harbor():
    s = Scene("Harbor", "What is lighter than water floats, as deep as its density says. Drop more things in with U, I or O.",
              (6.4, 7.0, 9.6), (0, 1.3, 0.4))
    rng = random.Random(36)
    s.ground(0.6, 0.1, "#C9B68B")
    stone, level = s.material(0.6, 0.1), 2.1
    s.walls(12, 8, 2.4, 0.4, stone)
    s.world["force_fields"] = [{"kind": "fluid", "center": [0, level, 0], "half_extents": [6, level, 4]}]

    # A pier on posts.
    for i in range(4):
        for z in (-3.6, -2.4):
            s.fixed(s.cylinder(0.09, 2.5), stone, (-4.5 + 1.5 * i, 1.25, z), None, "post", "#6B5A48")
    s.fixed(s.box(5.4, 0.12, 1.6), stone, (-2.25, 2.56, -3.1), None, "pier", WOOD)

    # A boat of light wood, a meter wide.
    hull = s.hull([(x, y, z) for x, y, w in ((-1.2, 0.42, 0.46), (0.7, 0.42, 0.5), (-1.1, 0, 0.3), (0.6, 0, 0.3))
                   for z in (-w, w)] + [(1.5, 0.46, 0), (1.0, 0.02, 0)])
    s.compound([(hull, (0, 0, 0), RED), (s.box(0.7, 0.34, 0.6), (-0.5, 0.59, 0), WHITE),
                (s.cylinder(0.04, 1.4), (0.25, 1.1, 0), WOOD)],
               s.material(0.5, 0.1, 250), (0.6, level - 0.1, 1.0), turn("y", 25), "boat")

    # Boxes of 100 to 1,300 kg/m^3: a scale of drafts.
    crate = s.box(0.6, 0.6, 0.6)
    for i in range(9):
        density = 100 + 150 * i
        s.body(crate, s.material(0.5, 0.1, density), (-4.6 + 1.15 * i, level + 0.5, 3.2), None, f"{density} kg/m3",
               blend("#F4E8C8", "#5B2C1A", i / 8))
    # Logs of square and of round section: the square ones turn on edge.
    wood = s.material(0.5, 0.1, 500)
    for i in range(3):
        s.body(s.box(0.3, 0.3, 1.8), wood, (3.4 + 0.8 * i, level + 0.3, -0.6), turn("z", 4), "square log", WOOD)
        s.body(s.cylinder(0.17, 1.8), wood, (3.4 + 0.8 * i, level + 0.9, -0.4), turn("x", 90), "log", "#8A5A33")
    # Buoys on ropes from the ground, a raft with a load, and what falls in.
    for i in range(4):
        place = (-5.2, level, -1.6 + 1.1 * i)
        buoy = s.body(s.sphere(0.26), s.material(0.4, 0.2, 250), place, None, "buoy", ORANGE)
        s.joint(None, buoy, joints.rope(2.1), (place[0], 0, place[2]), place_b=place, color="#E8E4D8")
    s.body(s.box(1.8, 0.24, 1.4), s.material(0.7, 0, 350), (-2.6, level + 0.05, 0.4), None, "raft", WOOD)
    for x, z in ((-3.0, 0.2), (-2.3, 0.6), (-2.6, 0.1)):
        s.body(s.box(0.36, 0.36, 0.36), s.material(0.7, 0, 300), (x, level + 0.36, z), None, "load", SKY)
    kinds = [s.sphere(0.22), s.box(0.5, 0.3, 0.4), s.capsule(0.16, 0.4), s.cylinder(0.28, 0.6), s.sphere(0.3)]
    for i in range(15):
        density = (150, 400, 700, 2500, 30)[i % 5]
        angle = 2 * math.pi * i / 15
        s.body(kinds[i % 5], s.material(0.5, 0.2, density),
               (1.2 + 1.6 * math.cos(angle), level + 1.6 + 0.55 * i, -1.4 + 1.0 * math.sin(angle)), any_turn(rng),
               f"{density} kg/m3", YELLOW if density == 30 else VIVID[i % 7])
    return s
