// Any bytes as an OBJ or STL file: the result is triangles whose indices are in range, or an Error. The first byte
// selects the format. `./dev fuzz` runs it; its corpus also runs with the tests, without a fuzzer (corpus_main.cpp).
#include "scene/mesh_files.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cairn;
    if (size == 0) return 0;
    const auto bytes = std::as_bytes(std::span(data + 1, size - 1));
    try {
        const scene::MeshFile mesh =
            data[0] % 2 == 0 ? scene::read_obj(bytes, "fuzz.obj") : scene::read_stl(bytes, "fuzz.stl");
        if (mesh.indices.empty() || mesh.indices.size() % 3 != 0) std::abort();
        for (const std::uint32_t index : mesh.indices) {
            if (index >= mesh.vertices.size()) std::abort();
        }
        for (const Vec3& v : mesh.vertices) {
            if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) std::abort();
        }
        const scene::Surface look = scene::visual_surface(mesh, {1.0, -2.0, 3.0});
        if (look.indices.size() != mesh.indices.size()) std::abort();
        for (const std::uint32_t index : look.indices) {
            if (index >= look.vertices.size()) std::abort();
        }
        if (!look.coordinates.empty() && look.coordinates.size() != look.vertices.size()) std::abort();
        if (!look.normals.empty() && look.normals.size() != look.vertices.size()) std::abort();
        scene::MeshImport options;
        options.as_hull = data[0] % 4 < 2;
        scene::scene_of_mesh(mesh, options, "fuzz");
    } catch (const Error&) {
        return 0;
    }
    return 0;
}
