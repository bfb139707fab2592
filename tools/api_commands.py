"""Generates src/commands/generated/* from the table: the commands of a world. Each call that changes a world has a
number and arguments; the generated code writes it as bytes and reads it again, and recordings contain a description of
this encoding."""
import json
import re

from api_c_source import fitted
from api_table import HANDLES, SCALARS, VECTORS
from api_text import MADE

TOP = f"// {MADE}\n// clang-format off\n"
FOLDER = "src/commands/generated"
# Types with hand-written code (commands/command_writer.h), and their descriptions in recordings.
BY_HAND = {
    "Hull": [["geometry", "geometry"], ["rounding", "float"]],
    "Mesh": [["geometry", "geometry"]],
    "HeightField": [["geometry", "geometry"]],
}
# Commands whose arguments in the table exist only in C, with their C++ arguments.
ARGUMENTS = {"world_restore": [("snapshot", "Snapshot")]}


def commands(table):
    """The calls that change a world, in the order of their numbers; those with 0 are not reported to listeners."""
    return sorted((f for f in table.functions if f.command is not None), key=lambda f: f.command)


def arguments(function):
    """(name, type) of each argument; for calls of Body the body comes first."""
    own = ARGUMENTS.get(function.name) or [(a.name, a.type) for a in function.args]
    return ([("body", "BodyId")] if function.owner == "Body" else []) + own


def base(kind):
    return re.sub(r"\?$|\[\d*\]$", "", kind)


def reached(table):
    """Names of the structs, variants and enums that commands contain, in the order of the table."""
    found = set()

    def visit(kind):
        kind = base(kind)
        if kind in found:
            return
        if kind in table.structs or kind in table.variants or kind in table.enums:
            found.add(kind)
        if kind in table.structs and kind not in BY_HAND:
            for member in table.structs[kind].fields:
                visit(member.type)
        if kind in table.variants:
            for alternative in table.variants[kind].alternatives:
                visit(alternative.type)

    for function in commands(table):
        for _, kind in arguments(function):
            visit(kind)
    return found


def class_name(function):
    return "".join(part.capitalize() for part in function.name.split("_"))


def argument_types(table, function):
    return ", ".join("std::string_view" if kind == "string" else table.cpp_type(kind) if kind != "Snapshot" else kind
                     for _, kind in arguments(function))


def calls_header(table):
    text = TOP + "// The calls that change a world.\n#pragma once\n\n#include <cairn/body.h>\n#include <cairn/joint.h>\n"
    text += "#include <cairn/shape.h>\n#include <cairn/world.h>\n\n#include <cstdint>\n#include <optional>\n"
    text += "#include <string_view>\n#include <tuple>\n\nnamespace cairn::commands {\n\n"
    text += "// `code`: what it is in bytes; 0: nobody is told of it, as no result depends on it. `moves_only`: it leaves alone\n"
    text += "// what snapshots have as definitions.\n"
    for f in commands(table):
        text += f"struct {class_name(f)} {{\n    static constexpr std::uint32_t code = {f.command};\n"
        text += f"    static constexpr const char* name = \"{f.owner}::{f.method}\";\n"
        text += f"    static constexpr bool moves_only = {'true' if f.moves_only else 'false'};\n"
        text += f"    using Arguments = std::tuple<{argument_types(table, f)}>;\n}};\n"
        text += f"inline constexpr {class_name(f)} {f.name}{{}};\n"
    return text + "\n} // namespace cairn::commands\n"


def codec_header(table):
    text = TOP + "#pragma once\n\n#include \"commands/command_reader.h\"\n#include \"commands/command_writer.h\"\n\n"
    text += "#include <cairn/world.h>\n\nnamespace cairn::commands {\n\n"
    for name in composed(table):
        cpp = table.cpp_type(name)
        text += f"void write(CommandWriter& to, const {cpp}& x);\nvoid read(CommandReader& from, {cpp}& x);\n"
    return text + "\n} // namespace cairn::commands\n"


def composed(table):
    """Structs and variants, each after those that it contains."""
    names, found = reached(table), []

    def visit(name):
        if name in found or name in BY_HAND or name not in names:
            return
        parts = table.structs[name].fields if name in table.structs else table.variants[name].alternatives
        for part in parts:
            if base(part.type) in table.structs or base(part.type) in table.variants:
                visit(base(part.type))
        found.append(name)

    for name in list(table.structs) + list(table.variants):
        visit(name)
    return found


def struct_writing(table, struct):
    cpp, count = table.cpp_type(struct.name), len(struct.fields)
    unused = "" if count else "[[maybe_unused]] "
    text = f"void write(CommandWriter& to, {unused}const {cpp}& x) {{\n    to.number({count});\n"
    return text + "".join(f"    write(to, x.{m.name});\n" for m in struct.fields) + "}\n\n"


def struct_reading(table, struct):
    cpp, count = table.cpp_type(struct.name), len(struct.fields)
    unused = "" if count else "[[maybe_unused]] "
    text = f"void read(CommandReader& from, {unused}{cpp}& x) {{\n"
    text += f"    {'const std::size_t members = ' if count else ''}from.member_count({count}, \"{struct.name}\");\n"
    for number, m in enumerate(struct.fields):
        last = f", {len(table.enums[m.type].values) - 1}" if m.type in table.enums else ""
        call = f"from.enumerator(x.{m.name}{last}, \"{struct.name}.{m.name}\")" if last else f"read(from, x.{m.name})"
        text += f"    if (members > {number}) {call};\n"
    return text + "}\n\n"


def variant_writing(table, variant):
    text = f"void write(CommandWriter& to, const {variant.name}& x) {{\n    to.number(x.index());\n"
    return text + "    std::visit([&](const auto& alternative) { write(to, alternative); }, x);\n}\n\n"


def variant_reading(table, variant):
    text = f"void read(CommandReader& from, {variant.name}& x) {{\n"
    text += f"    switch (from.choice({len(variant.alternatives)}, \"{variant.name}\")) {{\n"
    for number, alternative in enumerate(variant.alternatives):
        if alternative.type in BY_HAND:
            text += f"    case {number}: x = from.{alternative.name}(); break;\n"
        else:
            text += f"    case {number}: read(from, x.emplace<{number}>()); break;\n"
    return text + "    }\n}\n\n"


def codec_source(table, of_struct, of_variant):
    text = TOP + "#include \"commands/generated/codec.h\"\n\n#include <variant>\n\nnamespace cairn::commands {\n\n"
    for name in composed(table):
        text += of_struct(table, table.structs[name]) if name in table.structs else of_variant(table, table.variants[name])
    return fitted(text + "} // namespace cairn::commands\n")


def read_argument(table, name, kind):
    if kind in table.enums:
        last = len(table.enums[kind].values) - 1
        return f"        {table.cpp_type(kind)} {name}{{}};\n        from.enumerator({name}, {last}, \"{name}\");\n"
    if kind == "Snapshot":
        return f"        const Snapshot& {name} = from.snapshot();\n"
    return f"        {'std::string' if kind == 'string' else table.cpp_type(kind)} {name}{{}};\n        read(from, {name});\n"


def execute_source(table):
    """Source that executes a command, and that returns its name."""
    text = TOP + "#include \"commands/execute.h\"\n#include \"commands/generated/calls.h\"\n#include \"commands/generated/codec.h\"\n\n"
    text += "#include <string>\n\nnamespace cairn::commands {\n\n"
    groups = {}
    for f in commands(table):
        if f.command:
            groups.setdefault(f.owner, []).append(f)
    for owner, made in groups.items():
        text += f"static bool execute_{owner.lower()}(World& world, std::uint64_t code, CommandReader& from) {{\n    switch (code) {{\n"
        for f in made:
            text += f"    case {class_name(f)}::code: {{\n"
            text += "".join(read_argument(table, name, kind) for name, kind in arguments(f))
            names = ", ".join(name for name, _ in arguments(f)[1 if owner == "Body" else 0:])
            subject = "world.body(body)" if owner == "Body" else "world"
            text += f"        from.finish();\n        {subject}.{f.method}({names});\n        return true;\n    }}\n"
        text += "    default: return false;\n    }\n}\n"
    text += "void execute(World& world, CommandReader& from) {\n    const std::uint64_t code = from.number();\n"
    tries = " && ".join(f"!execute_{owner.lower()}(world, code, from)" for owner in groups)
    text += f"    if ({tries}) from.refuse_code(code);\n}}\n\n"
    text += "std::string_view name_of(std::uint64_t code) {\n    switch (code) {\n"
    for f in commands(table):
        if f.command:
            text += f"    case {f.command}: return \"{f.owner}::{f.method}\";\n"
    text += "    default: return {};\n    }\n}\n\n} // namespace cairn::commands\n"
    return fitted(text)


def description(table):
    """The description of the encoding that a recording contains, as JSON."""
    names = reached(table)
    calls = {str(f.command): [f"{f.owner}::{f.method}", [[name, kind] for name, kind in arguments(f)]]
             for f in commands(table) if f.command}
    structs = {name: BY_HAND.get(name) or [[m.name, m.type] for m in s.fields] for name, s in table.structs.items() if name in names}
    variants = {name: [a.type for a in v.alternatives] for name, v in table.variants.items() if name in names}
    enums = {name: [value.name for value in e.values] for name, e in table.enums.items() if name in names}
    return {
        "encoding": "cairn commands, version 1",
        "rules": [
            "A command is the number of its call and its arguments, one after the other, without padding.",
            "Whole numbers (int, u32, u64, size, counts): LEB128; int after zigzag. float, double: IEEE 754, little endian. bool: 0 or 1.",
            "string: count of bytes, bytes. T?: 0, or 1 and a T. T[]: count, elements. T[3]: 3 elements.",
            "Vec2, Vec3, Quat: 2, 3, 4 floats (Quat: x, y, z, w). Position: 3 doubles.",
            "BodyId and other handles: 0 for none, else slot index + 1 and generation.",
            "enum: number of the enumerator. variant: number of the alternative, and it. struct: count of members, members; what "
            "is absent at the end has its default.",
            "geometry, Snapshot: the number under which the recording holds it.",
        ],
        "calls": calls, "structs": structs, "variants": variants, "enums": enums,
    }


def description_lines(whole):
    """JSON with one line for each rule, call and type."""
    parts = []
    for key, value in whole.items():
        if isinstance(value, dict):
            inner = ",\n".join(f"{json.dumps(k)}: {json.dumps(v)}" for k, v in value.items())
            parts.append(f"{json.dumps(key)}: {{\n{inner}}}")
        elif isinstance(value, list):
            parts.append(f"{json.dumps(key)}: [\n" + ",\n".join(json.dumps(v) for v in value) + "]")
        else:
            parts.append(f"{json.dumps(key)}: {json.dumps(value)}")
    return ("{" + ",\n".join(parts) + "}").split("\n")


def description_source(table):
    text = TOP + "#include <cairn/commands.h>\n\nnamespace cairn {\n\nstd::string_view command_encoding() noexcept {\n    return "
    pieces = []
    for line in description_lines(description(table)):
        line += "\n"
        pieces += [json.dumps(line[at:at + 84]) for at in range(0, len(line), 84)]
    return text + "\n           ".join(pieces) + ";\n}\n\n} // namespace cairn\n"


def files(table):
    yield f"{FOLDER}/calls.h", calls_header(table)
    yield f"{FOLDER}/codec.h", codec_header(table)
    yield f"{FOLDER}/writing.cpp", codec_source(table, struct_writing, variant_writing)
    yield f"{FOLDER}/reading.cpp", codec_source(table, struct_reading, variant_reading)
    yield f"{FOLDER}/execute.cpp", execute_source(table)
    yield f"{FOLDER}/description.cpp", description_source(table)


def disagreements(table):
    """Errors in the numbers of commands, one line each."""
    used = {}
    for function in table.functions:
        if function.changes and function.command is None and not function.custom:
            yield f"{function.name} changes a world, but has no number (command) in the table"
        if function.command is not None and not function.changes:
            yield f"{function.name} has the number of a command, but changes nothing"
        if function.command:
            if function.command in used:
                yield f"{function.name} and {used[function.command]} are both command {function.command}"
            used[function.command] = function.name
