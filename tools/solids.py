"""Points and triangles of solids for the scenes. Triangles are counterclockwise as seen from outside."""

import math


def polyhedra():
    """The vertices of the five regular solids, each at distance 1 from the center."""
    golden = (1 + math.sqrt(5)) / 2
    cyclic = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]

    def turned(points):
        return [tuple(p[k] for k in order) for p in points for order in cyclic]

    signs = (-1, 1)
    cube = [(x, y, z) for x in signs for y in signs for z in signs]
    octahedron = turned([(s, 0, 0) for s in signs])
    icosahedron = turned([(0, x, y * golden) for x in signs for y in signs])
    dodecahedron = cube + turned([(0, x / golden, y * golden) for x in signs for y in signs])
    tetrahedron = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
    solids = [tetrahedron, cube, octahedron, dodecahedron, icosahedron]
    return [scaled(points, 1 / math.dist(points[0], (0, 0, 0))) for points in solids]


def scaled(points, factor):
    return [tuple(factor * c for c in p) for p in points]


def on_circle(radius, height, count, phase=0.0):
    """Points of a horizontal circle; phase in steps."""
    angles = [2 * math.pi * (i + phase) / count for i in range(count)]
    return [(radius * math.cos(a), height, radius * math.sin(a)) for a in angles]


def revolved(profile, count):
    """The surface of revolution of a profile of (radius, height) about the y axis: vertices and triangles. The outside
    is to the right of the direction of the profile (radius to the right, height up)."""
    vertices = [p for radius, height in profile for p in on_circle(radius, height, count)]
    triangles = []
    for k in range(len(profile) - 1):
        for i in range(count):
            a, b = k * count + i, k * count + (i + 1) % count
            c, d = b + count, a + count
            if profile[k][0] > 0:
                triangles.append((a, c, b))
            if profile[k + 1][0] > 0:
                triangles.append((a, d, c))
    return vertices, triangles


class Triangles:
    """Collects the triangles of one mesh."""

    def __init__(self):
        self.vertices, self.triangles = [], []

    def polygon(self, corners):
        """Adds a flat convex polygon."""
        first = len(self.vertices)
        self.vertices += corners
        self.triangles += [(first, first + i - 1, first + i) for i in range(2, len(corners))]

    def box(self, low, high):
        corner = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
        for face in ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)):
            self.polygon([corner[i] for i in face])

    def extruded(self, profile, near, far):
        """Adds the solid below a profile of (x, y) from left to right, down to y = 0, from z = near to z = far <
        near."""
        for (x0, y0), (x1, y1) in zip(profile, profile[1:]):
            self.polygon([(x0, y0, near), (x1, y1, near), (x1, y1, far), (x0, y0, far)])
            if x1 > x0:
                self.polygon([(x0, 0, near), (x1, 0, near), (x1, y1, near), (x0, y0, near)])
                self.polygon([(x1, 0, far), (x0, 0, far), (x0, y0, far), (x1, y1, far)])
