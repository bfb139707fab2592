// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/body.h"
#include "module/containers.h"
#include "module/definitions.h"

namespace cairn::python {

void add_body_calls(py::class_<PyBody>& c) {
    c.def_property("type", [](const PyBody& b) {
        const auto answer = b.get("Body.type").type();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<BodyType>(o, "Body.type");
        b.change("Body.type", [&](Body& body) { body.set_type(value); });
    }, "How the body moves. Setting: Makes the body static, kinematic or dynamic.");
    c.def_property("name", [](const PyBody& b) {
        const auto answer = b.get("Body.name").name();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<std::string>(o, "Body.name");
        b.change("Body.name", [&](Body& body) { body.set_name(value); });
    }, "The name of the body, as in `BodyDef.name`. Setting: Sets the name, for display and `World.find_body`; it "
        "need not be unique.");
    c.def_property_readonly("user_data", [](const PyBody& b) {
        const auto answer = b.get("Body.user_data").user_data();
        return write(answer);
    },
        "The number that the application stored in `BodyDef.user_data`.");
    c.def_property("position", [](const PyBody& b) {
        const auto answer = b.get("Body.position").position();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<Position>(o, "Body.position");
        b.change("Body.position", [&](Body& body) { body.set_position(value); });
    }, "Origin of the body's frame, meters. Setting: Teleports the origin of the body's frame: velocities stay, and "
        "contacts are detected afresh in the next step.");
    c.def_property("rotation", [](const PyBody& b) {
        const auto answer = b.get("Body.rotation").rotation();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<Quat>(o, "Body.rotation");
        b.change("Body.rotation", [&](Body& body) { body.set_rotation(value); });
    }, "Rotation of the body's frame, of unit length. Setting: Rotates the body about its origin at once: velocities "
        "stay, and contacts are detected afresh in the next step. Normalized on entry; must not be zero.");
    c.def_property_readonly("transform", [](const PyBody& b) {
        const auto answer = b.get("Body.transform").transform();
        return write(answer);
    },
        "Position and rotation of the body's frame.");
    c.def_property_readonly("center_of_mass", [](const PyBody& b) {
        const auto answer = b.get("Body.center_of_mass").center_of_mass();
        return write(answer);
    },
        "Center of mass in world space, meters. For a kinematic body: its origin, unless `BodyDef.mass_properties` "
            "gave a center of mass.");
    c.def_property("linear_velocity", [](const PyBody& b) {
        const auto answer = b.get("Body.linear_velocity").linear_velocity();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<Vec3>(o, "Body.linear_velocity");
        b.change("Body.linear_velocity", [&](Body& body) { body.set_linear_velocity(value); });
    }, "Velocity of the center of mass, m/s. Setting: Sets the velocity of the center of mass, m/s. Refused "
        "(wrong_state) for static bodies.");
    c.def_property("angular_velocity", [](const PyBody& b) {
        const auto answer = b.get("Body.angular_velocity").angular_velocity();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<Vec3>(o, "Body.angular_velocity");
        b.change("Body.angular_velocity", [&](Body& body) { body.set_angular_velocity(value); });
    }, "Angular velocity in world axes, rad/s. Setting: Sets the angular velocity, rad/s, world axes. Refused "
        "(wrong_state) for static bodies.");
    c.def("velocity_at", [](const PyBody& b, py::object o_point) {
        const auto point = take<Position>(o_point, "point");
        const auto answer = b.get("Body.velocity_at").velocity_at(point);
        return write(answer);
    }, py::arg("point"), "velocity_at(point: Vector) -> np.ndarray\n\nVelocity of the body's material at a point in "
        "world space, m/s.");
    c.def_property_readonly("mass", [](const PyBody& b) {
        const auto answer = b.get("Body.mass").mass();
        return write(answer);
    },
        "Mass, kg; +infinity for static and kinematic bodies.");
    c.def_property("mass_properties", [](const PyBody& b) {
        const auto answer = b.get("Body.mass_properties").mass_properties();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<MassProperties>(o, "Body.mass_properties");
        b.change("Body.mass_properties", [&](Body& body) { body.set_mass_properties(value); });
    }, "Mass, center of mass and inertia, as set or computed from the shapes. Setting: Sets the mass "
        "properties, which then do not follow the shapes. Dynamic bodies only; refused (wrong_state) for others.");
    c.def_property_readonly("world_inertia", [](const PyBody& b) {
        const auto answer = b.get("Body.world_inertia").world_inertia();
        return write(answer);
    },
        "Inertia tensor about the center of mass, world axes, kg m^2.");
    c.def_property_readonly("angular_momentum", [](const PyBody& b) {
        const auto answer = b.get("Body.angular_momentum").angular_momentum();
        return write(answer);
    },
        "Angular momentum about the center of mass, kg m^2/s.");
    c.def_property_readonly("kinetic_energy", [](const PyBody& b) {
        const auto answer = b.get("Body.kinetic_energy").kinetic_energy();
        return write(answer);
    },
        "Linear and rotational kinetic energy, J; 0 for static and kinematic bodies.");
    c.def_property("gravity_scale", [](const PyBody& b) {
        const auto answer = b.get("Body.gravity_scale").gravity_scale();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<float>(o, "Body.gravity_scale");
        b.change("Body.gravity_scale", [&](Body& body) { body.set_gravity_scale(value); });
    }, "The factor by which gravity is multiplied for this body. Setting: Sets the factor by which gravity is "
        "multiplied for this body; any finite value.");
    c.def_property_readonly("linear_damping", [](const PyBody& b) {
        const auto answer = b.get("Body.linear_damping").linear_damping();
        return write(answer);
    },
        "Damping of the linear velocity, 1/s.");
    c.def_property_readonly("angular_damping", [](const PyBody& b) {
        const auto answer = b.get("Body.angular_damping").angular_damping();
        return write(answer);
    },
        "Damping of the angular velocity, 1/s.");
    c.def_property_readonly("is_awake", [](const PyBody& b) {
        const auto answer = b.get("Body.is_awake").is_awake();
        return write(answer);
    },
        "Whether the body is awake. A static or disabled body never is; a kinematic body is while one of its "
            "velocities is not zero.");
    c.def_property("allow_sleep", [](const PyBody& b) {
        const auto answer = b.get("Body.allow_sleep").allow_sleep();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<bool>(o, "Body.allow_sleep");
        b.change("Body.allow_sleep", [&](Body& body) { body.set_allow_sleep(value); });
    }, "Whether the body may fall asleep. Setting: False: the body and its island never fall asleep.");
    c.def_property("enabled", [](const PyBody& b) {
        const auto answer = b.get("Body.enabled").enabled();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<bool>(o, "Body.enabled");
        b.change("Body.enabled", [&](Body& body) { body.set_enabled(value); });
    }, "Whether the body takes part in the simulation. Setting: Takes the body out of the simulation (false) or puts "
        "it back (true), and keeps its shapes, joints and handles. This suits bodies that are reused often, or that "
            "are needed only later. A disabled body does not move but keeps its velocities; it has no "
                "contacts, queries do not find it, its joints do not act, and energies and momenta of the world "
                    "exclude it. Its properties may be changed, but forces and impulses are refused (wrong_state). "
                        "When it is disabled, its contacts end with a ContactEnd, and the bodies that it touched "
                            "wake. If it overlaps others when it is enabled, it is pushed out of them like a newly "
                                "created body.");
    c.def_property_readonly("shapes", [](const PyBody& b) {
        const auto answer = b.get("Body.shapes").shapes();
        return write(answer);
    },
        "The shapes of the body, oldest first.");
    c.def("set_transform", [](const PyBody& b, py::object o_position, py::object o_rotation) {
        const auto position = take<Position>(o_position, "position");
        const auto rotation = take<Quat>(o_rotation, "rotation");
        b.change("Body.set_transform", [&](Body& body) { body.set_transform(position, rotation); });
    }, py::arg("position"), py::arg("rotation"), "set_transform(position: Vector, rotation: Vector) -> "
        "None\n\nTeleports the body: its velocities stay, and its contacts are detected afresh in the next step.");
    c.def("move_to", [](const PyBody& b, py::object o_target, py::object o_seconds) {
        const auto target = take<Transform>(o_target, "target");
        const auto seconds = take<float>(o_seconds, "seconds");
        b.change("Body.move_to", [&](Body& body) { body.move_to(target, seconds); });
    }, py::arg("target"), py::arg("seconds"), "move_to(target: Transform, seconds: float) -> None\n\nSets the "
        "velocities of a kinematic body such that it reaches `target` after `seconds` (> 0). It keeps these "
            "velocities afterwards. Refused (wrong_state) for bodies of other types.");
    c.def("set_damping", [](const PyBody& b, py::object o_linear, py::object o_angular) {
        const auto linear = take<float>(o_linear, "linear");
        const auto angular = take<float>(o_angular, "angular");
        b.change("Body.set_damping", [&](Body& body) { body.set_damping(linear, angular); });
    }, py::arg("linear"), py::arg("angular"), "set_damping(linear: float, angular: float) -> None\n\nSets the damping "
        "of the linear and angular velocity, 1/s, >= 0: velocities decay as v' = -damping v.");
    c.def("set_mass_from_shapes", [](const PyBody& b, py::object o_mass) {
        const auto mass = take<std::optional<float>>(o_mass, "mass");
        b.change("Body.set_mass_from_shapes", [&](Body& body) { body.set_mass_from_shapes(mass); });
    }, py::arg("mass") = py::none(), "set_mass_from_shapes(mass: float | None = None) -> None\n\nMakes the mass "
        "properties follow the densities of the shapes again, scaled to a total of `mass` (kg, > 0) if it is given. "
            "Dynamic bodies only; refused (wrong_state) for others.");
    c.def("wake", [](const PyBody& b) {
        b.change("Body.wake", [&](Body& body) { body.wake(); });
    }, "wake() -> None\n\nWakes the body and its island.");
    c.def("sleep", [](const PyBody& b) {
        b.change("Body.sleep", [&](Body& body) { body.sleep(); });
    }, "sleep() -> None\n\nSets the velocities of a dynamic body to zero and puts it to sleep at the beginning of the "
        "next step, at its present place, even in the air. This requires that `sleep` was called for all bodies of "
            "its island, that is, also for those that it touches or is joined to, and that all of them may sleep. A "
                "level that is created asleep costs no time until something wakes it; then it settles like newly "
                    "created bodies. Calls that move or push the body before that step wake it as usual. No effect on "
                        "other types of bodies, and where `WorldDef.enable_sleep` is false.");
    c.def("add_force", [](const PyBody& b, py::object o_force) {
        const auto force = take<Vec3>(o_force, "force");
        b.change("Body.add_force", [&](Body& body) { body.add_force(force); });
    }, py::arg("force"), "add_force(force: Vector) -> None\n\nAdds a force, N, at the center of mass; it acts during "
        "the next step only.");
    c.def("add_force_at", [](const PyBody& b, py::object o_force, py::object o_point) {
        const auto force = take<Vec3>(o_force, "force");
        const auto point = take<Position>(o_point, "point");
        b.change("Body.add_force_at", [&](Body& body) { body.add_force_at(force, point); });
    }, py::arg("force"), py::arg("point"), "add_force_at(force: Vector, point: Vector) -> None\n\nAdds a force, N, at "
        "a point in world space; it acts during the next step only.");
    c.def("add_torque", [](const PyBody& b, py::object o_torque) {
        const auto torque = take<Vec3>(o_torque, "torque");
        b.change("Body.add_torque", [&](Body& body) { body.add_torque(torque); });
    }, py::arg("torque"), "add_torque(torque: Vector) -> None\n\nAdds a torque, N m; it acts during the next step "
        "only.");
    c.def("apply_impulse", [](const PyBody& b, py::object o_impulse) {
        const auto impulse = take<Vec3>(o_impulse, "impulse");
        b.change("Body.apply_impulse", [&](Body& body) { body.apply_impulse(impulse); });
    }, py::arg("impulse"), "apply_impulse(impulse: Vector) -> None\n\nApplies an impulse, N s, at the center of "
        "mass; it changes the velocity at once.");
    c.def("apply_impulse_at", [](const PyBody& b, py::object o_impulse, py::object o_point) {
        const auto impulse = take<Vec3>(o_impulse, "impulse");
        const auto point = take<Position>(o_point, "point");
        b.change("Body.apply_impulse_at", [&](Body& body) { body.apply_impulse_at(impulse, point); });
    }, py::arg("impulse"), py::arg("point"), "apply_impulse_at(impulse: Vector, point: Vector) -> None\n\nApplies an "
        "impulse, N s, at a point in world space; it changes the velocities at once.");
    c.def("apply_angular_impulse", [](const PyBody& b, py::object o_impulse) {
        const auto impulse = take<Vec3>(o_impulse, "impulse");
        b.change("Body.apply_angular_impulse", [&](Body& body) { body.apply_angular_impulse(impulse); });
    }, py::arg("impulse"), "apply_angular_impulse(impulse: Vector) -> None\n\nApplies an angular impulse, N m s; it "
        "changes the angular velocity at once.");
    c.def_property_readonly("is_character", [](const PyBody& b) {
        const auto answer = b.get("Body.is_character").is_character();
        return write(answer);
    },
        "Whether the body is a character.");
    c.def_property("character", [](const PyBody& b) {
        const auto answer = b.get("Body.character").character();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<CharacterDef>(o, "Body.character");
        b.change("Body.character", [&](Body& body) { body.set_character(value); });
    }, "The definition of the character. Refused (wrong_state) if the body is no character. Setting: Makes a "
        "kinematic body a character, or changes the definition of a character. From then on each step sets the "
            "velocities of the body to those with which it moves the character. Setting its linear velocity then "
                "throws the character: with an upward velocity, it leaves the ground.");
    c.def("remove_character", [](const PyBody& b) {
        b.change("Body.remove_character", [&](Body& body) { body.remove_character(); });
    }, "remove_character() -> None\n\nMakes the character an ordinary kinematic body again, at rest.");
    c.def_property("walk_velocity", [](const PyBody& b) {
        const auto answer = b.get("Body.walk_velocity").walk_velocity();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<Vec3>(o, "Body.walk_velocity");
        b.change("Body.walk_velocity", [&](Body& body) { body.set_walk_velocity(value); });
    }, "The velocity with which the character tries to move, m/s, relative to the ground. Refused (wrong_state) if "
        "the body is no character. Setting: Sets the velocity with which a character tries to move, m/s, relative to "
            "the ground; it holds until the next call. The character moves along the ground with this speed, in this "
                "direction as seen from above. The component along `CharacterDef.up` is used only if the character "
                    "flies (`CharacterDef.flies`).");
    c.def("jump", [](const PyBody& b, py::object o_speed) {
        const auto speed = take<float>(o_speed, "speed");
        b.change("Body.jump", [&](Body& body) { body.jump(speed); });
    }, py::arg("speed"), "jump(speed: float) -> None\n\nA character that stands on the ground leaves it in the next "
        "step with this upward speed, m/s, > 0. No effect on a character that does not stand then.");
    c.def_property_readonly("character_state", [](const PyBody& b) {
        const auto answer = b.get("Body.character_state").character_state();
        return write(answer);
    },
        "The motion and support of the character after the last step. Refused (wrong_state) if the body is no "
            "character.");
    c.def_property_readonly("joints", [](const PyBody& b) {
        const auto answer = b.world->use("Body.joints").joints(b.id);
        return write(answer);
    },
        "The joints of one body, oldest first.");
    c.def_property_readonly("contacts", [](const PyBody& b) {
        const auto answer = b.world->use("Body.contacts").contacts(b.id);
        return write(answer);
    },
        "The contact manifolds of one body.");
}

} // namespace cairn::python
