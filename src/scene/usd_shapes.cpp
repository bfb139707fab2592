// Shapes of the prims of USD.
#include "scene/model_meshes.h"
#include "scene/usd_stage.h"

#include <cairn/error.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cairn::scene {

namespace {

class SolidReader {
  public:
    SolidReader(const UsdStage& stage, const UsdPlace& place, const Rigid& body, bool is_static, bool decomposes,
                std::vector<std::string>& warnings)
        : stage_(stage), prim_(*place.prim), map_(compose(inverse_of(body), place.world)), is_static_(is_static),
          decomposes_(decomposes), warnings_(warnings) {}

    UsdSolid read() {
        if (prim_.type == "Mesh") return mesh();
        const NodeTransform parts = parts_of(map_);
        if (parts.is_skewed) {
            throw Error(ErrorCode::unsupported, stage_.place(prim_), {},
                        "is skewed by a rotation below a nonuniform scale, which would distort its shape");
        }
        const glm::dvec3 scale = glm::abs(parts.scale);
        UsdSolid solid;
        solid.at = {parts.translation, parts.rotation};
        if (prim_.type == "Cube") {
            solid.shape = Box{Vec3(0.5 * size("size", 2.0) * checked(scale))};
        } else if (prim_.type == "Sphere") {
            const glm::dvec3 axes = size("radius", 1.0) * checked(scale);
            const double most = std::max({axes.x, axes.y, axes.z}), least = std::min({axes.x, axes.y, axes.z});
            if (most - least <= 1e-4 * most) {
                solid.shape = Sphere{static_cast<float>(most)};
            } else {
                solid.shape = Hull(ellipsoid_surface(axes).vertices);
            }
        } else if (prim_.type == "Cylinder" || prim_.type == "Capsule" || prim_.type == "Cone") {
            column(solid, checked(scale));
        } else if (prim_.type == "Plane") {
            glm::dvec3 normal(0.0);
            normal[axis()] = 1.0;
            solid.shape = Plane{.normal = Vec3(normal)};
        }
        return solid;
    }

    std::shared_ptr<const Surface> covered() const {
        const UsdValue* places = prim_.type == "Mesh" ? stage_.value(prim_, "primvars:st") : nullptr;
        if (places == nullptr) return nullptr;
        std::vector<std::size_t> numbers;
        const Surface plain = triangles(&numbers);
        const UsdValue* indices = stage_.value(prim_, "primvars:st:indices");
        const std::size_t pairs = places->numbers.size() / 2, count = indices ? indices->numbers.size() : pairs;
        // One texture coordinate per face corner, else per point.
        const bool is_of_corners = count != plain.vertices.size();
        Surface made;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            std::size_t at = is_of_corners ? numbers[i] : plain.indices[i];
            if (at >= count) stage_.fail(prim_, "primvars:st", "must have one for each point or corner of a face");
            if (indices != nullptr) {
                const double index = indices->numbers[at];
                if (!(index >= 0.0 && index < static_cast<double>(pairs)))
                    stage_.fail(prim_, "primvars:st:indices", "must be indices of pairs in primvars:st, from 0");
                at = static_cast<std::size_t>(index);
            }
            made.vertices.push_back(plain.vertices[plain.indices[i]]);
            made.coordinates.emplace_back(static_cast<float>(places->numbers[2 * at]),
                                          // USD counts v upward, Surface downward
                                          static_cast<float>(1.0 - places->numbers[2 * at + 1]));
            made.indices.push_back(static_cast<std::uint32_t>(i));
        }
        for (const glm::vec2& at : made.coordinates)
            if (!(std::fabs(at.x) <= 1e6f && std::fabs(at.y) <= 1e6f))
                stage_.fail(prim_, "primvars:st", "must be within 1000000");
        return std::make_shared<const Surface>(std::move(made));
    }

  private:
    double size(const char* name, double otherwise) const { return stage_.number(prim_, name, otherwise, 1e-9, 1e9); }
    glm::dvec3 checked(const glm::dvec3& scale) const {
        for (int i = 0; i < 3; ++i) {
            if (!(scale[i] >= 1e-9)) stage_.fail(prim_, "xformOpOrder", "must not make the shape flat");
        }
        return scale;
    }
    int axis() const {
        const std::string name = stage_.word(prim_, "axis", "Z");
        if (name != "X" && name != "Y" && name != "Z") stage_.fail(prim_, "axis", "must be X, Y or Z");
        return name[0] - 'X';
    }
    void warn_of_uneven(double a, double b) {
        if (std::fabs(a - b) <= 1e-4 * std::max(a, b)) return;
        warnings_.push_back(stage_.place(prim_) + ": is round, and takes the larger of its nonuniform scales");
    }

    void column(UsdSolid& solid, const glm::dvec3& scale) {
        const int along = axis(), second = (along + 1) % 3, third = (along + 2) % 3;
        const bool is_capsule = prim_.type == "Capsule";
        warn_of_uneven(scale[second], scale[third]);
        const float radius = static_cast<float>(size("radius", is_capsule ? 0.5 : 1.0) *
                                                std::max(scale[second], scale[third])),
                    half = static_cast<float>(0.5 * size("height", is_capsule ? 1.0 : 2.0) * scale[along]);
        if (is_capsule) {
            solid.shape = Capsule{half, radius, std::nullopt};
        } else if (prim_.type == "Cone") {
            solid.shape = cone(radius, half);
        } else {
            solid.shape = Cylinder{half, radius, std::nullopt};
        }
        const glm::dquat turns[] = {{root_of_half, 0.0, 0.0, -root_of_half}, {1.0, 0.0, 0.0, 0.0}, y_to_z.rotation};
        // From the y axis, which is that of shapes in the engine.
        solid.at.rotation = glm::normalize(solid.at.rotation * turns[along]);
    }

    // Returns the triangles. `numbers` receives the index of each of their corners in faceVertexIndices.
    Surface triangles(std::vector<std::size_t>* numbers = nullptr) const {
        const UsdValue* points = stage_.value(prim_, "points");
        const UsdValue* counts = stage_.value(prim_, "faceVertexCounts");
        const UsdValue* corners = stage_.value(prim_, "faceVertexIndices");
        if (points == nullptr || counts == nullptr || corners == nullptr || points->numbers.size() % 3 != 0) {
            throw Error(ErrorCode::invalid_file, stage_.place(prim_), {},
                        "must have points, faceVertexCounts and faceVertexIndices");
        }
        Surface made;
        for (std::size_t i = 0; i + 2 < points->numbers.size(); i += 3) {
            const glm::dvec3 p(points->numbers[i], points->numbers[i + 1], points->numbers[i + 2]);
            for (int k = 0; k < 3; ++k) {
                if (!(std::fabs(p[k]) <= 1e9))
                    throw Error(ErrorCode::invalid_file, stage_.place(prim_) + ": points", {}, "must be within 1e9");
            }
            made.vertices.push_back(Vec3(map_.linear * p + map_.translation));
        }
        const bool flips =
            (stage_.word(prim_, "orientation", "rightHanded") == "leftHanded") != (glm::determinant(map_.linear) < 0.0);
        std::size_t at = 0;
        for (const double count : counts->numbers) {
            if (!(count >= 0.0 && count == std::floor(count) &&
                  count <= static_cast<double>(corners->numbers.size() - at))) {
                throw Error(ErrorCode::invalid_file, stage_.place(prim_) + ": faceVertexCounts", std::to_string(count),
                            "must count the corners in faceVertexIndices");
            }
            const std::size_t end = at + static_cast<std::size_t>(count);
            for (std::size_t i = at; i < end; ++i) {
                const double index = corners->numbers[i];
                if (!(index >= 0.0 && index < static_cast<double>(made.vertices.size()) &&
                      index == std::floor(index))) {
                    throw Error(ErrorCode::invalid_file, stage_.place(prim_) + ": faceVertexIndices",
                                std::to_string(index), "must be indices of points, from 0");
                }
            }
            for (std::size_t i = at + 1; i + 1 < end; ++i) { // cut into a fan
                const auto corner = [&](std::size_t k) { return static_cast<std::uint32_t>(corners->numbers[k]); };
                const std::size_t of_fan[] = {at, flips ? i + 1 : i, flips ? i : i + 1};
                for (const std::size_t k : of_fan) made.indices.push_back(corner(k));
                if (numbers != nullptr) numbers->insert(numbers->end(), std::begin(of_fan), std::end(of_fan));
            }
            at = end;
        }
        if (made.indices.empty()) throw Error(ErrorCode::invalid_file, stage_.place(prim_), {}, "must have a triangle");
        return made;
    }

    UsdSolid mesh() {
        UsdSolid solid;
        solid.surface = std::make_shared<const Surface>(triangles());
        const std::string way = stage_.word(prim_, "physics:approximation", "none");
        try {
            if (way == "boundingCube" || way == "boundingSphere") {
                bounding(solid, way == "boundingCube");
            } else if (is_static_ && (way == "none" || way == "meshSimplification" || is_flat(*solid.surface))) {
                solid.shape = Mesh(solid.surface->vertices, solid.surface->indices);
            } else {
                solid.shape = Hull(used_vertices(*solid.surface));
                const bool has_word = stage_.value(prim_, "physics:approximation") != nullptr;
                solid.is_cut = way == "convexDecomposition" || (!has_word && decomposes_);
            }
        } catch (const Error& error) {
            throw Error(ErrorCode::invalid_file, stage_.place(prim_), {}, error.what());
        }
        return solid;
    }

    static bool is_flat(const Surface& surface) { // a flat mesh has no convex hull
        try {
            Hull(used_vertices(surface));
            return false;
        } catch (const Error&) {
            return true;
        }
    }

    static void bounding(UsdSolid& solid, bool is_box) {
        glm::dvec3 low(1e30), high(-1e30);
        for (const Vec3& v : used_vertices(*solid.surface)) {
            low = glm::min(low, glm::dvec3(v)), high = glm::max(high, glm::dvec3(v));
        }
        solid.at.position = 0.5 * (low + high);
        if (is_box) {
            solid.shape = Box{Vec3(0.5 * (high - low))};
        } else {
            double square = 0.0;
            for (const Vec3& v : used_vertices(*solid.surface)) {
                const glm::dvec3 d = glm::dvec3(v) - solid.at.position;
                square = std::max(square, glm::dot(d, d));
            }
            solid.shape = Sphere{static_cast<float>(std::sqrt(square))};
        }
    }

    const UsdStage& stage_;
    const UsdPrim& prim_;
    Affine map_; // to the frame of the body
    bool is_static_, decomposes_;
    std::vector<std::string>& warnings_;
};

} // namespace

UsdSolid usd_solid(const UsdStage& stage, const UsdPlace& place, const Rigid& body, bool is_static, bool decomposes,
                   std::vector<std::string>& warnings) {
    try {
        return SolidReader(stage, place, body, is_static, decomposes, warnings).read();
    } catch (const Error& error) {
        if (error.code() != ErrorCode::invalid_value) throw; // not an error of a shape
        throw Error(ErrorCode::invalid_file, stage.place(*place.prim), {}, error.what());
    }
}

std::shared_ptr<const Surface> usd_covered_surface(const UsdStage& stage, const UsdPlace& place, const Rigid& body) {
    std::vector<std::string> unused;
    return SolidReader(stage, place, body, true, false, unused).covered();
}

} // namespace cairn::scene
