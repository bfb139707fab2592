#!/usr/bin/env python3
"""Draws what `./dev bench --json` has measured: ms per step by scene and engine, as bars on a logarithmic axis.

Usage: ./dev bench --json > results.json; tools/plot_benchmarks.py results.json docs/images/benchmarks.svg
"""
import json
import math
import sys
from pathlib import Path

COLORS = {"cairn": "#2f7d6b", "bullet": "#c9772d", "ode": "#8a5aa8"}
BAR, GAP, LEFT, TOP, WIDTH = 13, 12, 130, 40, 560


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    results = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))["results"]
    scenes = list(dict.fromkeys(r["scene"] for r in results))
    times = [r["mean_ms"] for r in results]
    low, high = math.floor(math.log10(min(times))), math.ceil(math.log10(max(times)))

    def at(milliseconds):
        return LEFT + WIDTH * (math.log10(milliseconds) - low) / (high - low)

    marks, y = [], TOP
    for scene in scenes:
        rows = [r for r in results if r["scene"] == scene]
        marks.append(f'<text x="{LEFT - 8}" y="{y + BAR * len(rows) / 2 + 4:.0f}" text-anchor="end">{scene}</text>')
        for r in rows:
            color = COLORS.get(r["engine"], "#666666")
            threads = f", {r['threads']} threads" if r["threads"] > 1 else ""
            marks.append(f'<rect x="{LEFT}" y="{y}" width="{at(r["mean_ms"]) - LEFT:.1f}" height="{BAR - 2}" '
                         f'fill="{color}" fill-opacity="{0.65 if threads else 1}"/>')
            marks.append(f'<text x="{at(r["mean_ms"]) + 4:.1f}" y="{y + BAR - 3}" font-size="10">'
                         f'{r["mean_ms"]:.3g} ms {r["engine"]}{threads}</text>')
            y += BAR
        y += GAP
    for power in range(low, high + 1):
        x = at(10.0**power)
        marks.insert(0, f'<line x1="{x:.1f}" y1="{TOP - 6}" x2="{x:.1f}" y2="{y}" stroke="#dddddd"/>'
                        f'<text x="{x:.1f}" y="{TOP - 12}" text-anchor="middle" font-size="10">{10.0**power:g} ms</text>')
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{LEFT + WIDTH + 150}" height="{y + 8}" '
           f'font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="white"/>'
           + "".join(marks) + "</svg>\n")
    Path(sys.argv[2]).write_text(svg, encoding="utf-8")


if __name__ == "__main__":
    main()
