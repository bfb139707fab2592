"""The table of the API (api/*.toml) in memory, and whether it agrees with the public C++ headers.

Types in the table: bool, int, float, double, u32, u64, size, string; Vec2, Vec3, DVec3, Position, Quat, Mat3; handles
(BodyId, ...); enums, structs and variants by name; `T?` may be absent, `T[]` is a list, `T[3]` has three.
"""
import pathlib
import re
import tomllib
from dataclasses import dataclass, field

import api_headers

ROOT = pathlib.Path(__file__).resolve().parent.parent
# The headers for C, one per file of the table, in the order in which they include each other.
GROUPS = ["base", "math", "shape", "body", "joint", "query", "events", "world", "scene"]
HANDLES = {"BodyId": "a body", "ShapeId": "a shape on a body", "JointId": "a joint", "ForceFieldId": "a force field"}
SCALARS = {"bool": "bool", "int": "int", "float": "float", "double": "double", "u32": "std::uint32_t",
           "u64": "std::uint64_t", "size": "std::size_t", "string": "std::string"}
VECTORS = {"Vec2": "glm::vec2", "Vec3": "Vec3", "DVec3": "glm::dvec3", "Position": "Position", "Quat": "Quat", "Mat3": "Mat3"}
# Declarations of the headers that the table omits, each with the reason.
ELSEWHERE = {
    "World::body(BodyId)": "C names the body in each call; Python has it by hand",
    "World::body(BodyId) const": "likewise",
    "World::World(World&&)": "a world is held by a pointer",
    "World::World(const World&)": "deleted",
    "World::set_command_listener(std::shared_ptr<CommandListener>)": "a listener is a class; C has whole recordings",
    "World::set_communicator(std::shared_ptr<Communicator>)": "a communicator is a class; the program has mpirun",
    "World::execute(std::span<const std::byte>, CommandSource&)": "likewise",
    "World::state_digest() const": "for recordings",
    "World::bodies_that_differ(const StateDigest&) const": "likewise",
    "Body::id() const": "C names the body in each call",
    "Hull::data() const": "for the engine",
    "Mesh::data() const": "for the engine",
    "HeightField::data() const": "for the engine",
    "Hull::Hull(std::shared_ptr<const HullData>)": "for the engine",
    "Mesh::Mesh(std::shared_ptr<const MeshData>)": "for the engine",
    "HeightField::HeightField(std::shared_ptr<const HeightFieldData>)": "for the engine",
}
# Members that accept any value, because they are ignored while other members have their defaults.
UNCHECKED = {"Plane.tangent"}
CLASSES = ["World", "Body", "Hull", "Mesh", "HeightField", "Snapshot"]


def snake(name):
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower().replace("d_vec3", "dvec3")


@dataclass
class Field:
    name: str
    type: str
    unit: str = ""
    range: str = ""
    doc: str = ""
    default: str = ""
    cpp: str = ""
    count: str = ""  # for `T[3]`: the member that contains the number of elements


@dataclass
class Enum:
    name: str
    group: str
    doc: str
    values: list
    cpp: str


@dataclass
class Struct:
    name: str
    group: str
    doc: str
    fields: list
    versioned: bool = False  # begins with struct_size
    custom: bool = False     # the conversion is hand-written
    c_only: bool = False     # has no C++ counterpart
    first_size: int = 0      # size in bytes in the first release; 0: the current size
    is_input: bool = False
    is_output: bool = False


@dataclass
class Variant:
    name: str
    group: str
    doc: str
    alternatives: list
    reserved: int


@dataclass
class Function:
    name: str
    group: str
    doc: str
    errors: list
    cpp: str = ""
    args: list = field(default_factory=list)
    returns: str = ""
    unit: str = ""
    changes: bool = False
    custom: bool = False
    c_args: str = ""
    c_returns: str = "cairn_result"
    member: str = ""
    since: str = "0.1"
    command: int = None  # for calls that change a world: their permanent number in recordings; 0: not recorded
    moves_only: bool = False  # for commands: changes only the motion of bodies, and none of a snapshot's definitions

    @property
    def owner(self):
        """World, Body or another class."""
        return self.cpp.partition("::")[0]

    @property
    def method(self):
        return self.cpp.partition("::")[2].partition("(")[0]


class Table:
    def __init__(self, folder=ROOT / "api"):
        self.enums, self.structs, self.variants, self.functions = {}, {}, {}, []
        self.unchecked = UNCHECKED
        files = sorted(path.stem for path in pathlib.Path(folder).glob("*.toml"))
        if files != sorted(GROUPS):
            raise ValueError(f"{folder} has {files}; GROUPS in api_table.py has {sorted(GROUPS)}")
        for group in GROUPS:
            with open(pathlib.Path(folder) / f"{group}.toml", "rb") as file:
                self._add(group, tomllib.load(file))
        self._mark()

    def _add(self, group, data):
        for key in data.keys() - {"enum", "struct", "variant", "function"}:
            raise ValueError(f"api/{group}.toml: {key}: must be an enum, struct, variant or function")
        for name, entry in data.get("enum", {}).items():
            self.enums[name] = Enum(name, group, entry["doc"], [Field(v["name"], "", doc=v.get("doc", ""), cpp=v.get("cpp", v["name"]))
                                                              for v in entry["values"]], entry.get("cpp", name))
        for name, entry in data.get("struct", {}).items():
            fields = [Field(**f) for f in entry.pop("fields")]
            self.structs[name] = Struct(name, group, fields=fields, **entry)
        for name, entry in data.get("variant", {}).items():
            alternatives = [Field(**a) for a in entry.pop("alternatives")]
            self.variants[name] = Variant(name, group, alternatives=alternatives, **entry)
        for entry in data.get("function", []):
            args = [Field(**a) for a in entry.pop("args", [])]
            self.functions.append(Function(group=group, args=args, **entry))

    def _mark(self):
        """Marks the structs that are used as arguments and those that are used as results."""
        def visit(kind, attribute):
            base = re.sub(r"\?$|\[\d*\]$", "", kind)
            if base in self.structs:
                struct = self.structs[base]
                if not getattr(struct, attribute):
                    setattr(struct, attribute, True)
                    for member in struct.fields:
                        visit(member.type, attribute)
            elif base in self.variants:
                for alternative in self.variants[base].alternatives:
                    visit(alternative.type, attribute)
            elif base not in SCALARS and base not in VECTORS and base not in HANDLES and base not in self.enums and \
                    base not in ("geometry", "double*", "float*"):
                raise ValueError(f"the table has no type {base}")

        for function in self.functions:
            for arg in function.args:
                visit(arg.type, "is_input")
            if function.returns:
                visit(function.returns, "is_output")
        for struct in self.structs.values():
            for member in struct.fields:
                visit(member.type, "is_output" if struct.is_output else "is_input")
        for name in ("BodyArrays", "SnapshotSizes"):
            setattr(self.structs[name], "is_input" if name == "BodyArrays" else "is_output", True)

    def cpp_type(self, kind):
        """The C++ type that corresponds to a type of the table."""
        if kind.endswith("?"):
            return f"std::optional<{self.cpp_type(kind[:-1])}>"
        if kind.endswith("[]"):
            return f"std::vector<{self.cpp_type(kind[:-2])}>"
        many = re.match(r"(.*)\[(\d+)\]$", kind)
        if many:
            inner = self.cpp_type(many[1])
            return f"{inner}[{many[2]}]" if many[1] in self.structs else f"std::array<{inner}, {many[2]}>"
        return SCALARS.get(kind) or VECTORS.get(kind) or (self.enums[kind].cpp if kind in self.enums else kind)

    def parameter_type(self, kind):
        if kind == "string":
            return "std::string_view"
        cpp = self.cpp_type(kind)
        by_value = kind in SCALARS or kind in HANDLES or kind in self.enums or kind.endswith("?")
        return cpp if by_value else f"const {cpp}&"


def disagreements(table, folder=ROOT / "include" / "cairn"):
    """Differences between the headers and the table, one line each."""
    headers = api_headers.read(folder)
    known = {name.strip() for f in table.functions for name in re.split(r",\s*(?=[A-Z]\w+::)", f.cpp) if f.cpp}
    declared = set()
    for name in CLASSES:
        if name not in headers.classes:
            yield f"class {name} is not in {folder}"
        for function in headers.classes.get(name, []):
            if function.name.startswith("~") or function.returns == "~":
                signature = f"{name}::~{name}()"
            else:
                text = function.signature()
                signature = f"{name}::" + re.sub(r"\) : .*|(?<=\))\s*:.*", ")", re.sub(r"> data\).*", ">)", text))
            declared.add(signature)
            if signature not in known and signature not in ELSEWHERE:
                yield f"{signature} is in the headers, but not in the table (api/)"
    for signature in sorted(known):
        if signature.partition("::")[0] in CLASSES and signature not in declared:
            yield f"{signature} is in the table (api/), but not in the headers"
    for function in table.functions:
        if function.custom or not function.cpp:
            continue
        match = [f for c in CLASSES for f in headers.classes.get(c, []) if f"{c}::{f.signature()}" == function.cpp]
        if not match:
            continue
        types = [table.parameter_type(a.type) for a in function.args]
        if types != [p.type for p in match[0].parameters]:
            yield f"{function.cpp}: its arguments in the table are {types}"
        if [a.name for a in function.args] != [p.name for p in match[0].parameters]:
            yield f"{function.cpp}: the headers call its arguments {[p.name for p in match[0].parameters]}"
        is_const = function.cpp.endswith("const")
        if function.changes == is_const:
            yield f"{function.cpp}: `changes` in the table is {function.changes}"
    for struct in table.structs.values():
        if struct.custom or struct.c_only:
            continue
        ours = [(f.name, table.cpp_type(f.type).replace("ForceField::", "")) for f in struct.fields]
        theirs = [(v.name, v.type) for v in headers.structs.get(struct.name, [])]
        if set(ours) != set(theirs):  # in any order: new members come last in C, wherever they are in C++
            yield f"{struct.name}: the headers have {sorted(set(theirs) - set(ours))}, the table {sorted(set(ours) - set(theirs))}"
    for enum in table.enums.values():
        theirs = [name for name, _ in headers.enums.get(enum.cpp.rpartition("::")[2], [])]
        if [v.cpp for v in enum.values] != theirs:
            yield f"{enum.name}: the headers have {theirs}"
    for variant in table.variants.values():
        if [a.type for a in variant.alternatives] != headers.variants.get(variant.name):
            yield f"{variant.name}: the headers have {headers.variants.get(variant.name)}"
