#include "rank_courses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <thread>

namespace cairn_test {

using namespace cairn;

namespace {

class Sum {
  public:
    template <class T> void add(const T& value) {
        unsigned char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        for (const unsigned char byte : bytes) sum_ = (sum_ ^ byte) * 1099511628211u;
    }
    template <class Event> void add_pair(const Event& e) {
        for (const std::uint64_t bits : {e.shape_a.bits, e.shape_b.bits, e.body_a.bits, e.body_b.bits})
            add(bits & ~(std::uint64_t{0xffff} << 48)); // without the number of the world
    }
    void add_point(const Position& p) { add(p.x), add(p.y), add(p.z); }
    void add_vector(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
    std::uint64_t value() const { return sum_; }

  private:
    std::uint64_t sum_ = 14695981039346656037u;
};

std::uint64_t report_of(const World& world, bool with_contacts) {
    Sum sum;
    for (const ContactBegin& e : world.contact_begins()) sum.add_pair(e);
    for (const ContactEnd& e : world.contact_ends()) sum.add_pair(e);
    for (const ContactHit& e : world.contact_hits()) {
        sum.add_pair(e), sum.add_point(e.point), sum.add_vector(e.normal);
        sum.add(e.approach_speed), sum.add(e.time);
    }
    for (const TriggerEvent& e : world.trigger_events()) sum.add(e.other.index()), sum.add(e.inside);
    for (const SleepEvent& e : world.sleep_events()) sum.add(e.body.index()), sum.add(e.asleep);
    if (!with_contacts) return sum.value();
    for (const Contact& c : world.contacts()) {
        sum.add_pair(c), sum.add_vector(c.normal), sum.add_vector(c.friction_impulse);
        for (int i = 0; i < c.point_count; ++i)
            sum.add_point(c.points[i].point), sum.add(c.points[i].separation), sum.add(c.points[i].normal_impulse);
    }
    return sum.value();
}

} // namespace

Course run_alone(Scene& scene, World& world, int steps, int asked_every) {
    Course course;
    for (int i = 0; i < steps; ++i) {
        scene.step(world);
        course.hashes.push_back(world.state_hash());
        course.reports.push_back(report_of(world, asked_every > 0 && i % asked_every == 0));
        const Statistics now = world.statistics();
        course.overflow_contacts = std::max(course.overflow_contacts, now.overflow_contacts);
        course.clamped_speeds = now.clamped_speeds;
        course.hits += world.contact_hits().size();
    }
    course.end = world.save();
    return course;
}

std::vector<Course> run_on_ranks(Scene& scene, const Snapshot& start, int ranks, int steps, int threads,
                                 int asked_every) {
    std::vector<Course> courses(std::size_t(ranks), Course{});
    const auto post = std::make_shared<Post>(ranks);
    std::vector<std::thread> all;
    for (int rank = 0; rank < ranks; ++rank)
        all.emplace_back([&, rank] {
            World world;
            world.set_threads(threads);
            const auto communicator = std::make_shared<LocalRank>(post, rank);
            world.set_communicator(communicator);
            world.restore(start); // the communicator outlives the restore
            Course& course = courses[std::size_t(rank)] = run_alone(scene, world, steps, asked_every);
            course.exchanges = communicator->exchanges;
            world.step(1.0f / 60);
            const std::size_t before = communicator->bytes_sent;
            static_cast<void>(world.save());
            course.bytes_of_end = communicator->bytes_sent - before;
        });
    for (std::thread& thread : all) thread.join();
    return courses;
}

void expect_same(const Course& one, const Course& other, const std::string& who) {
    for (std::size_t i = 0; i < one.hashes.size(); ++i) {
        ASSERT_EQ(other.hashes[i], one.hashes[i]) << who << ", step " << i;
        ASSERT_EQ(other.reports[i], one.reports[i]) << who << ", events and contacts of step " << i;
    }
    EXPECT_TRUE(other.end.bytes == one.end.bytes) << who << ": another snapshot";
    EXPECT_EQ(other.clamped_speeds, one.clamped_speeds) << who;
}

} // namespace cairn_test
