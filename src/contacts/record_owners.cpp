#include "contacts/record_owners.h"

#include <cstring>
#include <span>

namespace cairn {

namespace {

// Contacts whose records are sent to, or received from, each rank.
using Lists = std::vector<std::vector<std::uint32_t>>;

// Lists the records that this rank sends and receives, ordered by contact, so that sender and receiver agree.
void list_moves(const Contacts& contacts, const std::vector<std::int32_t>& owners, int rank, Lists& sent,
                Lists& received) {
    for (std::uint32_t id = 0; id < contacts.info.size(); ++id) {
        const ContactInfo& c = contacts.info[id];
        if (!c.in_use) continue;
        const std::int32_t from = contacts.owners[c.body_a], to = owners[std::size_t(c.body_a)];
        if (from == to || from == every_rank) continue;
        if (from != rank) {
            if (to == rank || to == every_rank) received[std::size_t(from)].push_back(id);
            continue;
        }
        for (std::size_t other = 0; other < sent.size(); ++other)
            if (int(other) != rank && (to == every_rank || int(other) == to)) sent[other].push_back(id);
    }
}

using Bytes = std::vector<std::vector<std::byte>>; // by rank

std::size_t bytes_of(const std::vector<std::uint32_t>& ids) { return ids.size() * sizeof(ContactRecord); }

void exchange_records(const Contacts& contacts, const Lists& sent, const Lists& received, Communicator& ranks,
                      Bytes& arrived) {
    Bytes leaving(sent.size());
    std::vector<Communicator::Outgoing> out;
    std::vector<Communicator::Incoming> in;
    for (std::size_t other = 0; other < sent.size(); ++other) {
        if (!sent[other].empty()) {
            leaving[other].resize(bytes_of(sent[other]));
            std::byte* at = leaving[other].data();
            for (const std::uint32_t id : sent[other]) {
                std::memcpy(at, &contacts.records[id], sizeof(ContactRecord));
                at += sizeof(ContactRecord);
            }
            out.push_back({int(other), leaving[other]});
        }
        if (!received[other].empty()) {
            arrived[other].resize(bytes_of(received[other]));
            in.push_back({int(other), arrived[other]});
        }
    }
    if (!out.empty() || !in.empty()) ranks.exchange(out, in);
}

} // namespace

math::Vec3 normal_of(const Contacts& contacts, std::uint32_t contact, Communicator* ranks) {
    const bool is_here = contacts.records.has(contact);
    math::Vec3 normal = is_here ? math::to_vec(contacts.records[contact].normal) : math::Vec3{};
    if (!ranks) return normal;
    const std::int32_t owner = owner_of(contacts, contact);
    if (owner != every_rank) ranks->broadcast(owner, std::as_writable_bytes(std::span(&normal, 1)));
    return normal;
}

void find_normals(const Contacts& contacts, std::vector<ContactNormal>& list, Communicator* ranks) {
    for (ContactNormal& c : list)
        if (contacts.records.has(c.contact)) c.normal = math::to_vec(contacts.records[c.contact].normal);
    if (ranks) exchange_of_owners(list, *ranks, [&](const ContactNormal& c) { return owner_of(contacts, c.contact); });
}

void change_owners(Contacts& contacts, const std::vector<std::int32_t>& owners, Communicator& ranks) {
    if (!contacts.records.is_whole()) {
        const auto size = std::size_t(ranks.size());
        Lists sent(size), received(size);
        Bytes arrived(size);
        list_moves(contacts, owners, ranks.rank(), sent, received);
        exchange_records(contacts, sent, received, ranks, arrived);
        for (std::size_t from = 0; from < size; ++from) {
            const std::byte* at = arrived[from].data();
            for (const std::uint32_t id : received[from]) {
                contacts.records.open(id, true);
                std::memcpy(&contacts.records[id], at, sizeof(ContactRecord));
                at += sizeof(ContactRecord);
            }
        }
    }
    contacts.owners = {ranks.rank(), owners};
    leave_records_to_owners(contacts);
}

void gather_records(Contacts& contacts, Communicator& ranks) {
    if (contacts.records.is_whole()) return;
    std::vector<ContactRecord> all;
    set_size(all, contacts.info.size());
    exchange_of_owners(all, ranks, [&](ContactRecord& record) {
        const auto id = std::uint32_t(&record - all.data());
        if (!contacts.info[id].in_use) return every_rank;
        if (contacts.records.has(id)) record = contacts.records[id];
        return owner_of(contacts, id);
    });
    contacts.records.make_whole(std::move(all));
}

void leave_records_to_owners(Contacts& contacts) {
    const auto stays = [&](std::size_t id) {
        return contacts.info[id].in_use && contacts.owners.has(contacts.info[id].body_a);
    };
    if (contacts.records.is_whole()) return contacts.records.keep(contacts.info.size(), stays);
    for (std::uint32_t id = 0; id < contacts.info.size(); ++id)
        if (!stays(id)) contacts.records.drop(id);
    if (contacts.records.is_sparse()) contacts.records.keep(contacts.info.size(), stays);
}

} // namespace cairn
