// Random numbers that are functions of where they stand, and functions of numbers that are the same on every machine:
// plain IEEE operations, in the order written.
#pragma once

#include <cstdint>

namespace cairn::sweep {

// Sixty-four bits that look random, of two numbers.
std::uint64_t mixed(std::uint64_t a, std::uint64_t b);

// Between 0 and 1, neither of them, by the upper 53 bits.
double unit_interval(std::uint64_t bits);

// The natural logarithm of a positive, normal number, and the exponential function, both to some units in the last
// place. `exponential` is for results that are normal numbers, too.
double natural_log(double x);
double exponential(double x);

// The number below which a standard normal variable stays with probability `p`, above 0 and below 1 (algorithm AS 241
// of Wichura, 1988).
double normal_quantile(double p);

} // namespace cairn::sweep
