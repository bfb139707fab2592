// The number of queries that a world answers per second.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cairn::bench {

struct QueryOptions {
    int bodies = 5000;
    int queries = 20000; // of each kind per round
    int rounds = 5;
};

struct QueryRate {
    std::string kind;
    double per_second = 0; // in the median round, by processor time
    double met = 0;        // share of the queries that found something
};

// The world is a pile of spheres, boxes, capsules, cylinders and hulls at rest in a pen. Queries start at random
// positions in and above it: ray and shape casts in random directions over 0.1 to 30 m, closest points and overlaps,
// all with shapes of half a meter. Casts start where the query box overlaps nothing; those named `from all` start
// anywhere (a third of these positions overlap something).
std::vector<QueryRate> measure_queries(const QueryOptions& options);

} // namespace cairn::bench
