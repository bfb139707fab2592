// What a World holds: the simulation, and what only users see of it.
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
    std::atomic<bool> stepping{false};          // to notice calls from other threads
    std::shared_ptr<Communicator> communicator; // the other ranks of this world; null: there are none
    const char* failed_call = nullptr;          // what ran out of memory half way; null: nothing has

    std::shared_ptr<CommandListener> listener; // is told of all changes; null: nobody is
    std::vector<std::byte> command_bytes;      // of the command that it is told of
    bool telling = false;                      // while it is told of one

    // Checked lookups: throw Error(invalid_handle).
    std::int32_t index_of(BodyId id) const;
    std::uint32_t index_of(ShapeId id) const;
    std::uint32_t index_of(JointId id) const;
    std::uint32_t index_of(ForceFieldId id) const;

    // The state, for a query with that filter. Throws Error(invalid_handle) if it ignores a body that is not there.
    const State& seen_by(const QueryFilter& filter, const char* call) const {
        for (const BodyId id : filter.ignored_bodies) index_of(id);
        return whole(call);
    }

    // What a shape is, but for its body. `def`: with a unit rotation.
    void define_shape(std::uint32_t shape, Shape&& geometry, const ShapeDef& def);
    // Makes one that is there another one; `def` may be that of any shape of this world.
    void replace_shape(std::uint32_t shape, Shape geometry, const ShapeDef& def);

    // For snapshots: those of the last one if nothing has changed. May be called from many threads.
    std::shared_ptr<const SnapshotDefinitions> definitions();
    std::mutex last_definitions_mutex;
    std::shared_ptr<const SnapshotDefinitions> last_definitions;
    std::uint64_t last_definitions_hash = 0;         // of their bytes
    std::atomic<std::size_t> last_snapshot_size = 0; // bytes
    bool are_definitions_known = false; // they are `last_definitions`: nothing that they have has changed since
    // The shapes of a snapshot: throws Error(invalid_file) unless they are those of the geometry that is there.
    void set_shapes(const std::vector<Shape>& shapes);

    // Without any state yet. Throws Error(invalid_file).
    static std::unique_ptr<Impl> defined_by(const std::shared_ptr<const SnapshotDefinitions>& definitions,
                                            const WorldDef& settings);
    // Reads a state of the definitions that the world has, in place of its own. It comes from this process, and is
    // right. That takes no memory anew; where memory runs out all the same, the world is good for nothing.
    void restore_in_place(ImageReader& reader);
    // The same for bytes that anybody may have written: they are checked. What throws leaves the world as it was.
    // `tell_of_it()`: called when nothing else can go wrong, it sees the world as it was.
    template <class F> void restore_in_place(ArchiveReader& reader, F&& tell_of_it);
    SetAside set_aside; // what the state was before the last of these, for its memory
    // What belongs to the world, and not to its state.
    void take_over(Impl& other);

    // Takes a joint out of the world; with an event, if it was not asked for.
    void retire_joint(std::uint32_t joint, const std::optional<JointEvent>& event);
    void retire_joints_of(std::int32_t body);
    void break_joints(); // those whose load in the last step was too much
    JointEvent joint_event(std::uint32_t joint, bool broke) const;

    // Throws Error(wrong_state) while another thread is in a step.
    void require_idle(const char* call) const;
    // Throws Error(wrong_state) after a call has run out of memory half way.
    void require_whole(const char* call) const;
    const State& whole(const char* call) const {
        require_whole(call);
        return state;
    }

    // Throws Error(wrong_state) while the listener is told of a change.
    void require_not_telling(const char* call) const;
    // Tells the listener, if there is one. `command`: one of commands/generated/calls.h.
    template <class Command, class... Arguments> void tell(Command command, const Arguments&... arguments);

    void make_step(float dt);
    void gather_records(); // of contacts, from all ranks, which do so together

    // A call that changes the world, with its arguments: one of the table (api), or it does not compile. It is allowed
    // between steps only. What has been checked is done; from `begin` on, of which the listener is told, only running
    // out of memory can stop it half way, and then the world is good for nothing but `World::restore`.
    template <class Command, class... Given> class Change {
        static_assert(std::is_same_v<std::tuple<Given...>, typename Command::Arguments>,
                      "the call has other arguments in the table");

      public:
        Change(Impl& impl, Command, const Given&... arguments) : impl_(impl), arguments_(arguments...) {
            impl.require_idle(Command::name);
            impl.require_whole(Command::name);
            impl.require_not_telling(Command::name);
        }
        ~Change() {
            if (begun_ && std::uncaught_exceptions() > exceptions_) impl_.failed_call = Command::name;
        }
        Change(const Change&) = delete;
        Change& operator=(const Change&) = delete;

        void begin() {
            std::apply([&](const Given&... arguments) { impl_.tell(Command(), arguments...); }, arguments_);
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
void World::Impl::tell([[maybe_unused]] Command command, [[maybe_unused]] const Arguments&... arguments) {
    if constexpr (Command::code != 0) {
        if (!listener) return;
        const struct Telling {
            explicit Telling(bool& flag) : flag_(flag) { flag_ = true; }
            ~Telling() { flag_ = false; }
            bool& flag_;
        } now(telling);
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

// Characters that stand on a shape do so no more.
void forget_ground(Characters& characters, std::uint32_t shape);
// Takes a shape out of the world; its body still lists it. Characters on it forget it.
void retire_shape(Shapes& shapes, BroadPhase& broad_phase, Characters& characters, std::uint32_t shape);

inline math::Vec3 to_math(const Vec3& v) { return {v.x, v.y, v.z}; }
inline math::DVec3 to_math(const Position& v) { return {v.x, v.y, v.z}; }
inline math::Quat to_math(const Quat& q) { return {q.x, q.y, q.z, q.w}; }
inline Vec3 to_public(math::Vec3 v) { return {v.x, v.y, v.z}; }
inline Position to_public(math::DVec3 v) { return {v.x, v.y, v.z}; }
inline Quat to_public(math::Quat q) { return Quat(q.w, q.x, q.y, q.z); }

} // namespace cairn
