#!/usr/bin/env python3
"""Runs the same scenes on every compiler, instruction set and number of threads, and compares the hashes of their states.

usage: tools/determinism.py [--only CELL,...] [--packages] [--jobs N]
  --only      the cells to build and run (gcc, v4, clang, aarch64, mingw, wasm); all by default
  --packages  print the Debian packages that those cells need, and do nothing else
  --jobs      of the compiler, and programs that run at a time (as many as the machine has cores)

Builds the engine and the program cairn_hashes of each cell in build/, runs it, and prints one table.
Exit status 1 if any two hashes of a scene differ, or if a cell cannot be built or run. See docs/determinism.md.
"""
import argparse
import concurrent.futures
import dataclasses
import datetime
import os
import pathlib
import platform
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
STEPS = 600


@dataclasses.dataclass(eq=False)
class Cell:
    """One build, and the programs that are run with it."""

    name: str
    preset: str  # of CMakePresets.json
    packages: list  # in addition to those of ./dev build
    compiler: str
    kernels: dict  # instruction set -> numbers of threads
    run: list = dataclasses.field(default_factory=list)  # prefix of the command, for example an emulator
    program: str = "cairn_hashes"
    environment: dict = dataclasses.field(default_factory=dict)
    needs_cpu: str = ""  # a flag of /proc/cpuinfo that all of its kernels need


NEEDED_FLAGS = {"avx2": "avx2", "avx512": "avx512vl"}  # flags of /proc/cpuinfo that kernels need

CELLS = [
    Cell("gcc", "release", [], "c++",
         {"scalar": [1], "sse2": [1, 4], "avx2": [1, 2, 3, 4, 5, 6, 7, 8], "avx512": [1, 4]}),
    Cell("v4", "v4", [], "c++", {"avx2": [1, 4]}, needs_cpu="avx512vl"),
    Cell("clang", "clang", ["clang"], "clang++", {"scalar": [1], "sse2": [1], "avx2": [1, 4], "avx512": [1]}),
    Cell("aarch64", "aarch64", ["g++-aarch64-linux-gnu", "qemu-user"], "aarch64-linux-gnu-g++",
         {"scalar": [4], "neon": [1]}, run=["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"]),
    Cell("mingw", "mingw", ["g++-mingw-w64-x86-64", "wine64"], "x86_64-w64-mingw32-g++-posix",
         {"scalar": [1], "sse2": [1], "avx2": [1, 4], "avx512": [1]}, run=["/usr/lib/wine/wine64"], program="cairn_hashes.exe",
         environment={"WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml,winemenubuilder.exe=",
                      "WINEPREFIX": str(ROOT / "build" / "mingw" / "wine")}),
    Cell("wasm", "wasm", ["emscripten", "nodejs"], "em++", {"simd128": [1, 4]},
         run=["node", "--no-experimental-fetch"], program="cairn_hashes.js",
         environment={"NODE_PATH": "/usr/share/nodejs"}),
]


class Failed(Exception):
    """A cell that could not be built or run."""


def cpu_flags():
    text = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    return set(re.search(r"^(?:flags|Features)\s*:(.*)$", text, re.M).group(1).split())


def command(arguments, environment, what):
    """The output of a command; if it fails, the exception contains its last lines."""
    result = subprocess.run(arguments, cwd=ROOT, env={**os.environ, **environment}, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
    if result.returncode != 0:
        tail = "\n".join(result.stdout.splitlines()[-15:])
        raise Failed(f"{what}: exit status {result.returncode}\n  {' '.join(arguments)}\n{tail}")
    return result.stdout


def build(cell, jobs):
    print(f"building {cell.name}", file=sys.stderr, flush=True)
    command(["cmake", "--preset", cell.preset], cell.environment, f"configuring {cell.name}")
    command(["cmake", "--build", f"build/{cell.preset}", "--target", "cairn_hashes", "-j", str(jobs)],
            cell.environment, f"building {cell.name}")


def run(cell, kernels, threads):
    """The hashes of all scenes, by name."""
    what = f"running {cell.name} {kernels} with {threads} threads"
    print(what, file=sys.stderr, flush=True)
    program = f"build/{cell.preset}/bin/{cell.program}"
    text = command([*cell.run, program, "--threads", str(threads), "--steps", str(STEPS)],
                   {**cell.environment, "CAIRN_ISA": kernels}, what)
    lines = text.split("\n")
    if lines[0].strip() != kernels:
        raise Failed(f"{what}: it says that it runs {lines[0].strip()!r}")
    hashes = dict(re.findall(rf"^(\w+) {STEPS} ([0-9a-f]{{16}})\s*$", text, re.M))
    if len(hashes) != len([line for line in lines[1:] if line.strip()]):
        raise Failed(f"{what}: it prints something else than hashes:\n{text[:2000]}")
    return hashes


def run_all(cells, flags, jobs):
    """(cell, kernels, threads) -> scene -> hash, in the order of the cells."""
    runs = [(cell, kernels, threads) for cell in cells for kernels, counts in cell.kernels.items() for threads in counts
            if not (cell.name in ("gcc", "clang", "mingw") and kernels in NEEDED_FLAGS
                    and NEEDED_FLAGS[kernels] not in flags)]
    for cell in cells:
        if "WINEPREFIX" in cell.environment:  # the prefix is created by one program before several start
            command([*cell.run, "wineboot", "-i"], cell.environment, "setting up wine")
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        futures = {key: pool.submit(run, *key) for key in sorted(runs, key=slowness)}
        try:
            return {(key[0].name, *key[1:]): futures[key].result() for key in runs}
        except Failed:
            pool.shutdown(cancel_futures=True)
            raise


def slowness(key):
    """Sort key: the slowest runs first, so that none of them is started last."""
    cell, kernels, _ = key
    return [cell.name != "aarch64", kernels != "scalar"]


def version(cell):
    return command([cell.compiler, "--version"], cell.environment, cell.name).splitlines()[0].strip()


def print_table(cells, results, notes):
    columns = [(cell, kernels, counts) for cell in cells for kernels, counts in cell.kernels.items()
               if (cell.name, kernels, counts[0]) in results]
    scenes = list(next(iter(results.values())))
    width = max(map(len, scenes))

    def row(first, texts):
        print(first.ljust(width) + "".join(text.rjust(9) for text in texts).rstrip())

    print(f"{datetime.date.today()}, {platform.machine()}, {STEPS} steps; the first 8 of the 16 digits of each hash")
    for cell in cells:
        print(f"{cell.name:8} {version(cell)}")
    print("\n".join(notes))
    print()
    titles = [cell.name if i == 0 or columns[i - 1][0] is not cell else "" for i, (cell, _, _) in enumerate(columns)]
    row("compiler", titles)
    row("kernels", [kernels for _, kernels, _ in columns])
    row("threads", [",".join(map(str, counts)) if len(counts) < 5 else f"{counts[0]}-{counts[-1]}"
                    for _, _, counts in columns])
    different, compared = [], 0
    for scene in scenes:
        hashes = {key: result.get(scene, "missing") for key, result in results.items()}
        compared = len(hashes)
        # The most frequent hash is taken to be the correct one.
        right = max(set(hashes.values()), key=lambda value: (list(hashes.values()).count(value), value))
        texts = []
        for cell, kernels, counts in columns:
            found = [hashes[(cell.name, kernels, threads)] for threads in counts]
            odd = [value for value in found if value != right]
            texts.append(odd[0][:7] + "*" if odd else right[:8])
        row(scene, texts)
        different += [f"{scene}: {name} {kernels} with {threads} threads has {value} instead of {right}"
                      for (name, kernels, threads), value in hashes.items() if value != right]
    print()
    if different:
        print("\n".join(different))
        print("NOT the same; see docs/determinism.md for how to find the step where two of them part")
        return 1
    print(f"all {compared} hashes of each scene are the same")
    return 0


def main():
    parser = argparse.ArgumentParser(usage=argparse.SUPPRESS, description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="")
    parser.add_argument("--packages", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    names = [name for name in arguments.only.split(",") if name]
    unknown = set(names) - {cell.name for cell in CELLS}
    if unknown:
        parser.error(f"no cell {', '.join(sorted(unknown))}; there are {', '.join(cell.name for cell in CELLS)}")
    cells = [cell for cell in CELLS if not names or cell.name in names]
    if arguments.packages:
        print(*sorted({package for cell in cells for package in cell.packages}))
        return 0
    flags, notes = cpu_flags(), ["There are no kernels of 16 lanes: avx512 has 8, and v4 is all of the engine "
                                 "compiled with -march=x86-64-v4."]
    for cell in [cell for cell in cells if cell.needs_cpu and cell.needs_cpu not in flags]:
        if names:
            print(f"determinism: {cell.name}: this processor has no {cell.needs_cpu}", file=sys.stderr)
            return 1
        notes.append(f"Not run: {cell.name}, because this processor has no {cell.needs_cpu}.")
        cells.remove(cell)
    notes += [f"Not run: the kernels {kernels}, because this processor has no {flag}."
              for kernels, flag in NEEDED_FLAGS.items() if flag not in flags]
    try:
        for cell in cells:
            build(cell, arguments.jobs)
        results = run_all(cells, flags, arguments.jobs)
        return print_table(cells, results, notes)
    except (Failed, OSError) as failure:
        print(f"determinism: {failure}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
