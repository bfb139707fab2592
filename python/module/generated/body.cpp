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
    }, "The name of its definition. Setting: For people; need not be unique.");
    c.def_property_readonly("user_data", [](const PyBody& b) {
        const auto answer = b.get("Body.user_data").user_data();
        return write(answer);
    },
        "The number of its definition.");
    c.def_property("position", [](const PyBody& b) {
        const auto answer = b.get("Body.position").position();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<Position>(o, "Body.position");
        b.change("Body.position", [&](Body& body) { body.set_position(value); });
    }, "Origin of the body's frame, meters. Setting: Teleports the origin of the body's frame: velocities "
        "stay, contacts are found anew.");
    c.def_property("rotation", [](const PyBody& b) {
        const auto answer = b.get("Body.rotation").rotation();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<Quat>(o, "Body.rotation");
        b.change("Body.rotation", [&](Body& body) { body.set_rotation(value); });
    }, "Rotation of the body's frame, of unit length. Setting: Turns the body in place: velocities stay, contacts are "
        "found anew. Normalized on entry; must not be zero.");
    c.def_property_readonly("transform", [](const PyBody& b) {
        const auto answer = b.get("Body.transform").transform();
        return write(answer);
    },
        "Place and rotation of the body's frame.");
    c.def_property_readonly("center_of_mass", [](const PyBody& b) {
        const auto answer = b.get("Body.center_of_mass").center_of_mass();
        return write(answer);
    },
        "In world space, meters; of kinematic bodies, their origin, if not given.");
    c.def_property("linear_velocity", [](const PyBody& b) {
        const auto answer = b.get("Body.linear_velocity").linear_velocity();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<Vec3>(o, "Body.linear_velocity");
        b.change("Body.linear_velocity", [&](Body& body) { body.set_linear_velocity(value); });
    }, "Of the center of mass, m/s. Setting: Sets the velocity of the center of mass, m/s. Not of static bodies.");
    c.def_property("angular_velocity", [](const PyBody& b) {
        const auto answer = b.get("Body.angular_velocity").angular_velocity();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<Vec3>(o, "Body.angular_velocity");
        b.change("Body.angular_velocity", [&](Body& body) { body.set_angular_velocity(value); });
    }, "rad/s. Setting: Sets the angular velocity, rad/s, world axes. Not of static bodies.");
    c.def("velocity_at", [](const PyBody& b, py::object o_point) {
        const auto point = take<Position>(o_point, "point");
        const auto answer = b.get("Body.velocity_at").velocity_at(point);
        return write(answer);
    }, py::arg("point"), "velocity_at(point: Vector) -> np.ndarray\n\nOf the body's material at a world point, m/s.");
    c.def_property_readonly("mass", [](const PyBody& b) {
        const auto answer = b.get("Body.mass").mass();
        return write(answer);
    },
        "kg; +infinity for static and kinematic bodies.");
    c.def_property("mass_properties", [](const PyBody& b) {
        const auto answer = b.get("Body.mass_properties").mass_properties();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<MassProperties>(o, "Body.mass_properties");
        b.change("Body.mass_properties", [&](Body& body) { body.set_mass_properties(value); });
    }, "Mass, center of mass and inertia, as set or computed from the shapes. Setting: Replaces the mass "
        "properties; they no longer follow the shapes. Dynamic bodies only.");
    c.def_property_readonly("world_inertia", [](const PyBody& b) {
        const auto answer = b.get("Body.world_inertia").world_inertia();
        return write(answer);
    },
        "About the center of mass, world axes, kg m^2.");
    c.def_property_readonly("angular_momentum", [](const PyBody& b) {
        const auto answer = b.get("Body.angular_momentum").angular_momentum();
        return write(answer);
    },
        "About the center of mass, kg m^2/s.");
    c.def_property_readonly("kinetic_energy", [](const PyBody& b) {
        const auto answer = b.get("Body.kinetic_energy").kinetic_energy();
        return write(answer);
    },
        "Linear and rotational, J; 0 for static and kinematic bodies.");
    c.def_property("gravity_scale", [](const PyBody& b) {
        const auto answer = b.get("Body.gravity_scale").gravity_scale();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<float>(o, "Body.gravity_scale");
        b.change("Body.gravity_scale", [&](Body& body) { body.set_gravity_scale(value); });
    }, "What gravity is multiplied with for this body. Setting: Multiplies gravity for this body; any finite value.");
    c.def_property_readonly("linear_damping", [](const PyBody& b) {
        const auto answer = b.get("Body.linear_damping").linear_damping();
        return write(answer);
    },
        "1/s.");
    c.def_property_readonly("angular_damping", [](const PyBody& b) {
        const auto answer = b.get("Body.angular_damping").angular_damping();
        return write(answer);
    },
        "1/s.");
    c.def_property_readonly("is_awake", [](const PyBody& b) {
        const auto answer = b.get("Body.is_awake").is_awake();
        return write(answer);
    },
        "Static bodies never are; kinematic ones are while they move.");
    c.def_property("allow_sleep", [](const PyBody& b) {
        const auto answer = b.get("Body.allow_sleep").allow_sleep();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<bool>(o, "Body.allow_sleep");
        b.change("Body.allow_sleep", [&](Body& body) { body.set_allow_sleep(value); });
    }, "Whether it may fall asleep. Setting: False: the body and its island never fall asleep.");
    c.def_property("enabled", [](const PyBody& b) {
        const auto answer = b.get("Body.enabled").enabled();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<bool>(o, "Body.enabled");
        b.change("Body.enabled", [&](Body& body) { body.set_enabled(value); });
    }, "Whether it takes part in the world. Setting: Takes a body out of the world and puts it back, with its "
        "shapes, joints and handles as they are: for what is used again and again, or not yet. What is disabled does "
            "not move and keeps its velocities; nothing touches it, queries do not see it, its joints do not act, and "
                "energies and momenta are without it. All of it may be changed, but nothing can push it: forces and "
                    "impulses are refused (wrong_state). What it touched ends with a ContactEnd, and wakes; where it "
                        "is put back into something, it is pushed out as what is made there.");
    c.def_property_readonly("shapes", [](const PyBody& b) {
        const auto answer = b.get("Body.shapes").shapes();
        return write(answer);
    },
        "Its shapes, oldest first.");
    c.def("set_transform", [](const PyBody& b, py::object o_position, py::object o_rotation) {
        const auto position = take<Position>(o_position, "position");
        const auto rotation = take<Quat>(o_rotation, "rotation");
        b.change("Body.set_transform", [&](Body& body) { body.set_transform(position, rotation); });
    }, py::arg("position"), py::arg("rotation"), "set_transform(position: Vector, rotation: Vector) -> "
        "None\n\nTeleports the body: velocities stay, contacts are found anew.");
    c.def("move_to", [](const PyBody& b, py::object o_target, py::object o_seconds) {
        const auto target = take<Transform>(o_target, "target");
        const auto seconds = take<float>(o_seconds, "seconds");
        b.change("Body.move_to", [&](Body& body) { body.move_to(target, seconds); });
    }, py::arg("target"), py::arg("seconds"), "move_to(target: Transform, seconds: float) -> None\n\nKinematic "
        "bodies: sets the velocities that bring the body to `target` in `seconds` (> 0).");
    c.def("set_damping", [](const PyBody& b, py::object o_linear, py::object o_angular) {
        const auto linear = take<float>(o_linear, "linear");
        const auto angular = take<float>(o_angular, "angular");
        b.change("Body.set_damping", [&](Body& body) { body.set_damping(linear, angular); });
    }, py::arg("linear"), py::arg("angular"), "set_damping(linear: float, angular: float) -> None\n\n1/s, >= 0: the "
        "velocities decay as v' = -damping v.");
    c.def("set_mass_from_shapes", [](const PyBody& b, py::object o_mass) {
        const auto mass = take<std::optional<float>>(o_mass, "mass");
        b.change("Body.set_mass_from_shapes", [&](Body& body) { body.set_mass_from_shapes(mass); });
    }, py::arg("mass") = py::none(), "set_mass_from_shapes(mass: float | None = None) -> None\n\nMass properties "
        "follow the shapes' densities again, scaled to `mass` if given.");
    c.def("wake", [](const PyBody& b) {
        b.change("Body.wake", [&](Body& body) { body.wake(); });
    }, "wake() -> None\n\nWakes the body and its island.");
    c.def("sleep", [](const PyBody& b) {
        b.change("Body.sleep", [&](Body& body) { body.sleep(); });
    }, "sleep() -> None\n\nBrings a dynamic body to rest and lets it sleep from the next step on, as it is, even in "
        "the air: before anything moves, provided that all that touches it or is joined to it was told so, too, and "
            "may sleep. A level that is made asleep costs nothing until something comes; then it settles like "
                "anything that is made. What moves or pushes the body in between wakes it, as ever.");
    c.def("add_force", [](const PyBody& b, py::object o_force) {
        const auto force = take<Vec3>(o_force, "force");
        b.change("Body.add_force", [&](Body& body) { body.add_force(force); });
    }, py::arg("force"), "add_force(force: Vector) -> None\n\nN, at the center of mass; acts during the next step "
        "only.");
    c.def("add_force_at", [](const PyBody& b, py::object o_force, py::object o_point) {
        const auto force = take<Vec3>(o_force, "force");
        const auto point = take<Position>(o_point, "point");
        b.change("Body.add_force_at", [&](Body& body) { body.add_force_at(force, point); });
    }, py::arg("force"), py::arg("point"), "add_force_at(force: Vector, point: Vector) -> None\n\nN, at a world "
        "point; next step only.");
    c.def("add_torque", [](const PyBody& b, py::object o_torque) {
        const auto torque = take<Vec3>(o_torque, "torque");
        b.change("Body.add_torque", [&](Body& body) { body.add_torque(torque); });
    }, py::arg("torque"), "add_torque(torque: Vector) -> None\n\nN m; next step only.");
    c.def("apply_impulse", [](const PyBody& b, py::object o_impulse) {
        const auto impulse = take<Vec3>(o_impulse, "impulse");
        b.change("Body.apply_impulse", [&](Body& body) { body.apply_impulse(impulse); });
    }, py::arg("impulse"), "apply_impulse(impulse: Vector) -> None\n\nN s, at the center of mass; changes the "
        "velocity at once.");
    c.def("apply_impulse_at", [](const PyBody& b, py::object o_impulse, py::object o_point) {
        const auto impulse = take<Vec3>(o_impulse, "impulse");
        const auto point = take<Position>(o_point, "point");
        b.change("Body.apply_impulse_at", [&](Body& body) { body.apply_impulse_at(impulse, point); });
    }, py::arg("impulse"), py::arg("point"), "apply_impulse_at(impulse: Vector, point: Vector) -> None\n\nN s, at a "
        "world point.");
    c.def("apply_angular_impulse", [](const PyBody& b, py::object o_impulse) {
        const auto impulse = take<Vec3>(o_impulse, "impulse");
        b.change("Body.apply_angular_impulse", [&](Body& body) { body.apply_angular_impulse(impulse); });
    }, py::arg("impulse"), "apply_angular_impulse(impulse: Vector) -> None\n\nN m s.");
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
    }, "How the character moves (wrong_state unless it is one). Setting: Makes a kinematic body a character, or "
        "changes how one moves. From then on its velocities are those with which each step moves it, and setting its "
            "linear velocity throws it: upwards, it leaves the ground.");
    c.def("remove_character", [](const PyBody& b) {
        b.change("Body.remove_character", [&](Body& body) { body.remove_character(); });
    }, "remove_character() -> None\n\nIt is an ordinary kinematic body again, at rest.");
    c.def_property("walk_velocity", [](const PyBody& b) {
        const auto answer = b.get("Body.walk_velocity").walk_velocity();
        return write(answer);
    }, [](const PyBody& b, py::object o) {
        const auto value = take<Vec3>(o, "Body.walk_velocity");
        b.change("Body.walk_velocity", [&](Body& body) { body.set_walk_velocity(value); });
    }, "Where the character wants to go, m/s. Setting: Where a character wants to go, m/s, until it is set anew: over "
        "the ground, with this speed and, seen from above, in this direction, beside the motion of the ground itself. "
            "What of it leads up or down counts for those alone that fly.");
    c.def("jump", [](const PyBody& b, py::object o_speed) {
        const auto speed = take<float>(o_speed, "speed");
        b.change("Body.jump", [&](Body& body) { body.jump(speed); });
    }, py::arg("speed"), "jump(speed: float) -> None\n\nIn the next step, a character that stands on the ground "
        "leaves it with this speed, m/s, > 0; others do not.");
    c.def_property_readonly("character_state", [](const PyBody& b) {
        const auto answer = b.get("Body.character_state").character_state();
        return write(answer);
    },
        "How the character moves and what it is on, as it stood after the last step.");
    c.def_property_readonly("joints", [](const PyBody& b) {
        const auto answer = b.world->use("Body.joints").joints(b.id);
        return write(answer);
    },
        "Those of one body, oldest first.");
    c.def_property_readonly("contacts", [](const PyBody& b) {
        const auto answer = b.world->use("Body.contacts").contacts(b.id);
        return write(answer);
    },
        "Those of one body.");
}

} // namespace cairn::python
