#include "scene/model_meshes.h"

#include "scene/nearby_files.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace cairn::scene {

namespace {

std::string shown(const std::string& path) { return "\"" + printable(path, 200) + "\""; }

} // namespace

std::filesystem::path ModelMeshes::find(const XmlText& name, const std::string& path,
                                        const std::string& subfolder) const {
    if (!folder_) {
        throw Error(ErrorCode::unsupported, name.place, shown(path),
                    "other files cannot be read by a model that comes from memory");
    }
    const std::filesystem::path root = folder_on_disk(*folder_);
    const std::string written = subfolder.empty() ? path : subfolder + "/" + path;
    const NearbyFile file = nearby_file(written, root, root);
    switch (file.verdict) {
    case NearbyFile::Verdict::found:
        return file.path;
    case NearbyFile::Verdict::outside:
        throw Error(ErrorCode::io, name.place, shown(written),
                    "must name a file in the model's folder or below it, also where links lead");
    case NearbyFile::Verdict::not_a_file:
        throw Error(ErrorCode::io, name.place, shown(written), "must name a file, not a folder or a device");
    case NearbyFile::Verdict::missing:
        break;
    }
    throw Error(ErrorCode::io, name.place, shown(written), "there is no such file");
}

NamedFile ModelMeshes::named(const XmlText& name, const std::string& path, const std::string& subfolder,
                             const glm::dvec3& scale) const {
    for (int i = 0; i < 3; ++i) {
        if (!(std::fabs(scale[i]) <= 1e6 && std::fabs(scale[i]) >= 1e-9)) {
            throw Error(ErrorCode::invalid_file, name.place, shown(path), "must have a scale that is not 0");
        }
    }
    std::filesystem::path file = find(name, path, subfolder);
    return {std::move(file), folder_on_disk(*folder_), name.place, printable(path, 200)};
}

std::shared_ptr<const Surface> ModelMeshes::load(const XmlText& name, const std::string& path,
                                                 const std::string& subfolder, const glm::dvec3& scale) {
    return store_.surface(named(name, path, subfolder, scale), scale);
}

std::shared_ptr<const Surface> ModelMeshes::look(const XmlText& name, const std::string& path,
                                                 const std::string& subfolder, const glm::dvec3& scale) {
    return store_.look(named(name, path, subfolder, scale), scale);
}

const std::vector<MeshVisual>& ModelMeshes::looks(const XmlText& name, const std::string& path,
                                                  const std::string& subfolder, const glm::dvec3& scale,
                                                  std::vector<std::string>& warnings) {
    return store_.looks(named(name, path, subfolder, scale), scale, warnings);
}

std::shared_ptr<const std::string> ModelMeshes::picture(const XmlText& name, const std::string& path,
                                                        const std::string& subfolder) {
    return store_.pictures().read(find(name, path, subfolder), name.place, printable(path, 200));
}

Surface scaled_surface(const std::vector<Vec3>& vertices, std::vector<std::uint32_t> indices, const glm::dvec3& scale) {
    Surface made;
    made.vertices.reserve(vertices.size());
    for (const Vec3& v : vertices) made.vertices.push_back(Vec3(glm::dvec3(v) * scale));
    made.indices = std::move(indices);
    if (scale.x * scale.y * scale.z < 0.0) {
        for (std::size_t i = 0; i + 2 < made.indices.size(); i += 3) std::swap(made.indices[i], made.indices[i + 1]);
    }
    return made;
}

std::vector<Vec3> used_vertices(const Surface& surface) {
    std::vector<bool> used(surface.vertices.size(), false);
    for (const std::uint32_t i : surface.indices) used[i] = true;
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) result.push_back(surface.vertices[i]);
    }
    return result;
}

// A subdivided icosahedron: each face is divided into four, twice.
Surface ellipsoid_surface(const glm::dvec3& half_axes) {
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    std::vector<glm::dvec3> corners{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    std::vector<std::uint32_t> faces{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                     4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                     6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (int round = 0; round < 2; ++round) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, is_new] =
                middles.insert({std::minmax(a, b), static_cast<std::uint32_t>(corners.size())});
            if (is_new) corners.push_back(corners[a] + corners[b]);
            if (is_new) corners.back() *= std::sqrt(1.0 + g * g) / std::sqrt(glm::dot(corners.back(), corners.back()));
            return found->second;
        };
        std::vector<std::uint32_t> finer;
        for (std::size_t i = 0; i < faces.size(); i += 3) {
            const std::uint32_t a = faces[i], b = faces[i + 1], c = faces[i + 2];
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
        }
        faces = std::move(finer);
    }
    Surface made;
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 unit = corner / std::sqrt(glm::dot(corner, corner));
        made.vertices.push_back(Vec3(unit * half_axes));
        made.normals.push_back(Vec3(glm::normalize(unit / half_axes)));
    }
    made.indices = std::move(faces);
    return made;
}

SolidMass shape_mass(const Shape& shape, double density) {
    if (std::holds_alternative<Plane>(shape) || std::holds_alternative<Mesh>(shape) ||
        std::holds_alternative<HeightField>(shape) || density <= 0.0) {
        return {};
    }
    World world; // computes the mass properties of all shape types
    const BodyId body = world.create_body({});
    world.add_shape(body, shape, {.density = 1.0f});
    const MassProperties unit = world.body(body).mass_properties();
    const glm::dmat3 turn = glm::mat3_cast(glm::dquat(unit.inertia_orientation));
    const glm::dvec3 moments(unit.inertia_diagonal);
    const glm::dmat3 diagonal(moments.x, 0, 0, 0, moments.y, 0, 0, 0, moments.z);
    return {density * static_cast<double>(unit.mass), density * (turn * diagonal * glm::transpose(turn)),
            glm::dvec3(unit.center_of_mass)};
}

std::optional<SolidMass> surface_mass(const Surface& surface, double density) {
    double volume = 0.0;
    glm::dvec3 moment(0.0), low(1e30), high(-1e30);
    glm::dmat3 second(0.0); // integral of x x^T
    for (const Vec3& v : surface.vertices) low = glm::min(low, glm::dvec3(v)), high = glm::max(high, glm::dvec3(v));
    const glm::dvec3 middle = 0.5 * (low + high);
    for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return glm::dvec3(surface.vertices[surface.indices[i + k]]) - middle;
        };
        const glm::dvec3 a = corner(0), b = corner(1), c = corner(2), sum = a + b + c;
        const double six = glm::dot(a, glm::cross(b, c)); // six times the volume of the tetrahedron with the middle
        volume += six / 6.0;
        moment += six / 24.0 * sum;
        second +=
            six / 120.0 *
            (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) + glm::outerProduct(sum, sum));
    }
    const glm::dvec3 size = high - low;
    if (volume < 0.0) volume = -volume, moment = -moment, second = -second; // inside out
    if (!(volume > 1e-5 * size.x * size.y * size.z)) return std::nullopt;   // within rounding errors
    const glm::dvec3 center = moment / volume;
    second -= volume * glm::outerProduct(center, center);
    const double trace = second[0][0] + second[1][1] + second[2][2];
    return SolidMass{density * volume, density * (glm::dmat3(trace) - second), middle + center};
}

} // namespace cairn::scene
