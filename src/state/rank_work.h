// Working memory of a step that several ranks make together (solver/rank_cut.h).
#pragma once

#include <cairn/communicator.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

// What one rank solves: bodies that are touched, and contacts.
struct RankPart {
    std::vector<std::int32_t> bodies;
    std::vector<std::uint32_t> contacts;
};

// Who solves which batch: a rank, or one of these.
inline constexpr std::int32_t every_rank = -1;  // each for itself
inline constexpr std::int32_t cut_by_body = -2; // together: each has the bodies that are its own

struct RankCut {
    int rank = 0, size = 1;
    std::vector<std::int32_t> owner_of_batch;
    std::vector<std::int32_t> owner;       // by body, of batches that are cut
    std::vector<RankPart> parts;           // by rank
    std::vector<std::int32_t> free_bodies; // of batches that are shared out, those that nothing touches
    std::vector<std::uint64_t> keys;       // along the curve
    std::vector<double> weights;           // of batches
};

// A body that a rank other than its own needs as well, for a contact that it solves.
struct Ghost {
    std::int32_t body, rank;
};

// What two ranks tell each other after the contacts of a color: rows in RankBorder::sent and ::received.
struct BorderMessage {
    std::int32_t color, rank;
    std::int32_t first_sent, sent, first_received, received;
};

// Where a batch that is cut meets the other ranks' parts of it.
struct RankBorder {
    const RankCut* cut = nullptr;
    std::vector<Ghost> ghosts;                // of all ranks, by body, then by rank
    std::vector<std::uint8_t> is_shared;      // by body: it is somebody's ghost
    std::vector<BorderMessage> messages;      // by color, then by rank
    std::vector<std::int32_t> first_message;  // by color; one more: the end
    std::vector<std::int32_t> sent, received; // bodies, then their rows
    std::vector<std::byte> outgoing, incoming;
    std::vector<Communicator::Outgoing> out;
    std::vector<Communicator::Incoming> in;
};

} // namespace cairn
