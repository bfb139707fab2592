// Averages of the load that contacts carry (islands/substep_policy.cpp).
#include "bodies/integrators.h"
#include "islands/substep_policy.h"

#include <gtest/gtest.h>

namespace {

using namespace cairn;

// Without the fix a load that had disappeared decayed to the smallest denormal number and stayed there. Processors are
// slow with denormals: a step of bodies at rest took a tenth longer from its eighth second on.
TEST(Load, ThatHasGoneIsNoneAtAll) {
    Island island;
    island.weight = 1e4f;
    ContactInfo contact;
    for (int step = 0; step < 20; ++step) note_load(island, contact, 1e3f, 1e-3f, 0.25f);
    EXPECT_GT(contact.load, 900);
    for (int step = 0; step < 400; ++step) note_load(island, contact, 0, 1e-3f, 0.25f);
    EXPECT_EQ(contact.load, 0);
}

} // namespace
