#!/usr/bin/env python3
"""Counts the instructions of World::step in short runs of shipped scenes, and of a heap that has settled but may not
sleep, and compares them with the recorded figures.

Unlike times, counts repeat on any machine with the same compiler, so that a change that makes the step slower shows at
once. Changes of a few percent add up when the figures are renewed, so the least figure that a scene ever had is kept as
well: it is lowered, but never raised. Usage: instruction_counts.py CAIRN [--renew]
Exit codes: 0 none has grown by more than 5 %, nor by more than 65 % since its least; 1 one has, or there is an error;
77 this processor has no AVX2.
"""
import json
import os
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from scene_writer import Scene
from scenes_of_boxes import scatter

ROOT = Path(__file__).resolve().parent.parent
RECORDED = ROOT / "bench" / "instruction_counts.json"
SCENES = {"07_pyramid": 60, "13_pile": 150, "14_avalanche": 90}  # numbers of steps
HEAP = "heap at rest"
HEAP_STEPS = 500, 600  # the cost of the steps between these is counted
MOST_GROWTH = 0.05
MOST_SINCE_LEAST = 0.65
NO_AVX2 = 77


def write_heap(path):
    """Writes a scene with 240 boxes and balls that fall into a narrow pit, and may not sleep."""
    s = Scene("Heap", "", (8, 8, 8), (0, 1, 0), sleep=False)
    s.ground(0.5)
    s.walls(3, 3, 4, 0.4, s.material(0.5))
    scatter(s, random.Random(13), 240, 4, 0.7, 0.8, s.material(0.5), (0.25, 0.38), 0.03)
    s.write(path)


def count(cairn, scene, steps):
    """The total number of instructions of all steps."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", "--collect-atstart=no", "--toggle-collect=cairn::World::step(float)",
                   f"--callgrind-out-file={folder}/out", str(cairn), "run", str(scene), "--frames", str(steps),
                   "--threads", "1"]
        done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "CAIRN_ISA": "avx2"})
        found = re.search(r"Collected : (\d+)", done.stderr)
        if done.returncode != 0 or not found or int(found[1]) == 0:
            raise RuntimeError(f"{' '.join(command)}\nended with {done.returncode}:\n{done.stdout}{done.stderr}")
        return int(found[1])


def count_all(cairn):
    """The number of instructions for each scene."""
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        heap = Path(folder) / "heap.gltf"
        write_heap(heap)
        runs = [(ROOT / "scenes" / f"{scene}.gltf", steps) for scene, steps in SCENES.items()]
        runs += [(heap, steps) for steps in HEAP_STEPS]
        counts = list(pool.map(lambda run: count(cairn, *run), runs))
    return {**dict(zip(SCENES, counts)), HEAP: counts[-1] - counts[-2]}


def main():
    arguments = [a for a in sys.argv[1:] if a != "--renew"]
    if len(arguments) != 1:
        sys.exit(__doc__)
    if "avx2" not in Path("/proc/cpuinfo").read_text(encoding="ascii").split():
        print("this processor has no AVX2: nothing counted")
        return NO_AVX2
    counts = count_all(arguments[0])
    figures = json.loads(RECORDED.read_text(encoding="ascii"))
    if "--renew" in sys.argv:
        figures["recorded"] = counts
        figures["least"] = {scene: min(now, figures["least"].get(scene, now)) for scene, now in counts.items()}
        RECORDED.write_text(json.dumps(figures, indent=4) + "\n", encoding="ascii")
    recorded, least = figures["recorded"], figures["least"]
    grown, crept = [], []
    print(f"{'scene':<14}{'steps':>8}{'recorded':>15}{'now':>15}{'change':>9}{'least ever':>15}{'since':>9}")
    steps = {**SCENES, HEAP: f"{HEAP_STEPS[0] + 1}-{HEAP_STEPS[1]}"}
    for scene, now in counts.items():
        change = now / recorded[scene] - 1
        since = now / least[scene] - 1
        print(f"{scene:<14}{steps[scene]:>8}{recorded[scene]:>15,}{now:>15,}{change:>+9.1%}"
              f"{least[scene]:>15,}{since:>+9.1%}")
        if change > MOST_GROWTH:
            grown.append(scene)
        if since > MOST_SINCE_LEAST:
            crept.append(scene)
    if grown:
        print(f"more than {MOST_GROWTH:.0%} more instructions: {', '.join(grown)}. If that is meant, renew the figures "
              f"({RECORDED.relative_to(ROOT)}) with ./dev bench --quick --renew and say why in the commit.")
    if crept:
        print(f"more than {MOST_SINCE_LEAST:.0%} more instructions than the least ever: {', '.join(crept)}. Renewing does "
              "not change this: find what the changes since then cost, and what of it is needed.")
    return 1 if grown or crept else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, RuntimeError, KeyError) as error:
        sys.exit(f"instruction_counts.py: {error}")
