#include "viewer/change_names.h"

#include <variant>

namespace cairn::viewer {

namespace {

using Merge = Timeline::Merge;

struct Names {
    std::optional<NamedChange> operator()(const command::Spawn&) const { return NamedChange{"add a body"}; }
    std::optional<NamedChange> operator()(const command::Shoot&) const { return NamedChange{"shoot"}; }
    std::optional<NamedChange> operator()(const command::RemoveLast&) const { return NamedChange{"remove a body"}; }
    std::optional<NamedChange> operator()(const command::RemoveSelected&) const { return NamedChange{"remove a body"}; }
    std::optional<NamedChange> operator()(const command::SetForce& force) const {
        // Releasing the key ends the change that began when it was pressed.
        return NamedChange{"push", force.acceleration == Vec3(0.0f) ? Merge::always : Merge::soon};
    }
    std::optional<NamedChange> operator()(const command::SetPull& pull) const {
        return NamedChange{"pull to the center", pull.on ? Merge::never : Merge::always};
    }
    std::optional<NamedChange> operator()(const command::SetFreeze&) const { return NamedChange{"freeze"}; }
    std::optional<NamedChange> operator()(const command::SetSettings&) const {
        return NamedChange{"settings", Merge::soon};
    }
    std::optional<NamedChange> operator()(const command::AddField&) const { return NamedChange{"add a force field"}; }
    std::optional<NamedChange> operator()(const command::SetField&) const {
        return NamedChange{"force field", Merge::soon};
    }
    std::optional<NamedChange> operator()(const command::RemoveField&) const {
        return NamedChange{"remove a force field"};
    }
    std::optional<NamedChange> operator()(const command::GrabBody&) const { return NamedChange{"drag"}; }
    std::optional<NamedChange> operator()(const command::ReleaseGrab&) const {
        return NamedChange{"drag", Merge::always};
    }
    std::optional<NamedChange> operator()(const command::MakeJoint&) const { return NamedChange{"make a joint"}; }
    std::optional<NamedChange> operator()(const command::SetJoint&) const {
        return NamedChange{"change a joint", Merge::soon};
    }
    std::optional<NamedChange> operator()(const command::SetJointStrength&) const {
        return NamedChange{"change the strength of a joint", Merge::soon};
    }
    std::optional<NamedChange> operator()(const command::SetJointEnabled& change) const {
        return NamedChange{change.enabled ? "enable a joint" : "disable a joint"};
    }
    std::optional<NamedChange> operator()(const command::SetJointSolver&) const {
        return NamedChange{"change the solver of a joint"};
    }
    std::optional<NamedChange> operator()(const command::RemoveJoint&) const { return NamedChange{"remove a joint"}; }
    std::optional<NamedChange> operator()(const command::EditBody& change) const {
        return NamedChange{name_of(change.edit), Merge::soon};
    }
    std::optional<NamedChange> operator()(const command::EditBodies& change) const {
        if (change.edits.empty()) return std::nullopt;
        return NamedChange{std::string(name_of(change.edits.front().second)) + ", several bodies", Merge::soon};
    }
    std::optional<NamedChange> operator()(const command::GroupSelected&) const { return NamedChange{"group bodies"}; }
    std::optional<NamedChange> operator()(const command::UngroupSelected&) const { return NamedChange{"end a group"}; }
    std::optional<NamedChange> operator()(const command::DuplicateSelected&) const {
        return NamedChange{"duplicate a body"};
    }
    template <class Other> std::optional<NamedChange> operator()(const Other&) const { return std::nullopt; }
};

} // namespace

std::optional<NamedChange> change_of(const Command& command) { return std::visit(Names{}, command); }

} // namespace cairn::viewer
