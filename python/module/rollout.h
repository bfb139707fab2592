// Rollouts: many worlds from one snapshot, each with its own parameters, on many threads. This part is independent of
// Python.
#pragma once

#include <cairn/cairn.h>

#include <cstddef>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace cairn::python {

// The object of a parameter: the world, a body, a shape or a joint.
using Target = std::variant<std::monostate, BodyId, ShapeId, JointId>;

// A parameter: `numbers` doubles for each world, or for each step of each world.
struct Parameter {
    Target target;
    std::string name;
    std::size_t numbers = 1;
    bool of_steps = false;
    const double* values = nullptr; // worlds x [steps x] numbers
};

// A recorded quantity, with a number of values per body or per world.
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
    std::size_t worlds = 0, steps = 0, every = 1; // a frame is recorded after every `every` steps
    float dt = 0;
    int threads = 1;
    std::function<bool()> goes_on; // called regularly on the calling thread; false ends the rollout
};

// The number of values of the parameter with that name; throws Error (invalid_value) if the target has no such
// parameter.
std::size_t numbers_of(const Target& target, const std::string& name);

// Runs the rollout. Throws the error of the failing world with the lowest index; its field then begins with that index.
void run(const RolloutPlan& plan);

} // namespace cairn::python
