"""Generates tests/c_api/wrong_calls.c from the table: calls of the C API with exactly one fault each."""
import re

from api_c_header import c_parameters, count_of, is_plain
from api_table import HANDLES, snake
from api_text import BY_VALUE, MADE, c_name, constant

STALE = {"BodyId": "body", "ShapeId": "shape", "JointId": "joint", "ForceFieldId": "force_field"}
NUMBERS = {"float", "double"}
PARTS = {"Vec2": ["x"], "Vec3": ["y"], "DVec3": ["x"], "Position": ["z"], "Quat": ["w"]}


def bad_members(table, path, kind):
    """(statement, what, expected) for each way to make a value invalid; the path is its C expression."""
    base = kind.removesuffix("?")
    before, _, name = path.rpartition(".")
    given = f"{before}.has_{name} = true; " if kind.endswith("?") and before else ""
    if base in NUMBERS:
        yield f"{given}{path} = NAN;", f"{path} is NaN", "CAIRN_ERROR_INVALID_VALUE"
    elif base in PARTS:
        for part in PARTS[base]:
            yield f"{given}{path}.{part} = NAN;", f"{path}.{part} is NaN", "CAIRN_ERROR_INVALID_VALUE"
    elif base in table.enums:
        for value in ("-1", str(len(table.enums[base].values))):
            yield f"{given}{path} = {value};", f"{path} is {value}", "CAIRN_ERROR_INVALID_VALUE"
    elif base in HANDLES:
        yield f"{given}{path} = c->stale_{STALE[base]};", f"{path} is stale", "CAIRN_ERROR_INVALID_HANDLE"
    elif base in table.variants:
        variant = table.variants[base]
        for value in ("-1", str(len(variant.alternatives))):
            yield f"{path}.kind = {value};", f"{path}.kind is {value}", "CAIRN_ERROR_INVALID_VALUE"
        for alternative in variant.alternatives:
            begin = f"{path} = cairn_default_{snake(base)}({constant(base, alternative.name)}); "
            for statement, what, expected in bad_members(table, f"{path}.as.{alternative.name}", alternative.type):
                yield begin + statement, what, expected
    elif base == "geometry":
        yield f"{path} = NULL;", f"{path} is null", "CAIRN_ERROR_INVALID_VALUE"
    elif base.endswith("[]"):
        yield f"{path} = NULL; {before}.{count_of(name)} = 2;", f"{path} is null", "CAIRN_ERROR_INVALID_VALUE"
    elif base in table.structs:
        struct = table.structs[base]
        if struct.versioned:
            for value in ("0", f"sizeof({c_name(base)}) + 8"):
                yield f"{path}.struct_size = {value};", f"{path}.struct_size is {value}", "CAIRN_ERROR_INVALID_VALUE"
        for member in struct.fields:
            if f"{struct.name}.{member.name}" in table.unchecked:
                continue
            for statement, what, expected in bad_members(table, f"{path}.{member.name}", member.type):
                yield given + statement, what, expected


def call_source(table, function):
    """A C function that makes the call, either correctly (-1) or with the fault of the given number."""
    lines, wrongs, names = [], [], []

    def spoil(statement, what, expected):
        lines.append(f"    if (wrong == {len(wrongs)}) {{ {statement} }}")
        wrongs.append((what, expected))

    args = {a.name: a for a in function.args}
    for parameter in c_parameters(function).split(", "):
        kind, name = re.match(r"(.*?[ *])(\w+)$", parameter).groups()
        kind = kind.strip()
        names.append(name)
        arg = args.get(name)
        if name == "world":
            lines.append("    cairn_world* world = c->world;")
            spoil("world = NULL;", "world is null", "CAIRN_ERROR_INVALID_HANDLE")
        elif arg is None and name == "body":
            lines.append("    cairn_body_id body = c->body;")
            spoil("body = c->stale_body;", "body is stale", "CAIRN_ERROR_INVALID_HANDLE")
            spoil("body.bits = 0;", "body is null", "CAIRN_ERROR_INVALID_HANDLE")
        elif arg is None and name == "capacity":
            lines.append("    size_t capacity = 4;")
        elif arg is None and name not in args:  # arguments that receive results
            base = kind.rstrip("*").strip()
            struct = next((s for s in table.structs.values() if c_name(s.name) == base), None)
            first = f" = {{cairn_default_{snake(struct.name)}()}}" if struct and struct.versioned else ""
            lines.append(f"    {base} {name}_room[4]{first};\n    {kind} {name} = {name}_room;")
            spoil(f"{name} = NULL;", f"{name} is null", "CAIRN_ERROR_INVALID_VALUE")
            if first:
                spoil(f"{name}_room[0].struct_size = 1;", f"{name}.struct_size is 1", "CAIRN_ERROR_INVALID_VALUE")
        else:
            declared, path = declaration(table, arg, kind)
            lines += declared
            if kind.endswith("*") and not arg.default and not arg.type.endswith("?"):
                spoil(f"{name} = NULL;", f"{name} is null", "CAIRN_ERROR_INVALID_VALUE")
            for bad in bad_members(table, path, arg.type.rstrip("?")):
                spoil(*bad)
    lines = "\n".join(lines)
    call = f"cairn_{function.name}({', '.join(names)})"
    text = f"static cairn_result {function.name}(const struct wrong_context* c, int wrong) {{\n{lines}\n    return {call};\n}}\n"
    rows = "".join(f"    {{\"{function.name}\", \"{what}\", {function.name}, {number}, {expected}}},\n"
                   for number, (what, expected) in enumerate(wrongs))
    return text, rows


def declaration(table, arg, kind):
    """The lines that declare an argument with a valid value, and the C expression by which it is made invalid."""
    name, base = arg.name, arg.type.rstrip("?")
    value = {"bool": "true", "int": "2", "float": "1.0f", "double": "1.0", "u64": "UINT64_MAX", "string": "\"name\""}.get(base)
    if base in HANDLES:
        value = f"c->{STALE[base]}"
    elif base in BY_VALUE or base == "JointDef":
        value = f"c->{snake(base)}"
    elif base in table.enums:
        value = "1"
    elif base in table.variants:
        value = f"cairn_default_{snake(base)}(1)"
    elif base in table.structs:
        value = f"cairn_default_{snake(base)}()"
    own = "const char*" if base == "string" else c_name(base)
    if base == "string" or not kind.endswith("*"):
        return [f"    {own} {name} = {value};"], name
    return [f"    {own} {name}_value = {value};", f"    const {own}* {name} = &{name}_value;"], f"{name}_value"


def program(table):
    text = f"// {MADE}\n// clang-format off\n#include \"wrong_calls.h\"\n\n#include <math.h>\n#include <stddef.h>\n\n"
    rows = ""
    for function in table.functions:
        if function.custom or is_plain(function):
            continue
        source, own = call_source(table, function)
        text += source + "\n"
        rows += own
    return text + f"const struct wrong_call wrong_calls[] = {{\n{rows}}};\nconst int wrong_call_count = " \
                  "(int)(sizeof wrong_calls / sizeof wrong_calls[0]);\n"
