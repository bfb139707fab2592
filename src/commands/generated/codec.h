// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#pragma once

#include "commands/command_reader.h"
#include "commands/command_writer.h"

#include <cairn/world.h>

namespace cairn::commands {

void write(CommandWriter& to, const Transform& x);
void read(CommandReader& from, Transform& x);
void write(CommandWriter& to, const Sphere& x);
void read(CommandReader& from, Sphere& x);
void write(CommandWriter& to, const Box& x);
void read(CommandReader& from, Box& x);
void write(CommandWriter& to, const Plane& x);
void read(CommandReader& from, Plane& x);
void write(CommandWriter& to, const Capsule& x);
void read(CommandReader& from, Capsule& x);
void write(CommandWriter& to, const Cylinder& x);
void read(CommandReader& from, Cylinder& x);
void write(CommandWriter& to, const Material& x);
void read(CommandReader& from, Material& x);
void write(CommandWriter& to, const CollisionFilter& x);
void read(CommandReader& from, CollisionFilter& x);
void write(CommandWriter& to, const ShapeDef& x);
void read(CommandReader& from, ShapeDef& x);
void write(CommandWriter& to, const MassProperties& x);
void read(CommandReader& from, MassProperties& x);
void write(CommandWriter& to, const BodyDef& x);
void read(CommandReader& from, BodyDef& x);
void write(CommandWriter& to, const CharacterDef& x);
void read(CommandReader& from, CharacterDef& x);
void write(CommandWriter& to, const JointSpring& x);
void read(CommandReader& from, JointSpring& x);
void write(CommandWriter& to, const JointRange& x);
void read(CommandReader& from, JointRange& x);
void write(CommandWriter& to, const JointMotor& x);
void read(CommandReader& from, JointMotor& x);
void write(CommandWriter& to, const JointControl& x);
void read(CommandReader& from, JointControl& x);
void write(CommandWriter& to, const FixedJoint& x);
void read(CommandReader& from, FixedJoint& x);
void write(CommandWriter& to, const BallJoint& x);
void read(CommandReader& from, BallJoint& x);
void write(CommandWriter& to, const HingeJoint& x);
void read(CommandReader& from, HingeJoint& x);
void write(CommandWriter& to, const SliderJoint& x);
void read(CommandReader& from, SliderJoint& x);
void write(CommandWriter& to, const CylindricalJoint& x);
void read(CommandReader& from, CylindricalJoint& x);
void write(CommandWriter& to, const UniversalJoint& x);
void read(CommandReader& from, UniversalJoint& x);
void write(CommandWriter& to, const DistanceJoint& x);
void read(CommandReader& from, DistanceJoint& x);
void write(CommandWriter& to, const WheelJoint& x);
void read(CommandReader& from, WheelJoint& x);
void write(CommandWriter& to, const ServoJoint& x);
void read(CommandReader& from, ServoJoint& x);
void write(CommandWriter& to, const GearJoint& x);
void read(CommandReader& from, GearJoint& x);
void write(CommandWriter& to, const RackJoint& x);
void read(CommandReader& from, RackJoint& x);
void write(CommandWriter& to, const PulleyJoint& x);
void read(CommandReader& from, PulleyJoint& x);
void write(CommandWriter& to, const JointLimit& x);
void read(CommandReader& from, JointLimit& x);
void write(CommandWriter& to, const JointDrive& x);
void read(CommandReader& from, JointDrive& x);
void write(CommandWriter& to, const GeneralJoint& x);
void read(CommandReader& from, GeneralJoint& x);
void write(CommandWriter& to, const Joint& x);
void read(CommandReader& from, Joint& x);
void write(CommandWriter& to, const JointDef& x);
void read(CommandReader& from, JointDef& x);
void write(CommandWriter& to, const WorldDef& x);
void read(CommandReader& from, WorldDef& x);
void write(CommandWriter& to, const ForceField& x);
void read(CommandReader& from, ForceField& x);
void write(CommandWriter& to, const Shape& x);
void read(CommandReader& from, Shape& x);

} // namespace cairn::commands
