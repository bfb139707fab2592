// Rigid parts added up to one: mass, center of mass, principal moments of inertia.
#pragma once

#include "scene/rigid.h"

#include <cairn/body.h>

#include <optional>
#include <string>
#include <vector>

namespace cairn::scene {

class MassSum {
  public:
    // A part of `mass` (kg, > 0), whose center of mass and axes are at `at`; `inertia` (kg m^2) about them.
    void add(double mass, const glm::dmat3& inertia, const Rigid& at);

    void add_inertia(const glm::dmat3& inertia) { inertia_ += inertia; } // without mass

    double mass() const { return mass_; }
    double inertia_size() const; // of that about the center of mass, all entries
    MassProperties properties() const;
    // Likewise, with an inertia that a body can have: see real_inertia.
    MassProperties real_properties(const std::string& where, std::vector<std::string>& warnings) const;

  private:
    glm::dvec3 center() const { return moment_ / mass_; }
    glm::dmat3 inertia_about_center() const;
    MassProperties properties_with(const glm::dmat3& inertia) const;

    double mass_ = 0.0;
    glm::dvec3 moment_{0.0, 0.0, 0.0}; // sum of mass times place
    glm::dmat3 inertia_{0.0};          // about the origin
};

// Of the ball of 0.1 m radius that stands in for inertias that files do not give, kg m2.
inline glm::dmat3 blank_inertia(double mass) { return glm::dmat3(0.4 * mass * 0.1 * 0.1); }

// Eigenvalues of a symmetric matrix, and the rotation whose columns are their axes (Jacobi, Golub and Van Loan,
// Matrix Computations, section 8.5). A diagonal matrix keeps its axes.
struct PrincipalAxes {
    glm::dvec3 values;
    glm::dmat3 axes;
};
PrincipalAxes principal_axes(glm::dmat3 matrix);

// Moments of inertia of a real body satisfy the triangle inequality: none exceeds the sum of the other two. Empty if
// these do, as exactly as the engine asks for, else the nearest ones that do (by least squares).
std::optional<glm::dvec3> nearest_real_moments(const glm::dvec3& moments);

// The inertia itself, or the nearest that a body can have, with a warning. Throws Error (invalid_file) naming `where`
// if one of its principal moments is not positive.
glm::dmat3 real_inertia(const glm::dmat3& inertia, const std::string& where, std::vector<std::string>& warnings);

} // namespace cairn::scene
