// A world for Python: with the data of its scene file, and arrays of all bodies.
#pragma once

#include "module/convert.h"

#include "scene/scene.h"

#include <array>
#include <memory>
#include <vector>

namespace cairn::python {

// The quantities for which there are arrays.
enum class Column { positions, rotations, velocities, angular_velocities };
inline constexpr std::size_t column_count = 4;

class PyWorld : public std::enable_shared_from_this<PyWorld> {
  public:
    explicit PyWorld(scene::Scene scene) : scene_(std::move(scene)) {}
    ~PyWorld() { retire("the world is gone"); }
    PyWorld(const PyWorld&) = delete;
    PyWorld& operator=(const PyWorld&) = delete;

    // The world, for a call whose name appears in errors. Throws (wrong_state) if the world is closed, or is being
    // stepped on another thread: the interpreter's lock is held here, so that no call can intervene.
    World& use(const char* call);
    scene::Scene& scene(const char* call) { return use(call), scene_; }
    void close();
    bool is_closed() const { return closed_; }

    // Steps without the interpreter's lock; meanwhile the world is closed to other threads.
    void step(float dt, std::size_t count);

    // The array of all bodies in the order of slot indices. It is updated from then on until bodies are added or
    // removed; then it is retired, and a new one is created on demand.
    py::object column(Column which);
    void retire(const char* reason); // bodies were added or removed
    void update();                   // all bodies may have moved
    void update(BodyId body);        // one body may have moved

  private:
    struct Array {
        py::object owner; // owner of the memory; null if the array was never requested
        py::object view;  // the Python object: cairn._arrays.BodyArray
    };
    void fill(std::size_t first, std::size_t count);
    bool any() const;

    scene::Scene scene_;
    bool closed_ = false;
    const char* busy_ = nullptr; // the call that is running without the interpreter's lock
    std::array<Array, column_count> arrays_;
    py::object liveness_; // shared by the views
    std::vector<BodyId> ids_;
    std::vector<std::uint32_t> row_of_; // row of each body, by slot index
};

} // namespace cairn::python
