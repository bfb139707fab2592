#!/usr/bin/env python3
"""Builds the site of the documentation, without a network: tools/docs.py FOLDER

The pages of docs, and a reference that is made from the table of the API (api/), by MkDocs. Links of pages to files of the source
become their names. Exit status 1 if a page or a link of it is not right.
"""
import pathlib
import re
import shutil
import subprocess
import sys

import api_table
import docs_reference

ROOT = pathlib.Path(__file__).resolve().parent.parent
GUIDE = ["first_world", "shapes", "joints", "queries_and_events", "threads_and_determinism", "scenes", "python", "web", "performance",
         "how_it_works", "characters"]
PAGES = [("C", "c_api"), ("Python", "python"), ("The web", "web"), ("The viewer", "viewer"),
         ("Which integrator gains energy", "viewer_student"), ("A stack that falls", "viewer_developer"), ("Shapes", "shapes"), ("Joints", "joints"), ("Solver", "solver"),
         ("Determinism", "determinism"), ("Scene format", "scene_format"), ("Models", "models"), ("URDF", "urdf"), ("MJCF", "mjcf"),
         ("SDF", "sdf"), ("USD", "usd"), ("Benchmarks", "benchmarks"), ("One world on many machines", "scale"), ("Validation", "validation"), ("Rows of the validation", "validation_rows"),
         ("Faults", "faults"), ("Constants", "constants"), ("Rooms of the source", "architecture"), ("Glossary", "glossary")]
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^()\s]+)\)")
SETTINGS = """site_name: Cairn
site_description: A 3D rigid-body physics engine with the same bits everywhere
docs_dir: pages
use_directory_urls: false
theme:
  name: material
  font: false
  features: [navigation.sections, content.tabs.link]
  palette:
    - media: "(prefers-color-scheme: light)"
      scheme: default
    - media: "(prefers-color-scheme: dark)"
      scheme: slate
plugins: [search]
extra:
  generator: false
markdown_extensions: [tables, attr_list, toc: {permalink: true}, pymdownx.highlight, pymdownx.superfences, pymdownx.tabbed: {alternate_style: true}]
nav:
"""
HOME = """# Cairn

A 3D rigid-body physics engine for C++20, C, Python and the web. The same calls give results that are identical to the
bit in every language, for every instruction set and number of threads, and on every platform that it is tested on.

![A heavy ball flies through a brick wall into a round tower of stone wedges, which falls](images/wrecking_ball.gif)

- **[The guide](guide/first_world.md)**: eleven short chapters, with code in C++, Python and JavaScript.
- **[Recipes](guide/recipes.md)** for common tasks, and [a dictionary](guide/coming_from.md) for users of Box3D, Jolt,
  Rapier, PhysX, Bullet or MuJoCo.
- **[The reference](reference/world.md)**: every struct and every call, in every language.
- **[Known limits](known_limits.md)**: the cases in which the engine does not yet do what it should, with measured errors.
"""


def title_of(text):
    return re.search(r"^# (.+)$", text, re.M)[1]


def without_links_out(text, page):
    """Replaces links to targets outside the site by code or words."""
    def replaced(found):
        target = found[3].partition("#")[0]
        if re.match(r"[a-z]+:", found[3]) or not target:
            return found[0]
        file = (page.parent / target).resolve()
        if file.is_relative_to(ROOT / "docs") and file.is_file():
            return found[0]
        name = file.relative_to(ROOT) if file.is_relative_to(ROOT) else target
        return found[2] if str(name) in found[2].replace("`", "") else f"{found[2]} (`{name}`)"

    return LINK.sub(replaced, text)


def nav(entries, indent="  "):
    text = ""
    for title, target in entries:
        quoted = '"' + title.replace('"', '\\"') + '"'
        text += f"{indent}- {quoted}: {target}\n" if isinstance(target, str) else f"{indent}- {quoted}:\n{nav(target, indent + '    ')}"
    return text


def write_pages(folder):
    """Writes all pages below `folder`; returns the site's navigation in order."""
    for file in sorted((ROOT / "docs").rglob("*")):
        if file.is_dir():
            continue
        to = folder / file.relative_to(ROOT / "docs")
        to.parent.mkdir(parents=True, exist_ok=True)
        if file.suffix == ".md":
            text = re.sub(r"^ *<!-- check .*-->\n", "", file.read_text(encoding="utf-8"), flags=re.M)
            to.write_text(without_links_out(text, file), encoding="utf-8")
        else:
            shutil.copyfile(file, to)
    (folder / "index.md").write_text(HOME, encoding="utf-8")
    (folder / "reference").mkdir()
    reference = []
    for name, title, text in docs_reference.pages(api_table.Table()):
        (folder / "reference" / f"{name}.md").write_text(text, encoding="utf-8")
        reference.append((title, f"reference/{name}.md"))

    def named(name):
        return title_of((ROOT / "docs" / f"{name}.md").read_text(encoding="utf-8")), f"{name}.md"

    decisions = sorted(f"decisions/{file.stem}" for file in (ROOT / "docs/decisions").glob("*.md") if file.stem != "README")
    return [("Home", "index.md"), ("Guide", [named(f"guide/{name}") for name in GUIDE]),
            ("Recipes", "guide/recipes.md"), ("Coming from other engines", "guide/coming_from.md"), ("Reference", reference),
            ("Known limits", "known_limits.md"), ("In depth", [(title, f"{name}.md") for title, name in PAGES]),
            ("Decisions", [("All of them", "decisions/README.md"), *(named(name) for name in decisions)])]


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1]).resolve()
    shutil.rmtree(folder / "pages", ignore_errors=True)
    (folder / "pages").mkdir(parents=True)
    (folder / "mkdocs.yml").write_text(SETTINGS + nav(write_pages(folder / "pages")), encoding="utf-8")
    return subprocess.run(["mkdocs", "build", "--quiet", "--strict", "--clean", "--config-file", folder / "mkdocs.yml", "--site-dir", folder / "site"],
                          check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
