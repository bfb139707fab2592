// Sequences of calls of the API that bytes spell out, on three worlds side by side: one with a single thread, one with
// several, and one that is saved and restored again and again. All three must stay the same, bit by bit, and obey what
// holds of every world.
#pragma once

#include "bytes.h"

#include <string>
#include <vector>

namespace cairn_fuzz {

using namespace cairn;

class Calls {
  public:
    // No more steps than that are taken, however many the bytes ask for.
    explicit Calls(std::span<const std::uint8_t> bytes, std::uint64_t max_steps = 400);

    // Runs until the bytes are used up. Throws std::logic_error where something does not hold that must.
    void run();
    std::uint64_t steps() const { return worlds_[0].step_count(); }

  private:
    static constexpr std::size_t single = 0, threaded = 1, restored = 2;

    // Calls f(world) for each; all must answer alike, and refuse alike.
    template <class F> void each(F&& f);
    BodyId body();
    Body first(BodyId id) { return worlds_[single].body(id); }
    bool is(BodyId id, BodyType type) { return first(id).type() == type; }
    Shape shape();
    Shape surface();
    Joint joint();

    void call();
    void create();
    void destroy();
    void add_shape(BodyId id);
    void remove_shape();
    void move();
    void push();
    void change_body();
    void change_shape();
    void join();
    void change_joint();
    void change_fields();
    void change_settings();
    void query();
    void save_and_restore();
    void call_wrongly();
    void step();
    struct Before { // a step
        double energy, depth;
        bool has_joints; // they may break in it
    };
    void check_step(const Before& before, float dt);

    Bytes bytes_;
    std::uint64_t max_steps_;
    std::vector<World> worlds_;
    BodyId ground_;
    std::vector<BodyId> bodies_, dead_;
    std::vector<ForceFieldId> fields_;
    double pushed_ = 0;   // N: the sum of the forces since the last step
    bool placed_ = false; // whether anything was put somewhere since then, where it may overlap
};

} // namespace cairn_fuzz
