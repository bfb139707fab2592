// What contacts carry on the average (islands/substep_policy.cpp).
#include "bodies/integrators.h"
#include "islands/substep_policy.h"

#include <gtest/gtest.h>

namespace {

using namespace cairn;

// A load that has gone fell to the least number there is and stayed that: processors take long to reckon with those,
// and a step of bodies at rest took a tenth more from its eighth second on.
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
