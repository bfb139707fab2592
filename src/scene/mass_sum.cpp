#include "scene/mass_sum.h"

#include "scene/json_number.h"

#include <cairn/error.h>

#include <cmath>

namespace cairn::scene {

namespace {

// The inertia of a point mass of 1 at `d`.
glm::dmat3 of_point(const glm::dvec3& d) { return glm::dmat3(glm::dot(d, d)) - glm::outerProduct(d, d); }

} // namespace

void MassSum::add(double mass, const glm::dmat3& inertia, const Rigid& at) {
    const glm::dmat3 turn = glm::mat3_cast(at.rotation);
    mass_ += mass;
    moment_ += mass * at.position;
    inertia_ += turn * inertia * glm::transpose(turn) + mass * of_point(at.position);
}

glm::dmat3 MassSum::inertia_about_center() const { return inertia_ - mass_ * of_point(center()); }

double MassSum::inertia_size() const {
    const glm::dmat3 inertia = inertia_about_center();
    double size = 0.0;
    for (int i = 0; i < 9; ++i) size += std::fabs(inertia[i / 3][i % 3]);
    return size;
}

MassProperties MassSum::properties_with(const glm::dmat3& inertia) const {
    const PrincipalAxes principal = principal_axes(inertia);
    MassProperties result;
    result.mass = static_cast<float>(mass_);
    result.center_of_mass = Vec3(center());
    result.inertia_diagonal = Vec3(principal.values);
    result.inertia_orientation = Quat(glm::normalize(glm::quat_cast(principal.axes)));
    return result;
}

MassProperties MassSum::properties() const { return properties_with(inertia_about_center()); }

MassProperties MassSum::real_properties(const std::string& where, std::vector<std::string>& warnings) const {
    return properties_with(valid_inertia(inertia_about_center(), where, warnings));
}

PrincipalAxes principal_axes(glm::dmat3 matrix) {
    constexpr int max_sweeps = 50; // about 5 are enough
    glm::dmat3 axes(1.0);
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
        const double off = std::fabs(matrix[0][1]) + std::fabs(matrix[0][2]) + std::fabs(matrix[1][2]);
        const double size = std::fabs(matrix[0][0]) + std::fabs(matrix[1][1]) + std::fabs(matrix[2][2]);
        if (!(off > 1e-15 * size)) break;
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                if (matrix[p][q] == 0.0) continue;
                const double ratio = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
                const double t = (ratio >= 0.0 ? 1.0 : -1.0) / (std::fabs(ratio) + std::sqrt(1.0 + ratio * ratio));
                const double c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
                glm::dmat3 turn(1.0);
                turn[p][p] = turn[q][q] = c;
                turn[q][p] = s;
                turn[p][q] = -s;
                matrix = glm::transpose(turn) * matrix * turn;
                matrix[p][q] = matrix[q][p] = 0.0;
                axes = axes * turn;
            }
        }
    }
    return {{matrix[0][0], matrix[1][1], matrix[2][2]}, axes};
}

std::optional<glm::dvec3> nearest_valid_moments(const glm::dvec3& moments) {
    constexpr double tolerance = 1e-4; // relative to the largest
    int largest = 0;
    for (int i = 1; i < 3; ++i) {
        if (moments[i] > moments[largest]) largest = i;
    }
    double excess = moments[largest];
    for (int i = 0; i < 3; ++i) {
        if (i != largest) excess -= moments[i];
    }
    if (!(excess > tolerance * moments[largest])) return std::nullopt;
    // The nearest point on the plane where the largest moment equals the sum of the others.
    glm::dvec3 result = moments + excess / 3.0;
    result[largest] = moments[largest] - excess / 3.0;
    return result;
}

glm::dmat3 valid_inertia(const glm::dmat3& inertia, const std::string& where, std::vector<std::string>& warnings) {
    const PrincipalAxes principal = principal_axes(inertia);
    const auto nearest = nearest_valid_moments(principal.values);
    const glm::dvec3 moments = nearest ? *nearest : principal.values;
    for (int i = 0; i < 3; ++i) {
        if (!(moments[i] > 0.0)) {
            throw Error(ErrorCode::invalid_file, where + ": inertia",
                        "a principal moment of " + std::to_string(principal.values[i]) + " kg m2",
                        "must have three positive principal moments");
        }
    }
    if (!nearest) return inertia;
    warnings.push_back(where +
                       ": one principal moment of inertia exceeds the sum of the other two, which is impossible; the "
                       "nearest possible moments are used: " +
                       short_number(nearest->x) + ", " + short_number(nearest->y) + ", " + short_number(nearest->z) +
                       " kg m2");
    return principal.axes * glm::dmat3(nearest->x, 0, 0, 0, nearest->y, 0, 0, 0, nearest->z) *
           glm::transpose(principal.axes);
}

} // namespace cairn::scene
