#include "module/rollout.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>

namespace cairn::python {

namespace {

Vec3 vector(const double* n) { return {float(n[0]), float(n[1]), float(n[2])}; }

// A parameter of bodies, shapes, joints or the world: its name, the number of values, and its effect.
template <class F> struct Row {
    const char* name;
    std::size_t numbers;
    F apply;
};

using OfWorld = Row<void (*)(WorldDef&, const double*)>;
constexpr OfWorld of_world[] = {
    {"gravity", 3, [](WorldDef& d, const double* n) { d.gravity = vector(n); }},
    {"substeps", 1, [](WorldDef& d, const double* n) { d.substeps = int(n[0]); }},
    {"restitution_speed", 1, [](WorldDef& d, const double* n) { d.restitution_speed = float(n[0]); }},
    {"recovery_speed", 1, [](WorldDef& d, const double* n) { d.recovery_speed = float(n[0]); }},
};

using OfBody = Row<void (*)(Body&, const double*)>;
constexpr OfBody of_body[] = {
    {"position", 3,
     [](Body& b, const double* n) {
         b.set_position({n[0], n[1], n[2]});
     }},
    {"rotation", 4,
     [](Body& b, const double* n) { b.set_rotation(Quat(float(n[3]), float(n[0]), float(n[1]), float(n[2]))); }},
    {"linear_velocity", 3, [](Body& b, const double* n) { b.set_linear_velocity(vector(n)); }},
    {"angular_velocity", 3, [](Body& b, const double* n) { b.set_angular_velocity(vector(n)); }},
    {"mass", 1, [](Body& b, const double* n) { b.set_mass_from_shapes(float(n[0])); }},
    {"gravity_scale", 1, [](Body& b, const double* n) { b.set_gravity_scale(float(n[0])); }},
    {"linear_damping", 1, [](Body& b, const double* n) { b.set_damping(float(n[0]), b.angular_damping()); }},
    {"angular_damping", 1, [](Body& b, const double* n) { b.set_damping(b.linear_damping(), float(n[0])); }},
    {"force", 3, [](Body& b, const double* n) { b.add_force(vector(n)); }},
    {"torque", 3, [](Body& b, const double* n) { b.add_torque(vector(n)); }},
};

using OfShape = Row<void (*)(Material&, const double*)>;
constexpr OfShape of_shape[] = {
    {"friction", 1, [](Material& m, const double* n) { m.static_friction = m.dynamic_friction = float(n[0]); }},
    {"static_friction", 1, [](Material& m, const double* n) { m.static_friction = float(n[0]); }},
    {"dynamic_friction", 1, [](Material& m, const double* n) { m.dynamic_friction = float(n[0]); }},
    {"restitution", 1, [](Material& m, const double* n) { m.restitution = float(n[0]); }},
    {"rolling_friction", 1, [](Material& m, const double* n) { m.rolling_friction = float(n[0]); }},
    {"torsional_friction", 1, [](Material& m, const double* n) { m.torsional_friction = float(n[0]); }},
};

using OfJoint = Row<void (*)(JointMotor&, const double*)>;
constexpr OfJoint of_joint[] = {
    {"motor_velocity", 1, [](JointMotor& m, const double* n) { m.velocity = float(n[0]); }},
    {"motor_position", 1, [](JointMotor& m, const double* n) { m.position = float(n[0]); }},
    {"motor_max_force", 1, [](JointMotor& m, const double* n) { m.max_force = float(n[0]); }},
};

template <class Rows> auto& row_of(const Rows& rows, const std::string& name) {
    std::string names;
    for (const auto& row : rows) {
        if (name == row.name) return row;
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    throw Error(ErrorCode::invalid_value, "parameter", name, "must be one of " + names);
}

// The control of a joint with a single axis.
JointControl& control_of(Joint& joint) {
    if (HingeJoint* hinge = std::get_if<HingeJoint>(&joint)) return hinge->angle;
    if (SliderJoint* slider = std::get_if<SliderJoint>(&joint)) return slider->translation;
    if (DistanceJoint* distance = std::get_if<DistanceJoint>(&joint)) return distance->distance;
    throw Error(ErrorCode::invalid_value, "parameter", "a joint of another kind",
                "motors must be those of hinges, sliders or distances");
}

struct Apply {
    World& world;
    const std::string& name;
    const double* values;

    void operator()(std::monostate) const {
        WorldDef settings = world.settings();
        row_of(of_world, name).apply(settings, values);
        world.set_settings(settings);
    }
    void operator()(BodyId id) const {
        Body body = world.body(id);
        row_of(of_body, name).apply(body, values);
    }
    void operator()(ShapeId id) const {
        Material material = world.shape_def(id).material;
        row_of(of_shape, name).apply(material, values);
        world.set_material(id, material);
    }
    void operator()(JointId id) const {
        Joint joint = world.joint_def(id).joint;
        JointControl& control = control_of(joint);
        if (!control.motor) control.motor.emplace();
        row_of(of_joint, name).apply(*control.motor, values);
        world.set_joint(id, joint);
    }
};

// The threads take worlds one at a time, so that none waits for another; results do not depend on which thread takes a
// world.
class Run {
  public:
    explicit Run(const RolloutPlan& plan) : plan_(plan), frames_(plan.steps / plan.every) {}

    void work() {
        World world;
        std::vector<Transform> poses(plan_.bodies.size());
        for (std::size_t i = next_++; i < plan_.worlds && !stop_; i = next_++) try {
                one(world, poses, i);
            } catch (const Error& error) {
                const std::string what = error.what();
                fail(i, std::make_exception_ptr(Error(error.code(), "world " + std::to_string(i) + ": " + error.field(),
                                                      error.value(), expected_of(error))));
            } catch (...) {
                fail(i, std::current_exception());
            }
        ++finished_;
    }
    void stop() { stop_ = true; }
    int finished() const { return finished_; }
    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

  private:
    // The expected part of an error message of the form "field: expected, got value".
    static std::string expected_of(const Error& error) {
        std::string text = std::string(error.what()).substr(error.field().size() + 2);
        const std::string end = ", got " + error.value();
        if (!error.value().empty() && text.ends_with(end)) text.resize(text.size() - end.size());
        return text;
    }

    // After an error later worlds need not be run; earlier ones are still run, as they may fail too.
    void fail(std::size_t world, std::exception_ptr error) {
        const std::lock_guard lock(mutex_);
        if (error_ && world > failed_) return;
        error_ = std::move(error);
        failed_ = world;
        stop_ = true;
    }

    void one(World& world, std::vector<Transform>& poses, std::size_t i) {
        world.restore(*plan_.start);
        for (const Parameter& p : plan_.parameters)
            if (!p.of_steps) std::visit(Apply{world, p.name, p.values + i * p.numbers}, p.target);
        for (std::size_t step = 0; step < plan_.steps; ++step) {
            if (stop_ && step % 64 == 0) return;
            for (const Parameter& p : plan_.parameters)
                if (p.of_steps)
                    std::visit(Apply{world, p.name, p.values + (i * plan_.steps + step) * p.numbers}, p.target);
            world.step(plan_.dt);
            if ((step + 1) % plan_.every == 0) record(world, poses, i * frames_ + step / plan_.every);
        }
    }

    void record(const World& world, std::vector<Transform>& poses, std::size_t frame) {
        const std::size_t n = plan_.bodies.size(), first = frame * n;
        if (needs_poses()) world.read_transforms(plan_.bodies, poses);
        for (const Output& output : plan_.outputs) {
            double* const numbers = static_cast<double*>(output.values);
            float* const floats = static_cast<float*>(output.values);
            if (output.what == Record::kinetic_energy) numbers[frame] = world.kinetic_energy();
            if (output.what == Record::potential_energy) numbers[frame] = world.potential_energy();
            if (output.what == Record::state_hash)
                static_cast<std::uint64_t*>(output.values)[frame] = world.state_hash();
            if (output.what > Record::angular_velocities) continue;
            for (std::size_t b = 0; b < n; ++b) {
                if (output.what == Record::positions) {
                    std::memcpy(numbers + 3 * (first + b), &poses[b].position, 3 * sizeof(double));
                } else if (output.what == Record::rotations) {
                    const Quat& q = poses[b].rotation;
                    const float r[4] = {q.x, q.y, q.z, q.w};
                    std::memcpy(floats + 4 * (first + b), r, sizeof r);
                } else {
                    const Body body = world.body(plan_.bodies[b]);
                    const Vec3 v = output.what == Record::velocities ? body.linear_velocity() : body.angular_velocity();
                    std::memcpy(floats + 3 * (first + b), &v.x, sizeof v);
                }
            }
        }
    }
    bool needs_poses() const {
        return std::any_of(plan_.outputs.begin(), plan_.outputs.end(), [](const Output& output) {
            return output.what == Record::positions || output.what == Record::rotations;
        });
    }

    const RolloutPlan& plan_;
    std::size_t frames_;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> stop_{false};
    std::atomic<int> finished_{0};
    std::mutex mutex_;
    std::exception_ptr error_;
    std::size_t failed_ = 0;
};

} // namespace

std::size_t numbers_of(const Target& target, const std::string& name) {
    switch (target.index()) {
    case 0:
        return row_of(of_world, name).numbers;
    case 1:
        return row_of(of_body, name).numbers;
    case 2:
        return row_of(of_shape, name).numbers;
    default:
        return row_of(of_joint, name).numbers;
    }
}

void run(const RolloutPlan& plan) {
    Run all(plan);
    std::vector<std::jthread> threads;
    for (int i = 0; i < plan.threads; ++i) threads.emplace_back([&] { all.work(); });
    // This thread only polls whether the rollout is to continue.
    while (all.finished() < plan.threads) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (!plan.goes_on()) all.stop();
    }
    threads.clear(); // joined
    all.rethrow();
}

} // namespace cairn::python
