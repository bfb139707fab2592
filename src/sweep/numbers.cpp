#include "sweep/numbers.h"

#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace cairn::sweep {

namespace {

constexpr double log_2 = 0.69314718055994530942;

// Evaluates a polynomial; `c` has the coefficient of the highest power last.
template <std::size_t N> double polynomial(const double (&c)[N], double x) {
    double sum = c[N - 1];
    for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + c[i];
    return sum;
}

} // namespace

std::uint64_t hash_pair(std::uint64_t a, std::uint64_t b) {
    // The finalizer of SplitMix64 (Steele, Lea and Flood, 2014), once for each number.
    std::uint64_t z = 0;
    for (const std::uint64_t word : {a, b}) {
        z += word + 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        z ^= z >> 31;
    }
    return z;
}

double unit_interval(std::uint64_t bits) { return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52; }

double natural_log(double x) {
    int exponent = 0;
    double m = std::frexp(x, &exponent); // exact; 0.5 to 1
    if (m < 0.70710678118654752440) {
        m *= 2.0;
        --exponent;
    }
    // The series of the inverse hyperbolic tangent, whose argument is below 0.172.
    const double s = (m - 1.0) / (m + 1.0), square = s * s;
    double sum = 0.0;
    for (int k = 12; k >= 0; --k) sum = sum * square + 1.0 / static_cast<double>(2 * k + 1);
    return 2.0 * s * sum + static_cast<double>(exponent) * log_2;
}

double exponential(double x) {
    const double power = std::nearbyint(x / log_2), rest = x - power * log_2; // within 0.35
    double sum = 1.0;
    for (int k = 16; k >= 1; --k) sum = 1.0 + rest / static_cast<double>(k) * sum;
    return std::ldexp(sum, static_cast<int>(power)); // exact
}

double normal_quantile(double p) {
    constexpr double a[]{3.3871328727963666080e0,  1.3314166789178437745e+2, 1.9715909503065514427e+3,
                         1.3731693765509461125e+4, 4.5921953931549871457e+4, 6.7265770927008700853e+4,
                         3.3430575583588128105e+4, 2.5090809287301226727e+3};
    constexpr double b[]{1.0,
                         4.2313330701600911252e+1,
                         6.8718700749205790830e+2,
                         5.3941960214247511077e+3,
                         2.1213794301586595867e+4,
                         3.9307895800092710610e+4,
                         2.8729085735721942674e+4,
                         5.2264952788528545610e+3};
    constexpr double c[]{1.42343711074968357734e0,  4.63033784615654529590e0, 5.76949722146069140550e0,
                         3.64784832476320460504e0,  1.27045825245236838258e0, 2.41780725177450611770e-1,
                         2.27238449892691845833e-2, 7.74545014278341407640e-4};
    constexpr double d[]{1.0,
                         2.05319162663775882187e0,
                         1.67638483018380384940e0,
                         6.89767334985100004550e-1,
                         1.48103976427480074590e-1,
                         1.51986665636164571966e-2,
                         5.47593808499534494600e-4,
                         1.05075007164441684324e-9};
    constexpr double e[]{6.65790464350110377720e0,  5.46378491116411436990e0,  1.78482653991729133580e0,
                         2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
                         2.71155556874348757815e-5, 2.01033439929228813265e-7};
    constexpr double f[]{1.0,
                         5.99832206555887937690e-1,
                         1.36929880922735805310e-1,
                         1.48753612908506148525e-2,
                         7.86869131145613259100e-4,
                         1.84631831751005468180e-5,
                         1.42151175831644588870e-7,
                         2.04426310338993978564e-15};
    const double q = p - 0.5;
    if (std::fabs(q) <= 0.425) {
        const double r = 0.180625 - q * q;
        return q * polynomial(a, r) / polynomial(b, r);
    }
    const double r = std::sqrt(-natural_log(q < 0.0 ? p : 1.0 - p));
    const double x =
        r <= 5.0 ? polynomial(c, r - 1.6) / polynomial(d, r - 1.6) : polynomial(e, r - 5.0) / polynomial(f, r - 5.0);
    return q < 0.0 ? -x : x;
}

} // namespace cairn::sweep
