// The index of a checkpoint, converted to text and back.
#include "checkpoint/index.h"

#include "files/checksum.h"

#include <cairn/error.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <string>

namespace cairn::checkpoint {
namespace {

Index example() {
    Index index{{{"version", "1.2", ""}, {"start", "ab\"\n", ""}},
                {},
                {5, 0, 2},
                {{"part_0", 4, 1}, {"part_1", 3, 0xffffffffu}}};
    index.moment = {12345678901234u, 0.1 + 0.2, 0xfedcba9876543210u, std::numeric_limits<double>::denorm_min(),
                    TableProgress{"/a b/c.csv", "--every 1", {99, 7, 3, 4}}};
    return index;
}

TEST(CheckpointIndex, IsReadBackToTheLastBit) {
    const Index before = example(), after = read_index(to_text(before), "x");
    EXPECT_EQ(after.moment.step, before.moment.step);
    EXPECT_EQ(after.moment.time, before.moment.time);
    EXPECT_EQ(after.moment.state_hash, before.moment.state_hash);
    EXPECT_EQ(after.moment.max_penetration, before.moment.max_penetration);
    ASSERT_TRUE(after.moment.table);
    EXPECT_EQ(after.moment.table->file, "/a b/c.csv");
    EXPECT_EQ(after.moment.table->extent.rows_crc, 4u);
    EXPECT_EQ(after.sections, before.sections);
    ASSERT_EQ(after.parts.size(), 2u);
    EXPECT_EQ(after.parts[1].crc, 0xffffffffu);
    EXPECT_EQ(to_text(after), to_text(before));
    EXPECT_NO_THROW(require_same(before.identity, after, "x"));
}

// A modified index is rejected, unless only white space was changed.
TEST(CheckpointIndex, IsRefusedWithAnyBitChangedAndCutOffAnywhere) {
    const std::string text = to_text(example());
    for (std::size_t at = 0; at + 1 < text.size(); ++at) {
        EXPECT_THROW(read_index(text.substr(0, at), "x"), Error) << at;
        for (int bit = 0; bit < 8; ++bit) {
            std::string other = text;
            other[at] = char(other[at] ^ (1 << bit));
            try {
                EXPECT_EQ(to_text(read_index(other, "x")), text) << at;
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ErrorCode::invalid_file) << error.what();
            }
        }
    }
}

// With a matching checksum, as if somebody had edited the file by hand.
TEST(CheckpointIndex, SaysWhichMemberIsWrong) {
    const auto message = [](const char* change) {
        nlohmann::ordered_json json = nlohmann::ordered_json::parse(to_text(example()));
        json["checkpoint"].merge_patch(nlohmann::ordered_json::parse(change));
        json["crc32"] = hex(files::crc32(json["checkpoint"].dump()));
        try {
            read_index(json.dump(), "ck/index.json");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("nothing");
    };
    EXPECT_EQ(message(R"({"step": -1})"), "ck/index.json: step: must be a whole number, got -1");
    EXPECT_EQ(message(R"({"state_hash": "12"})"),
              "ck/index.json: state_hash: must be 16 hexadecimal digits, got \"12\"");
    EXPECT_EQ(message(R"({"parts": null})"), "ck/index.json: parts: is missing");
    EXPECT_EQ(message(R"({"parts": [{"file": "part_0"}]})"), "ck/index.json: parts[0].bytes: is missing");
    EXPECT_EQ(message(R"({"sections": [5, 0, 9]})"),
              "ck/index.json: parts: must have the 14 bytes of the sections, got 7");
    EXPECT_EQ(message(R"({"table": {"rows": "many"}})"),
              "ck/index.json: table.rows: must be a whole number, got \"many\"");
    EXPECT_EQ(message(R"({"format": 2})"),
              "ck/index.json: format: is of a later version of this program: must be 1, got 2");
}

} // namespace
} // namespace cairn::checkpoint
