#!/usr/bin/env python3
"""The code of the guide (docs/guide) as programs: each chapter has one in each of its languages, of its blocks in order.

usage: tools/snippets.py cpp FILE       writes a source with a function for each chapter, and a main that runs them all
       tools/snippets.py js FOLDER      writes a module for each chapter, CHAPTER.mjs
       tools/snippets.py python         runs each chapter; exit status 1 if any fails

A line `<!-- check LANGUAGE: EXPRESSION -->` behind a block, which readers do not see, says what must be true there.
"""
import pathlib
import re
import subprocess
import sys

GUIDE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "guide"
BLOCK = re.compile(r"^( *)```(\w+)$")
CHECK = re.compile(r"^ *<!-- check (\w+): (.*) -->$")
LANGUAGES = {"cpp", "js", "python"}


class Malformed(Exception):
    """A page that violates the format described above."""


def parts(page):
    """(language, line, text, whether it is a check) of a page, in order."""
    lines = page.read_text(encoding="utf-8").split("\n")
    at = 0
    while at < len(lines):
        block, check = BLOCK.match(lines[at]), CHECK.match(lines[at])
        if check:
            yield check[1], at + 1, check[2], True
        elif "<!-- check" in lines[at]:
            raise Malformed(f"{page.name}:{at + 1}: a check that is not understood")
        elif block:
            indent, begin = block[1], at + 1
            while at + 1 < len(lines) and lines[at + 1].strip() != "```":
                at += 1
            text = "\n".join(line.removeprefix(indent) for line in lines[begin:at + 1])
            at += 1
            if block[2] in LANGUAGES:
                yield block[2], begin + 1, text, False
        at += 1


def chapters(language):
    """(name, [(line, text, whether it is a check)]) of the pages that have code in a language."""
    for page in sorted(GUIDE.glob("*.md")):
        own = [(line, text, check) for kind, line, text, check in parts(page) if kind == language]
        if not own:
            continue
        blocks = sum(not check for *_, check in own)
        if sum(check for *_, check in own) < blocks:
            raise Malformed(f"{page.name}: of {blocks} blocks in {language} some have no check")
        yield page.stem, own


def cpp():
    """One source file. #include lines are at its top, everything else is in the function of its chapter."""
    includes, functions, calls = {"#include <cmath>", "#include <cstdio>", "#include <cstdlib>", "#include <string>"}, "", ""
    for name, own in chapters("cpp"):
        body = ""
        for line, text, check in own:
            if check:
                body += f"    if (!({text})) fail(\"docs/guide/{name}.md:{line}\", R\"check({text})check\");\n"
                continue
            body += f"#line {line} \"docs/guide/{name}.md\"\n"
            for row in text.split("\n"):
                if row.startswith("#include"):
                    includes.add(row)
                body += ("" if row.startswith("#include") or not row else f"    {row}") + "\n"
        functions += f"\nvoid {name}() {{\n{body}}}\n"
        calls += f"    {name}();\n"
    return "\n".join(sorted(includes)) + """

namespace {

[[noreturn]] void fail(const char* place, const char* expression) {
    std::printf("%s: not true: %s\\n", place, expression);
    std::exit(1);
}
""" + functions + "\n} // namespace\n\nint main() {\n" + calls + "}\n"


def javascript(name, own):
    text = "import assert from 'node:assert/strict';\n"
    for line, code, check in own:
        text += f"assert.ok({code}, {f'docs/guide/{name}.md:{line}: {code}'!r});\n" if check else code + "\n"
    return text


def python(name, own):
    text = ""
    for line, code, check in own:
        text += f"assert {code}, {f'docs/guide/{name}.md:{line}: {code}'!r}\n" if check else code + "\n"
    return text


def run_python():
    failed = 0
    for name, own in chapters("python"):
        done = subprocess.run([sys.executable, "-"], input=python(name, own), capture_output=True, text=True, timeout=120, check=False)
        if done.returncode != 0:
            failed += 1
            print(f"docs/guide/{name}.md\n{done.stdout}{done.stderr}")
        else:
            print(f"{name}: as it says")
    return 1 if failed else 0


def main():
    arguments = sys.argv[1:]
    try:
        if arguments == ["python"]:
            return run_python()
        if len(arguments) == 2 and arguments[0] == "cpp":
            pathlib.Path(arguments[1]).write_text(cpp(), encoding="utf-8")
        elif len(arguments) == 2 and arguments[0] == "js":
            folder = pathlib.Path(arguments[1])
            folder.mkdir(parents=True, exist_ok=True)
            for name, own in chapters("js"):
                (folder / f"{name}.mjs").write_text(javascript(name, own), encoding="utf-8")
        else:
            sys.exit(__doc__)
    except Malformed as error:
        sys.exit(f"snippets: {error}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
