#include "shapes/mass.h"

namespace cairn {

using math::DVec3;

MassSum combine(const MassSum& a, const MassSum& b) {
    const double mass = a.mass + b.mass;
    if (!(a.mass > 0)) return b;
    if (!(b.mass > 0)) return a;
    MassSum r;
    r.mass = mass;
    r.center = (1 / mass) * (a.mass * a.center + b.mass * b.center);
    auto shifted = [&](const MassSum& part) {
        const DVec3 d = part.center - r.center;
        const double m = part.mass;
        return part.inertia + math::DSym3{m * (d.y * d.y + d.z * d.z), -m * d.x * d.y, -m * d.x * d.z,
                                          m * (d.x * d.x + d.z * d.z), -m * d.y * d.z, m * (d.x * d.x + d.y * d.y)};
    };
    r.inertia = shifted(a) + shifted(b);
    return r;
}

PrincipalInertia diagonalize(const math::DSym3& inertia) {
    double a[3][3] = {{inertia.xx, inertia.xy, inertia.xz},
                      {inertia.xy, inertia.yy, inertia.yz},
                      {inertia.xz, inertia.yz, inertia.zz}};
    math::DQuat axes;
    for (int sweep = 0; sweep < 32; ++sweep) {
        const double off = std::fabs(a[0][1]) + std::fabs(a[0][2]) + std::fabs(a[1][2]);
        const double diagonal = std::fabs(a[0][0]) + std::fabs(a[1][1]) + std::fabs(a[2][2]);
        if (!(off > 1e-14 * diagonal)) break;
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (a[p][q] == 0) continue;
                const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
                const double t = (theta >= 0 ? 1.0 : -1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
                const double c = 1 / std::sqrt(t * t + 1), s = t * c;
                // A <- J^T A J, where J is the rotation in the plane (p, q) by the angle with tangent t.
                for (int k = 0; k < 3; ++k) {
                    const double kp = a[k][p], kq = a[k][q];
                    a[k][p] = c * kp - s * kq;
                    a[k][q] = s * kp + c * kq;
                }
                for (int k = 0; k < 3; ++k) {
                    const double pk = a[p][k], qk = a[q][k];
                    a[p][k] = c * pk - s * qk;
                    a[q][k] = s * pk + c * qk;
                }
                // J as a quaternion, with the half angle computed from the cosine, without trigonometric functions.
                const double half_cosine = std::sqrt((1 + c) / 2), half_sine = s / (2 * half_cosine);
                const int axis = 3 - p - q;
                const double sign = axis == 1 ? 1.0 : -1.0; // e_p x e_q = +-e_axis
                math::DQuat j{0, 0, 0, half_cosine};
                (axis == 0 ? j.x : axis == 1 ? j.y : j.z) = sign * half_sine;
                axes = math::normalized(axes * j);
            }
    }
    return {{a[0][0], a[1][1], a[2][2]}, axes};
}

} // namespace cairn
