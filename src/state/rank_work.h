// Working memory of a step that several ranks make together (solver/rank_cut.h).
#pragma once

#include "state/contact_records.h"

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

// Who solves which batch: a rank, every_rank, or this: all together, each the contacts of the bodies that it owns.
inline constexpr std::int32_t cut_by_body = -2;

// The bodies of a batch, in RankCut::touching.
struct BatchBodies {
    std::int32_t first, count;
};

struct RankCut {
    int rank = 0, size = 1;
    std::vector<std::int32_t> owner_of_batch;
    std::vector<BatchBodies> bodies_of_batch;
    std::vector<std::int32_t> touching, free_bodies; // of batches that are shared out: with and without a contact
    std::vector<std::int32_t> owner;                 // by body
    std::vector<RankPart> parts;                     // by rank
    std::vector<std::uint64_t> keys;                 // along the curve
    std::vector<double> weights;                     // of batches, of ranks
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
