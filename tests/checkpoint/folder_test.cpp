// Checkpoints in a folder: any number of ranks can read what any other number has written, and an incomplete checkpoint
// is never accepted.
#include "run_on_ranks.h"

#include "checkpoint/folder.h"

#include "files/checksum.h"

#include <cairn/error.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace cairn_test {
namespace {

namespace fs = std::filesystem;
using namespace cairn;
using namespace cairn::checkpoint;

using Sections = std::vector<std::vector<std::byte>>;

const Identity identity{{"version", "1", "was written by another version"}, {"start", "abc", "began otherwise"}};

class CheckpointFolder : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  (std::string("cairn_checkpoint_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    // Three random sections of up to `most` bytes each.
    Sections random_sections(std::size_t most) {
        Sections sections(3);
        for (std::vector<std::byte>& section : sections) {
            section.resize(random_() % (most + 1));
            for (std::byte& byte : section) byte = std::byte(random_() & 0xff);
        }
        return sections;
    }
    void write(std::uint64_t step, const Sections& sections, int ranks, int keep = 2) const {
        const std::vector<std::span<const std::byte>> spans(sections.begin(), sections.end());
        run_on_ranks(ranks, [&](Communicator* communicator) {
            Writer(folder_, identity, communicator, keep).write({step, 0.1 * double(step), 0, 0.0, {}}, spans);
        });
    }
    // Reads the checkpoint on that number of ranks, which must agree; the messages are in `lines_`.
    std::optional<Checkpoint> read(int ranks) {
        std::vector<std::optional<Checkpoint>> found;
        std::mutex mutex;
        lines_.clear();
        run_on_ranks(ranks, [&](Communicator* communicator) {
            std::optional<Checkpoint> here = read_last(folder_, identity, communicator, [&](const std::string& line) {
                const std::lock_guard lock(mutex);
                lines_.push_back(line);
            });
            const std::lock_guard lock(mutex);
            found.push_back(std::move(here));
        });
        for (const std::optional<Checkpoint>& one : found) {
            EXPECT_EQ(one.has_value(), found[0].has_value());
            if (!one || !found[0]) continue;
            EXPECT_EQ(one->sections, found[0]->sections);
            EXPECT_EQ(one->moment.step, found[0]->moment.step);
        }
        return found[0];
    }
    static std::string bytes(const fs::path& path) {
        std::ifstream stream(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    static void put(const fs::path& path, const std::string& text) {
        std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
    }
    fs::path step(int number) const { return folder_ / ("step_" + std::to_string(number)); }

    fs::path folder_;
    std::vector<std::string> lines_;
    std::mt19937 random_{7};
};

TEST(Checksum, IsThatOfZlibForAnyLengthAndInPieces) {
    EXPECT_EQ(files::crc32("123456789"), 0xcbf43926u);
    EXPECT_EQ(files::crc32(""), 0u);
    const std::string text = "the quick brown fox jumps over the lazy dog, and once more over the dog";
    EXPECT_EQ(files::crc32(text), 0xb91460d0u);
    for (std::size_t cut = 0; cut <= text.size(); ++cut)
        EXPECT_EQ(files::crc32(text.substr(cut), files::crc32(text.substr(0, cut))), files::crc32(text));
}

TEST_F(CheckpointFolder, AnyNumberOfRanksReadsWhatAnyOtherNumberHasWritten) {
    int number = 0;
    for (const std::size_t most : {std::size_t{0}, std::size_t{3}, std::size_t{5000}, std::size_t{3000000}}) {
        for (const int writers : {1, 2, 3, 5}) {
            const Sections sections = random_sections(most);
            write(std::uint64_t(++number), sections, writers);
            const fs::path place = step(number);
            std::uintmax_t least = ~std::uintmax_t{0}, greatest = 0;
            for (int rank = 0; rank < writers; ++rank) {
                const std::uintmax_t size = fs::file_size(place / ("part_" + std::to_string(rank)));
                least = std::min(least, size), greatest = std::max(greatest, size);
            }
            EXPECT_LE(greatest - least, 1u) << "no rank writes more than its share";
            for (const int readers : {1, 2, 4}) {
                const std::optional<Checkpoint> found = read(readers);
                ASSERT_TRUE(found);
                EXPECT_EQ(found->moment.step, std::uint64_t(number));
                EXPECT_EQ(found->sections, sections) << writers << " wrote, " << readers << " read";
                EXPECT_TRUE(lines_.empty());
            }
        }
    }
}

// A file of the last checkpoint is truncated, modified by one bit, or removed, at random.
TEST_F(CheckpointFolder, DamageAnywhereIsToldAndTheOlderOneIsRead) {
    const Sections older = random_sections(4000), newer = random_sections(4000);
    write(10, older, 2);
    write(20, newer, 3);
    const fs::path spare = fs::path(folder_) += "_spare";
    fs::remove_all(spare);
    fs::copy(folder_, spare, fs::copy_options::recursive);
    for (int i = 0; i < 300; ++i) {
        const std::string name = std::vector<std::string>{"part_0", "part_1", "part_2", "index.json"}[random_() % 4];
        const fs::path path = step(20) / name;
        std::string text = bytes(path);
        const std::size_t at = random_() % text.size();
        std::string what;
        switch (random_() % 4) {
        case 0:
            text.resize(at), what = "cut off";
            break;
        case 1:
            text[at] = char(text[at] ^ (1 << random_() % 8)), what = "flipped";
            break;
        case 2:
            text.insert(at, 1, 'x'), what = "longer";
            break;
        default:
            what = "missing";
            break;
        }
        if (what == "missing")
            fs::remove(path);
        else
            put(path, text);
        const std::optional<Checkpoint> found = read(1 + int(random_() % 3));
        ASSERT_TRUE(found) << name << " " << what << " at " << at;
        if (found->moment.step == 20) { // only white space of the index was changed
            EXPECT_EQ(found->sections, newer);
            EXPECT_EQ(name, "index.json") << what << " at " << at;
        } else {
            EXPECT_EQ(found->sections, older) << name << " " << what << " at " << at;
            EXPECT_FALSE(lines_.empty());
            EXPECT_NE(lines_[0].find(what == "missing" && name == "index.json" ? step(20).string() : path.string()),
                      std::string::npos)
                << lines_[0];
        }
        fs::remove_all(folder_);
        fs::copy(spare, folder_, fs::copy_options::recursive);
    }
    fs::remove_all(spare);
}

TEST_F(CheckpointFolder, MessagesSayWhatIsThereAndWhatMustBe) {
    const Sections sections{std::vector<std::byte>(1000, std::byte{1}), {}, {}};
    write(10, sections, 2);
    const fs::path part = step(10) / "part_1";
    const auto line = [&] {
        EXPECT_THROW(read(1), Error); // there is no other checkpoint
        return lines_.empty() ? std::string() : lines_[0];
    };
    const std::string whole = bytes(part);
    put(part, whole.substr(0, 123));
    EXPECT_EQ(line(), part.string() + ": size: must be 500 bytes, got 123");
    std::string flipped = whole;
    flipped[7] = char(flipped[7] ^ 1);
    put(part, flipped);
    EXPECT_EQ(line().find(part.string() + ": checksum: is damaged: must be "), 0u) << lines_[0];
    fs::remove(part);
    EXPECT_EQ(line(), part.string() + ": cannot be read: No such file or directory");
    fs::remove(step(10) / "index.json");
    EXPECT_EQ(line(), step(10).string() + ": was not finished: it has no index.json");
}

TEST_F(CheckpointFolder, ThatIsOfAnotherRunIsRefusedAndNotPassedOver) {
    write(10, random_sections(10), 1);
    Identity other = identity;
    other[1].value = "xyz";
    try {
        read_last(folder_, other, nullptr, [](const std::string&) {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::wrong_state);
        EXPECT_EQ(std::string(error.what()),
                  (step(10) / "index.json").string() + ": start: began otherwise: must be xyz, got abc");
    }
}

TEST_F(CheckpointFolder, AnEmptyOneHasNone) {
    EXPECT_FALSE(read(2));
    fs::create_directories(folder_ / "step_x");
    fs::create_directories(folder_ / "step_007");
    EXPECT_FALSE(read(1));
}

TEST_F(CheckpointFolder, KeepsSoManyAndAWholeOneAtAnyMoment) {
    for (const std::uint64_t number : {10, 20, 30}) write(number, random_sections(100), 2);
    EXPECT_EQ(steps_in(folder_), (std::vector<std::uint64_t>{30, 20}));
    fs::create_directories(step(35)); // begun by a program that was killed
    write(40, random_sections(100), 3, 1);
    EXPECT_EQ(steps_in(folder_), (std::vector<std::uint64_t>{40}));
    write(90, random_sections(100), 1);
    put(step(90) / "part_0", "damaged");
    // Resumed from step 40: the damaged checkpoint does not count among those that are kept.
    write(50, random_sections(100), 1, 1);
    EXPECT_EQ(steps_in(folder_), (std::vector<std::uint64_t>{90, 50}));
    EXPECT_EQ(read(1)->moment.step, 50u);
}

TEST_F(CheckpointFolder, WhatIsLeftOfOneThatWasBegunIsReplaced) {
    write(10, random_sections(3000), 4);
    fs::remove(step(10) / "index.json");
    const Sections sections = random_sections(3000);
    write(10, sections, 2);
    EXPECT_EQ(read(3)->sections, sections);
    EXPECT_FALSE(fs::exists(step(10) / "part_3"));
}

TEST_F(CheckpointFolder, TwoProgramsDoNotWriteThere) {
    const Writer one(folder_, identity, nullptr, 2);
    EXPECT_THROW(Writer(folder_, identity, nullptr, 2), Error);
}

TEST_F(CheckpointFolder, ThatCannotBeMadeIsSaidAtOnce) {
    put(fs::path(folder_) += "_file", "");
    try {
        Writer(fs::path(folder_) += "_file/ck", identity, nullptr, 2);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::io);
        EXPECT_NE(std::string(error.what()).find("_file/ck: cannot be made: "), std::string::npos) << error.what();
    }
    fs::remove(fs::path(folder_) += "_file");
}

} // namespace
} // namespace cairn_test
