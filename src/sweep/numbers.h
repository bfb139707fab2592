// Random numbers as functions of their position, and numeric functions with the same results on every machine: plain
// IEEE operations, in the order written.
#pragma once

#include <cstdint>

namespace cairn::sweep {

// Returns 64 pseudorandom bits as a function of two numbers.
std::uint64_t hash_pair(std::uint64_t a, std::uint64_t b);

// Maps the upper 53 bits to a number strictly between 0 and 1.
double unit_interval(std::uint64_t bits);

// The natural logarithm of a positive, normal number, and the exponential function, both accurate to a few units in the
// last place. The result of `exponential` must be a normal number, too.
double natural_log(double x);
double exponential(double x);

// Returns the quantile of the standard normal distribution for the probability `p`, above 0 and below 1 (algorithm AS
// 241 of Wichura, 1988).
double normal_quantile(double p);

} // namespace cairn::sweep
