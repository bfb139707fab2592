#!/usr/bin/env python3
"""Counts the instructions of steps with fast bodies in them, in worlds where all else rests.

One bullet in a world of 5,000 bodies that are awake may cost 2 %, and 1,000 projectiles at 200 m/s among 10,000 bodies
that sleep no more than what is recorded here. Counts repeat on any machine with the same compiler; times do not.
Usage: impact_cost.py CAIRN_IMPACT_COST
Exit codes: 0 both hold; 1 one does not, or there is an error; 77 there is no valgrind, or this processor has no AVX2.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

BULLET_SHARE = 0.02
PROJECTILES_MILLIONS = 31.1  # millions of instructions per step; 5 % more than the measured 29.6
STEPS = 20
SKIPPED = 77


def count(program, bodies, projectiles, state):
    """Millions of instructions per step."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", "--collect-atstart=no", "--toggle-collect=measured_steps",
                   f"--callgrind-out-file={folder}/out", program, str(bodies), str(projectiles), str(STEPS), state]
        done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "CAIRN_ISA": "avx2"})
        found = re.search(r"Collected : (\d+)", done.stderr)
        if done.returncode != 0 or not found or int(found[1]) == 0:
            raise RuntimeError(f"{' '.join(command)}\nended with {done.returncode}:\n{done.stdout}{done.stderr}")
        return int(found[1]) / STEPS / 1e6


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if not shutil.which("valgrind") or "avx2" not in Path("/proc/cpuinfo").read_text(encoding="ascii").split():
        print("no valgrind, or no AVX2: nothing counted")
        return SKIPPED
    runs = [(5000, 0, "awake"), (5000, 1, "awake"), (10000, 1000, "asleep")]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        without, with_one, projectiles = pool.map(lambda run: count(sys.argv[1], *run), runs)
    share = with_one / without - 1
    print(f"5,000 bodies: {without:.3f} million instructions a step, with a bullet {share:+.2%} (at most {BULLET_SHARE:.0%})")
    print(f"1,000 projectiles among 10,000 bodies: {projectiles:.2f} million (at most {PROJECTILES_MILLIONS})")
    return 0 if share <= BULLET_SHARE and projectiles <= PROJECTILES_MILLIONS else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, RuntimeError) as error:
        sys.exit(f"impact_cost.py: {error}")
