// Ranks that are threads of one process, so that tests of one world on many ranks need no MPI.
#pragma once

#include <cairn/communicator.h>

#include <condition_variable>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <queue>
#include <utility>
#include <vector>

namespace cairn_test {

// The mailbox through which ranks exchange messages.
class Post {
  public:
    explicit Post(int size) : size(size) {}
    void send(int from, int to, std::span<const std::byte> bytes) {
        const std::lock_guard lock(mutex_);
        letters_[{from, to}].emplace(bytes.begin(), bytes.end());
        arrived_.notify_all();
    }
    std::vector<std::byte> receive(int from, int to) {
        std::unique_lock lock(mutex_);
        auto& letters = letters_[{from, to}];
        arrived_.wait(lock, [&] { return !letters.empty(); });
        std::vector<std::byte> letter = std::move(letters.front());
        letters.pop();
        return letter;
    }
    const int size;

  private:
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::map<std::pair<int, int>, std::queue<std::vector<std::byte>>> letters_;
};

class LocalRank final : public cairn::Communicator {
  public:
    LocalRank(std::shared_ptr<Post> post, int rank) : post_(std::move(post)), rank_(rank) {}
    int rank() const override { return rank_; }
    int size() const override { return post_->size; }
    void exchange(std::span<const Outgoing> out, std::span<const Incoming> in) override {
        ++exchanges;
        for (const Outgoing& message : out) post_->send(rank_, message.rank, message.bytes);
        for (const Incoming& message : in) take(message.rank, message.bytes);
    }
    void broadcast(int root, std::span<std::byte> bytes) override {
        ++broadcasts;
        for (int other = 0; other < size() && root == rank_; ++other)
            if (other != rank_) post_->send(rank_, other, bytes);
        if (root == rank_) bytes_sent += bytes.size();
        if (root != rank_) take(root, bytes);
    }
    std::uint64_t sum(std::uint64_t number) override {
        std::uint64_t all = number;
        for (int other = 0; other < size(); ++other)
            if (other != rank_) post_->send(rank_, other, std::as_bytes(std::span(&number, 1)));
        for (int other = 0; other < size(); ++other) {
            std::uint64_t theirs = 0;
            if (other != rank_) take(other, std::as_writable_bytes(std::span(&theirs, 1)));
            all += theirs;
        }
        return all;
    }
    int exchanges = 0, broadcasts = 0;
    std::size_t bytes_sent = 0; // sent to all others

  private:
    // A message of unexpected size shows that the ranks have diverged.
    void take(int from, std::span<std::byte> bytes) {
        const std::vector<std::byte> letter = post_->receive(from, rank_);
        if (letter.size() != bytes.size()) std::abort();
        if (!letter.empty()) std::memcpy(bytes.data(), letter.data(), letter.size());
    }

    std::shared_ptr<Post> post_;
    int rank_;
};

} // namespace cairn_test
