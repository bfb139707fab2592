// The contents of a World: the simulation state, and the data that only users read.
#pragma once

#include "commands/generated/calls.h"
#include "commands/generated/codec.h"
#include "core/room.h"
#include "core/set_aside.h"
#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>
#include <cairn/world.h>

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace cairn {

class ArchiveReader;
class ImageReader;

struct World::Impl {
    explicit Impl(const WorldDef& def);

    State state;
    StepScratch step;
    std::vector<std::string> names;             // by body
    std::vector<std::uint64_t> user_data;       // by body
    std::vector<Shape> shape_of;                // by shape
    std::vector<ShapeDef> def_of;               // by shape
    std::vector<JointDef> joint_defs;           // by joint
    std::atomic<bool> stepping{false};          // detects calls from other threads during a step
    std::shared_ptr<Communicator> communicator; // to the other ranks of this world; null: a single process
    const char* failed_call = nullptr; // the call that ran out of memory while it changed the world; null: none

    std::shared_ptr<CommandListener> listener; // is notified of all changes; null: none
    std::vector<std::byte> command_bytes;      // the command that the listener is notified of
    bool is_notifying = false;                 // while the listener is being notified

    // Checked lookups: throw Error(invalid_handle).
    std::int32_t index_of(BodyId id) const;
    std::uint32_t index_of(ShapeId id) const;
    std::uint32_t index_of(JointId id) const;
    std::uint32_t index_of(ForceFieldId id) const;

    // The state for a query with this filter. Throws Error(invalid_handle) if the filter ignores a body that does not
    // exist.
    const State& for_queries(const QueryFilter& filter, const char* call) const {
        for (const BodyId id : filter.ignored_bodies) index_of(id);
        return intact(call);
    }

    // Sets everything about a shape except its body. The rotation of `def` must be a unit quaternion.
    void define_shape(std::uint32_t shape, Shape&& geometry, const ShapeDef& def);
    // Replaces an existing shape; `def` may refer to the definition of any shape of this world.
    void replace_shape(std::uint32_t shape, Shape geometry, const ShapeDef& def);

    // The definitions for a snapshot: those of the last snapshot if they have not changed. Thread-safe.
    std::shared_ptr<const SnapshotDefinitions> definitions();
    std::mutex last_definitions_mutex;
    std::shared_ptr<const SnapshotDefinitions> last_definitions;
    std::uint64_t last_definitions_hash = 0;         // of the bytes of last_definitions
    std::atomic<std::size_t> last_snapshot_size = 0; // bytes
    bool are_definitions_known = false;              // `last_definitions` is current: no definition has changed since
    // Takes over the shapes of a snapshot. Throws Error(invalid_file) unless they match the geometry in the state.
    void set_shapes(const std::vector<Shape>& shapes);

    // A world with these definitions and no state yet. Throws Error(invalid_file).
    static std::unique_ptr<Impl> defined_by(const std::shared_ptr<const SnapshotDefinitions>& definitions,
                                            const WorldDef& settings);
    // Replaces the state by one with the same definitions, saved by this process and therefore trusted. Allocates no
    // new memory in general; if memory runs out nevertheless, the world becomes unusable.
    void restore_in_place(ImageReader& reader);
    // As above, from untrusted bytes, which are checked. On an exception the world stays unchanged. `notify_listener()`
    // is called when nothing else can fail, and sees the world before the change.
    template <class F> void restore_in_place(ArchiveReader& reader, F&& notify_listener);
    SetAside set_aside; // the state before the last checked restore, kept for its memory
    // Takes over from `other` the members that belong to the world rather than to its state: threads, communicator,
    // listener.
    void take_over(Impl& other);

    // Removes a joint from the world; with an event if the user did not request the removal.
    void retire_joint(std::uint32_t joint, const std::optional<JointEvent>& event);
    void retire_joints_of(std::int32_t body);
    void break_joints(); // joints whose load in the last step exceeded their limits
    JointEvent joint_event(std::uint32_t joint, bool broke) const;

    // Throws Error(wrong_state) while another thread is in a step.
    void require_idle(const char* call) const;
    // Throws Error(wrong_state) after a call has run out of memory half way.
    void require_usable(const char* call) const;
    const State& intact(const char* call) const {
        require_usable(call);
        return state;
    }

    // Throws Error(wrong_state) while the listener is being notified of a change.
    void require_not_notifying(const char* call) const;
    // Notifies the listener, if there is one. `command`: one from commands/generated/calls.h.
    template <class Command, class... Arguments> void notify(Command command, const Arguments&... arguments);

    void make_step(float dt);
    void gather_records(); // collects contact records from all ranks; a collective operation

    // A call that changes the world, with its arguments, which must match the call table in api/ to compile. Such calls
    // are allowed between steps only. The arguments are checked before `begin`, which notifies the listener; after it
    // only running out of memory can interrupt the change, and then the world accepts nothing but `World::restore`.
    template <class Command, class... Given> class Change {
        static_assert(std::is_same_v<std::tuple<Given...>, typename Command::Arguments>,
                      "the call has other arguments in the table");

      public:
        Change(Impl& impl, Command, const Given&... arguments) : impl_(impl), arguments_(arguments...) {
            impl.require_idle(Command::name);
            impl.require_usable(Command::name);
            impl.require_not_notifying(Command::name);
        }
        ~Change() {
            if (begun_ && std::uncaught_exceptions() > exceptions_) impl_.failed_call = Command::name;
        }
        Change(const Change&) = delete;
        Change& operator=(const Change&) = delete;

        void begin() {
            std::apply([&](const Given&... arguments) { impl_.notify(Command(), arguments...); }, arguments_);
            begun_ = true;
            if constexpr (!Command::moves_only) impl_.are_definitions_known = false;
        }

      private:
        Impl& impl_;
        std::tuple<const Given&...> arguments_;
        int exceptions_ = std::uncaught_exceptions();
        bool begun_ = false;
    };
};

template <class Command, class... Arguments>
void World::Impl::notify([[maybe_unused]] Command command, [[maybe_unused]] const Arguments&... arguments) {
    if constexpr (Command::code != 0) {
        if (!listener) return;
        const struct Notifying {
            explicit Notifying(bool& flag) : flag_(flag) { flag_ = true; }
            ~Notifying() { flag_ = false; }
            bool& flag_;
        } now(is_notifying);
        commands::CommandWriter writer(command_bytes, *listener);
        writer.number(Command::code);
        (write(writer, arguments), ...);
        listener->on_command(command_bytes);
    }
}

template <class T> void make_room(std::vector<T>& v, std::size_t index) {
    if (v.size() <= index) set_size(v, index + 1);
}

template <class Id> void require_slot(const SlotPool<Id>& pool, const char* what) {
    if (pool.full())
        throw Error(ErrorCode::wrong_state, what, std::to_string(pool.live_count()), "no more can exist in one world");
}

// Clears the ground of characters that stand on this shape.
void forget_ground(Characters& characters, std::uint32_t shape);
// Removes a shape from the world, though its body still lists it; characters that stand on it lose their ground.
void retire_shape(Shapes& shapes, BroadPhase& broad_phase, Characters& characters, std::uint32_t shape);

inline math::Vec3 to_math(const Vec3& v) { return {v.x, v.y, v.z}; }
inline math::DVec3 to_math(const Position& v) { return {v.x, v.y, v.z}; }
inline math::Quat to_math(const Quat& q) { return {q.x, q.y, q.z, q.w}; }
inline Vec3 to_public(math::Vec3 v) { return {v.x, v.y, v.z}; }
inline Position to_public(math::DVec3 v) { return {v.x, v.y, v.z}; }
inline Quat to_public(math::Quat q) { return Quat(q.w, q.x, q.y, q.z); }

} // namespace cairn
