// The MPI part of the program: C functions that the program looks up by name (cli/ranks.cpp). They are never called
// concurrently.
#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <vector>

namespace {

MPI_Win window = MPI_WIN_NULL; // of the counter in the memory of rank 0

std::int64_t count_on(MPI_Op operation) {
    const std::int64_t one = 1;
    std::int64_t before = 0;
    MPI_Fetch_and_op(&one, &before, MPI_INT64_T, 0, 0, operation, window);
    MPI_Win_flush(0, window);
    return before;
}

// Splits a message into pieces, because MPI counts in int. Calls piece(bytes, count) for each piece.
template <class Byte, class F> void in_pieces(Byte* bytes, std::size_t count, const F& piece) {
    constexpr std::size_t most = std::size_t{1} << 30;
    do {
        const std::size_t now = std::min(count, most);
        piece(bytes, static_cast<int>(now));
        bytes += now, count -= now;
    } while (count > 0);
}

} // namespace

#define CAIRN_RANKS extern "C" __attribute__((visibility("default")))

CAIRN_RANKS void cairn_ranks_begin(int* rank, int* size) {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, rank);
    MPI_Comm_size(MPI_COMM_WORLD, size);
    std::int64_t* counter = nullptr;
    MPI_Win_allocate(*rank == 0 ? sizeof(std::int64_t) : 0, sizeof(std::int64_t), MPI_INFO_NULL, MPI_COMM_WORLD,
                     &counter, &window);
    if (*rank == 0) *counter = 0;
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(MPI_MODE_NOCHECK, window);
}

// Increments the counter shared by all ranks, and returns its previous value.
CAIRN_RANKS std::int64_t cairn_ranks_next() { return count_on(MPI_SUM); }

// Present value of the counter. The call also lets MPI progress, so that other ranks can access the counter.
CAIRN_RANKS std::int64_t cairn_ranks_taken() { return count_on(MPI_NO_OP); }

// A barrier that mostly sleeps, because other ranks may need the processor.
CAIRN_RANKS void cairn_ranks_meet() {
    MPI_Request request;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    for (int is_done = 0; MPI_Test(&request, &is_done, MPI_STATUS_IGNORE), is_done == 0;) {
        const timespec pause{0, 2'000'000};
        nanosleep(&pause, nullptr);
    }
}

// A message to or from another rank.
struct cairn_ranks_message {
    int rank;
    std::byte* bytes;
    std::size_t size;
};

// Sends the first `sent` messages and receives the others.
CAIRN_RANKS void cairn_ranks_exchange(const cairn_ranks_message* messages, int sent, int count) {
    static std::vector<MPI_Request> requests;
    requests.clear();
    for (int i = count - 1; i >= 0; --i) { // receives are posted first, so that incoming data has a buffer
        const cairn_ranks_message& m = messages[i];
        in_pieces(m.bytes, m.size, [&](std::byte* bytes, int size) {
            MPI_Request& request = requests.emplace_back();
            if (i < sent)
                MPI_Isend(bytes, size, MPI_BYTE, m.rank, 0, MPI_COMM_WORLD, &request);
            else
                MPI_Irecv(bytes, size, MPI_BYTE, m.rank, 0, MPI_COMM_WORLD, &request);
        });
    }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

CAIRN_RANKS void cairn_ranks_broadcast(int root, std::byte* bytes, std::size_t size) {
    in_pieces(bytes, size, [&](std::byte* at, int count) { MPI_Bcast(at, count, MPI_BYTE, root, MPI_COMM_WORLD); });
}

CAIRN_RANKS std::uint64_t cairn_ranks_sum(std::uint64_t number) {
    std::uint64_t sum = 0;
    MPI_Allreduce(&number, &sum, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    return sum;
}

CAIRN_RANKS void cairn_ranks_end() {
    MPI_Win_unlock_all(window);
    MPI_Win_free(&window);
    MPI_Finalize();
}

// Ends all ranks.
CAIRN_RANKS void cairn_ranks_abort(int code) { MPI_Abort(MPI_COMM_WORLD, code); }
