#!/usr/bin/env python3
"""Lists the named constants of the solver's rooms, as docs/constants.md has them.

usage: tools/constants.py [--write]   Without --write: exit status 1 if docs/constants.md is not what the code says.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "constants.md"
ROOMS = ["state", "bodies", "islands", "contacts", "joints", "solver", "impacts"]
GOAL = 40
DEFINITION = re.compile(r"^ *(?:static |inline )?constexpr (?:[\w:]+) (\w+ = [^;]*);(.*)$", re.MULTILINE)
BEFORE = re.compile(r"((?:^ *//.*\n)+)\Z", re.MULTILINE)
# Excluded: sizes of work for threads and caches, which do not change results, and names of values that mean "none".
WORK = re.compile(r"(_per_chunk|_ahead|^capacity$|_shared_contacts$|^batch_)")
MARKS = {"unused", "unlimited", "not_found", "unknown_speed", "no_impact_speed", "none", "pi", "whole", "ones", "max_joint_axes",
         "max_joint_axes", "wide_kinds", "tested_kinds", "one_point_type", "four_points_type", "block_types", "joint_row_types",
         "first_fixed_color", "overflow_color", "no_color", "patches_at_hand", "turn_phase", "point_phase", "phases", "forms",
         "keys_per_color", "keys_per_batch", "side_by_side", "min_handed_out", "ahead", "early", "early_pairs", "capacity", "count"}

# Names of values in encodings, and numbers that a formula brings with it: nobody chose them, and nobody could.
GIVEN = {"every_rank", "absent", "sleep_requested", "cut_by_body", "nothing_can_buckle", "outcome_bits",
         "points_shift", "points_bits", "one_of_round_surfaces", "is_open", "form_with_turn", "no_row",
         "rows_per_point", "travel_units", "euler", "greenhill", "of_outline"}


def constants(room):
    """(file, name, value, comment) of each constant; the comment is the one beside it, or else the first sentence above
    it."""
    for path in sorted((ROOT / "src" / room).glob("*")):
        text = path.read_text(encoding="utf-8")
        for found in DEFINITION.finditer(text):
            comment = found[2].strip().removeprefix("//").strip()
            above = BEFORE.search(text[: found.start()])
            if not comment and above:
                comment = " ".join(line.strip().removeprefix("//").strip() for line in above[1].splitlines())
                comment = re.split(r"(?<=\.) ", comment)[0]
            for part in re.split(r",\s*(?=\w+ = )", " ".join(found[1].split())):
                name, value = part.split(" = ", 1)
                yield path.relative_to(ROOT), name, value, comment


def kind(name, value):
    if WORK.search(name):
        return "work"
    if name in GIVEN:
        return "given"
    return "mark" if name in MARKS or value.startswith(("{", "std::tuple", "std::get")) or "|" in value else "physics"


def page():
    rows = [(room, *c) for room in ROOMS for c in constants(room)]
    of = {k: [r for r in rows if kind(r[2], r[3]) == k] for k in ("physics", "work", "given", "mark")}
    lines = ["# Constants of the solver's rooms", "",
             "Made by `tools/constants.py --write` from the named constants of `src/state`, `bodies`, `islands`, `contacts`, `joints`,",
             "`solver` and `impacts`; `./dev lint` checks that it is what the code says.", "",
             f"**{len(of['physics'])} constants are choices that decide what is computed; the goal is {GOAL}.** {len(of['work'])} more are sizes of work for",
             f"threads and caches, which change no result, and {len(of['given'])} are encodings or belong to formulas. Derivations and measurements: at the constant, and in [decisions](decisions/README.md).", ""]
    for key, title in (("physics", "What is computed"), ("work", "Sizes of work"),
                       ("given", "Encodings, and numbers that belong to formulas")):
        lines += [f"## {title}", "", "| constant | value | file | meaning |", "|---|---|---|---|"]
        lines += [f"| `{name}` | {value.replace('|', ' or ')} | `{path}` | {comment.replace('|', 'or')} |" for _, path, name, value, comment in of[key]]
        lines.append("")
    return "\n".join(lines), len(of["physics"])


def main():
    text, count = page()
    if "--write" in sys.argv:
        PAGE.write_text(text, encoding="utf-8")
    elif not PAGE.exists() or PAGE.read_text(encoding="utf-8") != text:
        print("docs/constants.md is not what the code says: python3 tools/constants.py --write")
        return 1
    print(f"constants: {count}, goal {GOAL}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
