// Readings: the visible state of a world after its steps, as messages for programs that know nothing of Cairn.
#pragma once

#include "recording/foxglove.h"
#include "recording/mcap_writer.h"
#include "recording/recorder.h"

#include <cairn/world.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cairn::recording {

class ReadingsWriter {
  public:
    // Adds the schemas and channels of the readings to the file.
    ReadingsWriter(McapWriter& file, const Readings& which, double interval);
    // To be called after each step, of length `step_length` in s; `time`: s since the beginning of the recording.
    void add(McapWriter::Chunk& chunk, const World& world, double time, double step_length);
    // To be called when the appearance of a body has changed: the next call of `add` sends the whole scene again.
    void forget_looks() { shapes_.clear(); }

  private:
    struct Channel {
        std::uint16_t id = 0;
        std::uint32_t sent = 0;
    };
    void send(McapWriter::Chunk& chunk, std::optional<Channel>& channel, const ProtoWriter& message);
    bool is_due(const World& world, double time);
    void find_frames(const World& world);
    ProtoWriter scene(const World& world) const;
    ProtoWriter poses(const World& world);
    ProtoWriter contacts(const World& world, double step_length) const;
    ProtoWriter statistics(const World& world) const;
    ProtoWriter joints(const World& world) const;
    ProtoWriter loads(const World& world) const;
    void add_events(McapWriter::Chunk& chunk, const World& world);
    void log(McapWriter::Chunk& chunk, const std::string& text, bool is_warning = false);
    std::string frame_of(BodyId body) const;

    double interval_, next_time_ = 0.0, whole_time_ = 0.0;
    std::uint64_t now_ = 0; // current time, ns
    std::optional<Channel> poses_, scene_, contacts_, joints_, loads_, statistics_, events_;
    bool is_whole_ = true; // whether the poses of all bodies are due, rather than only of those that moved
    std::map<BodyId, std::string> frames_;
    std::map<BodyId, Transform> sent_;
    std::vector<ShapeId> shapes_; // of the enabled bodies in `frames_`
};

} // namespace cairn::recording
