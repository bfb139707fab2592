// What a world shows after its steps, as messages for programs that know nothing of Cairn.
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
    // Adds its schemas and channels to the file.
    ReadingsWriter(McapWriter& file, const Readings& which, double interval);
    // To be called after each step, of that length; `time`: s since the recording began.
    void add(McapWriter::Chunk& chunk, const World& world, double time, double step_length);
    // Something is not what it was sent as: the next call of `add` sends all of it.
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
    std::uint64_t now_ = 0; // ns
    std::optional<Channel> poses_, scene_, contacts_, joints_, loads_, statistics_, events_;
    bool is_whole_ = true; // the poses of all bodies are due, not of those alone that moved
    std::map<BodyId, std::string> frames_;
    std::map<BodyId, Transform> sent_;
    std::vector<ShapeId> shapes_; // of the bodies in `frames_`, but for those that are disabled
};

} // namespace cairn::recording
