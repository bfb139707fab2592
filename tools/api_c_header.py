"""The headers of the C API, include/cairn/c/*.h, from the table."""
import re

from api_table import GROUPS, HANDLES, snake
from api_text import BY_VALUE, C_SCALARS, MADE, beside, c_name, comment, constant, described, joined, wrapped

ABI_VERSION = 6

BASE = '''#if defined(_WIN32) && defined(CAIRN_C_BUILDING)
#define CAIRN_C_API __declspec(dllexport)
#elif defined(_WIN32)
#define CAIRN_C_API __declspec(dllimport)
#else
#define CAIRN_C_API __attribute__((visibility("default")))
#endif

/// The version of the binary interface that these headers describe; see `cairn_abi_version`.
#define CAIRN_ABI_VERSION {abi}

/// The result of a call. If it is not CAIRN_OK, nothing has changed, and `cairn_last_error` describes the error.
typedef int32_t cairn_result;
enum {{
    CAIRN_OK = 0,
    CAIRN_ERROR_INVALID_VALUE = 1,  ///< An argument is null, NaN, infinite, or out of its range.
    CAIRN_ERROR_INVALID_HANDLE = 2, ///< A handle is null, stale, or belongs to another world.
    /// The call is not allowed in the present state (for example, during a step, or for a body of another type).
    CAIRN_ERROR_WRONG_STATE = 3,
    CAIRN_ERROR_INVALID_FILE = 4,   ///< A file or a buffer is malformed.
    CAIRN_ERROR_UNSUPPORTED = 5,    ///< The request is well formed, but this build does not support it.
    CAIRN_ERROR_IO = 6,             ///< A file could not be read or written.
    /// Memory ran out. The world is as it was, or refuses all calls (wrong_state) until it is restored.
    CAIRN_ERROR_OUT_OF_MEMORY = 7,
    CAIRN_ERROR_OTHER = 8           ///< Any other error; `cairn_last_error` has its text.
}};

/// A world of rigid bodies. One world must not be used by two threads at the same time, except for functions that take
/// it as const, which may run on many threads while no other function uses it.
typedef struct cairn_world cairn_world;
/// The data of a hull, mesh or height field. It never changes, and may be used by many shapes, worlds and threads.
typedef struct cairn_geometry cairn_geometry;
/// The complete state of a world at one time, to which it can be restored.
typedef struct cairn_snapshot cairn_snapshot;
'''

MATH = '''typedef struct cairn_vec2 {
    float x, y;
} cairn_vec2;

/// Directions, velocities, extents, forces: float, SI units.
typedef struct cairn_vec3 {
    float x, y, z;
} cairn_vec3;

typedef struct cairn_dvec3 {
    double x, y, z;
} cairn_dvec3;

/// World position in meters: double, so that large worlds keep their precision.
typedef cairn_dvec3 cairn_position;

/// Rotation as a unit quaternion; the identity is 0, 0, 0, 1.
typedef struct cairn_quat {
    float x, y, z, w;
} cairn_quat;

/// A 3x3 matrix, stored by columns (inertia tensors, in kg m^2).
typedef struct cairn_mat3 {
    float columns[3][3];
} cairn_mat3;
'''


def enum_text(enum):
    text = comment(enum.doc) + f"typedef int32_t {c_name(enum.name)};\nenum {{\n"
    for number, value in enumerate(enum.values):
        comma = "," if number + 1 < len(enum.values) else ""
        text += beside(f"    {constant(enum.name, value.name)} = {number}{comma}", value.doc)
    return text + "};\n\n"


def member_lines(member):
    kind, doc = member.type, described(member)
    if kind.endswith("?"):
        yield f"    bool has_{member.name};", f"Whether `{member.name}` is given."
        yield f"    {c_name(kind[:-1])} {member.name};", doc
    elif kind.endswith("[]"):
        yield f"    const {c_name(kind[:-2])}* {member.name};", doc
        yield f"    size_t {count_of(member.name)};", ""
    elif kind.endswith("]"):
        base, many = re.match(r"(.*)\[(\d+)\]", kind).groups()
        yield f"    {c_name(base)} {member.name}[{many}];", doc
    elif kind == "string":
        yield f"    const char* {member.name};", (doc + " UTF-8; null: empty.").strip()
    else:
        yield f"    {c_name(kind)} {member.name};", doc


def count_of(name):
    one = name[:-3] + "y" if name.endswith("ies") else name[:-1] if name.endswith("s") else name
    return one + "_count"


def struct_text(struct):
    name = c_name(struct.name)
    doc = struct.doc
    if struct.versioned:
        doc += f" Begin from `cairn_default_{snake(struct.name)}()`."
    text = comment(doc) + f"typedef struct {name} {{\n"
    if struct.versioned:
        text += beside("    uint32_t struct_size;", "Bytes, as `cairn_default_" + snake(struct.name) + "` sets it.")
    for member in struct.fields:
        for code, member_doc in member_lines(member):
            text += beside(code, member_doc)
    if not struct.fields:
        text += beside("    int unused;", "Not used: a C struct needs a member.")
    text += f"}} {name};\n"
    if struct.is_input or struct.versioned:
        text += f"CAIRN_C_API {name} cairn_default_{snake(struct.name)}(void);\n"
    return text + "\n"


def variant_text(variant):
    name = c_name(variant.name)
    text = f"typedef int32_t {name}_kind;\nenum {{\n"
    for number, alternative in enumerate(variant.alternatives):
        comma = "," if number + 1 < len(variant.alternatives) else ""
        text += f"    {constant(variant.name, alternative.name)} = {number}{comma}\n"
    text += "};\n\n" + comment(variant.doc) + f"typedef struct {name} {{\n    {name}_kind kind;\n    union {{\n"
    for alternative in variant.alternatives:
        text += f"        {c_name(alternative.type)} {alternative.name};\n"
    text += f"        unsigned char reserved[{variant.reserved}];\n    }} as; ///< The member that `kind` names.\n}} {name};\n"
    text += comment("The default values of a kind; those of the first kind if `kind` is unknown.")
    return text + f"CAIRN_C_API {name} cairn_default_{snake(variant.name)}({name}_kind kind);\n\n"


def c_parameters(function):
    """The C parameters of a generated function."""
    if function.custom:
        return function.c_args
    const = "" if function.changes else "const "
    parts = [f"{const}cairn_world* world"]
    if function.owner == "Body":
        parts.append("cairn_body_id body")
    for arg in function.args:
        kind = arg.type
        if kind.endswith("?"):
            parts.append(f"const {c_name(kind[:-1])}* {arg.name}")
        elif kind == "string":
            parts.append(f"const char* {arg.name}")
        elif kind in C_SCALARS or kind in HANDLES or kind in BY_VALUE or c_name(kind) in ENUM_NAMES:
            parts.append(f"{c_name(kind)} {arg.name}")
        else:
            parts.append(f"const {c_name(kind)}* {arg.name}")
    kind = function.returns
    if kind.endswith("[]"):
        parts += [f"{c_name(kind[:-2])}* {result_name(function)}", "size_t capacity", "size_t* count"]
    elif kind == "string":
        parts += ["char* text", "size_t capacity", "size_t* length"]
    elif kind.endswith("?"):
        parts += [f"{c_name(kind[:-1])}* {result_name(function)}", "bool* found"]
    elif kind and not is_plain(function):
        parts.append(f"{c_name(kind)}* {result_name(function)}")
    return joined(parts)


ENUM_NAMES = set()


def is_plain(function):
    """Whether the function returns its value directly: then it cannot fail."""
    return function.returns == "bool" and not function.errors


def result_name(function):
    name = function.name.split("_", 1)[1]
    name = name.removeprefix("get_") if name.startswith("get_") else "result"
    taken = {a.name for a in function.args} | {"world", "body"}
    return name if name not in taken else "result"


def function_text(function):
    doc = described(function)
    kind = function.returns
    if kind.endswith("[]"):
        doc += " `count` receives their number; the first `capacity` of them are written."
    elif kind == "string":
        doc += " `length` receives its length without the terminating zero; text beyond `capacity` bytes is cut off."
    elif kind.endswith("?"):
        doc += " `found` receives whether there is one."
    for arg in function.args:
        if arg.type.endswith("?"):
            doc += f" Null for `{arg.name}`: absent."
        elif arg.default == "{}":
            doc += f" Null for `{arg.name}`: the default."
    if function.errors:
        doc += f" Errors: {', '.join(function.errors)}."
    if function.since != "0.1":
        doc += f" Since {function.since}."
    returns = "bool" if is_plain(function) else function.c_returns if function.custom else "cairn_result"
    return comment(doc.strip()) + wrapped(f"CAIRN_C_API {returns} cairn_{function.name}(", c_parameters(function).split(", "),
                                          ");") + "\n"


def header(table, group):
    ENUM_NAMES.update(c_name(name) for name in table.enums)
    guard = f"CAIRN_C_{group.upper()}_H"
    text = f"// {MADE}\n// clang-format off\n#ifndef {guard}\n#define {guard}\n\n"
    before = GROUPS[:GROUPS.index(group)]
    text += f"#include <cairn/c/{before[-1]}.h>\n" if before else ""
    text += "#include <stdbool.h>\n#include <stddef.h>\n#include <stdint.h>\n\n"
    text += "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n"
    if group == "base":
        text += BASE.format(abi=ABI_VERSION) + "\n"
        for name, what in HANDLES.items():
            text += comment(f"Names {what} of a world; zero: null. Once that object is destroyed, its handle is stale. No new "
                            "object gets the same handle, except after `cairn_world_restore`.")
            text += f"typedef struct {c_name(name)} {{\n    uint64_t bits;\n}} {c_name(name)};\n\n"
    if group == "math":
        text += MATH + "\n"
    for entry in ordered(table, group):
        text += entry
    for function in table.functions:
        if function.group == group:
            text += function_text(function)
    return text.rstrip() + f"\n\n#ifdef __cplusplus\n}}\n#endif\n\n#endif // {guard}\n"


def ordered(table, group):
    """Enums, then structs and variants, each after those that it contains."""
    for enum in table.enums.values():
        if enum.group == group:
            yield enum_text(enum)
    done, entries = set(), {}
    for struct in table.structs.values():
        if struct.group == group:
            entries[struct.name] = ([m.type for m in struct.fields], struct_text(struct))
    for variant in table.variants.values():
        if variant.group == group:
            entries[variant.name] = ([a.type for a in variant.alternatives], variant_text(variant))

    def visit(name):
        if name in done or name not in entries:
            return
        done.add(name)
        for kind in entries[name][0]:
            yield from visit(re.sub(r"\?$|\[\d*\]$", "", kind))
        yield entries[name][1]

    for name in entries:
        yield from visit(name)


def umbrella():
    text = f"// {MADE}\n// clang-format off\n/// \\file cairn.h\n/// The C API. C programs may include <cairn/cairn.h> as well.\n"
    text += "#ifndef CAIRN_C_CAIRN_H\n#define CAIRN_C_CAIRN_H\n\n"
    text += "".join(f"#include <cairn/c/{group}.h>\n" for group in GROUPS)
    return text + "\n#endif // CAIRN_C_CAIRN_H\n"
