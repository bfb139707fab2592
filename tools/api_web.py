"""What the npm package has from the table: how values lie in the memory of the module (web/src/generated/values.js) and the
calls of World and Body (calls.js). The package's types are made by api_web_types.py."""
import re

from api_python import is_property, methods, setters
from api_table import HANDLES, VECTORS, snake
from api_text import BY_VALUE, C_SCALARS, MADE, constant, described
from api_web_layout import Layout, checks, exports

TOP = f"// {MADE}\n"
NUMBERS = {"Vec2": 2, "Vec3": 3, "DVec3": 3, "Position": 3, "Quat": 4}
# Written by hand in web/src/world.js.
BY_HAND = {"create_body", "destroy_body", "step", "is_valid", "joint_at", "joint_def"}


def camel(name):
    first, *others = name.rstrip("_").split("_")
    return first + "".join(word.capitalize() for word in others)


def javascript_words(text):
    """The documentation of C++ in the words of JavaScript."""
    text = re.sub(r"`([^`]+)`", lambda found: "`" + re.sub(r"[a-z]+(?:_[a-z]+)+", lambda n: camel(n[0]), found[1]) + "`", text)
    for name in ("World", "WorldDef", "BodyDef", "ShapeDef", "CollisionFilter"):
        text = re.sub(rf"\b{name}::(\w+)", lambda found, n=name: f"{n}.{camel(found[1])}", text)
    text = re.sub(r"\b[a-z]+(?:_[a-z]+)+\b", lambda found: camel(found[0]) if "`" not in found[0] else found[0], text)
    return re.sub(r"\b[Aa]bsent:", "Left out:", text)


def structs(table):
    return [s for s in table.structs.values() if not s.c_only]


# --- values

def put(table, kind, at, value, where):
    """A statement that writes a value of the user's into the module's memory."""
    if kind in table.enums:
        return f"putEnum({at}, {value}, {constant_name(kind)}, {where});"
    if kind in table.structs or kind in table.variants:
        return f"put{kind}({at}, {value}, {where});"
    if kind in HANDLES:
        return f"putHandle({at}, {value}, {where});"
    many = re.match(r"(.*)\[(\d+)\]$", kind)
    if many:
        size = Layout(table).size(many[1])[0]
        inner = put(table, many[1], f"at + {size} * i", "x", "place")
        return f"putMany({at}, {value}, {many[2]}, {where}, (at, x, i, place) => {{ {inner} }});"
    name = {"u32": "U32", "u64": "U64"}.get(kind, kind[0].upper() + kind[1:])
    return f"put{name}({at}, {value}, {where});"


def get(table, kind, at, count=None):
    """An expression that reads a value; `count`: of how many there are, where an array has room for more."""
    if kind in table.enums:
        return f"{constant_name(kind)}[getInt({at})]"
    if kind in table.structs or kind in table.variants:
        return f"get{kind}({at})"
    if kind in HANDLES:
        return f"getU64({at})"
    many = re.match(r"(.*)\[(\d+)\]$", kind)
    if many:
        size = Layout(table).size(many[1])[0]
        return f"getMany({at}, {count or many[2]}, {size}, (at) => {get(table, many[1], 'at')})"
    name = {"u32": "U32", "u64": "U64"}.get(kind, kind[0].upper() + kind[1:])
    return f"get{name}({at})"


def constant_name(kind):
    return snake(kind).upper()


def plus(at, offset):
    return f"{at} + {offset}" if offset else at


def member_put(table, layout, struct, member):
    place, where = layout.of(struct.name)[member.name], f"'{struct.name}.{camel(member.name)}'"
    kind, at = member.type, plus("p", place.offset)
    if kind.endswith("?"):
        inner = kind[:-1]
        default = f" {default_call(inner, at)}" if inner in table.structs else ""
        return f"if (x === null) continue;{default} {put(table, inner, at, 'x', where)} putBool({plus('p', place.flag)}, true, {where});"
    if kind.endswith("[]"):
        inner, size = kind[:-2], layout.size(kind[:-2])[0]
        default = f"{default_call(inner, 'at')} " if inner in table.structs else ""
        return f"putList({at}, {plus('p', place.count)}, x, {size}, {where}, (at, x, place) => " \
               f"{{ {default}{put(table, inner, 'at', 'x', 'place')} }});"
    return put(table, kind, at, "x", where)


def default_call(kind, at):
    return f"M._cairn_default_{snake(kind)}({at});"


def member_get(table, layout, struct, member):
    place, kind = layout.of(struct.name)[member.name], member.type
    at = plus("p", place.offset)
    if kind.endswith("?"):
        return f"getBool({plus('p', place.flag)}) ? {get(table, kind[:-1], at)} : null"
    if kind.endswith("[]"):
        size = layout.size(kind[:-2])[0]
        return f"getList({at}, {plus('p', place.count)}, {size}, (at) => {get(table, kind[:-2], 'at')})"
    if member.count:
        return get(table, kind, at, f"getInt({plus('p', layout.of(struct.name)[member.count].offset)})")
    return get(table, kind, at)


def struct_values(table, layout, struct):
    text = ""
    if struct.is_input:
        names = [camel(m.name) for m in struct.fields]
        text += f"\nexport function put{struct.name}(p, value, where) {{\n    for (const key of keysOf(value, where)) {{\n" \
                "        const x = value[key];\n        if (x === undefined) continue;\n        switch (key) {\n"
        for member in struct.fields:
            text += f"        case '{camel(member.name)}': {member_put(table, layout, struct, member)} break;\n"
        text += f"        default: unknown('{struct.name}', key, {names});\n        }}\n    }}\n}}\n"
    members = ",\n".join(f"        {camel(m.name)}: {member_get(table, layout, struct, m)}" for m in struct.fields)
    text += f"\nexport function get{struct.name}(p) {{\n    return {{\n{members},\n    }};\n}}\n" if members else \
        f"\nexport function get{struct.name}() {{\n    return {{}};\n}}\n"
    return text


def variant_values(table, layout, variant):
    at = layout.union_offset(variant.name)
    name, kinds = variant.name, constant_name(variant.name) + "_KINDS"
    text = f"\nexport const {kinds} = {[camel(a.name) for a in variant.alternatives]};\n"
    text += f"\n// An object whose `kind` says what it is; the other members are those of that kind.\n" \
            f"export function put{name}(p, value, where) {{\n    const {{ kind, ...members }} = objectOf(value, where);\n" \
            f"    const number = indexOf({kinds}, kind, where + '.kind');\n    M._cairn_default_{snake(name)}(p, number);\n" \
            "    switch (number) {\n"
    for number, alternative in enumerate(variant.alternatives):
        text += f"    case {number}: return put{alternative.type}(p + {at}, members, where);\n"
    text += f"    }}\n}}\n\nexport function get{name}(p) {{\n    switch (getInt(p)) {{\n"
    for number, alternative in enumerate(variant.alternatives):
        text += f"    case {number}: return {{ kind: '{camel(alternative.name)}', ...get{alternative.type}(p + {at}) }};\n"
    return text + "    }\n}\n"


def values(table):
    layout = Layout(table)
    text = TOP + "// How the structs of the API lie in the memory of the module.\n"
    text += "import { M, objectOf, keysOf, indexOf, unknown } from '../memory.js';\nimport * as memory from '../memory.js';\n"
    names = sorted({f"{verb}{kind}" for verb in ("put", "get") for kind in
                    ("Bool", "Int", "Float", "Double", "U32", "U64", "Size", "String", "Geometry", *VECTORS)} - {"putMat3"}
                   | {"putEnum", "putHandle", "putList", "putMany", "getList", "getMany"})
    text = text.replace("import * as memory from '../memory.js';\n", "import {\n" + "".join(f"    {n},\n" for n in names) + "} from '../fields.js';\n")
    for enum in table.enums.values():
        text += f"\nexport const {constant_name(enum.name)} = {[camel(v.name) for v in enum.values]};\n"
    for struct in structs(table):
        text += struct_values(table, layout, struct)
    for variant in table.variants.values():
        text += variant_values(table, layout, variant)
    text += "\n// Of what lists by hand are made, and of definitions.\n"
    for kind in ("Material", "JointSpring", "JointLimit", "JointDrive", "JointDef", "Joint", "BodyDef", "WorldDef", "SnapshotSizes", "BodyArrays"):
        text += f"export const {constant_name(kind)}_BYTES = {layout.size(kind)[0]};\n"
    text += "export const BODY_ARRAYS_OFFSETS = { " + ", ".join(
        f"{camel(name)}: {place.offset}" for name, place in layout.of("BodyArrays").items() if not name.endswith("stride")) + " };\n"
    return text


# --- calls

def argument(table, layout, arg):
    """The statements before a call that put an argument in place, and what is handed over for it."""
    name, kind, where = "$" + camel(arg.name), arg.type, f"'{camel(arg.name)}'"
    given = parameter_name(arg)
    if kind in HANDLES:
        return f"        const {name} = handleOf({given}, {where});\n", [f"{name}[0]", f"{name}[1]"]
    if kind == "u64":
        return f"        const {name} = u64Of({given}, {where});\n", [f"{name}[0]", f"{name}[1]"]
    if kind in ("float", "double"):
        return f"        const {name} = numberOf({given}, {where});\n", [name]
    if kind in ("int", "size"):
        return f"        const {name} = wholeOf({given}, {where});\n", [name]
    if kind == "bool":
        return f"        const {name} = boolOf({given}, {where});\n", [name]
    if kind == "string":
        return f"        const {name} = textAt({given}, {where});\n", [name]
    if kind in table.enums:
        return f"        const {name} = indexOf(values.{constant_name(kind)}, {given}, {where});\n", [name]
    inner = kind.removesuffix("?")
    size = layout.size(inner)[0]
    at = f"        const {name} = room({size});\n"
    if kind.endswith("?"):
        put_it = put(table, inner, "at", given, where).replace("put", "fields.put", 1)
        return f"        const {name} = {given} === undefined || {given} === null ? 0 : placed({size}, (at) => {put_it[:-1]});\n", [name]
    if inner in table.structs:
        return f"{at}        M._cairn_default_{snake(inner)}({name});\n        values.put{inner}({name}, {given}, '{inner}');\n", [name]
    if inner in table.variants:
        return f"{at}        values.put{inner}({name}, {given}, '{inner}');\n", [name]
    return f"{at}        fields.put{inner}({name}, {given}, {where});\n", [name]


def parameter_name(arg):
    return {"def": "definition"}.get(camel(arg.name), camel(arg.name))


def default_of(arg):
    return {"{}": " = {}"}.get(arg.default, "")


def reading(table, kind, at):
    text = get(table, kind, at)
    return re.sub(r"\b(get\w+|[A-Z_]{3,}(?=\[))", lambda f: (
        "fields." if f[0] in FIELD_READERS else "values.") + f[0] if f[0] != "M" else f[0], text)


FIELD_READERS = {f"get{n}" for n in ("Bool", "Int", "Float", "Double", "U32", "U64", "Size", "String", "Geometry", *VECTORS)} | {"getMany", "getList"}


def body_of(table, layout, function, owner):
    """The statements of a method."""
    before, call = "", []
    of_body = owner == "Body"
    args = [a for a in function.args if not (of_body and function.owner == "World" and a.type == "BodyId")]
    for arg in args:
        statements, given = argument(table, layout, arg)
        before += statements
        call += given
    first = ["use(this.world)", "this.low", "this.high"] if of_body else ["use(this)"]
    call = ", ".join(first + call)
    kind, name = function.returns, f"M._cairn_{function.name}"
    if not kind:
        return f"{before}        check({name}({call}));\n"
    if kind.endswith("[]"):
        inner, size = kind[:-2], layout.size(kind[:-2])[0]
        return f"{before}        return listOf({size}, (list, capacity, count) => {name}({call}, list, capacity, count), " \
               f"(at) => {reading(table, inner, 'at')});\n"
    if kind == "string":
        return f"{before}        return textOf((text, capacity, length) => {name}({call}, text, capacity, length));\n"
    if kind.endswith("?"):
        inner = kind[:-1]
        return f"{before}        const out = room({layout.size(inner)[0]}), found = room(1);\n" \
               f"        check({name}({call}, out, found));\n" \
               f"        return fields.getBool(found) ? {reading(table, inner, 'out')} : null;\n"
    size = layout.size(kind)[0]
    versioned = f"        M._cairn_default_{snake(kind)}(out);\n" if kind in table.structs and table.structs[kind].versioned else ""
    return f"{before}        const out = room({size});\n{versioned}        check({name}({call}, out));\n" \
           f"        return {reading(table, kind, 'out')};\n"


def method(table, layout, function, owner):
    args = [a for a in function.args if not (owner == "Body" and function.owner == "World" and a.type == "BodyId")]
    parameters = ", ".join(parameter_name(a) + default_of(a) for a in args)
    body = body_of(table, layout, function, owner)
    return wrapped_method(f"{camel(function.method)}({parameters})", body)


def wrapped_method(head, body):
    return f"\n    {head} {{\n        const mark = enter();\n        try {{\n" + \
        "".join("    " + line + "\n" for line in body.rstrip("\n").split("\n")) + \
        "        } finally {\n            leave(mark);\n        }\n    }\n"


def calls(table):
    layout = Layout(table)
    text = TOP + "// The calls of World and Body that say nothing but what the table says; web/src/world.js has the others.\n"
    text += "import { M, ALL_LAYERS, boolOf, check, enter, handleOf, indexOf, leave, listOf, numberOf, placed, room, textAt, textOf, u64Of,\n" \
            "    use, wholeOf } from '../memory.js';\nimport * as fields from '../fields.js';\nimport * as values from './values.js';\n"
    for owner in ("World", "Body"):
        own = setters(table, owner)
        text += f"\nexport class {owner}Calls {{"
        for function in methods(table, owner):
            if function.method in BY_HAND:
                continue
            if is_property(function):
                text += wrapped_method(f"get {camel(function.method)}()", body_of(table, layout, function, owner))
                setter = own.get(function.method)
                if setter:
                    body = body_of(table, layout, setter, owner)
                    text += wrapped_method(f"set {camel(function.method)}({parameter_name(setter.args[0])})", body)
            elif function not in own.values():
                text += method(table, layout, function, owner)
        text += "}\n"
    return text


def call_list(table):
    """The calls that are made from the table, with the types of their arguments: what tests/web/wrong_calls.test.mjs spoils."""
    text = TOP + "export const ENUMS = " + repr(sorted(table.enums)) + ";\nexport const CALLS = [\n"
    for owner in ("World", "Body"):
        own = setters(table, owner)
        for function in methods(table, owner):
            if function.method in BY_HAND or is_property(function):
                continue
            is_setter = function in own.values()
            name = camel(function.method.removeprefix("set_") if is_setter else function.method)
            types = [a.type for a in function.args if not (owner == "Body" and function.owner == "World" and a.type == "BodyId")]
            text += f"    {{ owner: '{owner}', name: '{name}', isSetter: {str(is_setter).lower()}, types: {types} }},\n"
    return text + "];\n"


def files(table):
    yield "tests/web/generated/calls.mjs", call_list(table)
    yield "web/module/layout.cpp", checks(table)
    yield "web/module/exports.txt", exports(table)
    yield "web/src/generated/values.js", values(table)
    yield "web/src/generated/calls.js", calls(table)
