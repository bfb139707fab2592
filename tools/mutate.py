#!/usr/bin/env python3
"""Gives the program mutated files of each format that it reads, and says where it did worse than refuse them.

usage: tools/mutate.py PROGRAM [--count N] [--seed S] [--formats gltf,mcap,...] [--only FORMAT:NUMBER] [--keep FOLDER]

Each file is a known good one with a few changes: bytes turned over, taken out, put in, doubled or cut off, numbers made
extreme, words and lines exchanged. The seed and the number of a file decide all of it, so that `--only gltf:1234` makes that
file again. The program must take the file, or refuse it in one line that begins with "cairn: " and with exit status 1; its
numbers must be numbers; and both must happen within 10 s of processor time and 1 GiB of memory.

Exit status 1 if any file did worse; that file then lies in the folder `--keep` (build/mutated).
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
CORPUS = ROOT / "tests/fuzz/corpus"
SECONDS = 10  # processor time, s
PATIENCE = 60  # wall-clock time, s; the machine may do other work too
MEMORY = 1 << 30  # resident memory of a process, bytes
ADDRESSES = 4 << 30  # address space, bytes: larger requests fail

# The prefix that the fuzz target of each of these folders adds to a file, and the number of bytes in which it encodes
# its choices.
BEGINNINGS = {"mjcf": (b"<mujoco", 0), "sdf": (b"<sdf", 0), "usd": (b"#usda 1.0\n", 0), "urdf": (b"<", 0), "mesh_file": (b"", 1)}
RUN = ["run", "FILE", "--frames", "3", "--threads", "1", "--json"]
CONVERT = ["convert", "FILE", "OUT.gltf"]
# For each format: the valid files, and the commands that a mutated file is given to.
FORMATS = {
    "gltf": (["scene/*.gltf", "../../../scenes/0[2568]_*.gltf", "../../../scenes/32_*.gltf"], RUN),
    "glb": (["scene/*.glb"], RUN),
    "urdf": (["urdf/*.urdf", "../../scene/data/*.urdf"], RUN + ["--fixed-base", "--floor"]),
    "mjcf": (["mjcf/*.xml"], RUN),
    "sdf": (["sdf/*.sdf"], RUN),
    "usd": (["usd/*.usda"], RUN),
    "obj": (["mesh_file/*.obj"], CONVERT),
    "stl": (["mesh_file/*.stl"], CONVERT + ["--decompose"]),
    "targets": (["targets/*.csv"], ["run", str(ROOT / "tests/scene/data/arm.urdf"), "--fixed-base", "--targets", "FILE"] + RUN[2:]),
    "recording": (["recording/*.mcap"], ["replay", "FILE", "--threads", "1", "--json"]),
    "plan": (["plan/*.json"], ["sweep", "FILE", "--check", "--threads", "1"]),
    "measurements": (["measurements/*.csv"], ["fit", str(CORPUS / "plan/spin.json"), "FILE", "--threads", "1",
                                              "--evaluations", "2", "--json"]),
}

NUMBERS = [b"0", b"-0", b"-1", b"1", b"0.5", b"1e-46", b"1e-320", b"1e-6", b"1e6", b"1e19", b"3.5e38", b"-1e38", b"1e308",
           b"1e999", b"nan", b"inf", b"-inf", b"255", b"256", b"65535", b"2147483647", b"2147483648", b"-2147483648",
           b"4294967295", b"4294967296", b"9007199254740993", b"9223372036854775807", b"18446744073709551616", b"0x10", b"1e",
           b"9" * 400, b"0." + b"0" * 400 + b"1"]
A_NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
A_WORD = re.compile(rb'"[^"\n]{0,80}"|[A-Za-z_][\w:.]*')
NAMES = [b"..", b"/etc/passwd", b"../" * 9 + b"etc/passwd", b"file:///etc/passwd", b"%2e%2e/%2e%2e/etc/passwd", b"/dev/zero", b".",
         b"\xff\xfe", b"&lt;", b"\x00", b"a" * 5000, b""]


def turn_over(data, dice):
    for _ in range(dice.randint(1, 8)):
        data[dice.randrange(len(data))] ^= 1 << dice.randrange(8)


def random_bytes(data, dice):
    begin = dice.randrange(len(data))
    for at in range(begin, min(len(data), begin + dice.randint(1, 8))):
        data[at] = dice.choice([0, 1, 127, 128, 255, dice.randrange(256)])


def take_out(data, dice):
    begin = dice.randrange(len(data))
    del data[begin:begin + dice.choice([1, 2, 4, 16, 200])]


def double(data, dice):
    begin = dice.randrange(len(data))
    part = data[begin:begin + dice.choice([1, 4, 20, 100, 1000])]
    at = dice.randrange(len(data) + 1)
    data[at:at] = part * dice.choice([1, 1, 2, 50])


def cut_off(data, dice):
    del data[dice.randrange(len(data)):]


def extreme_number(data, dice):
    found = list(A_NUMBER.finditer(data))
    for match in sorted(dice.sample(found, min(len(found), dice.choice([1, 1, 1, 2, 5]))), key=lambda m: -m.start()):
        data[match.start():match.end()] = dice.choice(NUMBERS)


def other_number(data, dice):
    found = list(A_NUMBER.finditer(data))
    for match in sorted(dice.sample(found, min(len(found), dice.choice([1, 1, 3, 10]))), key=lambda m: -m.start()):
        value = max(-1e300, min(1e300, float(match.group())))
        changed = dice.choice([-value, value * 10, value / 10, value + 1, value - 1, dice.uniform(-2, 2), 0.0, round(value) + 1])
        data[match.start():match.end()] = repr(changed).removesuffix(".0").encode()


def exchange_words(data, dice):
    found = list(A_WORD.finditer(data))
    if len(found) > 1:
        into, other = dice.sample(found, 2)
        data[into.start():into.end()] = other.group()


def strange_name(data, dice):
    found = [match for match in A_WORD.finditer(data) if match.group().startswith(b'"')]
    if found:
        match = dice.choice(found)
        data[match.start() + 1:match.end() - 1] = dice.choice(NAMES)


def move_lines(data, dice):
    separator = dice.choice([b"\n", b">", b",", b"{"])
    lines = bytes(data).split(separator)
    begin = dice.randrange(len(lines))
    part = lines[begin:begin + dice.choice([1, 1, 2, 5])]
    if dice.random() < 0.5:
        del lines[begin:begin + len(part)]
    at = dice.randrange(len(lines) + 1)
    lines[at:at] = part * dice.choice([1, 1, 2, 20])
    data[:] = separator.join(lines)


def nest(data, dice):
    """Nests one element or array in itself many times."""
    depth = dice.choice([10, 1000, 100000])
    opened, closed = dice.choice([(b"[", b"]"), (b"{\"a\":", b"}"), (b"<link>", b"</link>"), (b"(", b")"), (b"def \"a\" {", b"}")])
    at = dice.randrange(len(data) + 1)
    data[at:at] = opened * depth + closed * depth


CHANGES = [turn_over, random_bytes, take_out, double, cut_off] + 3 * [extreme_number] + 5 * [other_number] + 2 * [exchange_words, move_lines] + [strange_name, nest]


def mutated(good, dice):
    data = bytearray(good)
    for _ in range(dice.choice([1, 1, 1, 2, 3])):
        if data:
            dice.choice(CHANGES)(data, dice)
    return bytes(data[:1 << 20])


def short(data):
    """Limits the simulated time of a plan, which may be hours."""
    return re.sub(rb'("seconds"\s*:)[^,}\n]*', rb"\1 0.05", data)


def limits():
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESSES, ADDRESSES))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def numbers_fail(text):
    """The reason why the program's output is not valid JSON, or None."""
    try:
        json.loads(text, parse_constant=lambda word: 1 / 0)
    except ZeroDivisionError:
        return "its JSON has what is no number"
    except ValueError as error:
        return f"its JSON is none: {error}"
    return None


def fault_of(status, usage, out, said, is_json):
    """Describes what is wrong with the behavior of a process, or None."""
    lines = said.decode("utf-8", "replace").strip().splitlines()
    complaints = [line for line in lines if not line.startswith("cairn: warning: ")]
    if status in (-9, -24):
        return f"took more than {SECONDS} s of processor time"
    if status < 0:
        return f"ended by signal {-status}"
    if usage.ru_maxrss * 1024 > MEMORY:
        return f"held {usage.ru_maxrss >> 10} MiB"
    if any(ord(letter) < 32 and letter != "\t" for line in lines for letter in line):
        return "what it said has control characters"
    if any(len(line) > 2000 for line in lines):
        return "what it said has a line of more than 2,000 letters"
    if status == 0:
        if complaints:
            return f"took the file and said: {complaints[0]}"
        return numbers_fail(out) if is_json else None
    if status != 1:
        return f"exit status {status}"
    if not complaints and b'"same": false' in out:
        return None  # a recording whose replay diverged
    if len(complaints) != 1 or not complaints[0].startswith("cairn: "):
        return f"refused the file in {len(complaints)} lines"
    return None


class Trial:
    """Mutated files of one format, run in a folder of their own."""

    def __init__(self, program, seed, name, folder):
        patterns, self.arguments = FORMATS[name]
        self.program, self.seed, self.name, self.folder = program, seed, name, folder
        self.good = [path for pattern in patterns for path in sorted(CORPUS.glob(pattern))]
        self.good = [path.resolve() for path in self.good]
        if not self.good:
            sys.exit(f"mutate.py: no good files of {name} in {CORPUS}")

    def file(self, number):
        dice = random.Random(f"{self.seed}/{self.name}/{number}")
        good = dice.choice(self.good)
        return f"{self.name}_{number}{good.suffix}", self.change(good, dice)

    def good_bytes(self, path):
        beginning, choices = BEGINNINGS.get(path.parent.name, (b"", 0))
        return beginning + path.read_bytes()[choices:]

    def change(self, path, dice):
        data = mutated(self.good_bytes(path), dice)
        return short(data) if self.name == "plan" else data

    def run(self, number):
        """(verdict: taken, refused or what is wrong; the name of the file)."""
        name, data = self.file(number)
        path = self.folder / name
        path.write_bytes(data)
        words = {"FILE": str(path), "OUT.gltf": str(path) + ".gltf"}
        command = [self.program] + [words.get(word, word) for word in self.arguments]
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as said:
            child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=said, preexec_fn=limits)
            clock = threading.Timer(PATIENCE, child.kill)
            clock.start()
            _, status, usage = os.wait4(child.pid, 0)
            clock.cancel()
            child.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0), said.seek(0)
            fault = fault_of(child.returncode, usage, out.read(), said.read(), "--json" in command)
        if fault is None:
            path.unlink()
            pathlib.Path(words["OUT.gltf"]).unlink(missing_ok=True)
        return fault or ("taken" if child.returncode == 0 else "refused"), name


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=10000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--formats", default=",".join(FORMATS))
    parser.add_argument("--only")
    parser.add_argument("--keep", default="build/mutated")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    formats, numbers = options.formats.split(","), range(options.count)
    if options.only:
        name, number = options.only.split(":")
        formats, numbers = [name], [int(number)]
    unknown = [name for name in formats if name not in FORMATS]
    if unknown:
        parser.error(f"there is no format {unknown[0]}; there are {', '.join(FORMATS)}")
    program = str(pathlib.Path(options.program).resolve())
    keep = pathlib.Path(options.keep)
    bad = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for format_name in formats:
            trial = Trial(program, options.seed, format_name, pathlib.Path(folder))
            counts = {"taken": 0, "refused": 0}
            for verdict, name in pool.map(trial.run, numbers):
                if verdict in counts:
                    counts[verdict] += 1
                    continue
                bad += 1
                keep.mkdir(parents=True, exist_ok=True)
                shutil.move(pathlib.Path(folder) / name, keep / name)
                print(f"{keep / name}: {verdict}", flush=True)
            total = len(numbers)
            print(f"{format_name}: {total} files, {counts['taken']} taken, {counts['refused']} refused, "
                  f"{total - counts['taken'] - counts['refused']} worse", flush=True)
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
