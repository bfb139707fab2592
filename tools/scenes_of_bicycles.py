"""A scene of riderless bicycles."""

import math

import joints
from scene_writer import BLUE, GREEN, RED, STONE, Scene, turn
from scenes_of_joints import along

# The benchmark of J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab, Proc. R. Soc. A 463 (2007). x is
# forward.
TILT, BASE, TRAIL, REAR, FRONT = math.pi / 10, 1.02, 0.08, 0.3, 0.35


def moments(mass, xx, yy, zz, xy):
    """Members of a motion; the moments of inertia are about the axes of the bicycle."""
    angle = 0.5 * math.atan2(2 * xy, xx - yy)
    c, s = math.cos(angle), math.sin(angle)
    return {"mass": mass, "centerOfMass": [0, 0, 0],
            "inertiaDiagonal": [round(xx * c * c + 2 * xy * c * s + yy * s * s, 6),
                                round(xx * s * s - 2 * xy * c * s + yy * c * c, 6), zz],
            "inertiaOrientation": [0, 0, round(math.sin(angle / 2), 8), round(math.cos(angle / 2), 8)]}


def bicycle(s, place, speed, lean, color, name):
    """A bicycle that rides at that speed on a belt moving backwards at the same speed; `lean`: its initial roll rate,
    rad/s."""
    x0, y0, z0 = place
    rubber, paint = s.material(1, 0, 1000, torsional=0), s.material(0.5, 0, 1000)
    dark, metal, skin = "#23272E", "#C3C9CE", "#D9B99B"

    def part(points, radius, paint_color, middle):
        """A tube between two points (x, y, z) of the bicycle, in the frame of the body there."""
        center, spin, length = along(*points)
        return s.capsule(radius, length), [p - q for p, q in zip(center, middle)], paint_color, spin

    def body(parts, middle, motion, spin=0):
        x, y, z = middle
        return s.compound(parts, paint, (x0 + x, y0 + y, z0 + z), None, name, linearVelocity=[0, 0, round(lean * y, 6)],
                          angularVelocity=[lean, 0, round(-spin, 6)], **motion)

    def wheel(x, radius, mass, across, axial):
        half = 0.015  # the sharp rim, in the central plane, is the larger end of a cone
        tire = s.cylinder(radius, 2 * half, 0.94 * radius)
        parts = [(tire, (0, 0, half), dark, turn("x", 90)),
                 (s.box(1.7 * radius, 0.04, 0.036), (0, 0, half), metal), (s.box(0.04, 1.7 * radius, 0.036), (0, 0, half), metal)]
        return s.compound(parts, rubber, (x0 + x, y0 + radius, z0), None, name, linearVelocity=[0, 0, round(lean * radius, 6)],
                          angularVelocity=[lean, 0, round(-speed / radius, 6)], **moments(mass, across, across, axial, 0))

    rear, front = wheel(0, REAR, 2, 0.0603, 0.12), wheel(BASE, FRONT, 3, 0.1405, 0.28)
    head, saddle, crank = (0.8, 0.95, 0), (0.25, 0.95, 0), (0.4, 0.3, 0)
    frame = body([part((saddle, crank), 0.02, color, (0.3, 0.9, 0)), part((crank, head), 0.022, color, (0.3, 0.9, 0)),
                  part((saddle, head), 0.02, color, (0.3, 0.9, 0)),
                  part(((0, REAR, 0.05), (0.25, 0.9, 0.05)), 0.014, color, (0.3, 0.9, 0)),
                  part(((0, REAR, -0.05), (0.25, 0.9, -0.05)), 0.014, color, (0.3, 0.9, 0)),
                  part(((0, REAR, 0.05), (0.4, 0.3, 0.05)), 0.014, color, (0.3, 0.9, 0)),
                  part(((0, REAR, -0.05), (0.4, 0.3, -0.05)), 0.014, color, (0.3, 0.9, 0)),
                  part(((0.22, 1.0, 0), (0.35, 1.42, 0)), 0.13, skin, (0.3, 0.9, 0)),
                  (s.sphere(0.12), (0.12, 0.8, 0), skin),
                  (s.box(0.26, 0.05, 0.14), (-0.06, 0.08, 0), dark)],
                 (0.3, 0.9, 0), moments(85, 9.2, 2.8, 11, -2.4))
    # The steering axis intersects the ground ahead of the front wheel's contact point.
    on_axis = [(BASE + TRAIL - y * math.tan(TILT), y) for y in (0.55, 1.08)]
    fork = body([part(((BASE, FRONT, side * 0.05), (*on_axis[0], side * 0.05)), 0.014, metal, (0.9, 0.7, 0)) for side in (-1, 1)]
                + [part(((*on_axis[0], 0), (*on_axis[1], 0)), 0.02, metal, (0.9, 0.7, 0)),
                   part(((on_axis[1][0], on_axis[1][1], -0.28), (on_axis[1][0], on_axis[1][1], 0.28)), 0.016, dark, (0.9, 0.7, 0))],
                (0.9, 0.7, 0), moments(4, 0.05892, 0.00708, 0.06, 0.00756))
    s.joint(frame, rear, joints.hinge(), (x0, y0 + REAR, z0), "z")
    s.joint(fork, front, joints.hinge(), (x0 + BASE, y0 + FRONT, z0), "z")
    s.joint(frame, fork, joints.hinge(), (x0 + BASE + TRAIL - 0.9 * math.tan(TILT), y0 + 0.9, z0),
            (math.sin(TILT), -math.cos(TILT), 0))


def bicycles():
    s = Scene("Bicycles on treadmills",
              "Nobody steers. From 4.3 to 6 m/s a bicycle rights itself; slower it weaves until it falls, faster it leans ever "
              "further. Drag one to push it.",
              (5.6, 2.7, 8.4), (0.3, 0.6, 0.9), 40, sleep=False)
    s.ground(0.8, 0.0, "#7A8078")
    for speed, z, color in ((3, -4.4, RED), (5, 0, GREEN), (8, 4.4, BLUE)):
        belt = s.material(1, 0, 1000, torsional=0, belt=(-speed, 0, 0))
        s.fixed(s.box(6, 0.3, 4), belt, (0.5, 0.15, z), None, f"treadmill at {speed} m/s", STONE)
        bicycle(s, (0, 0.3, z), speed, 0.04, color, f"bicycle at {speed} m/s")
    return s
