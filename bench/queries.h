// How many queries a world answers in a second.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cairn::bench {

struct QueryOptions {
    int bodies = 5000;
    int queries = 20000; // of each kind in a round
    int rounds = 5;
};

struct QueryRate {
    std::string kind;
    double per_second = 0; // the median round, by the time of the processor
    double met = 0;        // share of the queries that found something
};

// A pile of spheres, boxes, capsules, cylinders and hulls that has come to rest in a pen, asked from random places in
// and above it: rays and casts in random directions over 0.1 to 30 m, closest points and overlaps, each of shapes of
// half a meter. Rays and casts start where the box is free; those `from all` also where it is not (a third of them).
std::vector<QueryRate> measure_queries(const QueryOptions& options);

} // namespace cairn::bench
