// Sequences of API calls, encoded as bytes, on three worlds: one with a single thread, one with several, and one that
// is saved and restored repeatedly. All three must stay identical bit by bit, and satisfy the conditions that hold in
// every world.
#pragma once

#include "bytes.h"

#include <string>
#include <vector>

namespace cairn_fuzz {

using namespace cairn;

class Calls {
  public:
    // At most `max_steps` steps are made, even if the bytes request more.
    explicit Calls(std::span<const std::uint8_t> bytes, std::uint64_t max_steps = 400);

    // Runs until the bytes are used up. Throws std::logic_error if a condition is violated.
    void run();
    std::uint64_t steps() const { return worlds_[0].step_count(); }

  private:
    static constexpr std::size_t single = 0, threaded = 1, restored = 2;

    // Calls f(world) for each world; all must return the same, and reject the same calls.
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
    struct Before { // state before a step
        double energy, depth;
        bool has_joints; // joints may break in the step
    };
    void check_step(const Before& before, float dt);

    Bytes bytes_;
    std::uint64_t max_steps_;
    std::vector<World> worlds_;
    BodyId ground_;
    std::vector<BodyId> bodies_, dead_;
    std::vector<ForceFieldId> fields_;
    double pushed_ = 0;   // sum of the forces since the last step, N
    bool placed_ = false; // whether a body was placed since then, where it may overlap others
};

} // namespace cairn_fuzz
