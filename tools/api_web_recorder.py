"""Generates the World and Body of tests/web's recorder: every call that changes something is made, and written as
JavaScript."""

from api_python import setters
from api_text import MADE
from api_web import camel

# Functions that are hand-written for the recorder, or omitted.
LEFT_OUT = {"is_valid", "step", "read_transforms", "save", "restore", "World", "~World"}


def writers(table):
    text = ""
    for enum in table.enums.values():
        names = ", ".join(f'"\'{camel(v.name)}\'"' for v in enum.values)
        text += f"inline std::string js({enum.cpp} x) {{\n    constexpr const char* names[] = {{{names}}};\n    return names[std::size_t(x)];\n}}\n"
    made = [s for s in table.structs.values() if s.is_input and not s.c_only and not s.custom]
    for item in [*made, *table.variants.values()]:
        text += f"std::string js(const {item.name}& x);\n"
    for struct in made:
        unused = "" if struct.fields else "[[maybe_unused]] "
        members = ", ".join(f'{{"{camel(m.name)}", js(x.{m.name})}}' for m in struct.fields)
        text += f"inline std::string js({unused}const {struct.name}& x) {{ return object({{{members}}}); }}\n"
    for variant in table.variants.values():
        kinds = ", ".join(f'"{camel(a.name)}"' for a in variant.alternatives)
        text += f"inline std::string js(const {variant.name}& x) {{\n    constexpr const char* kinds[] = {{{kinds}}};\n" \
                "    return of_kind(kinds[x.index()], std::visit([](const auto& y) { return js(y); }, x));\n}\n"
    return text


def parameters(table, function, with_defaults=True):
    parts = []
    for arg in function.args:
        default = {"{}": " = {}", "none": " = {}"}.get(arg.default, "") if with_defaults else ""
        parts.append(f"{table.parameter_type(arg.type)} {arg.name}{default}")
    return ", ".join(parts)


def said(function, owner, own):
    """The call in JavaScript, as a C++ expression that evaluates to its text."""
    target = "world" if owner == "World" else '" + body_text() + "'
    if function in own.values():
        return f'"{target}.{camel(function.method).removeprefix("set")[0].lower()}' \
               f'{camel(function.method).removeprefix("set")[1:]} = " + js({function.args[0].name}) + ";"'
    args = ' + ", " + '.join(f"js({a.name})" for a in function.args)
    return f'"{target}.{camel(function.method)}(" + ' + (args + " + " if args else "") + '")"'


def method(table, function, owner, own):
    names = ", ".join(a.name for a in function.args)
    inner = "world_" if owner == "World" else "real()"
    if not function.changes:
        return f"    auto {function.method}({parameters(table, function)}) const {{ return {inner}.{function.method}({names}); }}\n"
    text = f"    auto {function.method}({parameters(table, function)}) {{\n"
    call = said(function, owner, own)
    if function.returns:
        suffix = '.id' if function.method == "create_body" else ""
        text += f"        const auto answer = {inner}.{function.method}({names});\n"
        text += f'        note("keep(" + name(answer) + ", " + {call} + "{suffix});");\n        return answer;\n'
    else:
        end = "" if function in own.values() else ' + ";"'
        text += f"        {inner}.{function.method}({names});\n        note({call}{end});\n"
    return text + "    }\n"


def recorder(table):
    text = f"// {MADE}\n// clang-format off\n#pragma once\n\n#include \"javascript.h\"\n\nnamespace cairn {{\n\n"
    text += writers(table) + "\n"
    bodies = {}
    for owner in ("World", "Body"):
        own, bodies[owner] = setters(table, owner), ""
        for function in table.functions:
            if function.owner != owner or function.member or function.method in LEFT_OUT or function.custom and function.method != "joint_at":
                continue
            bodies[owner] += method(table, function, owner, own)
    text += "class RecordedBody;\n\nclass RecordedWorld : public Recording {\n  public:\n    using Recording::Recording;\n"
    text += "    RecordedBody body(BodyId body);\n" + bodies["World"] + "};\n\n"
    text += "class RecordedBody : public RecordedBodyBase {\n  public:\n    using RecordedBodyBase::RecordedBodyBase;\n" + bodies["Body"] + "};\n\n"
    text += "inline RecordedBody RecordedWorld::body(BodyId body) { return {*this, body}; }\n\n} // namespace cairn\n"
    return text
