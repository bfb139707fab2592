#include "module/world.h"

#include <algorithm>
#include <chrono>

namespace cairn::python {

namespace {

constexpr std::size_t chunk = 256; // bodies that are read at a time
constexpr std::chrono::milliseconds between_signals{50};

template <class T> T* data_of(const py::object& array) {
    return reinterpret_cast<T*>(py::detail::array_proxy(array.ptr())->data);
}

} // namespace

World& PyWorld::use(const char* call) {
    if (closed_) throw Error(ErrorCode::wrong_state, call, "", "the world is closed");
    if (busy_)
        throw Error(ErrorCode::wrong_state, call, "", std::string("the world is in ") + busy_ + " on another thread");
    return scene_.world;
}

void PyWorld::close() {
    if (closed_) return;
    use("World.close");
    closed_ = true;
    retire("the world is closed");
    scene_ = scene::Scene();
}

void PyWorld::step(float dt, std::size_t count) {
    World& world = use("World.step");
    if (count == 0) return;
    busy_ = "World.step";
    struct Free {
        const char*& busy;
        ~Free() { busy = nullptr; }
    };
    {
        const Free free{busy_};
        py::gil_scoped_release release;
        auto looked = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < count; ++i) {
            world.step(dt);
            // Lets Ctrl-C end a call with many steps, after a whole step.
            const auto now = std::chrono::steady_clock::now();
            if (now - looked < between_signals) continue;
            looked = now;
            py::gil_scoped_acquire acquire;
            if (PyErr_CheckSignals() != 0) {
                busy_ = nullptr;
                update();
                throw py::error_already_set();
            }
        }
    }
    update();
}

py::object PyWorld::column(Column which) {
    World& world = use("World arrays");
    Array& array = arrays_[std::size_t(which)];
    if (array.view) return array.view;
    if (!any()) {
        ids_ = world.bodies();
        row_of_.assign(ids_.empty() ? 0 : ids_.back().index() + 1, 0);
        for (std::size_t i = 0; i < ids_.size(); ++i) row_of_[ids_[i].index()] = std::uint32_t(i);
        liveness_ = py::module_::import("cairn._arrays").attr("Liveness")();
    }
    const auto rows = py::ssize_t(ids_.size());
    if (which == Column::positions)
        array.owner = new_array<double>({rows, 3});
    else
        array.owner = new_array<float>({rows, which == Column::rotations ? 4 : 3});
    fill(0, ids_.size());
    array.view = py::module_::import("cairn._arrays").attr("view_of")(array.owner, liveness_);
    return array.view;
}

bool PyWorld::any() const {
    return std::any_of(arrays_.begin(), arrays_.end(), [](const Array& array) { return bool(array.owner); });
}

void PyWorld::retire(const char* reason) {
    if (liveness_) liveness_.attr("reason") = reason;
    liveness_ = py::object();
    for (Array& array : arrays_) array = Array{};
}

void PyWorld::update() {
    if (any()) fill(0, ids_.size());
}

void PyWorld::update(BodyId body) {
    if (any()) fill(row_of_[body.index()], 1);
}

void PyWorld::fill(std::size_t first, std::size_t count) {
    const World& world = scene_.world;
    const py::object &p = arrays_[0].owner, &q = arrays_[1].owner, &v = arrays_[2].owner, &w = arrays_[3].owner;
    double* const positions = p ? data_of<double>(p) : nullptr;
    float* const rotations = q ? data_of<float>(q) : nullptr;
    float* const velocities = v ? data_of<float>(v) : nullptr;
    float* const angular = w ? data_of<float>(w) : nullptr;
    std::array<Transform, chunk> poses;
    for (std::size_t begin = first, end = first + count; begin < end && (positions || rotations); begin += chunk) {
        const std::size_t n = std::min(chunk, end - begin);
        world.read_transforms(std::span(ids_).subspan(begin, n), std::span(poses).first(n));
        for (std::size_t i = 0; i < n; ++i) {
            if (positions) std::memcpy(positions + 3 * (begin + i), &poses[i].position.x, 3 * sizeof(double));
            const Quat& r = poses[i].rotation;
            const float numbers[4] = {r.x, r.y, r.z, r.w};
            if (rotations) std::memcpy(rotations + 4 * (begin + i), numbers, sizeof numbers);
        }
    }
    for (std::size_t i = first; i < first + count && (velocities || angular); ++i) {
        const Body body = world.body(ids_[i]);
        const Vec3 linear = body.linear_velocity(), spin = body.angular_velocity();
        if (velocities) std::memcpy(velocities + 3 * i, &linear.x, sizeof linear);
        if (angular) std::memcpy(angular + 3 * i, &spin.x, sizeof spin);
    }
}

} // namespace cairn::python
