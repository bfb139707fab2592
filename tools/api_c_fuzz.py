"""Generates tests/fuzz/c_api_calls.inc from the table: calls of the C API with arguments from bytes, with their ranges,
and whether they change the world."""
import re

from api_c_header import c_parameters, count_of, is_plain
from api_table import HANDLES, VECTORS, snake
from api_text import MADE, c_name


def draws(table):
    """Source of a function for each struct, variant and enum that is an argument: it draws a value from the bytes."""
    text = ""
    for enum in table.enums.values():
        text += f"int32_t draw_{snake(enum.name)}(CBytes& b) {{ return b.pick(32) ? b.pick({len(enum.values)}) : b.pick(256) - 128; }}\n"
    done = set()

    def visit(item):
        nonlocal text
        if item.name in done:
            return
        done.add(item.name)
        members = item.fields if hasattr(item, "fields") else item.alternatives
        for member in members:
            base = re.sub(r"\?$|\[\d*\]$", "", member.type)
            for group in (table.structs, table.variants):
                if base in group:
                    visit(group[base])
        text += variant_draw(item) if hasattr(item, "alternatives") else struct_draw(table, item)

    for item in [*table.structs.values(), *table.variants.values()]:
        if getattr(item, "is_input", True) and not getattr(item, "c_only", False):
            visit(item)
    return text


# How numbers with a range are drawn: mostly inside the range.
RANGES = {"> 0": "b.positive()", ">= 0": "b.at_least_zero()", "0 to 1": "b.between(0, 1)", "0 to pi": "b.between(0, 3.1415926)",
          "0 to 1.57": "b.between(0, 1.57)", "1e-4 to 1": "b.between(1e-4, 1)",
          "-2, -1, 0 or 1": "double(b.whole_between(-2, 1))"}


def value_of(table, kind, allowed=""):
    if kind in ("float", "double") and allowed in RANGES:
        return RANGES[allowed] if kind == "double" else f"float({RANGES[allowed]})"
    whole = re.fullmatch(r"(-?\d+) to (-?\d+)", allowed)
    if kind == "int" and whole:
        return f"b.whole_between({whole[1]}, {whole[2]})"
    if kind in table.enums or kind in table.structs or kind in table.variants:
        return f"draw_{snake(kind)}(b)"
    if kind in HANDLES:
        return f"b.{snake(kind)}()"
    if kind in VECTORS:
        return f"b.{snake(kind)}()"
    return {"bool": "b.pick(2) != 0", "int": "b.whole()", "float": "float(b.number())", "double": "b.number()",
            "u64": "b.bits()", "size": "b.bits()", "string": "b.text()"}[kind]


GEOMETRIES = ["Hull", "Mesh", "HeightField"]  # in the order of CBytes::geometries


def struct_draw(table, struct):
    name = c_name(struct.name)
    text = f"{name} draw_{snake(struct.name)}([[maybe_unused]] CBytes& b) {{\n    {name} c = cairn_default_{snake(struct.name)}();\n"
    for member in struct.fields:
        kind = member.type
        given = ""
        if kind.endswith("?"):
            given, kind = f"c.has_{member.name} = true, ", kind[:-1]
        many = re.match(r"(.*)\[(\d+)\]$", kind)
        if kind == "geometry":
            text += f"    c.{member.name} = b.geometry({GEOMETRIES.index(struct.name)});\n"
        elif kind.endswith("[]"):
            inner = kind[:-2]
            text += f"    if (b.pick(2)) {{\n        static {c_name(inner)} list[4];\n        c.{count_of(member.name)} = size_t(b.pick(5));\n" \
                    f"        c.{member.name} = b.pick(16) ? list : nullptr;\n" \
                    f"        for (auto& element : list) element = {value_of(table, inner)};\n    }}\n"
        elif many:
            text += f"    for (auto& element : c.{member.name}) element = {value_of(table, many[1])};\n"
        else:
            text += f"    if (b.changes()) {given}c.{member.name} = {value_of(table, kind, member.range)};\n"
    if struct.versioned:
        text += "    if (b.pick(64) == 0) c.struct_size = uint32_t(b.pick(2) ? b.pick(256) : b.bits());\n"
    return text + "    return c;\n}\n"


def variant_draw(variant):
    name = c_name(variant.name)
    last = len(variant.alternatives)
    text = f"{name} draw_{snake(variant.name)}(CBytes& b) {{\n    const int kind = b.pick({last});\n    {name} c = cairn_default_{snake(variant.name)}(kind);\n    switch (kind) {{\n"
    for number, alternative in enumerate(variant.alternatives):
        text += f"    case {number}: c.as.{alternative.name} = draw_{snake(alternative.type)}(b); break;\n"
    # The kind is only changed to an invalid one: with another valid kind, numbers would be read as pointers.
    return text + f"    }}\n    if (b.pick(64) == 0) c.kind = b.pick(2) ? -1 : {last};\n    return c;\n}}\n"


def call_case(table, function, number):
    """A case of the switch: draws the arguments and makes the call."""
    args = {a.name: a for a in function.args}
    lines, names, rooms = "", [], []
    for parameter in c_parameters(function).split(", "):
        kind, name = re.match(r"(.*?[ *])(\w+)$", parameter).groups()
        kind, arg = kind.strip(), args.get(name)
        if name == "world":
            names.append("world")
        elif arg is None and name == "body":
            lines += "        const auto body = b.body_id();\n"
            names.append("body")
        elif arg is None and name == "capacity":
            names.append("capacity")
        elif arg is None:  # arguments that receive results
            base = kind.rstrip("*").strip()
            struct = next((s for s in table.structs.values() if c_name(s.name) == base), None)
            first = f", cairn_default_{snake(struct.name)}()" if struct and struct.versioned else ""
            count = "1"
            if "capacity" in c_parameters(function) and name not in ("count", "length"):
                lines += "        const auto capacity = size_t(b.pick(5));\n"
                count = "capacity"
            room = "answer" if name == "result" else name
            lines += f"        Room<{base}> {room}(b, {count}{first});\n"
            names.append(f"{room}.get()")
            rooms.append(room)
        elif arg.type == "string":
            lines += f"        const char* const {name} = b.text();\n"
            names.append(name)
        elif kind.endswith("*"):
            base = arg.type.removesuffix("?")
            rare = 4 if arg.default or arg.type.endswith("?") else 64
            lines += f"        Given<{c_name(base)}> {name}(b, {value_of(table, base, arg.range)}, {rare});\n"
            names.append(f"{name}.get()")
        else:
            lines += f"        const auto {name} = {value_of(table, arg.type, arg.range)};\n"
            names.append(name)
    call = f"cairn_{function.name}({', '.join(names)})"
    if is_plain(function):
        return f"    case {number}: {{\n{lines}        require(!{call} || world, \"no world has something\");\n        return CAIRN_OK;\n    }}\n"
    keep = ""
    made = {"world_create_body": "bodies", "world_add_shape": "shapes", "world_create_joint": "joints",
            "world_add_force_field": "fields"}.get(function.name)
    if made:
        keep = f"        if (result == CAIRN_OK) b.keep(b.{made}, {rooms[-1]}[0]);\n"
    if function.name == "world_get_shape":
        keep = f"        if (result == CAIRN_OK) release({rooms[-1]}[0]);\n"
    checked = f"done(result{''.join(', ' + r for r in rooms)})" if rooms else "result"
    return f"    case {number}: {{\n{lines}        const cairn_result result = {call};\n{keep}        return {checked};\n    }}\n"


def info(function):
    can_fail = not is_plain(function)  # for all others the world may be null
    return f"    {{\"{function.name}\", {str(function.changes).lower()}, {str(can_fail).lower()}}},\n"


def program(table):
    made = [f for f in table.functions if not f.custom and f.name not in ("world_step", "world_set_threads")]
    text = f"// {MADE}\n// clang-format off\nnamespace cairn_fuzz {{\n\n"
    text += draws(table) + "\n"
    text += "static constexpr CCallInfo infos[] = {\n" + "".join(info(f) for f in made) + "};\n"
    text += "const std::span<const CCallInfo> c_calls(infos);\n\n"
    parts = [made[i:i + 40] for i in range(0, len(made), 40)]
    for part, functions in enumerate(parts):
        text += f"static cairn_result c_calls_{part}(cairn_world* world, CBytes& b, int call) {{\n    switch (call) {{\n"
        text += "".join(call_case(table, f, 40 * part + i) for i, f in enumerate(functions))
        text += "    }\n    return CAIRN_OK;\n}\n\n"
    text += "cairn_result c_call(cairn_world* world, CBytes& b, int call) {\n    switch (call / 40) {\n"
    text += "".join(f"    case {part}: return c_calls_{part}(world, b, call);\n" for part in range(len(parts)))
    return text + "    }\n    return CAIRN_OK;\n}\n\n} // namespace cairn_fuzz\n"
