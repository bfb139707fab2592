// When the system could not create the requested threads, the world was lost: every later call was refused as if memory
// had run out.
#include <cairn/cairn.h>

#include <gtest/gtest.h>

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CAIRN_SANITIZED // reserves more address space than the limit below
#endif
#endif
#ifndef CAIRN_SANITIZED
#include <sys/resource.h>

#include <cstdint>
#include <cstdlib>

namespace {

// Exit status 0 if the world stays as it was. Runs in a process whose address space is too small for 256 stacks.
int set_too_many_threads() {
    cairn::World world;
    world.create_body({.position = {0, 5, 0}});
    const std::uint64_t before = world.state_hash();
    const rlimit few = {1u << 28, 1u << 28}; // address space, bytes
    if (setrlimit(RLIMIT_AS, &few) != 0) return 2;
    try {
        world.set_threads(256);
        return 3;
    } catch (const cairn::Error& error) {
        if (error.code() != cairn::ErrorCode::unsupported) return 4;
    }
    if (world.threads() != 1 || world.state_hash() != before) return 5;
    world.step(1.0f / 60.0f);
    return world.step_count() == 1 ? 0 : 6;
}

TEST(ThreadsRefused, LeaveTheWorldAsItWas) {
    EXPECT_EXIT(std::_Exit(set_too_many_threads()), testing::ExitedWithCode(0), "");
}

} // namespace
#endif
#endif
