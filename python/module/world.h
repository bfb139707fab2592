// A world as Python holds it: with what came from its file, and arrays of all bodies.
#pragma once

#include "module/convert.h"

#include "scene/scene.h"

#include <array>
#include <memory>
#include <vector>

namespace cairn::python {

// What there are arrays of.
enum class Column { positions, rotations, velocities, angular_velocities };
inline constexpr std::size_t column_count = 4;

class PyWorld : public std::enable_shared_from_this<PyWorld> {
  public:
    explicit PyWorld(scene::Scene scene) : scene_(std::move(scene)) {}
    ~PyWorld() { retire("the world is gone"); }
    PyWorld(const PyWorld&) = delete;
    PyWorld& operator=(const PyWorld&) = delete;

    // The world, for a call that it is named for in errors. Throws (wrong_state) if it is closed, or in a step on
    // another thread: the interpreter's lock is held here, so that no call can come in between.
    World& use(const char* call);
    scene::Scene& scene(const char* call) { return use(call), scene_; }
    void close();
    bool is_closed() const { return closed_; }

    // Without the interpreter's lock, and with this world closed to other threads meanwhile.
    void step(float dt, std::size_t count);

    // The array of all bodies, in order of slot index. It is kept up to date from then on, until bodies come or go:
    // then it is retired, and another one is made when it is asked for.
    py::object column(Column which);
    void retire(const char* reason); // bodies came or went
    void update();                   // all bodies may have moved
    void update(BodyId body);        // one of them

  private:
    struct Array {
        py::object owner; // of the memory; null: nobody has asked for it
        py::object view;  // what Python sees: cairn._arrays.BodyArray
    };
    void fill(std::size_t first, std::size_t count);
    bool any() const;

    scene::Scene scene_;
    bool closed_ = false;
    const char* busy_ = nullptr; // the call that is on its way without the interpreter's lock
    std::array<Array, column_count> arrays_;
    py::object liveness_; // shared by the views
    std::vector<BodyId> ids_;
    std::vector<std::uint32_t> row_of_; // by slot index
};

} // namespace cairn::python
