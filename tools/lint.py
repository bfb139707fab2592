#!/usr/bin/env python3
"""Checks what the compiler does not: includes go down the list of rooms, stages name the groups of the state that they
use, files stay short, and links lead somewhere.

usage: tools/lint.py [ROOT]   Prints one line per finding; exit status 1 if there is any.
"""
import pathlib
import re
import subprocess
import sys

# A file may include its own room and those before it. docs/architecture.md tells what each is for.
ROOMS = ["core", "commands", "simd", "math", "jobs", "shapes", "bvh", "collision", "kernels", "state", "bodies", "queries", "islands", "contacts", "joints",
         "solver", "impacts", "character", "world"]
# What only uses the public headers, and what it may include beside them.
USERS = {
    "python/module": {"module", "scene"},
    "src/c_api": {"c_api", "scene"},
    "src/files": {"files"},
    "src/checkpoint": {"checkpoint", "files"},
    "src/scene": {"files", "scene"},
    "src/sweep": {"files", "scene", "sweep"},
    "src/recording": {"files", "recording"},
    "src/validation": {"validation"},
    "app/ranks": set(),
    "app/viewer": {"files", "recording", "viewer"},
    "app/cli": {"checkpoint", "cli", "files", "recording", "scene", "sweep", "validation", "viewer"},
}
# Stages of a step take the groups of the state that they use (Bodies, Contacts, ...), const where they only read, or a
# struct that names those: a signature says what may be touched.
STAGES = {"bodies", "islands", "contacts", "joints", "solver", "impacts", "character"}
WHOLE_STATE = re.compile(r"\bState\b")
# Kernel sources are compiled once per instruction set: they see plain data only.
KERNEL_MAY = {"core", "simd", "math", "bvh", "collision", "kernels"}
MAX_LINES, MAX_COLUMNS = 500, 120
INCLUDE = re.compile(r'^\s*#include "([^"/]+)/[^"]+"')
SOURCES = (".h", ".cpp", ".py", ".sh", ".js", ".mjs")
# Of Markdown: [text](target), and [text](target "title"); code is not read.
LINK = re.compile(r"\]\(([^()\s]+)(?:\s+\"[^\"]*\")?\)")
CODE = re.compile(r"```.*?```|`[^`\n]*`", re.S)


def allowed_rooms(path):
    """The rooms that a file may include, or None if any (tests, benchmarks)."""
    parts = path.parts
    for folder, rooms in USERS.items():
        if str(path).startswith(folder + "/"):
            return rooms
    if parts[0] == "src":
        if parts[1] == "kernels":
            return KERNEL_MAY
        if parts[1] not in ROOMS:
            return set()
        return set(ROOMS[: ROOMS.index(parts[1]) + 1])
    return None


def check(root, path):
    text = (root / path).read_text(encoding="utf-8")
    lines = text.split("\n")
    is_made = "generated" in path.parts  # by tools/api.py
    if len(lines) - 1 > MAX_LINES and not is_made:
        yield 1, f"{len(lines) - 1} lines, at most {MAX_LINES} are meant"
    rooms = allowed_rooms(path)
    is_stage = path.parts[0] == "src" and path.parts[1] in STAGES
    for number, line in enumerate(lines, 1):
        if len(line) > MAX_COLUMNS and path.suffix in (".h", ".cpp", ".js", ".mjs") and not is_made:
            yield number, f"{len(line)} columns, at most {MAX_COLUMNS} are meant"
        if re.search(r"\b(TODO|FIXME|XXX)\b", line) and path.name != "lint.py":
            yield number, "unfinished work is an issue, not a comment"
        if is_stage and WHOLE_STATE.search(line.partition("//")[0]):
            yield number, "a stage takes the groups of the state that it uses (Bodies, Shapes, ...), not the whole State"
        found = INCLUDE.match(line)
        if found and rooms is not None and found.group(1) not in rooms:
            yield number, f"may not include {found.group(1)}/ (only {', '.join(sorted(rooms)) or 'public headers'})"


def headings(text):
    """The anchors that a page has: its headings as GitHub writes them."""
    titles = re.findall(r"^#+ +(.+?)\s*$", re.sub(r"```.*?```", "", text, flags=re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def check_links(root, path):
    """Links of a page to files of the project, and to headings in them."""
    text = CODE.sub(lambda code: re.sub(r"[^\n]", " ", code.group()), (root / path).read_text(encoding="utf-8"))
    for found in LINK.finditer(text):
        target, _, anchor = found.group(1).partition("#")
        if re.match(r"[a-z]+:", target):
            continue
        file = root / path.parent / target if target else root / path
        number = text.count("\n", 0, found.start()) + 1
        if not file.exists():
            yield number, f"there is no {target}"
        elif anchor and file.suffix == ".md" and anchor not in headings(file.read_text(encoding="utf-8")):
            yield number, f"there is no heading #{anchor} in {file.name}"


def pages(root):
    """The Markdown files that belong to the project: those that git knows, where there is a repository."""
    listing = subprocess.run(["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard", "*.md"],
                             capture_output=True, text=True, check=False)
    names = listing.stdout.split("\0") if listing.returncode == 0 else [
        file.relative_to(root) for folder in (root.glob("*.md"), (root / "docs").rglob("*.md")) for file in folder]
    return [pathlib.Path(name) for name in sorted(map(str, names)) if name and (root / name).exists()]


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    findings = 0
    for folder in ("include", "src", "app", "python", "tests", "bench", "tools", "web"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in SOURCES or "node_modules" in file.parts:
                continue
            path = file.relative_to(root)
            for line, text in check(root, path):
                print(f"{path}:{line}: {text}")
                findings += 1
    for path in pages(root):
        for line, text in check_links(root, path):
            print(f"{path}:{line}: {text}")
            findings += 1
    print(f"{findings} findings" if findings else "lint: clean")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
