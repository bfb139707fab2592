// Runs of a scene by one process and by several ranks, to be compared.
#pragma once

#include "local_ranks.h"
#include "scene_tools.h"

#include <memory>
#include <string>
#include <vector>

namespace cairn_test {

struct Course {
    std::vector<std::uint64_t> hashes;  // state hash after each step
    std::vector<std::uint64_t> reports; // hash after each step of all events, and of the contacts if read
    cairn::Snapshot end;
    std::uint64_t clamped_speeds = 0;
    std::size_t overflow_contacts = 0; // maximum
    std::size_t hits = 0;              // events
    int exchanges = 0;
    std::size_t bytes_of_end = 0; // sent by a rank to the others for `end`
};

// `asked_every`: contacts are read every so many steps; 0: never.
Course run_alone(Scene& scene, cairn::World& world, int steps, int asked_every = 0);
// The run of each rank, from a snapshot on.
std::vector<Course> run_on_ranks(Scene& scene, const cairn::Snapshot& start, int ranks, int steps, int threads,
                                 int asked_every = 0);
void expect_same(const Course& one, const Course& other, const std::string& who);

} // namespace cairn_test
