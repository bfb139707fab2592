"""Generates from the table what Python needs: its types (python/cairn/_types.py), the glue code
(python/module/generated) and the stubs (python/cairn/_cairn.pyi)."""
import ast
import re
import textwrap

import api_headers
from api_table import GROUPS, HANDLES, ROOT, VECTORS
from api_c_source import fitted
from api_text import COLUMNS, MADE, described, wrapped

TOP = f"// {MADE}\n// clang-format off\n"
PY_SCALARS = {"bool": "bool", "int": "int", "float": "float", "double": "float", "u32": "int", "u64": "int", "size": "int",
              "string": "str"}
BY_HAND = {"Hull", "Mesh", "HeightField"}  # classes of the module
# Calls that exist only in the C API, and those that are hand-written for Python.
LISTED = {"JointLimit", "JointDrive"}


def structs(table):
    return [s for s in table.structs.values() if not s.custom and not s.c_only]


def python_type(table, kind, given=False):
    """A type annotation. `given`: for an argument, which accepts more types than the exact one."""
    if kind.endswith("?"):
        return python_type(table, kind[:-1], given) + " | None"
    if kind.endswith("[]"):
        return f"{'Sequence' if given else 'list'}[{python_type(table, kind[:-2], given)}]"
    many = re.match(r"(.*)\[(\d+)\]$", kind)
    if many:
        return f"Sequence[{python_type(table, many[1], given)}]"
    if kind in PY_SCALARS:
        return PY_SCALARS[kind]
    if kind in VECTORS:
        return "Vector" if given else "np.ndarray"
    if given and kind in table.enums:
        return f"{kind} | str"
    if given and kind == "BodyId":
        return "BodyId | Body"
    return kind


def default_value(table, kind, cpp):
    """The Python form of a member's default in the C++ header."""
    cpp = cpp.strip()
    if kind.endswith("?"):
        return "None"
    if kind.endswith("[]"):
        return "field(default_factory=list)"
    many = re.match(r"(.*)\[(\d+)\]$", kind)
    if many:
        zero = {"bool": "False", "float": "0.0"}.get(many[1])
        return f"({', '.join([zero] * int(many[2]))})" if zero else "()"
    if kind in VECTORS:
        numbers = [n.rstrip("f") for n in re.findall(r"-?[\d.]+f?", cpp)]
        if kind == "Quat":
            numbers = numbers[1:] + numbers[:1] if numbers else ["0.0", "0.0", "0.0", "1.0"]
        if not numbers:
            numbers = ["0.0"] * {"Vec2": 2}.get(kind, 3)
        return f"({', '.join(numbers)})"
    if kind in table.enums:
        return f"{kind}.{cpp.rpartition('::')[2].rstrip('_')}" if cpp else f"{kind}.{table.enums[kind].values[0].name}"
    if kind in HANDLES:
        return f"{kind}()"
    if kind in table.structs:
        made = re.match(r"JointSpring::from_frequency\((.*)\)", cpp)
        if made:
            return f"field(default_factory=lambda: JointSpring.from_frequency({made[1].replace('f', '')}))"
        return f"field(default_factory={kind})"
    if kind in table.variants:
        return f"field(default_factory={cpp.removesuffix('{}')})"
    if kind == "bool":
        return "True" if cpp == "true" else "False"
    if kind == "string":
        return '""'
    if "infinity" in cpp:
        return "math.inf"
    if cpp.startswith("~") or cpp == "all_layers":
        return "2**64 - 1"
    if kind in ("float", "double"):
        return str(float(cpp.rstrip("f"))) if cpp else "0.0"
    return cpp or "0"


def docstring(text, indent):
    """A docstring, wrapped."""
    text = text.replace("\\", "\\\\")
    if len(indent) + len(text) + 6 <= COLUMNS:
        return f'{indent}"""{text}"""\n'
    lines = textwrap.wrap(text, COLUMNS, initial_indent=indent + '"""', subsequent_indent=indent, break_on_hyphens=False)
    return "\n".join(lines) + f'\n{indent}"""\n'


def python_words(text):
    """C++ documentation in Python's notation."""
    return text.replace("World::", "World.").replace("BodyDef::", "BodyDef.").replace("WorldDef::", "WorldDef.") \
               .replace("ShapeDef::", "ShapeDef.").replace("CollisionFilter::", "CollisionFilter.").replace("false:", "False:") \
               .replace("true:", "True:").replace("Absent:", "None:").replace("absent:", "None:").replace("Throws", "Raises")


def struct_class(table, struct, members):
    """A dataclass for a struct; `members` are those of the header, with their defaults."""
    out = f"\n\n@lists_members\n@dataclass(slots=True, eq=False)\nclass {struct.name}:\n{docstring(python_words(struct.doc), '    ')}"
    out += "\n" if struct.fields else ""
    for member in struct.fields:
        default = default_value(table, member.type, members[member.name].default)
        annotation = python_type(table, member.type, True).replace("BodyId | Body", "BodyId")
        doc = python_words(described(member))
        out += f"    {member.name}: {annotation} = {default}\n" + (docstring(doc, "    ") if doc else "")
    if struct.name == "JointSpring":
        out += '\n    @staticmethod\n    def from_frequency(hertz: float, damping_ratio: float) -> "JointSpring":\n'
        out += docstring("The spring with which the bodies oscillate at a natural frequency of `hertz` (Hz, > 0), with that "
                         "damping ratio (>= 0; 1: critical damping).", "        ")
        out += "        return JointSpring(*_spring_from_frequency(hertz, damping_ratio), True)\n"
    return out


def types_of(table, group):
    """The Python names of a group of the table."""
    return [e.name for e in table.enums.values() if e.group == group] + \
        [s.name for s in structs(table) if s.group == group] + [v.name for v in table.variants.values() if v.group == group]


def types_module(table, group):
    """The Python file with the types of a group; empty if there are none."""
    if not types_of(table, group):
        return ""
    headers = api_headers.read(ROOT / "include" / "cairn")
    body, done = "", set()
    for enum in table.enums.values():
        if enum.group == group:
            body += f"\n\nclass {enum.name}(enum.Enum):\n{docstring(python_words(enum.doc), '    ')}\n"
            for number, value in enumerate(enum.values):
                body += f"    {value.name} = {number}\n" + (docstring(python_words(value.doc), "    ") if value.doc else "")

    def visit(struct):
        if struct.name in done or struct.group != group:
            return ""
        done.add(struct.name)
        out = ""
        for member in struct.fields:
            base = re.sub(r"\?$|\[\d*\]$", "", member.type)
            needed = [a.type for a in table.variants[base].alternatives] if base in table.variants else [base]
            out += "".join(visit(table.structs[n]) for n in needed if n in table.structs and n not in BY_HAND)
        return out + struct_class(table, struct, {v.name: v for v in headers.structs[struct.name]})

    for struct in structs(table):
        body += visit(struct)
    for variant in table.variants.values():
        if variant.group == group:
            body += f"\n\n{variant.name} = Union[\n" + "".join(f"    {a.type},\n" for a in variant.alternatives) + "]\n"
    return f'# {MADE}\n"""Structs and enums of the API: those of include/cairn/{group}.h."""\n' + imports_of(table, group, body) + body


def imports_of(table, group, body):
    """The imports that a file of types needs."""
    def used(name):
        return re.search(rf"\b{name}\b", body)

    text = "from __future__ import annotations\n\n" + "".join(
        f"import {m}\n" for m in ("enum", "math") if used(rf"{m}\."))
    if used("dataclass"):
        text += "from dataclasses import dataclass" + (", field" if used("field") else "") + "\n"
    typing = [n for n in ("Sequence", "Union") if used(n)]
    text += f"from typing import {', '.join(typing)}\n" if typing else ""
    by_hand = sorted(n for n in [*HANDLES, *BY_HAND, "_spring_from_frequency"] if used(n))
    text = text.rstrip() + "\n\n"
    text += f"from .._cairn import {', '.join(by_hand)}\n" if by_hand else ""
    for other in GROUPS[:GROUPS.index(group)]:
        names = sorted(n for n in types_of(table, other) if used(n))
        text += f"from .{other} import {', '.join(names)}\n" if names else ""
    text += "from ._members import lists_members\n" if used("lists_members") else ""
    return text + ("from ._vector import Vector\n" if used("Vector") else "")


def types_package(table):
    text = f'# {MADE}\n"""The structs and enums of the API."""\n'
    names = []
    for group in GROUPS:
        own = sorted(types_of(table, group))
        names += own
        if own:
            text += wrapped(f"from .{group} import (", own, ")")
    return text + "\n__all__ = [\n" + "".join(f'    "{n}",\n' for n in sorted(names)) + "]\n"


def glue_types_header(table):
    text = TOP + "#pragma once\n\n#include \"module/convert.h\"\n\nnamespace cairn::python {\n\n"
    for enum in table.enums.values():
        text += f"void read(py::handle o, {enum.cpp}& x, const Where& where);\npy::object write({enum.cpp} x);\n"
    for item in [*structs(table), *table.variants.values()]:
        if getattr(item, "is_input", True):
            text += f"void read(py::handle o, {item.name}& x, const Where& where);\n"
        text += f"py::object write(const {item.name}& x);\n"
    return text + "\n} // namespace cairn::python\n"


def glue_types_source(table, group):
    text = ""
    for enum in table.enums.values():
        if enum.group == group:
            text += f"void read(py::handle o, {enum.cpp}& x, const Where& where) {{\n" \
                    f"    x = {enum.cpp}(read_enum(o, \"{enum.name}\", where));\n}}\n"
            text += f"py::object write({enum.cpp} x) {{ return write_enum(\"{enum.name}\", int(x)); }}\n\n"
    for struct in structs(table):
        if struct.group != group:
            continue
        unused = "" if struct.fields else "[[maybe_unused]] "
        if struct.is_input:
            text += f"void read(py::handle o, {unused}{struct.name}& x, const Where& where) {{\n"
            text += f"    if (!is_a(o, \"{struct.name}\")) refuse_type(where, \"a {struct.name}\", o);\n"
            for member in struct.fields:
                text += f"    read(o.attr(\"{member.name}\"), x.{member.name}, {{\"{struct.name}\", \"{member.name}\"}});\n"
            text += "}\n"
        values = ", ".join(f"write_list(std::span(x.{m.name}).first(std::size_t(x.{m.count})))" if m.count else f"write(x.{m.name})"
                           for m in struct.fields)
        text += f"py::object write({unused}const {struct.name}& x) {{\n    return make(\"{struct.name}\", py::make_tuple({values}));\n}}\n\n"
    for variant in table.variants.values():
        if variant.group != group:
            continue
        text += f"void read(py::handle o, {variant.name}& x, const Where& where) {{\n"
        for alternative in variant.alternatives:
            test = f"py::isinstance<{alternative.type}>(o)" if alternative.type in BY_HAND else f"is_a(o, \"{alternative.type}\")"
            value = f"x = o.cast<{alternative.type}>()" if alternative.type in BY_HAND else f"read(o, x.emplace<{alternative.type}>(), where)"
            text += f"    if ({test}) {{\n        {value};\n        return;\n    }}\n"
        text += f"    refuse_type(where, \"a {variant.name}\", o);\n}}\n"
        text += f"py::object write(const {variant.name}& x) {{\n    return std::visit([](const auto& y) {{ return write(y); }}, x);\n}}\n\n"
    if not text:
        return ""
    return fitted(TOP + "#include \"module/containers.h\"\n\nnamespace cairn::python {\n\n" + text + "} // namespace cairn::python\n")


# Functions that are hand-written in python/module/module.cpp with their stubs.
WORLD_BY_HAND = {"is_valid", "step", "destroy_body", "create_body"}


def methods(table, owner):
    """The functions of World or Body for which glue code is generated."""
    for function in table.functions:
        if function.custom and function.method != "joint_at" or function.member or function.owner != owner:
            continue
        if owner == "World" and (function.method in WORLD_BY_HAND or function.name.startswith("body_get_")):
            continue
        yield function
    if owner == "Body":  # World::contacts(body) and similar functions
        yield from (f for f in table.functions if f.owner == "World" and f.name.startswith("body_get_"))


def is_property(function):
    return not function.changes and function.returns and (not function.args or function.name.startswith("body_get_") and
                                                          function.owner == "World")


def setters(table, owner):
    """The setter function of each property, by the name of the property."""
    properties = {f.method for f in methods(table, owner) if is_property(f)}
    return {f.method.removeprefix("set_"): f for f in methods(table, owner)
            if f.method.startswith("set_") and len(f.args) == 1 and f.method.removeprefix("set_") in properties}


def doc_literal(text):
    return '"' + python_words(text).replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def python_name(name):
    return {"def": "definition"}.get(name, name)


def takes_members(table, function, arg):
    """Whether a definition may be given as keyword arguments, one per member."""
    struct = table.structs.get(arg.type)
    return struct is not None and struct.versioned and arg is function.args[-1]


def taken(table, function, arg):
    """The statement that converts an argument from Python. All conversions come before the world is accessed: they may
    run Python code, which may destroy or change the world."""
    kind = "std::string" if arg.type == "string" else table.cpp_type(arg.type)
    name = python_name(arg.name)
    if takes_members(table, function, arg):
        return f"        const auto {arg.name} = take_definition<{kind}>(o_{name}, members, \"{kind}\");\n"
    return f"        const auto {arg.name} = take<{kind}>(o_{name}, \"{name}\");\n"


def method_glue(table, function, owner):
    """The glue code of a method that is not a property."""
    parameters, arguments, body = ["PyWorld& w" if owner == "World" else "const PyBody& b"], [], ""
    for arg in function.args:
        name = python_name(arg.name)
        parameters.append(f"py::object o_{name}")
        default = {"{}": "py::none()", "none": "py::none()"}.get(arg.default, arg.default)
        if takes_members(table, function, arg):
            default = "py::none()"
            parameters.append("py::kwargs members")
        arguments.append(f"py::arg(\"{name}\")" + (f" = {default}" if default else ""))
        body += taken(table, function, arg)
    where = f"\"{owner}.{function.method}\""
    names = ", ".join(a.name for a in function.args)
    if owner == "World":
        call = f"w.use({where}).{function.method}({names})"
        if function.changes:
            body += f"        {'const auto answer = ' if function.returns else ''}{call};\n        w.update();\n"
            body += "        return write(answer);\n" if function.returns else ""
        else:
            body += f"        const auto answer = {call};\n        return write(answer);\n"
    elif function.changes:
        body += f"        b.change({where}, [&](Body& body) {{ body.{function.method}({names}); }});\n"
    else:
        body += f"        const auto answer = b.get({where}).{function.method}({names});\n        return write(answer);\n"
    last = ", ".join([*arguments, doc_literal(signature_of(table, function) + "\n\n" + described(function))])
    return f"    c.def(\"{function.method}\", []({', '.join(parameters)}) {{\n{body}    }}, {last});\n"


def property_glue(table, function, owner, setter):
    where = f"\"{owner}.{function.method}\""
    if owner == "World":
        getter = f"w.use({where}).{function.method}()"
    elif function.owner == "World":  # takes a body
        getter = f"b.world->use({where}).{function.method}(b.id)"
    else:
        getter = f"b.get({where}).{function.method}()"
    parameter = "PyWorld& w" if owner == "World" else "const PyBody& b"
    getter = f"[]({parameter}) {{\n        const auto answer = {getter};\n        return write(answer);\n    }}"
    doc = described(function)
    if not setter:
        return f"    c.def_property_readonly(\"{function.method}\", {getter},\n        {doc_literal(doc)});\n"
    arg = setter.args[0]
    kind = "std::string" if arg.type == "string" else table.cpp_type(arg.type)
    value = f"const auto value = take<{kind}>(o, {where});"
    call = f"{setter.method}(value)"
    if owner == "World":
        change = f"[](PyWorld& w, py::object o) {{\n        {value}\n        w.use({where}).{call};\n        w.update();\n    }}"
    else:
        change = f"[](const PyBody& b, py::object o) {{\n        {value}\n" \
                 f"        b.change({where}, [&](Body& body) {{ body.{call}; }});\n    }}"
    if setter.doc not in doc:
        doc = f"{doc} Setting: {setter.doc}"
    return f"    c.def_property(\"{function.method}\", {getter}, {change}, {doc_literal(doc)});\n"


def glue_methods(table, owner):
    kind = {"World": "py::class_<PyWorld, std::shared_ptr<PyWorld>>", "Body": "py::class_<PyBody>"}[owner]
    text = TOP + "#include \"module/body.h\"\n#include \"module/containers.h\"\n#include \"module/definitions.h\"\n\n"
    text += f"namespace cairn::python {{\n\nvoid add_{owner.lower()}_calls({kind}& c) {{\n"
    own = setters(table, owner)
    for function in methods(table, owner):
        if is_property(function):
            text += property_glue(table, function, owner, own.get(function.method))
        elif function not in own.values():
            text += method_glue(table, function, owner)
    return fitted_code(text + "}\n\n} // namespace cairn::python\n")


def fitted_code(text):
    """Wraps long lines of code; string literals are split if they are too long."""
    lines = []
    for line in text.split("\n"):
        while len(line) > COLUMNS:
            indent = " " * (len(line) - len(line.lstrip()) + 4)
            best = None
            for match in re.finditer(r", |; | ", line[:COLUMNS - 2]):
                inside = len(re.findall(r'(?<!\\)"', line[:match.start()])) % 2 == 1
                if match.start() > len(indent) and (not inside or match[0] == " "):
                    best = (match.end(), inside)
            if best is None:
                break
            at, inside = best
            lines.append(line[:at] + '"' if inside else line[:at].rstrip())
            line = indent + ('"' if inside else "") + line[at:]
        lines.append(line)
    return "\n".join(lines)


def signature_of(table, function, first=()):
    """The signature of a method with its return type, as in a stub."""
    args = list(first)
    for arg in function.args:
        name = python_name(arg.name)
        kind = python_type(table, arg.type, True)
        default = {"{}": "None", "none": "None", "": ""}.get(arg.default, arg.default)
        if takes_members(table, function, arg):
            args += [f"{name}: {kind} | None = None", "**members: Any"]
        else:
            args.append(f"{name}: {kind}" + (f" = {default}" if default else ""))
    return f"{function.method}({', '.join(args)}) -> {python_type(table, function.returns) if function.returns else 'None'}"


def stub_of(table, function, owner):
    doc = python_words(described(function)) + (f" Raises: {', '.join(function.errors)}." if function.errors else "")
    return f"    def {signature_of(table, function, ['self'])}:\n{docstring(doc, '        ')}"


def stubs(table):
    by_hand = (ROOT / "tools" / "api_python_stubs.pyi").read_text(encoding="utf-8")
    text = f"# {MADE}\n" + by_hand
    for owner in ("World", "Body"):
        own, made = setters(table, owner), ""
        for function in methods(table, owner):
            if not is_property(function):
                made += stub_of(table, function, owner) if function not in own.values() else ""
                continue
            doc = python_words(described(function))
            setter = own.get(function.method)
            if setter and setter.doc not in function.doc:
                doc += f" Setting: {python_words(setter.doc)}"
            made += f"    @property\n    def {function.method}(self) -> {python_type(table, function.returns)}:\n{docstring(doc, '        ')}"
            if setter:
                made += f"    @{function.method}.setter\n    def {function.method}(self, value: " \
                        f"{python_type(table, setter.args[0].type, True)}) -> None: ...\n"
        text = text.replace(f"    # {owner}: from the table\n", made)
    return text


def docs_source():
    """The docstrings of hand-written functions, taken from their stubs."""
    tree = ast.parse((ROOT / "tools" / "api_python_stubs.pyi").read_text(encoding="utf-8"))
    rows = []

    def add(name, node):
        text = ast.get_docstring(node)
        if text:
            rows.append((name, re.sub(r"\s+", " ", text)))

    for node in tree.body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            add(node.name, node)
        for member in getattr(node, "body", []) if isinstance(node, ast.ClassDef) else []:
            if isinstance(member, ast.FunctionDef):
                add(f"{node.name}.{member.name}", member)
    text = TOP + "#include \"module/docs.h\"\n\n#include <cstring>\n#include <stdexcept>\n#include <string>\n\n"
    text += "namespace cairn::python {\n\nnamespace {\n\nstruct Row {\n    const char *name, *text;\n};\nconstexpr Row rows[] = {\n"
    text += "".join(f"    {{\"{name}\", {doc_literal(doc)}}},\n" for name, doc in rows)
    text += "};\n\n} // namespace\n\nconst char* doc_of(const char* name) {\n    for (const Row& row : rows)\n" \
            "        if (std::strcmp(row.name, name) == 0) return row.text;\n" \
            "    throw std::logic_error(std::string(\"no documentation of \") + name);\n}\n\n} // namespace cairn::python\n"
    return fitted_code(text)
