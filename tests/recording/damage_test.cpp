// Recordings that are truncated or damaged, or that do not match the original run.
#include "recorded.h"
#include "recording/contents.h"
#include "recording/log_format.h"
#include "recording/mcap_writer.h"

#include <gtest/gtest.h>

#include <functional>

namespace cairn::test {
namespace {

using recording::Recording;
using recording::Replay;

// The same recording with modified messages in its log, and matching checksums.
std::string rewritten(const std::string& bytes, const std::function<void(std::string& message)>& change) {
    const TemporaryFile file(".rewritten");
    const recording::McapReader reader(recording::InputBytes(bytes, "run.mcap"));
    recording::McapWriter writer(file.path(), true);
    const std::uint16_t schema = writer.add_schema("cairn.Commands", "cairn", "{}");
    std::map<std::uint16_t, std::uint16_t> channels;
    for (const std::string_view topic :
         {recording::topic_log, recording::topic_geometry, recording::topic_snapshots, recording::topic_states})
        channels[*reader.channel(topic)] = writer.add_channel(schema, topic, recording::log_encoding);
    for (std::size_t i = 0; i < reader.chunks().size(); ++i) {
        recording::McapWriter::Chunk chunk;
        const std::string records = reader.load(i);
        reader.for_each_message(records, [&](const recording::McapMessage& message) {
            std::string data(message.data);
            if (message.channel == reader.channel(recording::topic_log)) change(data);
            chunk.add(channels.at(message.channel), message.sequence, message.nanoseconds, data);
        });
        writer.write(chunk);
    }
    writer.close();
    return file.bytes();
}

// The location of a command in the log.
struct CommandPlace {
    std::uint64_t step;            // the step that it precedes, counted from 1
    std::size_t message, at, size; // message index, and offset and size within the message, bytes
    std::string name;
};
std::vector<CommandPlace> commands_of(const std::string& bytes) {
    std::vector<CommandPlace> places;
    std::size_t message = 0;
    std::uint64_t steps = 0;
    rewritten(bytes, [&](std::string& data) {
        recording::BatchReader batch(data, "log");
        for (;;) {
            const recording::LogEntry entry = batch.next();
            if (entry.kind == recording::LogEntry::Kind::end) break;
            if (entry.kind != recording::LogEntry::Kind::command) continue;
            const auto at = std::size_t(reinterpret_cast<const char*>(entry.command.data()) - data.data());
            places.push_back({steps + 1, message, at, entry.command.size(), std::string(command_name(entry.command))});
            if (recording::is_step(entry.command)) ++steps;
        }
        ++message;
    });
    return places;
}

TEST(DamagedRecording, SaysAtWhichStepAFlippedBitOfACommandWorks) {
    recording::RecorderOptions options;
    options.keyframe_budget = 0;
    const RecordedRun run = record_changes(4, 300, options);
    std::mt19937 random(1);
    int found = 0, refused = 0, named = 0;
    std::vector<CommandPlace> places = commands_of(run.bytes);
    // Commands with a velocity, impulse or position, in which every bit matters.
    std::erase_if(places, [](const CommandPlace& place) {
        return place.name != "Body::set_linear_velocity" && place.name != "Body::apply_impulse" &&
               place.name != "Body::set_position" && place.name != "World::create_body";
    });
    for (int round = 0; round < 250; ++round) {
        const CommandPlace& place = places[random() % places.size()];
        const std::size_t bit = random() % (8 * place.size);
        std::size_t message = 0;
        const std::string changed = rewritten(run.bytes, [&](std::string& data) {
            if (message++ == place.message)
                data[place.at + bit / 8] = char(data[place.at + bit / 8] ^ (1 << (bit % 8)));
        });
        std::uint64_t step = 0;
        std::string text;
        try {
            const Recording recording = Recording::from_memory(changed, "run.mcap");
            Replay replay(recording);
            while (replay.step() && !replay.divergence()) {}
            if (!replay.divergence()) continue; // a name, user data, or a bit below the precision
            step = replay.divergence()->step;
            text = replay.divergence()->text();
            ++found;
            named += replay.divergence()->bodies.empty() ? 0 : 1;
        } catch (const Error& error) { // an invalid body or a non-finite number: detected as well
            text = error.what();
            const std::size_t at = text.find("step ");
            ASSERT_NE(at, std::string::npos) << text;
            step = std::stoull(text.substr(at + 5));
            ++refused;
        }
        if (place.name == "World::create_body") {
            EXPECT_GE(step, place.step) << text; // the effect may appear only later, as with damping
        } else {
            EXPECT_EQ(step, place.step) << place.name << " bit " << bit << ": " << text;
        }
    }
    EXPECT_GT(found, 100);
    EXPECT_GT(refused, 5);
    EXPECT_GT(named, found / 2);
}

TEST(DamagedRecording, ThatIsCutAtAnyByteOfItsLastChunkHasAllThatCameBefore) {
    recording::RecorderOptions options;
    options.keyframe_budget = 0;
    const RecordedRun run = record_changes(6, 600, options);
    const recording::McapReader reader(recording::InputBytes(run.bytes, "run.mcap"));
    ASSERT_GT(reader.chunks().size(), 1u);
    const auto& last = reader.chunks().back();
    const auto steps_at = [&](std::size_t size) {
        return Recording::from_memory(run.bytes.substr(0, size), "cut.mcap").info().steps;
    };
    const std::uint64_t before = steps_at(std::size_t(last.offset));
    EXPECT_GT(before, 0u);
    for (std::size_t size = std::size_t(last.offset); size < run.bytes.size(); ++size) {
        const Recording cut = Recording::from_memory(run.bytes.substr(0, size), "cut.mcap");
        EXPECT_TRUE(cut.info().is_cut_off);
        EXPECT_EQ(cut.info().source, "random changes");
        ASSERT_EQ(cut.info().steps, size < last.offset + last.size ? before : run.hashes.size() - 1) << size;
        if (size % 499 != 0) continue;
        Replay replay(cut);
        std::uint64_t last = 0; // hash after a step, which changes may follow
        while (replay.step()) last = replay.world().state_hash();
        EXPECT_FALSE(replay.divergence());
        EXPECT_EQ(last, run.hashes[std::size_t(replay.steps())]);
    }
}

TEST(DamagedRecording, ThatIsCutAnywhereOpensOrSaysThatItIsNone) {
    const RecordedRun run = record_changes(8, 300);
    std::uint64_t steps = 0;
    for (std::size_t size = 0; size < run.bytes.size(); size += 7) {
        if (size < recording::mcap_magic.size()) {
            EXPECT_THROW(Recording::from_memory(run.bytes.substr(0, size), "cut.mcap"), Error);
            continue;
        }
        const Recording cut = Recording::from_memory(run.bytes.substr(0, size), "cut.mcap");
        EXPECT_GE(cut.info().steps, steps);
        steps = cut.info().steps;
    }
    EXPECT_EQ(steps, run.hashes.size() - 1);
}

TEST(DamagedRecording, WithAnyByteChangedIsRefusedOrReplaysAsItWas) {
    const RecordedRun run = record_changes(10, 120);
    std::size_t refused = 0, same = 0;
    std::mt19937 random(3);
    for (int round = 0; round < 600; ++round) {
        std::string bytes = run.bytes;
        const std::size_t at = random() % bytes.size();
        bytes[at] = char(bytes[at] ^ (1 << (random() % 8)));
        try {
            const Recording recording = Recording::from_memory(bytes, "damaged.mcap");
            if (recording.info().is_cut_off) continue; // its end is damaged: the complete part is read
            Replay replay(recording);
            while (replay.step()) {}
            replay.seek(recording.info().steps / 2);
            EXPECT_FALSE(replay.divergence()) << "byte " << at;
            EXPECT_EQ(replay.world().state_hash(), run.hashes[std::size_t(replay.steps())]) << "byte " << at;
            ++same;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("damaged.mcap"), std::string::npos) << error.what();
            ++refused;
        }
    }
    EXPECT_GT(refused, 100u);
    EXPECT_GT(same, 100u); // in descriptions, message indexes, times
}

TEST(DamagedRecording, ThatClaimsMoreThanItHasTakesNoMemory) {
    std::string bytes(recording::mcap_magic), content, record;
    recording::RecordWriter channel(content);
    channel.number(std::uint16_t{0}).number(std::uint16_t{0}).text(recording::topic_log).text("cairn1").text("");
    append_record(bytes, recording::Opcode::channel, content);
    content.clear();
    recording::RecordWriter(content)
        .number(std::uint64_t{0})
        .number(std::uint64_t{0})
        .number(std::uint64_t{1} << 30) // uncompressed size
        .number(std::uint32_t{0})
        .text("zstd")
        .number(std::uint64_t{8});
    content += "12345678";
    append_record(bytes, recording::Opcode::chunk, content);
    try {
        Recording::from_memory(bytes, "bomb.mcap");
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_file);
        EXPECT_NE(std::string(error.what()).find("bomb.mcap: chunk at byte "), std::string::npos) << error.what();
    }
    EXPECT_THROW(Recording(std::filesystem::path("/dev/zero")), Error);
    EXPECT_THROW(Recording(std::filesystem::path(testing::TempDir())), Error);
    EXPECT_THROW(Recording::from_memory("", "empty.mcap"), Error);
}

} // namespace
} // namespace cairn::test
