#!/usr/bin/env python3
"""Builds a project of somebody else's, with Cairn along with it, from nothing, and says what that takes.

usage: tools/first_build.py [--limit SECONDS] [--slowest N] [--generator NAME] [CMAKE OPTIONS]

The project is tests/consumer: the README's lines with FetchContent. No cache of the compiler's helps. Of the processor's time
and that of a clock the first is the one to compare: it hardly depends on what else the machine does. Exit status 1 if it is
more than the limit, 120 s: a minute on two cores. --slowest lists the files that take longest, as the clock had them.
"""
import argparse
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


def slowest_files(folder, count):
    """(seconds, file) of the files that ninja built."""
    times = []
    for line in (folder / ".ninja_log").read_text().splitlines()[1:]:
        begin, end, _, name, _ = line.split("\t")
        times.append(((int(end) - int(begin)) / 1000, name))
    return sorted(times, reverse=True)[:count]


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("--limit", type=float, default=120)
    parser.add_argument("--slowest", type=int, default=0)
    parser.add_argument("--generator", default="Ninja")
    options, others = parser.parse_known_args()
    environment = dict(os.environ, CCACHE_DISABLE="1")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        started = time.monotonic()
        for command in (["cmake", "-S", ROOT / "tests/consumer", "-B", folder, "-G", options.generator, "-DCMAKE_BUILD_TYPE=Release",
                         f"-DCAIRN_SOURCE={ROOT}"] + others,
                        ["cmake", "--build", folder, "-j", str(os.cpu_count())],
                        [folder / "consumer"]):
            done = subprocess.run(command, env=environment, capture_output=True, text=True)
            if done.returncode != 0:
                sys.exit(f"{done.stdout}\n{done.stderr}")
        clock = time.monotonic() - started
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        processor = children.ru_utime + children.ru_stime
        print(f"{done.stdout.strip()}\n{processor:.0f} s of processor time, {clock:.0f} s of a clock")
        if options.slowest:
            for seconds, file in slowest_files(folder, options.slowest):
                print(f"{seconds:8.2f} s  {file}")
    return processor > options.limit


if __name__ == "__main__":
    sys.exit(main())
