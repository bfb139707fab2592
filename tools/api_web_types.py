"""Generates web/src/index.d.ts, the types of the npm package: those of the table, inserted into the hand-written part
in tools/api_web_types.d.ts."""
import re
import textwrap

from api_python import is_property, methods, setters
from api_table import HANDLES, ROOT
from api_text import COLUMNS, MADE, described
from api_web import BY_HAND, camel, javascript_words, parameter_name

SCALARS = {"bool": "boolean", "int": "number", "float": "number", "double": "number", "u32": "number", "u64": "bigint",
           "size": "number", "string": "string", "geometry": "Geometry"}


def kind_of(table, kind, given):
    """A TypeScript type; `given`: for an argument, which accepts more types than the exact one."""
    if kind.endswith("?"):
        return kind_of(table, kind[:-1], given) + " | null"
    many = re.match(r"(.*)\[\d*\]$", kind)
    if many:
        inner = kind_of(table, many[1], given)
        return f"readonly ({inner})[]" if given else f"({inner})[]" if " " in inner else f"{inner}[]"
    if kind == "u64" and given:
        return "bigint | number"
    if kind in SCALARS:
        return SCALARS[kind]
    if kind == "Mat3":
        return "number[]"
    if kind in ("Vec2", "Quat"):
        return f"{kind}Like" if given else kind
    if kind in ("Vec3", "DVec3", "Position"):
        return "Vec3Like" if given else "Vec3"
    if kind == "BodyId" and given:
        return "BodyId | Body | null"
    if kind in HANDLES and given:
        return f"{kind} | null"
    if kind in table.enums:
        return kind
    if given or kind not in table.structs or not table.structs[kind].is_input:
        return kind
    return f"Complete<{kind}>"


def comment(text, indent):
    text = javascript_words(text)
    if not text:
        return ""
    if len(indent) + len(text) + 7 <= COLUMNS:
        return f"{indent}/** {text} */\n"
    lines = textwrap.wrap(text, COLUMNS - len(indent) - 3, break_on_hyphens=False, break_long_words=False)
    return f"{indent}/**\n" + "".join(f"{indent} * {line}\n" for line in lines) + f"{indent} */\n"


def struct_type(table, struct):
    text = comment(struct.doc, "") + f"export interface {struct.name} {{\n"
    for member in struct.fields:
        optional = "?" if struct.is_input and not member.type == "geometry" else ""
        text += comment(described(member), "    ")
        text += f"    {camel(member.name)}{optional}: {kind_of(table, member.type, struct.is_input)};\n"
    return text + "}\n\n"


def declarations(table):
    text = ""
    for enum in table.enums.values():
        text += comment(enum.doc + " " + " ".join(f"`{camel(v.name)}`: {v.doc}" for v in enum.values if v.doc), "")
        text += f"export type {enum.name} = " + " | ".join(f"'{camel(v.name)}'" for v in enum.values) + ";\n\n"
    for struct in table.structs.values():
        if not struct.c_only:
            text += struct_type(table, struct)
    for variant in table.variants.values():
        text += comment(variant.doc, "") + f"export type {variant.name} =\n"
        text += "\n".join(f"    | ({{ kind: '{camel(a.name)}' }} & {a.type})" for a in variant.alternatives) + ";\n\n"
    return text


def documented(function):
    errors = f" Throws {', '.join(camel(e) for e in function.errors)}." if function.errors else ""
    return described(function) + errors


def method_type(table, function, owner):
    args = [a for a in function.args if not (owner == "Body" and function.owner == "World" and a.type == "BodyId")]
    parts = []
    for arg in args:
        optional = "?" if arg.default in ("{}", "none") else ""
        parts.append(f"{parameter_name(arg)}{optional}: {kind_of(table, arg.type, True)}")
    returns = kind_of(table, function.returns, False) if function.returns else "void"
    return comment(documented(function), "    ") + f"    {camel(function.method)}({', '.join(parts)}): {returns};\n"


def members(table, owner):
    own, text = setters(table, owner), ""
    for function in methods(table, owner):
        if function.method in BY_HAND or function in own.values():
            continue
        if not is_property(function):
            text += method_type(table, function, owner)
            continue
        setter = own.get(function.method)
        doc = described(function) + (f" Setting: {setter.doc}" if setter and setter.doc not in function.doc else "")
        text += comment(doc, "    ") + f"    get {camel(function.method)}(): {kind_of(table, function.returns, False)};\n"
        if setter:
            text += f"    set {camel(function.method)}(value: {kind_of(table, setter.args[0].type, True)});\n"
    return text


def types(table):
    text = (ROOT / "tools" / "api_web_types.d.ts").read_text(encoding="utf-8")
    text = text.replace("// From the table: the structs and enums.\n", declarations(table))
    for owner in ("World", "Body"):
        text = text.replace(f"    // From the table: {owner}.\n", members(table, owner))
    return f"// {MADE}\n{text}"
