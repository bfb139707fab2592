#!/usr/bin/env python3
"""Runs all models of a folder and says what becomes of them.

usage: tools/models.py PROGRAM FOLDER [--seconds S] [--only PART] [--markdown | --table]

Models are .gltf and .glb files, .xml files of MJCF, .sdf, .world, .urdf and .usda files; those that other models include
are run as well. Each has a verdict:

  rests      nothing moves any more
  parts      bodies that overlap by more than 5 mm as the file has them have pushed each other away
  moves      it moves, and has not gained energy
  falls      nothing is below it: it has the speed of what falls freely
  driven     it moves, and has gained energy that its motors may have given it
  empty      nothing in it can move
  explodes   speeds were cut to the world's limits, or energy came from nowhere
  refused    with the reason
  fails      the program broke off, or took too long

Exit status 1 if any model explodes or fails.
"""
import argparse
import csv
import io
import json
import pathlib
import re
import subprocess
import sys

KINDS = {".xml": "MJCF", ".sdf": "SDF", ".world": "SDF", ".urdf": "URDF", ".usda": "USD", ".gltf": "glTF", ".glb": "glTF"}
PATIENCE = 120  # s
# Energy that servos, springs and keyframes may add, relative to the kinetic energy of the model.
TOLERANCE = 0.05
REST, NOISE = 1e-3, 0.05  # J
OVERLAP = 5e-3  # m


def is_model(path):
    """Whether the file is a complete model, and not a part of one."""
    text = path.read_bytes()[:20000]
    if path.suffix == ".xml":
        return b"<mujoco" in text and b"<mujocoinclude" not in text
    if path.suffix == ".usda":
        return b"Physics" in path.read_bytes()
    return True


def energies(program, path, seconds):
    """(kinetic, potential) after each step, the overlap at the start, the messages, and the exit status."""
    command = [program, "run", path.name, "--seconds", str(seconds), "--csv", "-", "--columns", "energy,contacts"]
    done = subprocess.run(command, cwd=path.parent, capture_output=True, text=True, timeout=PATIENCE)
    rows = list(csv.DictReader(io.StringIO(done.stdout))) if done.returncode == 0 else []
    overlap = max([float(row["max_penetration"]) for row in rows[:3]], default=0.0)
    return [(float(row["kinetic"]), float(row["potential"])) for row in rows], overlap, done.stderr, done.returncode


def is_driven(program, path):
    """Whether its glTF form has motors or springs."""
    done = subprocess.run([program, "convert", path.name, "/dev/stdout"], cwd=path.parent, capture_output=True)
    return b'"drives"' in done.stdout or b'"motor"' in done.stdout


def verdict(program, path, seconds):
    try:
        steps, overlap, said, status = energies(program, path, seconds)
    except subprocess.TimeoutExpired:
        return "fails", f"more than {PATIENCE} s"
    lines = said.strip().splitlines()
    if status == 1:
        return "refused", lines[-1].removeprefix("cairn: ") if lines else ""
    if status != 0 or not steps:
        return "fails", f"exit status {status}"
    if any("speeds were cut" in line for line in lines):
        return "explodes", "speeds were cut"
    totals = [kinetic + potential for kinetic, potential in steps]
    if any(total != total for total in totals):
        return "explodes", "not a number"
    moved = max(kinetic for kinetic, _ in steps)
    moved = max(moved, max(p for _, p in steps) - min(p for _, p in steps))
    gain = max(totals) - totals[0]
    if moved < NOISE and steps[-1][0] < REST:
        return ("rests", "as it stands") if moved > 0 else ("empty", "")
    if gain > TOLERANCE * moved + NOISE:
        if overlap > OVERLAP:
            return "parts", f"{1000 * overlap:.3g} mm"
        return ("driven", f"{gain:.3g} J") if is_driven(program, path) else ("explodes", f"{gain:.3g} J from nowhere")
    if steps[-1][0] < REST:
        return "rests", ""
    lost = totals[0] - totals[-1]
    if steps[-1][0] == max(k for k, _ in steps) and abs(lost) < 0.02 * moved and moved > 100 * NOISE:
        return "falls", ""
    return "moves", ""


def in_runs(names):
    """Sorted names; three or more consecutive numbers become "a_00 to a_35"."""
    runs = []
    for name in names:
        stem, number = re.fullmatch(r"(.*?)(\d*)", name).groups()
        last = runs[-1][-1] if runs else None
        if last and number and last[0] == stem and last[1] and int(last[1]) + 1 == int(number):
            runs[-1].append((stem, number))
        else:
            runs.append([(stem, number)])
    texts = [[stem + number for stem, number in run] for run in runs]
    return ", ".join(f"{run[0]} to {run[-1]}" if len(run) > 2 else ", ".join(run) for run in texts)


def print_groups(groups):
    words = [line.split()[0] for line in __doc__.splitlines() if line.startswith("  ")]
    print("| format | folder | verdict | number | models |\n|---|---|---|---|---|")
    for (kind, folder, word), paths in sorted(groups.items(), key=lambda item: (*item[0][:2], words.index(item[0][2]))):
        suffixes = {path.stem: [other.suffix for other in paths if other.stem == path.stem] for path in paths}
        names = [stem + ("" if len(found) == 1 else f" ({', '.join(found)})") for stem, found in sorted(suffixes.items())]
        print(f"| {kind} | {folder} | {word} | {len(paths)} | {in_runs(names)} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seconds", type=float, default=5.0)
    parser.add_argument("--only", default="", help="paths with this part only")
    parser.add_argument("--markdown", action="store_true", help="a table with a row for each model")
    parser.add_argument("--table", action="store_true", help="a table with a row for each folder and verdict")
    options = parser.parse_args()
    program = str(pathlib.Path(options.program).resolve())
    counts, groups = {}, {}
    if options.markdown:
        print("| format | model | verdict |\n|---|---|---|")
    for path in sorted(options.folder.rglob("*")):
        name = str(path.relative_to(options.folder))
        if path.suffix not in KINDS or not path.is_file() or options.only not in name or not is_model(path):
            continue
        word, why = verdict(program, path, options.seconds)
        counts[word] = counts.get(word, 0) + 1
        text = word + (f": {why}" if why else "")
        if options.table:
            groups.setdefault((KINDS[path.suffix], name.split("/")[0], word), []).append(path)
            continue
        print(f"| {KINDS[path.suffix]} | {name} | {text} |" if options.markdown else f"{text:40} {name}", flush=True)
    if options.table:
        print_groups(groups)
    print(json.dumps(counts), file=sys.stderr)
    return 1 if counts.get("explodes") or counts.get("fails") else 0


if __name__ == "__main__":
    sys.exit(main())
