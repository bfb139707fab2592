// Many worlds from one, each with parameters of its own, on many threads. Nothing here knows Python.
#pragma once

#include <cairn/cairn.h>

#include <cstddef>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace cairn::python {

// What a parameter acts on: the world, a body, a shape or a joint.
using Target = std::variant<std::monostate, BodyId, ShapeId, JointId>;

// A parameter: `numbers` doubles for each world, or for each step of each world.
struct Parameter {
    Target target;
    std::string name;
    std::size_t numbers = 1;
    bool of_steps = false;
    const double* values = nullptr; // worlds x [steps x] numbers
};

// What is recorded: so many doubles a body, or a world.
enum class Record {
    positions,
    rotations,
    velocities,
    angular_velocities,
    kinetic_energy,
    potential_energy,
    state_hash
};

struct Output {
    Record what;
    void* values; // worlds x frames x [bodies x numbers]: doubles, floats or 64-bit numbers
};

struct RolloutPlan {
    const Snapshot* start = nullptr;
    std::vector<BodyId> bodies; // of the snapshot, in order of slot index
    std::vector<Parameter> parameters;
    std::vector<Output> outputs;
    std::size_t worlds = 0, steps = 0, every = 1; // a frame after every so many steps
    float dt = 0;
    int threads = 1;
    std::function<bool()> goes_on; // asked now and then on the calling thread; false: end
};

// How many numbers a parameter of that name has; throws Error (invalid_value) if there is none for such a target.
std::size_t numbers_of(const Target& target, const std::string& name);

// Runs all of it. Throws the error of the world with the least number, whose field then begins with that number.
void run(const RolloutPlan& plan);

} // namespace cairn::python
