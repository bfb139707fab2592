// Combines rigid parts into one: mass, center of mass, principal moments of inertia.
#pragma once

#include "scene/rigid.h"

#include <cairn/body.h>

#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

class MassSum {
  public:
    // Adds a part of `mass` (kg, > 0) whose center of mass and axes are at `at`; `inertia` (kg m^2) is about them.
    void add(double mass, const glm::dmat3& inertia, const Rigid& at);

    void add_inertia(const glm::dmat3& inertia) { inertia_ += inertia; } // an inertia without mass

    double mass() const { return mass_; }
    double inertia_size() const; // norm of the inertia about the center of mass, over all entries
    MassProperties properties() const;
    // The mass properties with an inertia that is physically possible: see valid_inertia.
    MassProperties real_properties(const std::string& where, std::vector<std::string>& warnings) const;

  private:
    glm::dvec3 center() const { return moment_ / mass_; }
    glm::dmat3 inertia_about_center() const;
    MassProperties properties_with(const glm::dmat3& inertia) const;

    double mass_ = 0.0;
    glm::dvec3 moment_{0.0, 0.0, 0.0}; // sum of mass times position
    glm::dmat3 inertia_{0.0};          // about the origin
};

// The inertia (kg m2) of a ball of 0.1 m radius, a substitute where a file gives no inertia.
inline glm::dmat3 fallback_inertia(double mass) { return glm::dmat3(0.4 * mass * 0.1 * 0.1); }

// Eigenvalues of a symmetric matrix, and the rotation whose columns are its eigenvectors (Jacobi, Golub and Van Loan,
// Matrix Computations, section 8.5). A diagonal matrix keeps its axes.
struct PrincipalAxes {
    glm::dvec3 values;
    glm::dmat3 axes;
};
PrincipalAxes principal_axes(glm::dmat3 matrix);

// Moments of inertia of a real body satisfy the triangle inequality: none exceeds the sum of the other two. Returns
// nothing if the moments satisfy it to the engine's tolerance, else the nearest moments that do (by least squares).
std::optional<glm::dvec3> nearest_valid_moments(const glm::dvec3& moments);

// Returns the inertia, or the nearest one that a body can have, with a warning. Throws Error (invalid_file) naming
// `where` if one of its principal moments is not positive.
glm::dmat3 valid_inertia(const glm::dmat3& inertia, const std::string& where, std::vector<std::string>& warnings);

} // namespace cairn::scene
