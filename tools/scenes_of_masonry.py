"""A scene of stone structures that stand by their shape alone."""

import math

from scene_writer import RED, SKY, STONE, WOOD, Scene, blend, turn


def arch(s, material, radius, thickness, depth, stones, z, color):
    """A semicircular arch of wedges; thickness is relative to the radius of its center line."""
    angle = math.pi / stones
    low, high = 1 - thickness / 2, 1 + thickness / 2
    center = (1 + thickness ** 2 / 12) * math.cos(angle / 2)
    # Each stone is upright in the file, so that all stones of an arch share one shape.
    stone = s.hull([(radius * r * math.sin(a), radius * (r * math.cos(a) - center), side * depth / 2)
                    for r in (low, high) for a in (-angle / 2, angle / 2) for side in (-1, 1)])
    for i in range(stones):
        middle = (i + 0.5) * angle
        s.body(stone, material, (radius * center * math.cos(middle), radius * center * math.sin(middle), z),
               turn("z", math.degrees(middle) - 90), f"arch of {thickness}",
               blend(color, "#FFFFFF", 0.25 if i % 2 else 0))


def arches():
    s = Scene("Arches",
              "Half circles of 25 stones, 0.085, 0.1, 0.115 and 0.15 of their radius thick. Stones that cannot slide stand from "
              "0.107 on, where a line of thrust fits into the arch. P shoots a box at them.",
              (7.4, 4.6, 10.4), (0, 1.5, 0), substeps=128)
    s.ground(0.8, 0, "#7D8471")
    stone = s.material(0.8, 0, 2400)
    for i, thickness in enumerate((0.085, 0.1, 0.115, 0.15)):
        arch(s, stone, 2.2, thickness, 0.9, 25, 3.3 - 2.2 * i, RED if thickness < 0.107 else STONE)
    # Planks that overhang an edge by 1/2, 1/4, 1/6 ... of their length; those of the other stack by a twentieth more.
    wood, half, planks = s.material(0.6, 0, 600), 0.8, 8
    for x, part in ((-5.2, 0.97), (5.2, 1.05)):
        side = 1 if x < 0 else -1
        s.fixed(s.box(1.2, 1.6, 0.9), wood, (x - side * 0.6, 0.8, 0), None, "table", "#6B5A48")
        over = 0
        for k in range(planks):
            over += part * half / (planks - k)
            s.body(s.box(2 * half, 0.12, 0.7), wood, (x + side * (over - half), 1.6 + 0.12 * k + 0.06, 0), None, "plank",
                   blend(WOOD, SKY if part < 1 else RED, k / planks))
    return s
