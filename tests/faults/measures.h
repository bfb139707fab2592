/// \file measures.h
/// Measures shared by the tests of faults.
#pragma once

#include <cairn/cairn.h>

#include <cstddef>
#include <fstream>
#include <unistd.h>

namespace cairn::test {

inline float speed_of(const World& world, BodyId body) { return glm::length(world.body(body).linear_velocity()); }

/// Memory of this process that lies in RAM, in bytes.
inline std::size_t resident_memory() {
    std::ifstream file("/proc/self/statm");
    std::size_t total = 0, resident = 0;
    file >> total >> resident;
    return resident * std::size_t(sysconf(_SC_PAGESIZE));
}

} // namespace cairn::test
