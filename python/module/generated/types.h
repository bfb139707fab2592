// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#pragma once

#include "module/convert.h"

namespace cairn::python {

void read(py::handle o, CombineRule& x, const Where& where);
py::object write(CombineRule x);
void read(py::handle o, BodyType& x, const Where& where);
py::object write(BodyType x);
void read(py::handle o, JointAxis& x, const Where& where);
py::object write(JointAxis x);
void read(py::handle o, JointSolver& x, const Where& where);
py::object write(JointSolver x);
void read(py::handle o, Integrator& x, const Where& where);
py::object write(Integrator x);
void read(py::handle o, ForceField::Kind& x, const Where& where);
py::object write(ForceField::Kind x);
void read(py::handle o, Transform& x, const Where& where);
py::object write(const Transform& x);
void read(py::handle o, Bounds& x, const Where& where);
py::object write(const Bounds& x);
void read(py::handle o, Sphere& x, const Where& where);
py::object write(const Sphere& x);
void read(py::handle o, Box& x, const Where& where);
py::object write(const Box& x);
void read(py::handle o, Plane& x, const Where& where);
py::object write(const Plane& x);
void read(py::handle o, Capsule& x, const Where& where);
py::object write(const Capsule& x);
void read(py::handle o, Cylinder& x, const Where& where);
py::object write(const Cylinder& x);
void read(py::handle o, Material& x, const Where& where);
py::object write(const Material& x);
void read(py::handle o, CollisionFilter& x, const Where& where);
py::object write(const CollisionFilter& x);
void read(py::handle o, ShapeDef& x, const Where& where);
py::object write(const ShapeDef& x);
void read(py::handle o, MassProperties& x, const Where& where);
py::object write(const MassProperties& x);
void read(py::handle o, BodyDef& x, const Where& where);
py::object write(const BodyDef& x);
void read(py::handle o, JointSpring& x, const Where& where);
py::object write(const JointSpring& x);
void read(py::handle o, JointRange& x, const Where& where);
py::object write(const JointRange& x);
void read(py::handle o, JointMotor& x, const Where& where);
py::object write(const JointMotor& x);
void read(py::handle o, JointControl& x, const Where& where);
py::object write(const JointControl& x);
void read(py::handle o, FixedJoint& x, const Where& where);
py::object write(const FixedJoint& x);
void read(py::handle o, BallJoint& x, const Where& where);
py::object write(const BallJoint& x);
void read(py::handle o, HingeJoint& x, const Where& where);
py::object write(const HingeJoint& x);
void read(py::handle o, SliderJoint& x, const Where& where);
py::object write(const SliderJoint& x);
void read(py::handle o, CylindricalJoint& x, const Where& where);
py::object write(const CylindricalJoint& x);
void read(py::handle o, UniversalJoint& x, const Where& where);
py::object write(const UniversalJoint& x);
void read(py::handle o, DistanceJoint& x, const Where& where);
py::object write(const DistanceJoint& x);
void read(py::handle o, WheelJoint& x, const Where& where);
py::object write(const WheelJoint& x);
void read(py::handle o, ServoJoint& x, const Where& where);
py::object write(const ServoJoint& x);
void read(py::handle o, GearJoint& x, const Where& where);
py::object write(const GearJoint& x);
void read(py::handle o, RackJoint& x, const Where& where);
py::object write(const RackJoint& x);
void read(py::handle o, PulleyJoint& x, const Where& where);
py::object write(const PulleyJoint& x);
void read(py::handle o, JointLimit& x, const Where& where);
py::object write(const JointLimit& x);
void read(py::handle o, JointDrive& x, const Where& where);
py::object write(const JointDrive& x);
void read(py::handle o, GeneralJoint& x, const Where& where);
py::object write(const GeneralJoint& x);
void read(py::handle o, JointDef& x, const Where& where);
py::object write(const JointDef& x);
py::object write(const JointState& x);
py::object write(const RayHit& x);
py::object write(const ShapeCastHit& x);
py::object write(const ClosestPoint& x);
py::object write(const ContactBegin& x);
py::object write(const ContactEnd& x);
py::object write(const ContactHit& x);
py::object write(const TriggerEvent& x);
py::object write(const JointEvent& x);
py::object write(const SleepEvent& x);
py::object write(const ContactPoint& x);
py::object write(const Contact& x);
void read(py::handle o, WorldDef& x, const Where& where);
py::object write(const WorldDef& x);
void read(py::handle o, ForceField& x, const Where& where);
py::object write(const ForceField& x);
py::object write(const StageTimes& x);
py::object write(const Statistics& x);
py::object write(const SnapshotSizes& x);
void read(py::handle o, Shape& x, const Where& where);
py::object write(const Shape& x);
void read(py::handle o, Joint& x, const Where& where);
py::object write(const Joint& x);

} // namespace cairn::python
