"""Memory layout of the C API's structs in WebAssembly, whose pointers have 32 bits."""
import re
from dataclasses import dataclass

from api_c_header import count_of
from api_table import HANDLES
from api_text import MADE, c_name

# Size and alignment in bytes.
SIZES = {"bool": (1, 1), "int": (4, 4), "float": (4, 4), "double": (8, 8), "u32": (4, 4), "u64": (8, 8), "size": (4, 4),
         "string": (4, 4), "geometry": (4, 4), "double*": (4, 4), "float*": (4, 4), "Vec2": (8, 4), "Vec3": (12, 4),
         "DVec3": (24, 8), "Position": (24, 8), "Quat": (16, 4), "Mat3": (36, 4), **{handle: (8, 8) for handle in HANDLES}}


@dataclass
class Place:
    """Location of a member: its `offset` in bytes, the offset of a list's length in `count`, and that of an optional's
    flag in `flag`."""

    offset: int
    count: int = -1
    flag: int = -1


class Layout:
    """Sizes, alignments and member locations of all structs and variants of the table."""

    def __init__(self, table):
        self.table, self.places, self.sizes = table, {}, dict(SIZES)
        for enum in table.enums:
            self.sizes[enum] = (4, 4)

    def size(self, kind):
        many = re.match(r"(.*)\[(\d+)\]$", kind)
        if many:
            size, alignment = self.size(many[1])
            return size * int(many[2]), alignment
        if kind not in self.sizes:
            self.sizes[kind] = self._variant(kind) if kind in self.table.variants else self._struct(kind)
        return self.sizes[kind]

    def of(self, struct):
        """The locations of the members of a struct, by name."""
        self.size(struct)
        return self.places[struct]

    def union_offset(self, variant):
        """The offset at which the alternatives of a variant begin."""
        return max(4, max(self.size(a.type)[1] for a in self.table.variants[variant].alternatives))

    def _variant(self, name):
        variant = self.table.variants[name]
        sizes = [self.size(a.type) for a in variant.alternatives]
        alignment = max(4, max(a for _, a in sizes))
        size = self.union_offset(name) + max([variant.reserved, *(s for s, _ in sizes)])
        return -(-size // alignment) * alignment, alignment

    def _struct(self, name):
        struct, at, greatest, places = self.table.structs[name], 0, 1, {}

        def put(kind):
            nonlocal at, greatest
            size, alignment = self.size(kind)
            begin = -(-at // alignment) * alignment
            at, greatest = begin + size, max(greatest, alignment)
            return begin

        if struct.versioned:
            put("u32")
        for member in struct.fields:
            if member.type.endswith("?"):
                flag = put("bool")
                places[member.name] = Place(put(member.type[:-1]), flag=flag)
            elif member.type.endswith("[]"):
                pointer = put("string")
                places[member.name] = Place(pointer, count=put("size"))
            else:
                places[member.name] = Place(put(member.type))
        if not struct.fields:
            put("int")
        self.places[name] = places
        return -(-at // greatest) * greatest, greatest


def checks(table):
    """A source file of the module that fails to compile if the compiler's layout of a struct differs."""
    layout = Layout(table)
    text = f"// {MADE}\n// clang-format off\n// The places that web/src/generated takes the members of structs to be at.\n"
    text += "#include <cairn/c/cairn.h>\n\n#include <cstddef>\n\n"
    for struct in table.structs.values():
        name = c_name(struct.name)
        text += f"static_assert(sizeof({name}) == {layout.size(struct.name)[0]});\n"
        for member in struct.fields:
            place = layout.of(struct.name)[member.name]
            text += f"static_assert(offsetof({name}, {member.name}) == {place.offset});\n"
            if place.flag >= 0:
                text += f"static_assert(offsetof({name}, has_{member.name}) == {place.flag});\n"
            if place.count >= 0:
                text += f"static_assert(offsetof({name}, {count_of(member.name)}) == {place.count});\n"
    for variant in table.variants.values():
        name = c_name(variant.name)
        text += f"static_assert(sizeof({name}) == {layout.size(variant.name)[0]});\n"
        text += f"static_assert(offsetof({name}, as) == {layout.union_offset(variant.name)});\n"
    return text


# Functions with file names: web pages have no files, and keep scenes in memory.
WITH_FILES = {"scene_load", "scene_save"}


def exports(table):
    """The functions of the module that JavaScript calls, in the syntax of Emscripten's linker."""
    names = [f"_cairn_{function.name}" for function in table.functions if function.name not in WITH_FILES]
    names += [f"_cairn_default_{snake_name}" for snake_name in default_names(table)]
    names += ["_cairn_web_shape_color", "_cairn_web_shape_triangles", "_cairn_web_triangles_release", "_free", "_malloc"]
    return "\n".join(sorted(names)) + "\n"


def default_names(table):
    for struct in table.structs.values():
        if (struct.is_input or struct.versioned):
            yield c_name(struct.name).removeprefix("cairn_")
    for variant in table.variants:
        yield c_name(variant).removeprefix("cairn_")
