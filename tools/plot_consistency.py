#!/usr/bin/env python3
"""Draws what `./dev bench --consistency --json` has measured: deviation against speed, a panel for each scene.

Usage: ./dev bench --consistency --json > results.json; tools/plot_consistency.py results.json docs/images/consistency.svg
"""
import json
import math
import sys
from pathlib import Path

COLORS = {"cairn": "#2f7d6b", "bullet": "#c9772d", "ode": "#8a5aa8"}
TITLES = {"pile_boxes": "a pile of 27 boxes", "tower": "a tower of 10 boxes", "chain": "a chain of 5 hinges"}
WIDTH, HEIGHT, LEFT, TOP, GAP = 270, 260, 64, 48, 66
FLOOR = 1e-9  # smaller deviations are drawn here, m


def panel(points, x0):
    points = [p for p in points if p["time_step"] > 1.6e-5]  # not the reference itself
    speeds = [math.log10(p["real_time_factor"]) for p in points]
    sizes = [math.log10(max(p["deviation"], FLOOR)) for p in points]
    low_x, high_x = math.floor(min(speeds)), math.ceil(max(speeds))
    low_y, high_y = math.floor(min(sizes)), math.ceil(max(sizes))

    def place(p):
        x = (math.log10(p["real_time_factor"]) - low_x) / (high_x - low_x)
        y = (math.log10(max(p["deviation"], FLOOR)) - low_y) / (high_y - low_y)
        return x0 + WIDTH * x, TOP + HEIGHT * (1 - y)

    for power in range(low_x, high_x + 1):
        x = x0 + WIDTH * (power - low_x) / (high_x - low_x)
        yield f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{TOP + HEIGHT}" stroke="#e2e2e2"/>'
        yield f'<text x="{x:.1f}" y="{TOP + HEIGHT + 16}" text-anchor="middle">{10.0**power:g}</text>'
    for power in range(low_y, high_y + 1):
        y = TOP + HEIGHT * (1 - (power - low_y) / (high_y - low_y))
        yield f'<line x1="{x0}" y1="{y:.1f}" x2="{x0 + WIDTH}" y2="{y:.1f}" stroke="#e2e2e2"/>'
        yield f'<text x="{x0 - 6}" y="{y + 4:.1f}" text-anchor="end">{1000 * 10.0**power:g}</text>'
    for engine in dict.fromkeys(p["engine"] for p in points):
        own = [p for p in points if p["engine"] == engine]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in map(place, own))
        color = COLORS.get(engine, "#666666")
        yield f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="1.5"/>'
        for p in own:
            x, y = place(p)
            yield (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"><title>{engine}, step '
                   f'{1000 * p["time_step"]:g} ms: {1000 * p["deviation"]:.3g} mm, {p["real_time_factor"]:.3g} times '
                   "real time</title></circle>")
            if round(1000 * p["time_step"], 6) in (1, 32):
                yield f'<text x="{x + 5:.1f}" y="{y - 5:.1f}" font-size="9" fill="{color}">{1000 * p["time_step"]:g} ms</text>'


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    points = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))["consistency"]
    scenes = list(dict.fromkeys(p["scene"] for p in points))
    marks = []
    for i, scene in enumerate(scenes):
        x0 = LEFT + i * (WIDTH + GAP)
        marks.append(f'<text x="{x0 + WIDTH / 2}" y="{TOP - 10}" text-anchor="middle" font-size="13">'
                     f"{TITLES.get(scene, scene)}</text>")
        marks += panel([p for p in points if p["scene"] == scene], x0)
        marks.append(f'<text x="{x0 + WIDTH / 2}" y="{TOP + HEIGHT + 34}" text-anchor="middle">times real time</text>')
    middle = TOP + HEIGHT / 2
    marks.append(f'<text x="16" y="{middle}" text-anchor="middle" transform="rotate(-90 16 {middle})">deviation, mm</text>')
    for i, engine in enumerate(dict.fromkeys(p["engine"] for p in points)):
        marks.append(f'<circle cx="{LEFT + 90 * i}" cy="16" r="5" fill="{COLORS.get(engine, "#666666")}"/>'
                     f'<text x="{LEFT + 90 * i + 10}" y="20" font-size="13">{engine}</text>')
    width, height = LEFT + len(scenes) * (WIDTH + GAP), TOP + HEIGHT + 48
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" '
           f'font-size="11"><rect width="100%" height="100%" fill="white"/>' + "".join(marks) + "</svg>\n")
    Path(sys.argv[2]).write_text(svg, encoding="utf-8")


if __name__ == "__main__":
    main()
