"""The implementation of the C API, src/c_api/generated/*, from the table."""
import re

from api_c_header import ENUM_NAMES, c_parameters, count_of, is_plain, result_name
from api_table import HANDLES, SCALARS, VECTORS, snake
from api_text import BY_VALUE, C_SCALARS, COLUMNS, MADE, c_name, constant, wrapped

TOP = f"// {MADE}\n// clang-format off\n"


def converted(table):
    """The structs whose conversion is generated."""
    return [s for s in table.structs.values() if not s.custom and not s.c_only]


def convert_header(table):
    text = TOP + "#pragma once\n\n#include \"c_api/convert.h\"\n\nnamespace cairn::c_api {\n\n"
    for enum in table.enums.values():
        text += f"{enum.cpp} to_{snake(enum.name)}({c_name(enum.name)} value, const char* field);\n"
    text += "\n"
    for struct in converted(table):
        if struct.is_input:
            text += f"{struct.name} to_cpp(const {c_name(struct.name)}& c);\n"
        text += f"{c_name(struct.name)} to_c(const {struct.name}& x);\n"
    for variant in table.variants.values():
        text += f"{variant.name} to_cpp(const {c_name(variant.name)}& c);\n"
        text += f"{c_name(variant.name)} to_c(const {variant.name}& x);\n"
    return text + "\n} // namespace cairn::c_api\n"


def enum_source(enum):
    text = f"{enum.cpp} to_{snake(enum.name)}({c_name(enum.name)} value, const char* field) {{\n"
    last = len(enum.values) - 1
    names = ", ".join(v.name for v in enum.values)
    text += f"    if (value < 0 || value > {last})\n"
    text += f"        throw Error(ErrorCode::invalid_value, field, std::to_string(value), \"must be 0 to {last} ({names})\");\n"
    return text + f"    return {enum.cpp}(value);\n}}\n\n"


def into_cpp(table, member, where):
    """Statements that set x.member from c.member."""
    name, kind = member.name, member.type

    def value(inner, kind):
        if kind in table.enums:
            return f"to_{snake(kind)}({inner}, \"{where}.{name}\")"
        return inner if kind in SCALARS else f"to_cpp({inner})"

    if kind.endswith("?"):
        return f"    if (c.has_{name}) x.{name} = {value('c.' + name, kind[:-1])};\n"
    if kind.endswith("[]"):
        count = f"c.{count_of(name)}"
        return f"    require_list(c.{name}, {count}, \"{where}.{name}\");\n" \
               f"    for (std::size_t i = 0; i < {count}; ++i) x.{name}.push_back({value(f'c.{name}[i]', kind[:-2])});\n"
    many = re.match(r"(.*)\[(\d+)\]$", kind)
    if many:
        return f"    for (std::size_t i = 0; i < {many[2]}; ++i) x.{name}[i] = {value(f'c.{name}[i]', many[1])};\n"
    if kind == "string":
        return f"    x.{name} = text_of(c.{name});\n"
    return f"    x.{name} = {value('c.' + name, kind)};\n"


def into_c(table, member):
    """Statements that set c.member from x.member."""
    name, kind = member.name, member.type

    def value(inner, kind):
        if kind in table.enums:
            return f"{c_name(kind)}({inner})"
        return inner if kind in SCALARS else f"to_c({inner})"

    if kind.endswith("?"):
        return f"    c.has_{name} = x.{name}.has_value();\n    if (x.{name}) c.{name} = {value('*x.' + name, kind[:-1])};\n"
    if kind.endswith("[]"):
        return f"    c.{count_of(name)} = x.{name}.size();\n"
    many = re.match(r"(.*)\[(\d+)\]$", kind)
    if many:
        return f"    for (std::size_t i = 0; i < {many[2]}; ++i) c.{name}[i] = {value(f'x.{name}[i]', many[1])};\n"
    if kind == "string":
        return ""
    return f"    c.{name} = {value('x.' + name, kind)};\n"


def struct_source(table, struct):
    name, text = c_name(struct.name), ""
    unused = "" if struct.fields else "[[maybe_unused]] "
    if struct.is_input:
        body = "".join(into_cpp(table, m, struct.name) for m in struct.fields)
        text += f"{struct.name} to_cpp({unused}const {name}& c) {{\n    {struct.name} x;\n{body}    return x;\n}}\n"
    body = "".join(into_c(table, m) for m in struct.fields)
    size = "    c.struct_size = sizeof c;\n" if struct.versioned else ""
    text += f"{name} to_c({unused}const {struct.name}& x) {{\n    {name} c{{}};\n{size}{body}    return c;\n}}\n\n"
    return text


def variant_source(variant):
    name, last = c_name(variant.name), len(variant.alternatives) - 1
    text = f"{variant.name} to_cpp(const {name}& c) {{\n    switch (c.kind) {{\n"
    for alternative in variant.alternatives:
        text += f"    case {constant(variant.name, alternative.name)}: return to_cpp(c.as.{alternative.name});\n"
    text += f"    default:\n        throw Error(ErrorCode::invalid_value, \"{variant.name}.kind\", std::to_string(c.kind), " \
            f"\"must be 0 to {last}\");\n    }}\n}}\n"
    text += f"{name} to_c(const {variant.name}& x) {{\n    {name} c{{}};\n    c.kind = {name}_kind(x.index());\n    switch (c.kind) {{\n"
    for number, alternative in enumerate(variant.alternatives):
        text += f"    case {constant(variant.name, alternative.name)}: c.as.{alternative.name} = to_c(std::get<{number}>(x)); break;\n"
    return text + "    }\n    return c;\n}\n\n"


def convert_source(table, group):
    """Source of the conversions for a group of the table; empty if there are none."""
    made = [enum_source(e) for e in table.enums.values() if e.group == group]
    made += [struct_source(table, s) for s in converted(table) if s.group == group]
    made += [variant_source(v) for v in table.variants.values() if v.group == group]
    if not made:
        return ""
    text = TOP + "#include \"c_api/generated/convert.h\"\n\n#include <string>\n\nnamespace cairn::c_api {\n\n"
    return fitted(text + "".join(made) + "} // namespace cairn::c_api\n")


def defaults_source(table):
    text = TOP + "#include \"c_api/generated/convert.h\"\n\n#include <cairn/c/cairn.h>\n\nusing namespace cairn::c_api;\n\n"
    for struct in table.structs.values():
        if not (struct.is_input or struct.versioned):
            continue
        name, function = c_name(struct.name), f"cairn_default_{snake(struct.name)}(void)"
        if struct.c_only:
            value = f"    {name} c{{}};\n    c.struct_size = sizeof c;\n    return c;\n"
        else:
            value = f"    return {name}{{}};\n" if struct.custom else f"    return to_c(cairn::{struct.name}{{}});\n"
        text += f"{name} {function} {{\n{value}}}\n"
    for variant in table.variants.values():
        name = c_name(variant.name)
        text += f"{name} cairn_default_{snake(variant.name)}({name}_kind kind) {{\n    {name} c{{}};\n    switch (kind) {{\n"
        for alternative in variant.alternatives[1:]:
            default = f"cairn_default_{snake(alternative.type)}()"
            text += f"    case {constant(variant.name, alternative.name)}: c.as.{alternative.name} = {default}; break;\n"
        first = variant.alternatives[0]
        text += f"    default: kind = 0; c.as.{first.name} = cairn_default_{snake(first.type)}(); break;\n    }}\n"
        text += "    c.kind = kind;\n    return c;\n}\n"
    return text


def argument(table, arg):
    """(checks before the call, expression of the argument)."""
    name, kind = arg.name, arg.type
    if kind.endswith("?"):
        inner = kind[:-1]
        value = f"*{name}" if inner in SCALARS else f"to_cpp(*{name})"
        return "", f"{name} ? {table.cpp_type(kind)}({value}) : std::nullopt".replace("std::optional<", "std::optional<")
    if kind == "string":
        return "", f"required_text({name}, \"{name}\")"
    if kind in C_SCALARS:
        return "", name
    if kind in table.enums:
        return "", f"to_{snake(kind)}({name}, \"{name}\")"
    if kind in HANDLES or kind in BY_VALUE:
        return "", f"to_cpp({name})"
    struct = table.structs.get(kind)
    value = f"to_cpp(required({name}, \"{name}\"))"
    if struct and struct.versioned:
        first = f", {struct.first_size}" if struct.first_size else ""
        value = f"to_cpp(versioned(*{name}, \"{name}\", cairn_default_{snake(kind)}(){first}))"
        if arg.default != "{}":
            value = value.replace(f"(*{name}", f"(required({name}, \"{name}\")")
    if arg.default == "{}":
        return "", f"{name} ? {value} : {kind}{{}}"
    return "", value


def fitted(text):
    """Wraps statements that are too long for a line after a comma or before an operator."""
    lines = []
    for line in text.split("\n"):
        indent = " " * (len(line) - len(line.lstrip()) + 4)
        while len(line) > COLUMNS:
            places = [m.start() + (m[0] == ", ") for m in re.finditer(r", | \? | : ", line[:COLUMNS + 1])
                      if m.start() > len(indent) and line[:m.start()].count('"') % 2 == 0]
            if not places:
                break
            at = places[-1]
            lines.append(line[:at].rstrip())
            line = indent + line[at:].lstrip()
        lines.append(line)
    return "\n".join(lines)


def function_source(table, function):
    returns = "bool" if is_plain(function) else "cairn_result"
    text = wrapped(f"{returns} cairn_{function.name}(", c_parameters(function).split(", "), ") {").rstrip("\n") + "\n"
    subject = "world_of(world)" if function.owner == "World" else "world_of(world).body(to_cpp(body))"
    call = f"{subject}.{function.method}({', '.join(argument(table, a)[1] for a in function.args)})"
    if function.member:
        call += f".{function.member}"
    if is_plain(function):
        return text + f"    return world && {call};\n}}\n"
    kind, checks, body = function.returns, "", ""
    result = result_name(function) if kind else ""
    if not kind:
        body = f"        {call};\n"
    elif kind.endswith("[]"):
        checks = f"        require_room({result}, capacity, count, \"{result}\");\n"
        body = f"        write_list({call}, {result}, capacity, count, [](const auto& x) {{ return to_c(x); }});\n"
    elif kind == "string":
        checks = "        require_room(text, capacity, length, \"text\");\n"
        body = f"        write_text({call}, text, capacity, length);\n"
    elif kind.endswith("?"):
        checks = f"        required({result}, \"{result}\");\n        required(found, \"found\");\n"
        body = f"        const auto answer = {call};\n        *found = answer.has_value();\n" \
               f"        if (answer) *{result} = to_c(*answer);\n"
    elif kind in table.structs and table.structs[kind].versioned:
        first = f", {table.structs[kind].first_size}" if table.structs[kind].first_size else ""
        checks = f"        require_versioned({result}, \"{result}\"{first});\n"
        body = f"        write_versioned(to_c({call}), {result});\n"
    else:
        value = call if kind in SCALARS else f"{c_name(kind)}({call})" if kind in table.enums else f"to_c({call})"
        checks = f"        required({result}, \"{result}\");\n"
        body = f"        *{result} = {value};\n"
    return text + f"    return guarded([&] {{\n{checks}{body}    }});\n}}\n"


def functions_source(table, group):
    ENUM_NAMES.update(c_name(name) for name in table.enums)
    text = TOP + "#include \"c_api/generated/convert.h\"\n#include \"c_api/support.h\"\n\n#include <cairn/c/cairn.h>\n\n"
    text += "using namespace cairn::c_api;\nusing namespace cairn;\n\n"
    made = [f for f in table.functions if f.group == group and not f.custom]
    return fitted(text + "\n".join(function_source(table, f) for f in made)) if made else ""


def exported(table):
    """Names of all functions of the library, each with the version that introduced it."""
    names = {f"cairn_{f.name}": f.since for f in table.functions}
    for struct in table.structs.values():
        if struct.is_input or struct.versioned:
            names[f"cairn_default_{snake(struct.name)}"] = "0.1"
    for variant in table.variants.values():
        names[f"cairn_default_{snake(variant.name)}"] = "0.1"
    return names


def version_script(table):
    """The version script of the linker: the version of each symbol, so that a program states which versions it
    needs."""
    names = exported(table)
    text, before = f"# {MADE}\n", ""
    for version in sorted(set(names.values()), key=lambda v: [int(n) for n in v.split(".")]):
        own = sorted(name for name, since in names.items() if since == version)
        local = "" if before else "local: *; "
        text += f"CAIRN_{version} {{\nglobal:\n" + "".join(f"    {name};\n" for name in own) + f"{local}}}{before};\n"
        before = f" CAIRN_{version}"
    return text


def layout_program(table):
    """A C program that prints the size of each struct and the offsets of its members."""
    text = TOP + "#include <cairn/c/cairn.h>\n#include <stdio.h>\n\n"
    text += "#define SIZE(type) printf(#type \" %d\\n\", (int)sizeof(type))\n"
    text += "#define MEMBER(type, member) printf(#type \".\" #member \" %d\\n\", (int)offsetof(type, member))\n\n"
    text += "int main(void) {\n"
    for struct in table.structs.values():
        name = c_name(struct.name)
        text += f"    SIZE({name});\n"
        members = ["struct_size"] if struct.versioned else []
        for member in struct.fields:
            if member.type.endswith("?"):
                members.append(f"has_{member.name}")
            members.append(member.name)
            if member.type.endswith("[]"):
                members.append(count_of(member.name))
        text += "".join(f"    MEMBER({name}, {member});\n" for member in members)
    for variant in table.variants.values():
        text += f"    SIZE({c_name(variant.name)});\n    MEMBER({c_name(variant.name)}, as);\n"
    for name in [*VECTORS, *HANDLES]:
        text += f"    SIZE({c_name(name)});\n"
    return text + "    return 0;\n}\n"
