// Contact records: all of them, or only those kept on one of several ranks.
#include "state/contact_records.h"

#include <gtest/gtest.h>

namespace {

using namespace cairn;

ContactRecords numbered(std::size_t count) {
    ContactRecords records;
    for (std::size_t contact = 0; contact < count; ++contact) {
        records.open(contact, false); // the owner does not matter while all records are on this rank
        records[contact].friction = float(contact);
    }
    return records;
}

TEST(ContactRecords, WholeOnesLieAtThePlacesOfTheirContacts) {
    const ContactRecords records = numbered(5);
    EXPECT_TRUE(records.is_whole());
    EXPECT_EQ(records.places(), 5u);
    for (std::size_t contact = 0; contact < 5; ++contact) {
        EXPECT_TRUE(records.has(contact));
        EXPECT_EQ(records.whole()[contact].friction, float(contact));
    }
}

TEST(ContactRecords, ThoseThatStayTakeNoMoreRoomThanTheyAreMany) {
    ContactRecords records = numbered(1000);
    records.keep(1000, [](std::size_t contact) { return contact % 10 == 3; });
    EXPECT_FALSE(records.is_whole());
    EXPECT_EQ(records.places(), 100u);
    for (std::size_t contact = 0; contact < 1000; ++contact) {
        ASSERT_EQ(records.has(contact), contact % 10 == 3) << contact;
        if (!records.has(contact)) continue;
        ASSERT_EQ(records[contact].friction, float(contact));
    }
}

TEST(ContactRecords, PlacesAreGivenOutAgainAndRecordsBeginEmpty) {
    ContactRecords records = numbered(8);
    records.keep(8, [](std::size_t contact) { return contact < 4; });
    records.drop(1);
    records.drop(1);
    records.drop(6); // owned by another rank
    EXPECT_FALSE(records.has(1));
    records.open(9, false);
    EXPECT_FALSE(records.has(9));
    records.open(10, true);
    EXPECT_EQ(records.places(), 4u);
    EXPECT_EQ(records[10].friction, 0.0f);
    records.open(11, true);
    EXPECT_EQ(records.places(), 5u);
    EXPECT_EQ(records[3].friction, 3.0f);
    for (const std::size_t contact : {0u, 2u, 10u, 11u}) records.drop(contact);
    EXPECT_TRUE(records.is_sparse());
    records.keep(12, [](std::size_t) { return true; });
    EXPECT_EQ(records.places(), 1u);
    EXPECT_EQ(records[3].friction, 3.0f);
}

TEST(BodyOwners, BodiesThatNobodyWasGivenAreEveryRanks) {
    const BodyOwners owners{1, {0, 1, every_rank}};
    EXPECT_FALSE(owners.has(0));
    for (const std::int32_t body : {1, 2, 3}) EXPECT_TRUE(owners.has(body)) << body;
    EXPECT_EQ(owners[1], 1);
    EXPECT_EQ(owners[3], every_rank);
}

} // namespace
