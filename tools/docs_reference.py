"""Generates the site's API reference from the table: a page for each of its files, with the names in every language."""
import html

from api_c_header import c_parameters, is_plain
from api_python import is_property as is_property_of_python, methods, setters, signature_of
from api_table import GROUPS
from api_text import c_name, described
from api_web import BY_HAND, camel

TITLES = {"base": "The library", "math": "Vectors and poses", "shape": "Shapes", "body": "Bodies", "joint": "Joints",
          "query": "Queries", "events": "Events and contacts", "world": "Worlds", "scene": "Scenes"}


def cell(text):
    return html.escape(text, quote=False).replace("|", "\\|").replace("\n", " ")


def type_text(kind):
    """A type of the table, in words."""
    if kind.endswith("?"):
        return f"{kind[:-1]}, may be absent"
    if kind.endswith("[]"):
        return f"list of {kind[:-2]}"
    return kind


def struct_page(struct):
    text = f"### {struct.name}\n\n{cell(struct.doc)}\n\nIn C: `{c_name(struct.name)}`.\n\n"
    if not struct.fields:
        return text
    text += "| member | in JavaScript | type | |\n|---|---|---|---|\n"
    for member in struct.fields:
        text += f"| `{member.name}` | `{camel(member.name)}` | {cell(type_text(member.type))} | {cell(described(member))} |\n"
    return text + "\n"


def enum_page(enum):
    text = f"### {enum.name}\n\n{cell(enum.doc)}\n\nIn C: `{c_name(enum.name)}`.\n\n| value | in JavaScript | |\n|---|---|---|\n"
    for value in enum.values:
        text += f"| `{value.name}` | `'{camel(value.name)}'` | {cell(value.doc)} |\n"
    return text + "\n"


def variant_page(variant):
    text = f"### {variant.name}\n\n{cell(variant.doc)}\n\nIn C: `{c_name(variant.name)}`. In JavaScript an object with `kind`:\n\n"
    return text + "| kind | struct |\n|---|---|\n" + "".join(
        f"| `'{camel(a.name)}'` | [{a.type}](#{a.type.lower()}) |\n" for a in variant.alternatives) + "\n"


def python_and_javascript(table, function):
    """The call in Python and JavaScript, if it is a method there."""
    for owner in ("World", "Body"):
        if function not in list(methods(table, owner)) or function.method in BY_HAND:
            continue
        setter = function in setters(table, owner).values()
        target = owner.lower()
        name = function.method.removeprefix("set_") if setter else function.method
        if is_property_of_python(function):
            return f"{target}.{name}", f"{target}.{camel(name)}"
        if setter:
            return f"{target}.{name} = ...", f"{target}.{camel(name)} = ..."
        of_world = owner == "Body" and function.owner == "World"
        args = ", ".join(camel(a.name) if a.name != "def" else "definition" for a in function.args if not (of_world and a.type == "BodyId"))
        return f"{target}.{signature_of(table, function)}", f"{target}.{camel(function.method)}({args})"
    return None


def function_page(table, function):
    returns = "bool" if is_plain(function) else function.c_returns if function.custom else "cairn_result"
    text = f"### cairn_{function.name}\n\n{cell(described(function))}\n\n| | |\n|---|---|\n"
    if function.cpp:
        text += f"| C++ | `{cell(function.cpp)}` |\n"
    both = python_and_javascript(table, function)
    if both:
        text += f"| Python | `{cell(both[0])}` |\n| JavaScript | `{cell(both[1])}` |\n"
    text += f"| C | `{cell(f'{returns} cairn_{function.name}({c_parameters(function)})')}` |\n"
    if function.errors:
        text += f"| errors | {', '.join(function.errors)} |\n"
    return text + "\n"


def pages(table):
    """(name, title, text) of each page."""
    for group in GROUPS:
        text = f"# {TITLES[group]}\n\n"
        own = [(item, page) for items, page in ((table.enums, enum_page), (table.variants, variant_page), (table.structs, struct_page))
               for item in items.values() if item.group == group]
        if own:
            text += "## Structs and values\n\n" + "".join(page(item) for item, page in own)
        functions = [f for f in table.functions if f.group == group]
        if functions:
            text += "## Calls\n\n" + "".join(function_page(table, f) for f in functions)
        yield group, TITLES[group], text
