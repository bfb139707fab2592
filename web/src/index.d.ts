// Made by tools/api.py from api/: change those, and run it.
/** What a call that was refused throws. The world is as it was before the call. */
export class CairnError extends Error {
    readonly name: 'CairnError';
    /** What kind of error it is. */
    readonly code: CairnErrorCode;
    /** The argument or member that it is about, such as `BodyDef.mass`; may be empty. */
    readonly field: string;
    /** What that was; may be empty. */
    readonly value: string;
}

/**
 * `invalidValue`: an argument is NaN, infinite, of another type, or out of its range. `invalidHandle`: a handle is null, stale, or
 * of another world. `wrongState`: the call is not allowed now, as of a world that was disposed of. `invalidFile`: a file is
 * malformed. `unsupported`: a well-formed request for something that this build does not do. `io`: a file could not be read.
 * `outOfMemory`: the world is as it was, or refuses all until it is restored. `other`: what none of these says.
 */
export type CairnErrorCode =
    'invalidValue' | 'invalidHandle' | 'wrongState' | 'invalidFile' | 'unsupported' | 'io' | 'outOfMemory' | 'other';

/**
 * Loads the engine. Every other call needs it, and throws `wrongState` before it is done. Further calls return the same
 * promise. `source`: where the file `cairn.wasm` of the package is, or what is in it; left out: beside this module. Rejects with
 * `io` where it cannot be read, with `invalidFile` where something else is there, and with `wrongState` after `init` of
 * `cairn-physics/mt`.
 */
export default function init(source?: string | URL | Response | Promise<Response> | ArrayBuffer | ArrayBufferView |
    WebAssembly.Module): Promise<void>;
export { init };

/** The version of the engine, such as "0.1.0". */
export function version(): string;

/**
 * The spring with which what a joint moves swings at `hertz` (> 0) with that ratio to critical damping (>= 0). Throws
 * invalidValue.
 */
export function springFromFrequency(hertz: number, dampingRatio: number): Complete<JointSpring>;

/** All layers, for queries. */
export const ALL_LAYERS: bigint;

export interface Vec2 { x: number; y: number }
/** Directions, extents, velocities and places, in SI units. */
export interface Vec3 { x: number; y: number; z: number }
/** A rotation as a unit quaternion; no rotation is 0, 0, 0, 1. */
export interface Quat { x: number; y: number; z: number; w: number }
/** What calls take for a vector: an object with its components, as three.js has them, or an array of as many numbers. */
export type Vec2Like = Readonly<Vec2> | ArrayLike<number>;
export type Vec3Like = Readonly<Vec3> | ArrayLike<number>;
export type QuatLike = Readonly<Quat> | ArrayLike<number>;

/** Handles: they name what they were made for, are stale once that is gone, and never name another. 0n: none. */
export type BodyId = bigint;
export type ShapeId = bigint;
export type JointId = bigint;
export type ForceFieldId = bigint;

/** A definition as calls return it: with all of its members, vectors as objects. */
export type Complete<T> = { -readonly [K in keyof T]-?: CompleteMember<Exclude<T[K], undefined>> };
type CompleteMember<T> =
    Vec2Like extends T ? Vec2 | Extract<T, null>
    : Vec3Like extends T ? Vec3 | Extract<T, null>
    : QuatLike extends T ? Quat | Extract<T, null>
    : bigint extends T ? bigint
    : T extends Geometry | null | string | number | boolean ? T
    : T extends readonly (infer E)[] ? CompleteMember<E>[]
    : Complete<T>;

/**
 * How the coefficients of two touching materials become one. Where the two materials disagree on the rule, the stronger
 * one counts, in the order average > minimum > maximum > multiply (KHR_physics_rigid_bodies). `average`: The mean of
 * both. `minimum`: The smaller one. `maximum`: The greater one. `multiply`: The product of both.
 */
export type CombineRule = 'average' | 'minimum' | 'maximum' | 'multiply';

/**
 * How a body moves. `static`: Never moves by itself. `kinematic`: Moves with the velocity it is given, and turns about
 * its origin; nothing pushes it. `dynamic`: Moves by forces and contacts.
 */
export type BodyType = 'static' | 'kinematic' | 'dynamic';

/**
 * What a character is on. `none`: It is in the air, or flies. `steep`: It slides down something steeper than
 * `CharacterDef.maxSlope`. `ground`: It stands.
 */
export type CharacterSupport = 'none' | 'steep' | 'ground';

/**
 * What a limit or drive of a general joint is about. `linear`: A distance along axes. `angular`: An angle about axes.
 */
export type JointAxis = 'linear' | 'angular';

/**
 * How a joint is solved. Both give the same motion; they differ in cost and stiffness. `automatic`: Direct in chains,
 * machines, robots whose angles servos hold, and under high mass ratios as long as it pays, and where it hangs together
 * with joints that are asked to be direct; else iterative. `iterative`: 8 joints at a time, one after the other, with
 * the contacts. For nets and heaps of many joints. `direct`: All direct joints that hang together at once. With their
 * motors, springs, friction and limits. For chains, machines, robots, and what must not give at all. Gears, racks and
 * pulleys stay iterative; so do all of a net of thousands of joints, whose factorization would not end.
 */
export type JointSolver = 'automatic' | 'iterative' | 'direct';

/**
 * The trees of the broad phase. Planes are in none. `fixed`: Of what is fixed. `awake`: Of what is awake. `large`: Of
 * what is awake and large beside the others. `sleeping`: Of what sleeps, with a tree for each island below that of all
 * islands.
 */
export type BroadPhaseTree = 'fixed' | 'awake' | 'large' | 'sleeping';

/**
 * How free motion is integrated over a substep of length h. Contacts work with all of them. `semiImplicitEuler`: v += h
 * a, then x += h v. Bounded energy error; the default. `explicitEuler`: x += h v, then v += h a. Gains energy; kept for
 * teaching. `rk4`: Classic fourth-order Runge-Kutta.
 */
export type Integrator = 'semiImplicitEuler' | 'explicitEuler' | 'rk4';

/**
 * What a force field does. `uniform`: The same everywhere, along `direction`. `radial`: Towards `center`, `strength` x
 * distance^`exponent`. `fluid`: A fluid with a level surface through `center`, which flows with the velocity
 * `direction`.
 */
export type ForceFieldKind = 'uniform' | 'radial' | 'fluid';

/** A pose: rotate by `rotation`, then translate by `position` (meters). */
export interface Transform {
    /** Meters. */
    position?: Vec3Like;
    /** A unit quaternion. */
    rotation?: QuatLike;
}

/** An axis-aligned box in world space, in meters. Empty when any `min` exceeds its `max`. */
export interface Bounds {
    /** Least coordinates, meters. */
    min?: Vec3Like;
    /** Greatest coordinates, meters. */
    max?: Vec3Like;
}

/** A ball around the shape's origin. `radius` in meters, > 0. */
export interface Sphere {
    /** Meters, > 0. */
    radius?: number;
}

/**
 * A box around the shape's origin. `halfExtents` in meters, each > 0. A Box, a Cylinder or a Hull with `rounding` r > 0
 * is that solid plus a ball of radius r: all that is within r of the sharp solid (its Minkowski sum with the ball). It
 * is larger by r on every side, its faces stay flat, and its edges and corners are round with radius r. To keep the
 * outer size, take r off the half extents.
 */
export interface Box {
    /** Meters, each > 0, of the sharp box: the rounding comes on top. */
    halfExtents?: Vec3Like;
    /** Meters, >= 0: radius of the ball that is added to the sharp box. */
    rounding?: number;
}

/**
 * A plane through the shape's origin; solid is the side away from `normal`. Without `halfExtents` it is an infinite
 * half-space. With them it is a rectangle, `halfExtents[0]` along the shape's `tangent` and `halfExtents[1]` along
 * normal x tangent; the rectangle is one-sided, and pushes along its normal whatever is above it or has sunk in so that
 * a part of it is still above. Where one half extent is infinite, it is a strip: without ends along that axis.
 * Double-sided, it is a sheet without thickness that holds things on both sides: an infinite one pushes a body to the
 * side where its center of mass is, a rectangle or strip pushes a shape to the side where the shape's middle is. Rays
 * and casts meet a sheet from either side, and nothing is inside of it. Planes have no mass: they may only be added to
 * static and kinematic bodies.
 */
export interface Plane {
    /** Any non-zero finite vector; it is normalized. */
    normal?: Vec3Like;
    /** Only for the rectangle; made orthogonal to `normal`. */
    tangent?: Vec3Like;
    /** Meters, each > 0, one may be infinite; absent for an infinite plane. */
    halfExtents?: Vec2Like | null;
    /** A sheet that holds things on both sides. */
    doubleSided?: boolean;
}

/**
 * The convex hull of two balls on the shape's y axis, their centers at -halfHeight and +halfHeight. Meters, all > 0
 * (`radiusTop` >= 0).
 */
export interface Capsule {
    /** Meters, > 0, along the y axis. */
    halfHeight?: number;
    /** Of both balls, or of the lower one if `radiusTop` is given. (m, > 0) */
    radius?: number;
    /** Of the upper ball: a tapered capsule. (m, >= 0) */
    radiusTop?: number | null;
}

/**
 * A solid cylinder around the shape's y axis, from -halfHeight to +halfHeight. Meters, all > 0 (`radiusTop` >= 0);
 * without its rounding.
 */
export interface Cylinder {
    /** Meters, > 0, along the y axis. */
    halfHeight?: number;
    /** At both ends, or at the lower end if `radiusTop` is given. (m, > 0) */
    radius?: number;
    /** At the upper end: a tapered cylinder, or with 0 a cone. (m, >= 0) */
    radiusTop?: number | null;
    /** Meters, >= 0: radius of the ball that is added to the sharp cylinder. */
    rounding?: number;
}

/** A convex polyhedron. */
export interface Hull {
    /** Made by `cairnGeometryCreateHull`. */
    geometry: Geometry;
    /** Meters, >= 0: radius of the ball that is added to the sharp polyhedron. */
    rounding?: number;
}

/** A surface of triangles, for static and kinematic bodies. Solid is the side that sees the corners clockwise. */
export interface Mesh {
    /** Made by `cairnGeometryCreateMesh`. */
    geometry: Geometry;
}

/** A surface over a grid in the shape's xz plane, solid below, for static and kinematic bodies. */
export interface HeightField {
    /** Made by `cairnGeometryCreateHeightField`. */
    geometry: Geometry;
}

/** Surface properties of a shape. */
export interface Material {
    /** Coulomb coefficient while the contact sticks, >= 0. */
    staticFriction?: number;
    /** Coulomb coefficient while it slides, >= 0. */
    dynamicFriction?: number;
    /** Ratio of rebound to approach speed, 0 (no bounce) to 1 (elastic). (0 to 1) */
    restitution?: number;
    /** Lever arm of the rolling resistance torque in meters, >= 0. */
    rollingFriction?: number;
    /**
     * Radius of the contact patch in meters, >= 0: a spinning one-point contact feels a torque of at most friction x
     * normal force x this radius. Without any, a ball that spins upright never comes to rest.
     */
    torsionalFriction?: number;
    /** How its friction and the other material's become one. */
    frictionCombine?: CombineRule;
    /** How its restitution and the other material's become one. */
    restitutionCombine?: CombineRule;
}

/** Which shapes meet: two do if each is in a layer that the other collides with. */
export interface CollisionFilter {
    /** The layers that the shape is in, one bit each. */
    layers?: bigint | number;
    /** The layers that it collides with. */
    collidesWith?: bigint | number;
}

/** How a shape is attached to its body. */
export interface ShapeDef {
    /** Origin of the shape in the body's frame, meters; within 1e15. */
    position?: Vec3Like;
    /** Orientation in the body's frame; normalized, must not be zero. */
    rotation?: QuatLike;
    /** kg/m^3, >= 0; 0 adds no mass. Ignored by planes. */
    density?: number;
    /** Of its surface. */
    material?: Material;
    /** What it meets. */
    filter?: CollisionFilter;
    /** A trigger touches nothing: it only reports what overlaps it (trigger events). */
    isTrigger?: boolean;
    /**
     * m/s, in the shape's frame: the surface moves with it like a conveyor belt, beside the motion of the body. Only
     * its part along the surface counts. Static and kinematic bodies only.
     */
    surfaceVelocity?: Vec3Like;
    /** Not touched by the engine. */
    userData?: bigint | number;
    /**
     * A direction in the shape's frame, of any length. Not zero: the shape holds only what came from there. What is not
     * wholly beyond it in that direction when the two meet goes through it, until it is: onto such a platform one jumps
     * from below. Static and kinematic bodies only; infinite planes, meshes and height fields have none. Rays, casts
     * and other queries meet it from all sides.
     */
    oneWay?: Vec3Like;
}

/**
 * Mass, center of mass and inertia of a body. A `mass` of +infinity, and zero entries of `inertiaDiagonal`, stand for
 * what cannot be moved or turned.
 */
export interface MassProperties {
    /** kg, > 0; may be infinite. */
    mass?: number;
    /** In the body's frame, meters. */
    centerOfMass?: Vec3Like;
    /** Principal moments about the center of mass, kg m^2. */
    inertiaDiagonal?: Vec3Like;
    /** Rotation from principal axes to the body's frame. */
    inertiaOrientation?: QuatLike;
}

/** Everything needed to make a body. */
export interface BodyDef {
    /** How it moves. */
    type?: BodyType;
    /** Origin of the body's frame (not its center of mass), meters. */
    position?: Vec3Like;
    /** Normalized on entry; must not be zero. */
    rotation?: QuatLike;
    /** Of the center of mass, m/s. */
    linearVelocity?: Vec3Like;
    /** In world axes, rad/s. */
    angularVelocity?: Vec3Like;
    /** 1/s, >= 0: velocity decays as v' = -damping v. */
    linearDamping?: number;
    /** 1/s, >= 0. */
    angularDamping?: number;
    /** Multiplies the world's gravity for this body; any finite value. */
    gravityScale?: number;
    /** false: the body and its island never fall asleep. */
    allowSleep?: boolean;
    /** kg, > 0 (+infinity: immovable). Left out: from the shapes' densities. */
    mass?: number | null;
    /** Overrides mass and shapes altogether. */
    massProperties?: MassProperties | null;
    /** For people; need not be unique. */
    name?: string;
    /** Not touched by the engine. */
    userData?: bigint | number;
    /** false: it takes no part in the world until it is enabled. */
    enabled?: boolean;
}

/**
 * How a character moves. A character is a kinematic body that is moved at the beginning of each step: it slides along
 * walls, climbs steps, stands on slopes, falls, is carried by what it stands on, and never passes through anything that
 * its shapes collide with. Its shapes must be convex to count; a capsule along `up` is usual. It does not turn by
 * itself, but for what it stands on.
 */
export interface CharacterDef {
    /** Away from the ground; any non-zero vector, it is normalized. */
    up?: Vec3Like;
    /** rad, 0 to 1.57: it slides down what is steeper, and does not walk up there. */
    maxSlope?: number;
    /** m, >= 0: it climbs steps up to this height; 0: none. */
    stepHeight?: number;
    /** m, >= 0: it stays on ground that falls away by up to this in a step. */
    stickDistance?: number;
    /** m, 1e-4 to 1: the distance that it keeps from everything. */
    skin?: number;
    /** kg, >= 0: what dynamic bodies feel that it stands on, lands on or jumps off. */
    mass?: number;
    /** N, >= 0: it pushes dynamic bodies out of its way with no more than this. */
    maxPushForce?: number;
    /** m/s^2, >= 0: how fast its velocity follows the wanted one in the air. */
    airAcceleration?: number;
    /**
     * It moves with the wanted velocity in all directions, without gravity, ground and steps: for swimming, ladders,
     * flying.
     */
    flies?: boolean;
}

/** How a character moves, as it stood after the last step. */
export interface CharacterState {
    /** What it is on. */
    support: CharacterSupport;
    /**
     * m/s, in world axes, that of the ground included. Unlike the velocity of its body, which is by how much the last
     * step moved it, it is without steps that were climbed, and in the air it is that at the end of the step.
     */
    velocity: Vec3;
    /** What it is on; null in the air, and when that was removed. */
    groundShape: ShapeId;
    /** Its body. */
    groundBody: BodyId;
    /** Where it touches that, m; valid unless `support` is none. */
    groundPoint: Vec3;
    /** Unit, out of it; likewise. */
    groundNormal: Vec3;
    /** m/s, of its material there; likewise. */
    groundVelocity: Vec3;
}

/** A damped spring. It is stepped implicitly: any stiffness is stable. */
export interface JointSpring {
    /** N/m or N m/rad, >= 0. */
    stiffness?: number;
    /** N s/m or N m s/rad, >= 0. */
    damping?: number;
    /**
     * true: both are per unit of the mass (or moment of inertia) that the joint moves along that axis, so that the
     * motion, not the force, is given.
     */
    isAcceleration?: boolean;
}

/** The range of a position, m or rad. `lower` = `upper` holds it at one value. */
export interface JointRange {
    /** lower <= upper; -infinity and +infinity for no bound. (m or rad) */
    lower?: number;
    /** lower <= upper; -infinity and +infinity for no bound. (m or rad) */
    upper?: number;
    /** Pushes back from beyond a bound; Left out: rigid. */
    spring?: JointSpring | null;
}

/** What drives an axis: with a spring, towards `position` and `velocity`; without one, it holds the velocity. */
export interface JointMotor {
    /** m/s or rad/s. */
    velocity?: number;
    /** m or rad; only with a spring. */
    position?: number;
    /** Left out: the motor holds its velocity. */
    spring?: JointSpring | null;
    /** N or N m, >= 0. */
    maxForce?: number;
}

/** All that can act along one axis of a joint. */
export interface JointControl {
    /** Left out: no limits. */
    limits?: JointRange | null;
    /** Left out: no motor. */
    motor?: JointMotor | null;
    /** N or N m, >= 0: dry friction, which holds until it is overcome. */
    friction?: number;
}

/** B keeps its place and rotation against A. */
export interface FixedJoint {
}

/** The origins of the frames coincide; B turns freely. */
export interface BallJoint {
    /** rad, 0 to pi: greatest angle between the x axes of the two frames. */
    coneAngle?: number | null;
    /** Of the angle about the x axis, -pi to pi. */
    twist?: JointRange | null;
    /** N m about each axis, >= 0. */
    friction?: number;
}

/**
 * B turns about the x axis of A. Its angle is counted on beyond a full turn while a limit, motor or friction acts on
 * it; without any it is between -pi and pi.
 */
export interface HingeJoint {
    /** About the x axis of A. */
    angle?: JointControl;
}

/** B moves along the x axis of A without turning. */
export interface SliderJoint {
    /** Along the x axis of A. */
    translation?: JointControl;
}

/** B moves along the x axis of A and turns about it. */
export interface CylindricalJoint {
    /** Along the x axis of A. */
    translation?: JointControl;
    /** About the x axis of A. */
    angle?: JointControl;
}

/** A cross of two axes at a right angle: A turns about its x axis, B about its y axis (a Cardan joint). */
export interface UniversalJoint {
    /** About the x axis of A. */
    first?: JointControl;
    /** About the y axis of B. */
    second?: JointControl;
}

/**
 * The distance between the origins of the frames. A rod has lower = upper, a rope lower = 0, a spring a motor with a
 * spring at its length at rest.
 */
export interface DistanceJoint {
    /** Between the origins of the frames. */
    distance?: JointControl;
}

/**
 * A wheel B under a car A. The wheel moves along the x axis of A (the suspension), turns about it (the steering) and
 * spins about its own y axis.
 */
export interface WheelJoint {
    /** Along the x axis of A. */
    suspension?: JointControl;
    /** Left out: the wheel does not steer. */
    steering?: JointControl | null;
    /** About the y axis of the wheel. */
    spin?: JointControl;
}

/** A servo that moves B to a place and rotation in the frame of A. */
export interface ServoJoint {
    /** Of the origin of frame B in frame A, meters. */
    position?: Vec3Like;
    /** Of frame B in frame A; normalized. */
    rotation?: QuatLike;
    /** The spring that pulls B to its place. */
    linear?: JointSpring;
    /** The spring that turns B to its rotation. */
    angular?: JointSpring;
    /** N along each axis, >= 0. */
    maxForce?: number;
    /** N m about each axis, >= 0. */
    maxTorque?: number;
}

/**
 * Two turning bodies in mesh: (rate of A about its frame's x axis) + ratio x (rate of B about its own) = 0. With teeth
 * in mesh on the outside of both, about parallel axes, ratio = teeth of B / teeth of A. Rates are those against the
 * world: the bodies that carry the axles must not turn about them.
 */
export interface GearJoint {
    /** Not 0. */
    ratio?: number;
}

/**
 * A pinion A on a rack B: (translation of B along its frame's x axis) = radius x (angle of A about its frame's x axis),
 * as against the world.
 */
export interface RackJoint {
    /** m, not 0; negative for the other sense. */
    radius?: number;
}

/** A rope over two fixed pulleys: length at A + ratio x length at B <= length. */
export interface PulleyJoint {
    /** World points from which the bodies hang. */
    groundA?: Vec3Like;
    /** World points from which the bodies hang. */
    groundB?: Vec3Like;
    /** > 0: of a block and tackle. */
    ratio?: number;
    /** m, > 0; Left out: what it is when the joint is made, which `World.jointDef` then has. */
    length?: number | null;
}

/**
 * Keeps a distance (m) or an angle (rad) between the two frames in a range. With one axis: along or about it; with two:
 * from the line of the remaining axis, or of the cone about it; with three: of points, or any turn.
 */
export interface JointLimit {
    /** Whether it is about distances or angles. */
    kind?: JointAxis;
    /** x, y and z of frame A; one to three of them. */
    axes?: readonly (boolean)[];
    /** Left out: no bound on that side. min <= max. */
    min?: number | null;
    /** Left out: no bound on that side. min <= max. */
    max?: number | null;
    /** N/m or N m/rad, >= 0; Left out: rigid. */
    stiffness?: number | null;
    /** N s/m or N m s/rad, >= 0; with a stiffness only. */
    damping?: number;
}

/**
 * A damped spring or motor along or about one axis: pushes with stiffness x (positionTarget - position) + damping x
 * (velocityTarget - velocity).
 */
export interface JointDrive {
    /** Whether it is about distances or angles. */
    kind?: JointAxis;
    /** true: the above is an acceleration; false: a force or torque. */
    isAcceleration?: boolean;
    /** 0, 1 or 2, of frame A. */
    axis?: number;
    /** N or N m, >= 0; Left out: no bound. */
    maxForce?: number | null;
    /** Where the spring pulls to. (m or rad) */
    positionTarget?: number;
    /** What the damping aims at. (m/s or rad/s) */
    velocityTarget?: number;
    /** Of the spring, >= 0. (N/m or N m/rad) */
    stiffness?: number;
    /** Of the spring, >= 0. (N s/m or N m s/rad) */
    damping?: number;
}

/**
 * The joint of the glTF draft KHR_physics_rigid_bodies: six degrees of freedom, and any of them limited or driven. At
 * most eight limits and drives that are not plain locks.
 */
export interface GeneralJoint {
    /** What is kept in a range. */
    limits?: readonly (JointLimit)[];
    /** What is driven. */
    drives?: readonly (JointDrive)[];
}

/** Everything needed to make a joint. */
export interface JointDef {
    /** Null: the world. At least one must be dynamic; not the same body. */
    bodyA?: BodyId | Body | null;
    /** Null: the world. At least one must be dynamic; not the same body. */
    bodyB?: BodyId | Body | null;
    /** In the frames of the bodies; of the world, in its own. */
    frameA?: Transform;
    /** In the frames of the bodies; of the world, in its own. */
    frameB?: Transform;
    /** What kind of joint, and how it is limited and driven. */
    joint?: Joint;
    /** Whether the two bodies collide with each other. */
    enableCollision?: boolean;
    /** N, > 0: the joint breaks beyond it. */
    breakForce?: number;
    /** N m, > 0. */
    breakTorque?: number;
    /** How it is solved. */
    solver?: JointSolver;
    /** For people; need not be unique. */
    name?: string;
    /** Not touched by the engine. */
    userData?: bigint | number;
    /** false: it acts on nothing, as if it were not there. */
    enabled?: boolean;
}

/** What a joint did in the last step. */
export interface JointState {
    /** N: mean force on B, world axes. */
    force: Vec3;
    /** N m: mean torque on B about the origin of its frame, world axes. */
    torque: Vec3;
    /**
     * The positions of its axes (m or rad), in the order of the fields of its type: of a hinge the angle, of a
     * cylindrical joint translation and angle, of a general joint those of its limits and drives that are not plain
     * locks.
     */
    positions: number[];
    /** How many of `positions` there are. */
    positionCount: number;
    /** m: how far the points that it holds together are apart. */
    linearError: number;
    /** rad: how far B has turned about the axes that it locks. */
    angularError: number;
}

/** The nearest thing that a ray met. */
export interface RayHit {
    shape: ShapeId;
    body: BodyId;
    /** On the surface, meters. */
    point: Vec3;
    /** Unit outward normal of the surface there. */
    normal: Vec3;
    /** From the ray's origin, meters. */
    distance: number;
    /**
     * Of a mesh: the one of its triangles that the ray met, in the order of its indices; of a height field: twice the
     * number of its cell, row after row, and 1 more for the half on the side of greatest x. Of other shapes -1.
     */
    triangle: number;
}

/** The first thing that a moving shape met. */
export interface ShapeCastHit {
    shape: ShapeId;
    body: BodyId;
    /** Of the translation, 0 to 1; 0 if they overlapped from the start. */
    fraction: number;
    /** Where they meet, meters. */
    point: Vec3;
    /** Unit, out of the shape that was met. */
    normal: Vec3;
    /** That was met; as in RayHit. */
    triangle: number;
}

/** The surface point nearest to a given one. */
export interface ClosestPoint {
    shape: ShapeId;
    body: BodyId;
    /** On the surface, meters; the given point itself if that lies inside. */
    point: Vec3;
    /** Meters; 0 inside. */
    distance: number;
    /** That it is on; as in RayHit. */
    triangle: number;
}

/**
 * A box of a tree of the broad phase. It holds the boxes below it, up to eight; those of nodes side by side may
 * overlap.
 */
export interface BroadPhaseNode {
    /** Meters; of a shape, somewhat larger than the shape. */
    bounds: Complete<Bounds>;
    /** The one that it is in. */
    tree: BroadPhaseTree;
    /** 0: the root of the tree. */
    depth: number;
    /** Its place in the list; -1: it is a root. */
    parent: number;
    /** It is the box of one shape. */
    isLeaf: boolean;
    /** Of a leaf; else null. */
    shape: ShapeId;
}

/**
 * How the solver works on a touching pair of shapes, as it stood after the last step; for pictures and measurements.
 */
export interface SolverContact {
    shapeA: ShapeId;
    shapeB: ShapeId;
    bodyA: BodyId;
    bodyB: BodyId;
    /**
     * Contacts of one color share no body that moves by forces, so they are solved side by side; colors take turns, the
     * lowest first, and those with what does not move by forces come last. -1: no color was free; solved one by one,
     * before all others.
     */
    color: number;
    /** Of its island in the last step in which that was awake; 0: not solved yet. */
    substeps: number;
}

/** What debug lines show. */
export interface DebugLinesDef {
    /**
     * Edges of shapes; of infinite planes a grid of 20 m. Bodies that are static, kinematic, awake and asleep, and
     * triggers, have colors of their own.
     */
    shapes?: boolean;
    /** Boxes around shapes, along the axes of the world. */
    bounds?: boolean;
    /** The axes of inertia at the centers of mass of dynamic bodies: x red, y green, z blue. */
    centers?: boolean;
    /** From each center of mass of what moves to where it is in a tenth of a second. */
    velocities?: boolean;
    /** At each point that touches, the normal. */
    contacts?: boolean;
    /** From both centers of mass to the anchors, and the axes of the joint there. */
    joints?: boolean;
    /** The length of axes, and of normals. (> 0) */
    size?: number;
    /** Not 0: a normal is as long as this times the impulse at its point. (m/(N s), >= 0) */
    impulseScale?: number;
}

/** A straight line. */
export interface DebugLine {
    /** In world space. (m) */
    begin: Vec3;
    /** In world space. (m) */
    end: Vec3;
    /** Red, green and blue, 0 to 1. */
    color: Vec3;
}

/** Which shapes a query sees: those that pass all of it. */
export interface QueryFilter {
    /** Those that are in any of these layers (`CollisionFilter.layers`). */
    layers?: bigint | number;
    /** Those that collide with any of these, in which the query itself is. */
    ownLayers?: bigint | number;
    /** Those of static bodies. */
    staticBodies?: boolean;
    /** Those of kinematic bodies. */
    kinematicBodies?: boolean;
    /** Those of dynamic bodies. */
    dynamicBodies?: boolean;
    /** Triggers as well; they are seen like any other shape then. */
    triggers?: boolean;
    /**
     * Any one is enough: the first that is found, rather than the nearest, and of overlaps a single one. Faster, where
     * only the question is whether there is any.
     */
    any?: boolean;
    /** Shapes of these are not seen. Each must exist. */
    ignoredBodies?: readonly (BodyId | Body | null)[];
}

/** Two shapes began to touch. */
export interface ContactBegin {
    shapeA: ShapeId;
    shapeB: ShapeId;
    bodyA: BodyId;
    bodyB: BodyId;
}

/** Two shapes no longer touch, or one of them was removed (its handles are stale then). */
export interface ContactEnd {
    shapeA: ShapeId;
    shapeB: ShapeId;
    bodyA: BodyId;
    bodyB: BodyId;
}

/** Two shapes began to touch with an approach speed of at least WorldDef.hitSpeed. */
export interface ContactHit {
    shapeA: ShapeId;
    shapeB: ShapeId;
    bodyA: BodyId;
    bodyB: BodyId;
    /** Meters, world space. */
    point: Vec3;
    /** Unit, from A to B. */
    normal: Vec3;
    /** m/s, > 0. */
    approachSpeed: number;
    /**
     * When they met: seconds after the beginning of the last step, 0 to its length (but for rounding). Of what bounces
     * or passes far in a step, the moment of the impact, on a straight way through the step: with gravity at 60 Hz that
     * is within 0.4 mm of the true way. Of what comes to rest on something, and of bodies that touch others already or
     * hang on joints: when the gap would close at the approach speed with which the step (or the pass of it, where
     * something spins) began, without what forces and other contacts do until then; at the end of it at the latest, as
     * the solver may stop it a substep early, and at its beginning if they overlapped by then. Hits are not listed in
     * its order. (0 to the step)
     */
    time: number;
    /**
     * Of a mesh or height field, where it was hit: the number of its material there (0: that of the shape). Of other
     * shapes 0.
     */
    surfaceMaterial: number;
}

/**
 * A shape began or ceased to overlap a trigger (ShapeDef.isTrigger). Triggers see what is on dynamic and kinematic
 * bodies, characters too; those on dynamic and kinematic bodies see static ones as well. They do not see each other. It
 * is seen at the beginning of each step: what comes in is told after the next one. What passes through within a step
 * has both events in that one, behind those of the beginning, in the order of their times. Handles of what was removed
 * are stale.
 */
export interface TriggerEvent {
    trigger: ShapeId;
    other: ShapeId;
    triggerBody: BodyId;
    otherBody: BodyId;
    /** true: it came in; false: it left, or one of the two was removed. */
    inside: boolean;
    /**
     * Seconds after the beginning of the last step, 0 to its length: 0 for what is seen there; of what passes within
     * it, when it came in and when it left, on the way that it took. (0 to the step)
     */
    time: number;
}

/** A joint is gone: it broke under its load, or one of its bodies was destroyed. Its handle is stale. */
export interface JointEvent {
    joint: JointId;
    /** Null: the world. */
    bodyA: BodyId;
    /** Null: the world. */
    bodyB: BodyId;
    /** false: a body was destroyed. */
    broke: boolean;
    /** N: at which it broke. */
    force: number;
    /** N m: likewise. */
    torque: number;
    /** Of its definition. */
    userData: bigint;
}

/** A body fell asleep or woke up. */
export interface SleepEvent {
    body: BodyId;
    /** false: it woke up. */
    asleep: boolean;
}

/** One point of a contact. */
export interface ContactPoint {
    /** Midway between the two surfaces, meters. */
    point: Vec3;
    /** Meters; negative when the shapes overlap. */
    separation: number;
    /** N s during the last step, >= 0. Divide by the step for the mean force. */
    normalImpulse: number;
}

/**
 * A touching pair of shapes as it stood after the last step. A shape may touch a mesh or height field, and the surfaces
 * of several of its faces, in several of these, one for each normal and material.
 */
export interface Contact {
    shapeA: ShapeId;
    shapeB: ShapeId;
    bodyA: BodyId;
    bodyB: BodyId;
    /** Unit, from A to B. */
    normal: Vec3;
    /** N s on B during the last step, world axes. */
    frictionImpulse: Vec3;
    /** 1 to 4. */
    pointCount: number;
    /** The first `pointCount` of them. */
    points: ContactPoint[];
    /** Of a mesh or height field there: the number of its material (0: that of the shape). Of other shapes 0. */
    surfaceMaterial: number;
}

/** Settings of a world. All may be changed later through `World.setSettings`. */
export interface WorldDef {
    /** m/s^2, finite. */
    gravity?: Vec3Like;
    /**
     * Solver substeps of one step, 1 to 256; or 0: as many as make them no longer than 1/360 s (6 at 60 Hz, 2 at 240
     * Hz). (0 to 256)
     */
    substeps?: number;
    /**
     * Take more in islands that ask for it: with joints (no longer than 1/660 s), high mass ratios, tall stacks, bodies
     * less than 10 cm wide.
     */
    adaptiveSubsteps?: boolean;
    /** How free motion is integrated. */
    integrator?: Integrator;
    /** Islands at rest stop costing time. */
    enableSleep?: boolean;
    /** m/s; a body slower than this at its surface may sleep. >= 0. */
    sleepSpeed?: number;
    /** s at rest before an island sleeps, unless it gains speed steadily. >= 0. */
    sleepTime?: number;
    /** m/s; slower impacts do not bounce. >= 0. */
    restitutionSpeed?: number;
    /** m/s; least approach speed for a hit event. >= 0. */
    hitSpeed?: number;
    /** m/s; overlaps are pushed apart no faster than this. > 0. */
    recoverySpeed?: number;
    /** m/s; faster bodies are slowed to this, and counted. > 0, at most 1e15. */
    maxLinearSpeed?: number;
    /** rad/s; likewise. (> 0) */
    maxAngularSpeed?: number;
}

/**
 * A field that acts on every dynamic body: an acceleration or a force, evaluated at its center of mass, or a fluid,
 * which fills a box below its level surface, lifts what is in it by the weight of what that displaces, and resists
 * motion against it.
 */
export interface ForceField {
    /** What it does. */
    kind?: ForceFieldKind;
    /** Uniform: acceleration in m/s^2 (or force in N, see `isForce`). Fluid: m/s. (m/s^2 or N or m/s) */
    direction?: Vec3Like;
    /** Radial: the point that attracts, meters. Fluid: the middle of its surface. */
    center?: Vec3Like;
    /** Radial: m/s^2 (or N) at a distance of one meter; negative repels. (m/s^2 or N) */
    strength?: number;
    /** Radial: 0 constant, 1 spring, -1, -2 gravity of a point. One of -2,-1,0,1. (-2, -1, 0 or 1) */
    exponent?: number;
    /** false: an acceleration, equal for all masses; true: a force. */
    isForce?: boolean;
    /**
     * Fluid: how far it reaches from `center` along the axes of the world, meters, > 0; may be infinite. Along the axis
     * nearest to gravity it is the depth.
     */
    halfExtents?: Vec3Like;
    /** Fluid: kg/m^3, >= 0. The default is that of water. */
    density?: number;
    /** Fluid: coefficient of what is pushed ahead, >= 0. That of a plate; a ball has half of it. */
    drag?: number;
    /** Fluid: coefficient of what is dragged along, >= 0. */
    skinFriction?: number;
    /** Fluid: how much of it moves along, >= 0, of what a body displaces; a ball: 0.5. */
    addedMass?: number;
    /** Fluid: how fast bobbing is lost to waves, >= 0, of critical damping. */
    waveDamping?: number;
}

/** Wall-clock time of the stages of the last step, in milliseconds. */
export interface StageTimes {
    /** Pairs of bounds. (ms) */
    broadPhase: number;
    /** Contact points. (ms) */
    narrowPhase: number;
    /** What is solved together. (ms) */
    islands: number;
    /** Rows of the solver. (ms) */
    prepare: number;
    /** Substeps. (ms) */
    solve: number;
    /** New places, events, sleep. (ms) */
    finalize: number;
    /** The whole step. (ms) */
    total: number;
}

/** Counts and times of the last step. */
export interface Statistics {
    /** Steps since the world was made. */
    steps: bigint;
    /** Simulated seconds since then. */
    time: number;
    /** All of them. */
    bodies: number;
    /** Those that forces move. */
    dynamicBodies: number;
    /** Those that are not asleep. */
    awakeBodies: number;
    /** All of them. */
    shapes: number;
    /** Pairs whose bounds overlap. */
    candidatePairs: number;
    /**
     * Of those, how many the last step has tested. The others were well apart or asleep, or their bodies have moved by
     * a few millimeters at most since they were.
     */
    testedPairs: number;
    /** Touching pairs of shapes, asleep ones included. */
    contacts: number;
    /** Their points. */
    contactPoints: number;
    /** Awake islands. */
    islands: number;
    /** Islands that are asleep. */
    sleepingIslands: number;
    /** Colors of contacts, which are solved one after the other. */
    colors: number;
    /** Contacts that found no free color, solved one by one. */
    overflowContacts: number;
    /** Since the world was made: velocities cut to the maximum. */
    clampedSpeeds: bigint;
    /** Most substeps that any island took. */
    maxSubsteps: number;
    /** Deepest overlap, meters, >= 0. */
    maxPenetration: number;
    /** In the last step: pairs looked at along their ways, as one moved far. */
    sweptPairs: number;
    /** In the last step: impacts of bodies in flight, several of one body included. */
    impacts: number;
    /** In the last step: bodies held where they met what the solver did not know. */
    stoppedBodies: number;
    /** Of the last step. */
    times: StageTimes;
}

/** What the bytes of a snapshot are for. */
export interface SnapshotSizes {
    /**
     * The dynamic state of the bodies and their shapes: place, rotation, velocities, where they came to rest, island,
     * time to sleep, forces. (bytes)
     */
    bodies: number;
    /** Pairs of shapes: points, and the impulses that the next step starts from. (bytes) */
    contacts: number;
    /** Impulses that the next step starts from, and positions. (bytes) */
    joints: number;
    /** Boxes, their tree, and the list of pairs. (bytes) */
    broadPhase: number;
    /** Header, counters, events that the next step will report. (bytes) */
    other: number;
    /** Once for all snapshots that share them. (bytes) */
    definitions: number;
}

/** Any shape. A compound is a body with several of them. */
export type Shape =
    | ({ kind: 'sphere' } & Sphere)
    | ({ kind: 'box' } & Box)
    | ({ kind: 'plane' } & Plane)
    | ({ kind: 'capsule' } & Capsule)
    | ({ kind: 'cylinder' } & Cylinder)
    | ({ kind: 'hull' } & Hull)
    | ({ kind: 'mesh' } & Mesh)
    | ({ kind: 'heightField' } & HeightField);

/** Any joint. */
export type Joint =
    | ({ kind: 'fixed' } & FixedJoint)
    | ({ kind: 'ball' } & BallJoint)
    | ({ kind: 'hinge' } & HingeJoint)
    | ({ kind: 'slider' } & SliderJoint)
    | ({ kind: 'cylindrical' } & CylindricalJoint)
    | ({ kind: 'universal' } & UniversalJoint)
    | ({ kind: 'distance' } & DistanceJoint)
    | ({ kind: 'wheel' } & WheelJoint)
    | ({ kind: 'servo' } & ServoJoint)
    | ({ kind: 'gear' } & GearJoint)
    | ({ kind: 'rack' } & RackJoint)
    | ({ kind: 'pulley' } & PulleyJoint)
    | ({ kind: 'general' } & GeneralJoint);

/**
 * The data of a hull, mesh or height field. It never changes; many shapes, in several worlds, may be made of it, and keep what they
 * need when it is disposed of.
 */
export class Geometry {
    private constructor();
    /**
     * The convex hull of points: x, y, z each, in meters, in the shape's frame. Throws invalidValue when a coordinate is not finite or
     * exceeds 1e6, when there are fewer than 4 points, or when they all lie in one point, on one line or in one plane.
     */
    static hull(points: readonly number[] | Float32Array | Float64Array): Geometry;
    /**
     * A surface of triangles: three indices each, counterclockwise as seen from outside; vertices are x, y, z in meters. Triangles
     * without area are left out. Throws invalidValue when a coordinate is not finite or exceeds 1e6, when an index is out of range
     * or their number is no multiple of three, or when no triangle is left. `materials`: those that parts of it have beside that of
     * the shape; `materialNumbers`: which one each triangle has, 0 for that of the shape, k for materials[k - 1]; without any, all
     * have that of the shape.
     */
    static mesh(
        vertices: readonly number[] | Float32Array | Float64Array,
        indices: readonly number[] | Uint32Array | Uint16Array,
        materials?: readonly Material[],
        materialNumbers?: readonly number[] | Uint16Array | Uint8Array,
    ): Geometry;
    /**
     * A surface over a grid: meters along y, row after row, columns x rows of them. Throws invalidValue for fewer than 2 columns or
     * rows, another number of heights, a spacing that is no size, a height that is no number or exceeds 1e6 and is not Infinity,
     * or holes alone. Triangles of which a corner has the height Infinity are holes. Materials as of a mesh, with a number for each
     * cell, row after row.
     */
    static heightField(
        columns: number,
        rows: number,
        spacing: Vec2Like,
        heights: readonly number[] | Float32Array | Float64Array,
        materials?: readonly Material[],
        materialNumbers?: readonly number[] | Uint16Array | Uint8Array,
    ): Geometry;
    /** The corners of a hull, the vertices of a mesh, or where the heights of a height field stand: x, y, z each; y of a hole is Infinity. */
    get vertices(): Float32Array;
    /** The triangles of a mesh, or of a height field that are no holes: three indices of its vertices each. Throws invalidValue for a hull. */
    get indices(): Uint32Array;
    /** The materials of a mesh or height field beside that of the shape. Throws invalidValue for a hull. */
    get materials(): Material[];
    /** Of each triangle of a mesh, or each cell of a height field; none: all have that of the shape. Throws invalidValue for a hull. */
    get materialNumbers(): Uint16Array;
    /** How many triangles of a mesh had no area. Throws invalidValue for others. */
    get droppedTriangles(): number;
    /** The faces of a hull: indices of their corners, counterclockwise as seen from outside. Throws invalidValue for others. */
    get faces(): number[][];
    /** m^3, of a hull. Throws invalidValue for others. */
    get volume(): number;
    /** The grid of a height field. Throws invalidValue for others. */
    get grid(): { columns: number; rows: number; spacing: Vec2 };
    /** The heights of a height field, row after row. Throws invalidValue for others. */
    get heights(): Float32Array;
    /** Gives its memory back. Twice: nothing happens. What is never disposed of goes when it is collected as garbage. */
    dispose(): void;
    [Symbol.dispose](): void;
}

/** The state of a world at one moment. */
export class Snapshot {
    private constructor();
    get sizes(): SnapshotSizes;
    /** Gives its memory back. Twice: nothing happens. What is never disposed of goes when it is collected as garbage. */
    dispose(): void;
    [Symbol.dispose](): void;
}

/** One body of a world, by its handle. Every call throws invalidHandle once the body is gone. Setting something wakes it. */
export class Body {
    private constructor();
    readonly world: World;
    readonly id: BodyId;
    /** Whether the body still exists. */
    get isValid(): boolean;
    /** As `World.addShape`. */
    addShape(shape: Shape, definition?: ShapeDef): ShapeId;
    /** As `World.destroyBody`. */
    destroy(): void;
    /** How the body moves. Setting: Makes the body static, kinematic or dynamic. */
    get type(): BodyType;
    set type(value: BodyType);
    /** The name of its definition. Setting: For people; need not be unique. */
    get name(): string;
    set name(value: string);
    /** The number of its definition. */
    get userData(): bigint;
    /**
     * Origin of the body's frame, meters. Setting: Teleports the origin of the body's frame: velocities stay, contacts
     * are found anew.
     */
    get position(): Vec3;
    set position(value: Vec3Like);
    /**
     * Rotation of the body's frame, of unit length. Setting: Turns the body in place: velocities stay, contacts are
     * found anew. Normalized on entry; must not be zero.
     */
    get rotation(): Quat;
    set rotation(value: QuatLike);
    /** Place and rotation of the body's frame. */
    get transform(): Complete<Transform>;
    /** In world space, meters; of kinematic bodies, their origin, if not given. */
    get centerOfMass(): Vec3;
    /** Of the center of mass, m/s. Setting: Sets the velocity of the center of mass, m/s. Not of static bodies. */
    get linearVelocity(): Vec3;
    set linearVelocity(value: Vec3Like);
    /** rad/s. Setting: Sets the angular velocity, rad/s, world axes. Not of static bodies. */
    get angularVelocity(): Vec3;
    set angularVelocity(value: Vec3Like);
    /** Of the body's material at a world point, m/s. Throws invalidHandle, invalidValue, wrongState. */
    velocityAt(point: Vec3Like): Vec3;
    /** kg; +infinity for static and kinematic bodies. */
    get mass(): number;
    /**
     * Mass, center of mass and inertia, as set or computed from the shapes. Setting: Replaces the mass properties; they
     * no longer follow the shapes. Dynamic bodies only.
     */
    get massProperties(): Complete<MassProperties>;
    set massProperties(value: MassProperties);
    /** About the center of mass, world axes, kg m^2. */
    get worldInertia(): number[];
    /** About the center of mass, kg m^2/s. */
    get angularMomentum(): Vec3;
    /** Linear and rotational, J; 0 for static and kinematic bodies. */
    get kineticEnergy(): number;
    /** What gravity is multiplied with for this body. Setting: Multiplies gravity for this body; any finite value. */
    get gravityScale(): number;
    set gravityScale(value: number);
    /** 1/s. */
    get linearDamping(): number;
    /** 1/s. */
    get angularDamping(): number;
    /** Static bodies never are; kinematic ones are while they move. */
    get isAwake(): boolean;
    /** Whether it may fall asleep. Setting: false: the body and its island never fall asleep. */
    get allowSleep(): boolean;
    set allowSleep(value: boolean);
    /**
     * Whether it takes part in the world. Setting: Takes a body out of the world and puts it back, with its shapes,
     * joints and handles as they are: for what is used again and again, or not yet. What is disabled does not move and
     * keeps its velocities; nothing touches it, queries do not see it, its joints do not act, and energies and momenta
     * are without it. All of it may be changed, but nothing can push it: forces and impulses are refused (wrongState).
     * What it touched ends with a ContactEnd, and wakes; where it is put back into something, it is pushed out as what
     * is made there.
     */
    get enabled(): boolean;
    set enabled(value: boolean);
    /** Its shapes, oldest first. */
    get shapes(): ShapeId[];
    /** Teleports the body: velocities stay, contacts are found anew. Throws invalidHandle, invalidValue, wrongState. */
    setTransform(position: Vec3Like, rotation: QuatLike): void;
    /**
     * Kinematic bodies: sets the velocities that bring the body to `target` in `seconds` (> 0). Throws invalidHandle,
     * invalidValue, wrongState.
     */
    moveTo(target: Transform, seconds: number): void;
    /** 1/s, >= 0: the velocities decay as v' = -damping v. Throws invalidHandle, invalidValue, wrongState. */
    setDamping(linear: number, angular: number): void;
    /**
     * Mass properties follow the shapes' densities again, scaled to `mass` if given. Throws invalidHandle,
     * invalidValue, wrongState.
     */
    setMassFromShapes(mass?: number | null): void;
    /** Wakes the body and its island. Throws invalidHandle, wrongState. */
    wake(): void;
    /**
     * Brings a dynamic body to rest and lets it sleep from the next step on, as it is, even in the air: before anything
     * moves, provided that all that touches it or is joined to it was told so, too, and may sleep. A level that is made
     * asleep costs nothing until something comes; then it settles like anything that is made. What moves or pushes the
     * body in between wakes it, as ever. Throws invalidHandle, wrongState.
     */
    sleep(): void;
    /** N, at the center of mass; acts during the next step only. Throws invalidHandle, invalidValue, wrongState. */
    addForce(force: Vec3Like): void;
    /** N, at a world point; next step only. Throws invalidHandle, invalidValue, wrongState. */
    addForceAt(force: Vec3Like, point: Vec3Like): void;
    /** N m; next step only. Throws invalidHandle, invalidValue, wrongState. */
    addTorque(torque: Vec3Like): void;
    /** N s, at the center of mass; changes the velocity at once. Throws invalidHandle, invalidValue, wrongState. */
    applyImpulse(impulse: Vec3Like): void;
    /** N s, at a world point. Throws invalidHandle, invalidValue, wrongState. */
    applyImpulseAt(impulse: Vec3Like, point: Vec3Like): void;
    /** N m s. Throws invalidHandle, invalidValue, wrongState. */
    applyAngularImpulse(impulse: Vec3Like): void;
    /** Whether the body is a character. */
    get isCharacter(): boolean;
    /**
     * How the character moves (wrongState unless it is one). Setting: Makes a kinematic body a character, or changes
     * how one moves. From then on its velocities are those with which each step moves it, and setting its linear
     * velocity throws it: upwards, it leaves the ground.
     */
    get character(): Complete<CharacterDef>;
    set character(value: CharacterDef);
    /** It is an ordinary kinematic body again, at rest. Throws invalidHandle, wrongState. */
    removeCharacter(): void;
    /**
     * Where the character wants to go, m/s. Setting: Where a character wants to go, m/s, until it is set anew: over the
     * ground, with this speed and, seen from above, in this direction, beside the motion of the ground itself. What of
     * it leads up or down counts for those alone that fly.
     */
    get walkVelocity(): Vec3;
    set walkVelocity(value: Vec3Like);
    /**
     * In the next step, a character that stands on the ground leaves it with this speed, m/s, > 0; others do not.
     * Throws invalidHandle, invalidValue, wrongState.
     */
    jump(speed: number): void;
    /** How the character moves and what it is on, as it stood after the last step. */
    get characterState(): CharacterState;
    /** Those of one body, oldest first. */
    get joints(): JointId[];
    /** Those of one body. */
    get contacts(): Contact[];
}

/** Arrays of `World.readBodies`: for each body in the order of `World.bodies`. Those that are left out are not read. */
export interface BodyArrays {
    /** x, y, z of the origin of each body's frame, meters. */
    positions?: Float64Array;
    /** x, y, z, w of each body's rotation, of unit length. */
    rotations?: Float32Array;
    /** x, y, z of the velocity of each center of mass, m/s. */
    linearVelocities?: Float32Array;
    /** x, y, z of each angular velocity in world axes, rad/s. */
    angularVelocities?: Float32Array;
}

/** Triangles to draw a shape by, in its frame. Three indices a triangle, counterclockwise as seen from outside. */
export interface Triangles {
    vertices: Float32Array;
    /** One for each vertex; null: draw flat triangles. */
    normals: Float32Array | null;
    indices: Uint32Array;
}

/** A world of rigid bodies. */
export class World {
    /** An empty world. Throws invalidValue. */
    constructor(definition?: WorldDef);
    /**
     * A world from a scene: glTF with KHR_physics_rigid_bodies, as text (.gltf) or bytes (.gltf, .glb). `name` stands for it in messages.
     * Throws invalidFile, unsupported (also for other files that it names), invalidValue.
     */
    static load(scene: string | ArrayBuffer | Uint8Array, name?: string): World;
    /** The world as it stands now, as the text of a .gltf file. Throws wrongState. */
    saveScene(): string;
    /** Seconds: what `step` advances by if nothing is said. 1/60, or what the scene is meant for. */
    timeStep: number;
    /** Makes a body without shapes. Throws invalidValue, wrongState. */
    createBody(definition?: BodyDef): Body;
    /** With its shapes and joints; wakes what rested on it. Throws invalidHandle, wrongState. */
    destroyBody(body: BodyId | Body): void;
    /** A body by its handle, whether or not there is one of that name. */
    body(id: BodyId): Body;
    bodyIsValid(id: BodyId | Body | null): boolean;
    shapeIsValid(id: ShapeId | null): boolean;
    jointIsValid(id: JointId | null): boolean;
    forceFieldIsValid(id: ForceFieldId | null): boolean;
    /**
     * Advances by `count` steps (1) of `seconds` each (`timeStep`; > 0, finite). The same step every time gives the best results. Events are
     * those of the last step. Throws invalidValue, wrongState.
     */
    step(seconds?: number, count?: number): void;
    /** The whole state, to go back to: a world restored from it goes on bit for bit. Throws wrongState. */
    save(): Snapshot;
    /** Makes this world the one that was saved. Handles from then are valid again. Throws invalidValue, wrongState. */
    restore(snapshot: Snapshot): void;
    /**
     * The definition of a joint whose frames both lie at `anchor`, with x along `axis` (any non-zero vector; world space), as the bodies
     * stand now. Throws invalidHandle, invalidValue, wrongState.
     */
    jointAt(bodyA: BodyId | Body | null, bodyB: BodyId | Body | null, anchor: Vec3Like, axis: Vec3Like, joint: Joint): Complete<JointDef>;
    /** The definition of a joint, as it is now. Throws invalidHandle, wrongState. */
    jointDef(joint: JointId): Complete<JointDef>;
    /**
     * Writes places, rotations and velocities of all bodies, in the order of `bodies`, into arrays; returns them. Throws invalidValue
     * where one has another length than 3 or 4 for each body: then nothing is written.
     */
    readBodies<T extends BodyArrays>(arrays: T): T;
    get bodyCount(): number;
    /** New arrays of what `readBodies` reads. */
    get positions(): Float64Array;
    get rotations(): Float32Array;
    get linearVelocities(): Float32Array;
    get angularVelocities(): Float32Array;
    /** Triangles to draw a shape by. Infinite planes are squares of 200 m. Throws invalidHandle, wrongState. */
    shapeTriangles(shape: ShapeId): Triangles;
    /** The color that the scene's file gives to a shape, linear red, green and blue, each 0 to 1. Throws invalidHandle, wrongState. */
    shapeColor(shape: ShapeId): Vec3 | null;
    /** Ends the world with all that is in it; every call throws wrongState from then on. Twice: nothing happens. */
    dispose(): void;
    [Symbol.dispose](): void;
    /**
     * Adds a shape to a body and, unless its mass properties were given, updates them. A dynamic body whose shapes have
     * no mass at all is a point of its given mass, or of 1 kg, that does not turn. Planes are refused on dynamic
     * bodies. Throws invalidHandle, invalidValue, wrongState.
     */
    addShape(body: BodyId | Body | null, shape: Shape, definition?: ShapeDef): ShapeId;
    /**
     * Takes a shape off its body, whose mass properties follow unless they were given. Throws invalidHandle,
     * wrongState.
     */
    removeShape(shape: ShapeId | null): void;
    /**
     * Gives a shape another geometry, in place: its handle and all that its definition says stay. The mass of the body
     * follows as when a shape is added. What it touches then goes on touching it, without events, as long as it is of
     * the same type; else its contacts end and begin anew. What overlaps it then is pushed out, no faster than
     * `WorldDef.recoverySpeed`: ground that rises carries what is on it if it rises more slowly than that, and by less
     * than the height of that in one call. Wakes its body and what is around the shape, before and after. Throws
     * invalidHandle, invalidValue, wrongState.
     */
    setShape(shape: ShapeId | null, geometry: Shape): void;
    /**
     * Gives a shape another definition, in place: place on its body, density, material, filter, and what else that
     * says; to change a part of it, begin with the one that it has. Its contacts end and begin anew where `isTrigger`
     * or `filter` is not what it was; else as when its geometry is set. Throws invalidHandle, invalidValue, wrongState.
     */
    setShapeDef(shape: ShapeId | null, definition: ShapeDef): void;
    /** The body that a shape is on. Throws invalidHandle, wrongState. */
    bodyOf(shape: ShapeId | null): BodyId;
    /** What was added. Throws invalidHandle, wrongState. */
    shape(shape: ShapeId | null): Shape;
    /** How it is attached to its body, as it is now. Throws invalidHandle, wrongState. */
    shapeDef(shape: ShapeId | null): Complete<ShapeDef>;
    /** In world space. Throws invalidHandle, wrongState. */
    shapeTransform(shape: ShapeId | null): Complete<Transform>;
    /** Tight; infinite for infinite planes. Throws invalidHandle, wrongState. */
    shapeBounds(shape: ShapeId | null): Complete<Bounds>;
    /** Replaces the material. Throws invalidHandle, invalidValue, wrongState. */
    setMaterial(shape: ShapeId | null, material: Material): void;
    /** Replaces the collision filter. Throws invalidHandle, invalidValue, wrongState. */
    setFilter(shape: ShapeId | null, filter: CollisionFilter): void;
    /**
     * See `ShapeDef.surfaceVelocity`. Refused (wrongState) for a shape of a dynamic body. Throws invalidHandle,
     * invalidValue, wrongState.
     */
    setSurfaceVelocity(shape: ShapeId | null, velocity: Vec3Like): void;
    /** All, in order of slot index. */
    get bodies(): BodyId[];
    /** The first of that name. Throws wrongState. */
    findBody(name: string): BodyId | null;
    /** Joins two bodies, or a body and the world. Wakes them. Throws invalidValue, wrongState. */
    createJoint(definition: JointDef): JointId;
    /** Takes a joint out of the world and wakes its bodies. Throws invalidHandle, wrongState. */
    destroyJoint(joint: JointId | null): void;
    /**
     * Changes limits, motors, springs, or the kind of the joint. Wakes its bodies. Throws invalidHandle, invalidValue,
     * wrongState.
     */
    setJoint(id: JointId | null, joint: Joint): void;
    /** N and N m, > 0; may be infinite. Throws invalidHandle, invalidValue, wrongState. */
    setJointStrength(joint: JointId | null, breakForce: number, breakTorque: number): void;
    /**
     * A joint that is disabled keeps its definition and its handle, and acts on nothing: its bodies move, and collide,
     * as if it had been destroyed. Enabled again it begins without impulses, and brings its bodies together where they
     * have parted. Both wake them. Throws invalidHandle, wrongState.
     */
    setJointEnabled(joint: JointId | null, enabled: boolean): void;
    /** What a joint did in the last step. Throws invalidHandle, wrongState. */
    jointState(joint: JointId | null): JointState;
    /** All, in order of slot index. */
    get joints(): JointId[];
    /** The first of that name. Throws wrongState. */
    findJoint(name: string): JointId | null;
    /**
     * The nearest shape that the ray meets within `maxDistance`. `direction` need not be unit length. A ray that starts
     * inside a shape does not meet that shape's surface from within, except planes' solid side. Throws invalidHandle,
     * invalidValue, wrongState.
     */
    castRay(origin: Vec3Like, direction: Vec3Like, maxDistance: number, filter?: QueryFilter): RayHit | null;
    /** Every shape that the ray meets, nearest first. Throws invalidHandle, invalidValue, wrongState. */
    castRayAll(origin: Vec3Like, direction: Vec3Like, maxDistance: number, filter?: QueryFilter): RayHit[];
    /**
     * The first shape that the given convex one meets when it moves by `translation` (meters) from `start` without
     * turning. Planes, meshes and height fields are met from outside only, and cannot be cast themselves
     * (invalidValue). Throws invalidHandle, invalidValue, wrongState.
     */
    castShape(shape: Shape, start: Transform, translation: Vec3Like, filter?: QueryFilter): ShapeCastHit | null;
    /**
     * The shape nearest to a point, up to `maxDistance` (meters, >= 0) away. What is below a plane is inside it; meshes
     * and height fields have no inside. Throws invalidHandle, invalidValue, wrongState.
     */
    closestPoint(point: Vec3Like, maxDistance: number, filter?: QueryFilter): ClosestPoint | null;
    /**
     * Shapes that overlap the given shape posed in the world, in order of slot index. Throws invalidHandle,
     * invalidValue, wrongState.
     */
    overlap(shape: Shape, pose: Transform, filter?: QueryFilter): ShapeId[];
    /**
     * Shapes whose tight bounds overlap the box, in order of slot index. Throws invalidHandle, invalidValue,
     * wrongState.
     */
    overlapBounds(bounds: Bounds, filter?: QueryFilter): ShapeId[];
    /**
     * The boxes of the broad phase as they stand, down to that depth, for pictures and for who wants to know why a
     * scene is slow: those of least depth first, and no more than `maxCount`. Both >= 0. Throws invalidValue,
     * wrongState.
     */
    broadPhaseNodes(maxDepth: number, maxCount: number): BroadPhaseNode[];
    /** How each touching pair of shapes is solved, in the order of `worldGetContacts`. */
    get solverContacts(): SolverContact[];
    /**
     * What the world consists of as lines, for programs that draw it themselves: bodies in order of slot index, then
     * contacts, then joints. As many as there are edges: of large meshes and height fields that takes its time. Throws
     * invalidValue, wrongState.
     */
    debugLines(what?: DebugLinesDef): DebugLine[];
    /** Shapes that began to touch in the last step. */
    get contactBegins(): ContactBegin[];
    /** Shapes that ceased to touch in the last step. */
    get contactEnds(): ContactEnd[];
    /** Shapes that hit each other in the last step, at `WorldDef.hitSpeed` or more. */
    get contactHits(): ContactHit[];
    /** What came into triggers and left them in the last step. */
    get triggerEvents(): TriggerEvent[];
    /** Joints that broke or lost a body in the last step, or since. */
    get jointEvents(): JointEvent[];
    /** Bodies that fell asleep or woke up in the last step. */
    get sleepEvents(): SleepEvent[];
    /** All touching pairs. */
    get contacts(): Contact[];
    /**
     * What the world was made with, or was last set to. Setting: Replaces the settings. Wakes everything if gravity
     * changes.
     */
    get settings(): Complete<WorldDef>;
    set settings(value: WorldDef);
    /**
     * The substeps of a step of `dt` seconds, finite and > 0, where no island asks for more: `WorldDef.substeps`, or
     * what its 0 stands for. Throws invalidValue, wrongState.
     */
    usualSubsteps(dt: number): number;
    /**
     * The number of threads that a step may use. Setting: The number of threads that a step may use: that of the
     * caller, and `count` - 1 more that the world keeps. 1 to 256; default 1. Results do not depend on it. Snapshots do
     * not hold it. Throws outside that range, or when the system has no more threads.
     */
    get threads(): number;
    set threads(value: number);
    /** Adds a field that acts on every dynamic body from the next step on. Throws invalidValue, wrongState. */
    addForceField(field: ForceField): ForceFieldId;
    /** Replaces a field by another one. Throws invalidHandle, invalidValue, wrongState. */
    setForceField(id: ForceFieldId | null, field: ForceField): void;
    /** Takes a field out of the world. Throws invalidHandle, wrongState. */
    removeForceField(id: ForceFieldId | null): void;
    /** A field, as it is now. Throws invalidHandle, wrongState. */
    forceField(id: ForceFieldId | null): Complete<ForceField>;
    /** All, in order of slot index. */
    get forceFields(): ForceFieldId[];
    /** Steps since the world was made. */
    get stepCount(): bigint;
    /** Simulated seconds. */
    get time(): number;
    /** J, of all dynamic bodies. */
    get kineticEnergy(): number;
    /** J in the world's gravity, relative to the origin. */
    get potentialEnergy(): number;
    /** kg m/s, of all dynamic bodies. */
    get linearMomentum(): Vec3;
    /** kg m^2/s about the origin, of all dynamic bodies. */
    get angularMomentum(): Vec3;
    /** Of positions, rotations and velocities, by bits. */
    get stateHash(): bigint;
    /** Counts and times of the last step. */
    get statistics(): Statistics;
}
