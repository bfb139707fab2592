// Working memory of a step that several ranks compute together (solver/rank_cut.h).
#pragma once

#include "state/contact_records.h"

#include <cairn/communicator.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

// The part of a batch that one rank solves: bodies that have contacts, and contacts.
struct RankPart {
    std::vector<std::int32_t> bodies;
    std::vector<std::uint32_t> contacts;
};

// Owner of a batch that is cut: all ranks solve it together, each rank the contacts of the bodies that it owns.
inline constexpr std::int32_t cut_by_body = -2;

// The bodies of a batch: a range of RankCut::touching.
struct BatchBodies {
    std::int32_t first, count;
};

struct RankCut {
    int rank = 0, size = 1;
    std::vector<std::int32_t> owner_of_batch;
    std::vector<BatchBodies> bodies_of_batch;
    std::vector<std::int32_t> touching, free_bodies; // bodies of distributed batches: with and without contacts
    std::vector<std::int32_t> owner;                 // by body
    std::vector<RankPart> parts;                     // by rank
    std::vector<std::uint64_t> keys;                 // positions along the space-filling curve
    std::vector<double> weights;                     // of batches, of ranks
};

// A body that another rank than its owner needs as well, for a contact that it solves.
struct Ghost {
    std::int32_t body, rank;
};

// The rows that this rank sends to another after the contacts of a color, and those that it receives: ranges of
// RankBorder::sent and ::received.
struct BorderMessage {
    std::int32_t color, rank;
    std::int32_t first_sent, sent, first_received, received;
};

// The border between this rank's part of a cut batch and the parts of other ranks.
struct RankBorder {
    const RankCut* cut = nullptr;
    std::vector<Ghost> ghosts;                // of all ranks, by body, then by rank
    std::vector<std::uint8_t> is_shared;      // by body: some rank has it as a ghost
    std::vector<BorderMessage> messages;      // by color, then by rank
    std::vector<std::int32_t> first_message;  // by color, and the end of the last
    std::vector<std::int32_t> sent, received; // first bodies, then their rows
    std::vector<std::byte> outgoing, incoming;
    std::vector<Communicator::Outgoing> out;
    std::vector<Communicator::Incoming> in;
};

} // namespace cairn
