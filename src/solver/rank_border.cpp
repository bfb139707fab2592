// Finds the border between the parts of a batch, and exchanges body rows across it.
#include "solver/rank_border.h"

#include "solver/contact_order.h"

#include <algorithm>
#include <cstring>

namespace cairn {

namespace {

struct OrderOfGhosts {
    bool operator()(const Ghost& a, const Ghost& b) const {
        return a.body != b.body ? a.body < b.body : a.rank < b.rank;
    }
};

std::pair<std::vector<Ghost>::const_iterator, std::vector<Ghost>::const_iterator> ghosts_of(const RankBorder& border,
                                                                                            std::int32_t body) {
    const auto first = std::lower_bound(border.ghosts.begin(), border.ghosts.end(), Ghost{body, 0}, OrderOfGhosts());
    auto last = first;
    while (last != border.ghosts.end() && last->body == body) ++last;
    return {first, last};
}

void find_ghosts(const Bodies& bodies, const SortedContact* first, const SortedContact* last, RankBorder& border) {
    for (const Ghost& ghost : border.ghosts) border.is_shared[ghost.body] = 0; // marks of the last batch
    border.is_shared.resize(bodies.links.size());
    border.ghosts.clear();
    const std::int32_t* const owner = border.cut->owner.data();
    for (const SortedContact* c = first; c != last; ++c) {
        if (c->body_b == none || !bodies.is_dynamic(c->body_b) || owner[c->body_a] == owner[c->body_b]) continue;
        border.ghosts.push_back({c->body_b, owner[c->body_a]});
        border.is_shared[c->body_b] = 1;
    }
    std::sort(border.ghosts.begin(), border.ghosts.end(), OrderOfGhosts());
    const auto same = [](const Ghost& a, const Ghost& b) { return a.body == b.body && a.rank == b.rank; };
    border.ghosts.erase(std::unique(border.ghosts.begin(), border.ghosts.end(), same), border.ghosts.end());
}

// A body whose velocity goes from one rank to another after a color.
struct Entry {
    std::int32_t color, rank, body;
    bool is_sent;
};

// Lists the transfers of a body's state that involve this rank, after rank `solver` has solved a contact of the body.
void list_entries(const RankBorder& border, std::int32_t color, std::int32_t body, std::int32_t solver,
                  std::vector<Entry>& entries) {
    if (!border.is_shared[body]) return;
    const RankCut& cut = *border.cut;
    const auto tell = [&](std::int32_t holder) {
        if (holder == solver) return;
        if (solver == cut.rank) entries.push_back({color, holder, body, true});
        if (holder == cut.rank) entries.push_back({color, solver, body, false});
    };
    tell(cut.owner[body]);
    const auto [first, last] = ghosts_of(border, body);
    for (auto ghost = first; ghost != last; ++ghost) tell(ghost->rank);
}

// Merges the entries, which are sorted by color and rank, into messages.
void list_messages(const std::vector<Entry>& entries, std::int32_t colors, RankBorder& border) {
    border.messages.clear(), border.sent.clear(), border.received.clear();
    border.first_message.assign(std::size_t(colors) + 1, 0);
    for (const Entry& e : entries) {
        if (border.messages.empty() || border.messages.back().color != e.color || border.messages.back().rank != e.rank)
            border.messages.push_back(
                {e.color, e.rank, std::int32_t(border.sent.size()), 0, std::int32_t(border.received.size()), 0});
        BorderMessage& message = border.messages.back();
        (e.is_sent ? border.sent : border.received).push_back(e.body);
        ++(e.is_sent ? message.sent : message.received);
    }
    for (const BorderMessage& m : border.messages) ++border.first_message[std::size_t(m.color) + 1];
    for (std::size_t k = 1; k < border.first_message.size(); ++k)
        border.first_message[k] += border.first_message[k - 1];
}

} // namespace

void find_border(const Bodies& bodies, const IslandBatch& batch, const SolverScratch& solver, RankBorder& border) {
    border.cut = &solver.cut;
    const SortedContact* const first = solver.sorted.data() + batch.first_contact;
    const SortedContact* const last = first + batch.contact_count;
    find_ghosts(bodies, first, last, border);
    std::vector<Entry> entries;
    std::int32_t color = -1;
    std::uint32_t rank_of_color = ~0u;
    for (const SortedContact* c = first; c != last; ++c) {
        // As in fill_lanes, each overflow contact counts as a color of its own.
        if (const std::uint32_t now = c->key / keys_per_color; now == 0 || now != rank_of_color)
            ++color, rank_of_color = now;
        const std::int32_t at = border.cut->owner[c->body_a];
        list_entries(border, color, c->body_a, at, entries);
        if (c->body_b != none && bodies.is_dynamic(c->body_b)) list_entries(border, color, c->body_b, at, entries);
    }
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.color != b.color ? a.color < b.color : a.rank < b.rank;
    });
    list_messages(entries, color + 1, border);
}

bool is_needed(const RankBorder& border, std::int32_t body) {
    if (is_own(*border.cut, body)) return true;
    if (!border.is_shared[body]) return false;
    const auto [first, last] = ghosts_of(border, body);
    return std::any_of(first, last, [&](const Ghost& ghost) { return ghost.rank == border.cut->rank; });
}

void number_border_rows(RankBorder& border, const BatchScratch& scratch) {
    for (std::int32_t& row : border.sent) row = scratch.row_of_body[row];
    for (std::int32_t& row : border.received) row = scratch.row_of_body[row];
}

void exchange_border(RankBorder& border, Communicator& ranks, std::size_t color, std::span<void* const> arrays) {
    const std::size_t begin = std::size_t(border.first_message[color]);
    const std::size_t end = std::size_t(border.first_message[color + 1]);
    if (begin == end) return;
    const std::size_t size = arrays.size() * row_bytes; // bytes per body
    const BorderMessage &head = border.messages[begin], &tail = border.messages[end - 1];
    const auto sent =
        std::span(border.sent)
            .subspan(std::size_t(head.first_sent), std::size_t(tail.first_sent + tail.sent - head.first_sent));
    const auto received = std::span(border.received)
                              .subspan(std::size_t(head.first_received),
                                       std::size_t(tail.first_received + tail.received - head.first_received));
    border.outgoing.resize(sent.size() * size);
    border.incoming.resize(received.size() * size);
    border.out.clear(), border.in.clear();
    const auto part_of = [&](std::vector<std::byte>& bytes, std::int32_t first, std::int32_t count) {
        return std::span(bytes).subspan(std::size_t(first) * size, std::size_t(count) * size);
    };
    for (std::size_t k = begin; k < end; ++k) {
        const BorderMessage& m = border.messages[k];
        if (m.sent > 0)
            border.out.push_back({m.rank, part_of(border.outgoing, m.first_sent - head.first_sent, m.sent)});
        if (m.received > 0)
            border.in.push_back({m.rank, part_of(border.incoming, m.first_received - head.first_received, m.received)});
    }
    std::byte* out = border.outgoing.data();
    for (const std::int32_t row : sent)
        for (void* const array : arrays) {
            std::memcpy(out, static_cast<std::byte*>(array) + std::size_t(row) * row_bytes, row_bytes);
            out += row_bytes;
        }
    ranks.exchange(border.out, border.in);
    const std::byte* in = border.incoming.data();
    for (const std::int32_t row : received)
        for (void* const array : arrays) {
            std::memcpy(static_cast<std::byte*>(array) + std::size_t(row) * row_bytes, in, row_bytes);
            in += row_bytes;
        }
}

} // namespace cairn
