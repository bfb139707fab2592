"""Shared by the generators of tools/api.py: comment lines, and the C names of types."""
import textwrap

from api_table import HANDLES, snake

COLUMNS = 120
C_SCALARS = {"bool": "bool", "int": "int", "float": "float", "double": "double", "u32": "uint32_t", "u64": "uint64_t",
             "size": "size_t"}
# Structs that are small enough to be passed by value.
BY_VALUE = {"Vec2", "Vec3", "DVec3", "Position", "Quat", "Mat3", "Transform", "Bounds"}
MADE = "Made by tools/api.py from api/: change those, and run it."


def comment(text, indent="", mark="/// "):
    return "".join(line + "\n" for line in textwrap.wrap(text, COLUMNS, initial_indent=indent + mark,
                                                         subsequent_indent=indent + mark, break_long_words=False,
                                                         break_on_hyphens=False)) if text else ""


def beside(code, doc):
    """A line of code followed by its documentation, or preceded by it if the line would be too long."""
    line = f"{code} ///< {doc}" if doc else code
    if len(line) <= COLUMNS:
        return line + "\n"
    indent = code[:len(code) - len(code.lstrip())]
    return comment(doc, indent) + code + "\n"


def described(item):
    """The documentation of a field, with unit and range unless the text mentions them."""
    text, missing = item.doc, []
    if item.unit and item.unit not in text and not (item.unit == "m" and "meters" in text.lower()):
        missing.append(item.unit)
    allowed = getattr(item, "range", "")
    if allowed and allowed.lower() not in text.lower():
        missing.append(allowed)
    return f"{text} ({', '.join(missing)})".strip() if missing else text


def wrapped(before, parts, after):
    """A declaration or call whose arguments are wrapped to several lines if necessary."""
    line = before + ", ".join(parts) + after
    if len(line) <= COLUMNS:
        return line + "\n"
    indent = " " * (len(before) if len(before) < 70 else 4)
    text, line = "", before
    for number, part in enumerate(parts):
        piece = part + (after if number + 1 == len(parts) else ",")
        if line != before and line.strip() and len(line) + 1 + len(piece) > COLUMNS:
            text += line.rstrip() + "\n"
            line = indent + piece
        else:
            line += ("" if line == before else " ") + piece
    return text + line + "\n"


def c_name(kind):
    """The C type for a type of the table, without `?` and `[]`."""
    if kind in C_SCALARS:
        return C_SCALARS[kind]
    if kind == "geometry":
        return "const cairn_geometry*"
    if kind.endswith("*"):
        return kind
    return "cairn_" + snake(kind)


def constant(enum, value):
    return f"CAIRN_{snake(enum).upper()}_{value.upper()}"


def joined(parts, separator=", "):
    return separator.join(p for p in parts if p)


def is_handle(kind):
    return kind in HANDLES
