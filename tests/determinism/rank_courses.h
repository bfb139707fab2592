// Runs of a scene by one process and by several ranks, to be compared.
#pragma once

#include "local_ranks.h"
#include "scene_tools.h"

#include <memory>
#include <string>
#include <vector>

namespace cairn_test {

struct Course {
    std::vector<std::uint64_t> hashes;  // after each step
    std::vector<std::uint64_t> reports; // likewise, of all events; of the contacts, where these are asked for
    cairn::Snapshot end;
    std::uint64_t clamped_speeds = 0;
    std::size_t overflow_contacts = 0; // greatest
    std::size_t hits = 0;              // events
    int exchanges = 0;
    std::size_t bytes_of_end = 0; // that a rank has told the others of for `end`
};

// `asked_every`: so many steps; 0: contacts are not asked for.
Course run_alone(Scene& scene, cairn::World& world, int steps, int asked_every = 0);
// What each of the ranks has, from a snapshot on.
std::vector<Course> run_on_ranks(Scene& scene, const cairn::Snapshot& start, int ranks, int steps, int threads,
                                 int asked_every = 0);
void expect_same(const Course& one, const Course& other, const std::string& who);

} // namespace cairn_test
