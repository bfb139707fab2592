// Made by tools/api.py from api/: change those, and run it.
/** The error that a rejected call throws. The world is unchanged. */
export class CairnError extends Error {
    readonly name: 'CairnError';
    /** The kind of error. */
    readonly code: CairnErrorCode;
    /** The invalid argument or member, such as `BodyDef.mass`; may be empty. */
    readonly field: string;
    /** Its value as text; may be empty. */
    readonly value: string;
}

/**
 * `invalidValue`: an argument is NaN, infinite, of a wrong type, or out of its range. `invalidHandle`: a handle is
 * null, stale, or belongs to another world. `wrongState`: the call is not allowed in the present state, for example for
 * a disposed world. `invalidFile`: a file is malformed. `unsupported`: the request is well formed, but this build does
 * not support it. `io`: a file could not be read. `outOfMemory`: memory ran out; the world is as it was, or refuses all
 * calls until it is restored. `other`: any other error.
 */
export type CairnErrorCode =
    'invalidValue' | 'invalidHandle' | 'wrongState' | 'invalidFile' | 'unsupported' | 'io' | 'outOfMemory' | 'other';

/**
 * Loads the engine. Every other call requires it, and throws `wrongState` before the promise is fulfilled. Further
 * calls return the same promise. `source`: the URL of the file `cairn.wasm` of the package, or its contents; default:
 * beside this module. Rejects with `io` if the file cannot be read, `invalidFile` if it is not that module, and
 * `wrongState` after `init` of `cairn-physics/mt`.
 */
export default function init(source?: string | URL | Response | Promise<Response> | ArrayBuffer | ArrayBufferView |
    WebAssembly.Module): Promise<void>;
export { init };

/** The version of the engine, such as "0.1.0". */
export function version(): string;

/**
 * The spring with which the bodies of a joint oscillate at a natural frequency of `hertz` (Hz, > 0), with that damping
 * ratio (>= 0; 1: critical damping). Throws invalidValue.
 */
export function springFromFrequency(hertz: number, dampingRatio: number): Complete<JointSpring>;

/** All collision layers, for the filters of queries. */
export const ALL_LAYERS: bigint;

export interface Vec2 { x: number; y: number }
/** Directions, extents, velocities and positions, in SI units. */
export interface Vec3 { x: number; y: number; z: number }
/** A rotation as a unit quaternion; the identity is 0, 0, 0, 1. */
export interface Quat { x: number; y: number; z: number; w: number }
/**
 * Vectors as arguments: an object with the components as members, such as a vector of three.js, or an array of the
 * components.
 */
export type Vec2Like = Readonly<Vec2> | ArrayLike<number>;
export type Vec3Like = Readonly<Vec3> | ArrayLike<number>;
export type QuatLike = Readonly<Quat> | ArrayLike<number>;

/**
 * Handles identify bodies, shapes, joints and force fields. Once its object is destroyed, a handle is stale, and no new
 * object gets the same one, except after `World.restore`. 0n: the null handle.
 */
export type BodyId = bigint;
export type ShapeId = bigint;
export type JointId = bigint;
export type ForceFieldId = bigint;

/** A definition as calls return it: with all of its members, and vectors as objects. */
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
 * How the coefficients of two materials in contact are combined into one. If their rules differ, the one with
 * precedence applies, in the order average > minimum > maximum > multiply (KHR_physics_rigid_bodies). `average`: The
 * mean of both coefficients. `minimum`: The smaller coefficient. `maximum`: The greater coefficient. `multiply`: The
 * product of both coefficients.
 */
export type CombineRule = 'average' | 'minimum' | 'maximum' | 'multiply';

/**
 * How a body moves. `static`: Never moves by itself. `kinematic`: Moves with the velocities that it is given, rotating
 * about its origin. Forces and contacts do not change them. `dynamic`: Moves by forces and contacts.
 */
export type BodyType = 'static' | 'kinematic' | 'dynamic';

/**
 * What supports a character. `none`: The character is in the air, or flies. `steep`: It slides down a slope steeper
 * than `CharacterDef.maxSlope`. `ground`: It stands on the ground.
 */
export type CharacterSupport = 'none' | 'steep' | 'ground';

/**
 * Whether a limit or drive of a general joint acts on a distance or on an angle. `linear`: A distance along axes.
 * `angular`: An angle about axes.
 */
export type JointAxis = 'linear' | 'angular';

/**
 * How a joint is solved. Both solvers give the same motion; they differ in cost and stiffness. `automatic`: The engine
 * chooses. It solves directly: chains, machines, robots with servo-driven angles, and joints under high mass ratios, as
 * long as this is not too expensive; and all joints that connect to joints with `direct`. All others are iterative.
 * `iterative`: Joints are solved in turn (eight at a time, in SIMD lanes), together with the contacts. For nets, and
 * heaps of many joints. `direct`: All direct joints that connect bodies are solved as one system of equations,
 * including their motors, springs, friction and limits. For chains, machines, robots, and joints that must not yield.
 * Gears, racks and pulleys remain iterative, and so do all joints of a net of thousands, whose factorization would take
 * far too long.
 */
export type JointSolver = 'automatic' | 'iterative' | 'direct';

/**
 * The trees of the broad phase. Infinite planes are in none. `fixed`: Shapes of static bodies. `awake`: Awake shapes.
 * `large`: Awake shapes that are large compared to the others. `sleeping`: Sleeping shapes: a tree of all sleeping
 * islands, below which each island has a tree of its own.
 */
export type BroadPhaseTree = 'fixed' | 'awake' | 'large' | 'sleeping';

/**
 * How free motion is integrated over a substep of length h. Contacts work with all of them. `semiImplicitEuler`: v += h
 * a, then x += h v. Bounded energy error; the default. `explicitEuler`: x += h v, then v += h a. Gains energy; kept for
 * teaching. `rk4`: Classic fourth-order Runge-Kutta.
 */
export type Integrator = 'semiImplicitEuler' | 'explicitEuler' | 'rk4';

/**
 * The kind of a force field. `uniform`: `direction` at every place. `radial`: `strength` x distance^`exponent`, towards
 * `center`. `fluid`: A fluid with a level surface through `center`, which flows with the velocity `direction`.
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
    /** Radius in meters, > 0. */
    radius?: number;
}

/**
 * A box around the shape's origin. `halfExtents` in meters, each > 0. A Box, Cylinder or Hull with `rounding` r > 0 is
 * the Minkowski sum of the sharp solid and a ball of radius r: all points within a distance r of the sharp solid. It is
 * larger by r on every side; its faces stay flat, and its edges and corners are rounded with radius r. To keep the
 * outer size, subtract r from the half extents.
 */
export interface Box {
    /** Half extents of the sharp box, meters, each > 0; the rounding adds to them. */
    halfExtents?: Vec3Like;
    /** Meters, >= 0: radius of the ball that is added to the sharp box. */
    rounding?: number;
}

/**
 * A plane through the shape's origin, solid on the side opposite to `normal`. Without `halfExtents` it is an infinite
 * half-space. With them it is a rectangle: `halfExtents[0]` along `tangent`, `halfExtents[1]` along normal x tangent. A
 * rectangle is one-sided: it pushes shapes along its normal that are above it, or that have sunk into it and are still
 * partly above. With one infinite half extent it is a strip, without ends along that axis. A double-sided plane is a
 * sheet without thickness that collides on both sides: an infinite one pushes a body to the side on which its center of
 * mass is; a rectangle or strip pushes a shape to the side on which the middle of that shape is. Rays and casts hit a
 * sheet from both sides, and no point is inside of it. Planes have no mass, and may only be added to static and
 * kinematic bodies.
 */
export interface Plane {
    /** Any non-zero finite vector; it is normalized. */
    normal?: Vec3Like;
    /** Direction of `halfExtents[0]`; it is made orthogonal to `normal`. Used only by rectangles and strips. */
    tangent?: Vec3Like;
    /** Meters, each > 0; one may be infinite. Left out: an infinite plane. */
    halfExtents?: Vec2Like | null;
    /** true: the plane is a sheet that collides on both sides. */
    doubleSided?: boolean;
}

/**
 * The convex hull of two balls on the shape's y axis, their centers at -halfHeight and +halfHeight. Meters, all > 0
 * (`radiusTop` >= 0).
 */
export interface Capsule {
    /** Half the distance between the centers of the balls, meters, > 0. */
    halfHeight?: number;
    /** Radius of both balls, or of the lower one if `radiusTop` is given, meters, > 0. */
    radius?: number;
    /** Radius of the upper ball, meters, >= 0, for a tapered capsule; Left out: `radius`. */
    radiusTop?: number | null;
}

/**
 * A solid cylinder around the shape's y axis, from -halfHeight to +halfHeight. Meters, all > 0 (`radiusTop` >= 0); the
 * rounding adds to these sizes.
 */
export interface Cylinder {
    /** Half the length along the y axis, meters, > 0. */
    halfHeight?: number;
    /** Radius at both ends, or at the lower end if `radiusTop` is given, meters, > 0. */
    radius?: number;
    /** Radius at the upper end, meters, >= 0, for a tapered cylinder, or a cone if it is 0; Left out: `radius`. */
    radiusTop?: number | null;
    /** Meters, >= 0: radius of the ball that is added to the sharp cylinder. */
    rounding?: number;
}

/** A convex polyhedron. Its vertices never change. */
export interface Hull {
    /** A hull created by `cairnGeometryCreateHull`. */
    geometry: Geometry;
    /** Meters, >= 0: radius of the ball that is added to the sharp polyhedron. */
    rounding?: number;
}

/**
 * A triangle mesh, for static and kinematic bodies. The solid side of a triangle is the one from which its vertices
 * appear clockwise: a shape that has sunk below a triangle and is still partly above it is pushed out along the normal.
 * Walls may be arbitrarily thin: a sheet that has triangles facing both ways collides on both sides.
 */
export interface Mesh {
    /** A mesh created by `cairnGeometryCreateMesh`. */
    geometry: Geometry;
}

/** A surface over a grid in the shape's xz plane, solid below, for static and kinematic bodies. */
export interface HeightField {
    /** A height field created by `cairnGeometryCreateHeightField`. */
    geometry: Geometry;
}

/** Surface properties of a shape. */
export interface Material {
    /** Coulomb coefficient while the contact sticks, >= 0. */
    staticFriction?: number;
    /** Coulomb coefficient while it slides, >= 0. */
    dynamicFriction?: number;
    /** Ratio of rebound to approach speed, 0 to 1; 0: no bounce, 1: elastic. */
    restitution?: number;
    /** Lever arm of the rolling resistance torque in meters, >= 0. */
    rollingFriction?: number;
    /**
     * Radius of the contact patch in meters, >= 0: a spinning one-point contact feels a torque of at most friction x
     * normal force x this radius. With 0, a ball that spins about the contact normal never comes to rest.
     */
    torsionalFriction?: number;
    /** How its friction coefficients are combined with those of the other material. */
    frictionCombine?: CombineRule;
    /** How its restitution is combined with that of the other material. */
    restitutionCombine?: CombineRule;
}

/** Decides which shapes collide: two shapes do if each is in a layer with which the other collides. */
export interface CollisionFilter {
    /** Layers to which the shape belongs, one bit for each. */
    layers?: bigint | number;
    /** Layers with which the shape collides. */
    collidesWith?: bigint | number;
}

/** How a shape is attached to its body. */
export interface ShapeDef {
    /** Origin of the shape in the body's frame, meters; within 1e15. */
    position?: Vec3Like;
    /** Orientation in the body's frame; normalized, must not be zero. */
    rotation?: QuatLike;
    /** kg/m^3, >= 0; with 0 the shape adds no mass. Not used for planes. */
    density?: number;
    /** Friction and restitution of its surface. */
    material?: Material;
    /** Decides with which shapes it collides. */
    filter?: CollisionFilter;
    /**
     * true: the shape is a trigger. It has no contacts, and only reports shapes that overlap it
     * (`World.triggerEvents`).
     */
    isTrigger?: boolean;
    /**
     * m/s, in the shape's frame: velocity of the surface relative to the body, as of a conveyor belt. Only its
     * component along the surface counts. Static and kinematic bodies only.
     */
    surfaceVelocity?: Vec3Like;
    /** Stored for the application; the engine does not use it. */
    userData?: bigint | number;
    /**
     * A direction in the shape's frame, of any length; zero: none. Otherwise the shape is a one-way platform: it
     * collides only with shapes that come from that side. A shape that is not entirely on that side when the two meet
     * passes through until it is, so that one can jump onto the platform from below. Static and kinematic bodies only;
     * infinite planes, meshes and height fields cannot be one-way. Rays, casts and other queries find the shape from
     * all sides.
     */
    oneWay?: Vec3Like;
}

/**
 * Mass, center of mass and inertia of a body. With a `mass` of +infinity forces do not translate the body; a zero entry
 * of `inertiaDiagonal` keeps torques from rotating it about that principal axis.
 */
export interface MassProperties {
    /** kg, > 0; may be infinite. */
    mass?: number;
    /** Center of mass in the body's frame, meters. */
    centerOfMass?: Vec3Like;
    /** Principal moments about the center of mass, kg m^2. */
    inertiaDiagonal?: Vec3Like;
    /** Rotation from principal axes to the body's frame. */
    inertiaOrientation?: QuatLike;
}

/** Everything that is needed to create a body. */
export interface BodyDef {
    /** How it moves. */
    type?: BodyType;
    /** Origin of the body's frame (not its center of mass), meters. */
    position?: Vec3Like;
    /** Rotation of the body's frame. Normalized on entry; must not be zero. */
    rotation?: QuatLike;
    /** Velocity of the center of mass, m/s. */
    linearVelocity?: Vec3Like;
    /** Angular velocity in world axes, rad/s. */
    angularVelocity?: Vec3Like;
    /** 1/s, >= 0: velocity decays as v' = -damping v. */
    linearDamping?: number;
    /** 1/s, >= 0: the same for the angular velocity. */
    angularDamping?: number;
    /** Multiplies the world's gravity for this body; any finite value. */
    gravityScale?: number;
    /** false: the body and its island never fall asleep. */
    allowSleep?: boolean;
    /**
     * Total mass in kg, > 0 (+infinity: immovable), to which the mass properties of the shapes are scaled. Left out:
     * the mass follows from the densities of the shapes.
     */
    mass?: number | null;
    /** Used in place of `mass` and of the shapes' densities. */
    massProperties?: MassProperties | null;
    /** For display and `World.findBody`; need not be unique. */
    name?: string;
    /** Stored for the application; the engine does not use it. */
    userData?: bigint | number;
    /** false: the body does not take part in the simulation until it is enabled. */
    enabled?: boolean;
}

/**
 * How a character moves. A character is a kinematic body that is moved at the beginning of each step: it slides along
 * walls, climbs steps, stands on slopes, falls, is carried by the body on which it stands, and never passes through
 * anything that its shapes collide with. Only its convex shapes count; a capsule along `up` is usual. It rotates with
 * the body on which it stands (about `up`), and otherwise only if the application rotates it.
 */
export interface CharacterDef {
    /** Direction away from the ground: any non-zero vector; it is normalized. */
    up?: Vec3Like;
    /**
     * rad, 0 to 1.57: greatest slope on which the character stands. It slides down steeper slopes and does not walk up
     * them.
     */
    maxSlope?: number;
    /** m, >= 0: greatest height of a step that it climbs; 0: it climbs none. */
    stepHeight?: number;
    /**
     * m, >= 0: it stays on the ground where this drops by up to this distance within a time step, as on stairs
     * downwards.
     */
    stickDistance?: number;
    /** m, 1e-4 to 1: the distance that it keeps from all other shapes. */
    skin?: number;
    /** kg, >= 0: the mass with which it acts on dynamic bodies on which it stands or lands, or from which it jumps. */
    mass?: number;
    /** N, >= 0: greatest force with which it pushes dynamic bodies that are in its way. */
    maxPushForce?: number;
    /** m/s^2, >= 0: greatest acceleration towards the walk velocity while it is in the air. */
    airAcceleration?: number;
    /**
     * true: it moves with the walk velocity in all three directions, and gravity, ground and steps do not act on it:
     * for swimming, ladders, flying.
     */
    flies?: boolean;
}

/** The motion and support of a character after the last step. */
export interface CharacterState {
    /** What supports the character. */
    support: CharacterSupport;
    /**
     * m/s, in world axes, including the velocity of the ground. It differs from the velocity of the body, which is the
     * displacement in the last step divided by its duration: it excludes the height of stairs that were climbed, and in
     * the air it is the velocity at the end of the step.
     */
    velocity: Vec3;
    /** The shape on which it stands or slides; null in the air, and if that shape was removed. */
    groundShape: ShapeId;
    /** The body of that shape. */
    groundBody: BodyId;
    /** Where the character touches that shape, m, world space; valid unless `support` is none. */
    groundPoint: Vec3;
    /** Unit normal there, out of the ground; valid unless `support` is none. */
    groundNormal: Vec3;
    /** m/s: velocity of the ground's material there; valid unless `support` is none. */
    groundVelocity: Vec3;
}

/** A damped spring. It is integrated implicitly, so that any stiffness is stable. */
export interface JointSpring {
    /** N/m or N m/rad, >= 0. */
    stiffness?: number;
    /** N s/m or N m s/rad, >= 0. */
    damping?: number;
    /**
     * true: stiffness (1/s^2) and damping (1/s) are per unit of the mass (or moment of inertia) that the joint moves
     * along that axis: they set the motion, whatever the mass. false: they set the force.
     */
    isAcceleration?: boolean;
}

/** Limits of a position, m or rad. `lower` = `upper` holds it at one value. */
export interface JointRange {
    /** m or rad, lower <= upper; -infinity: no bound on that side. */
    lower?: number;
    /** m or rad, lower <= upper; +infinity: no bound on that side. */
    upper?: number;
    /** Pulls back a position that is beyond a bound; Left out: the limit is rigid. */
    spring?: JointSpring | null;
}

/**
 * Drives an axis. With a spring it pulls towards `position` and `velocity`; without one it keeps the velocity, as far
 * as `maxForce` allows.
 */
export interface JointMotor {
    /** m/s or rad/s: target velocity. */
    velocity?: number;
    /** m or rad: target position; used only with a spring. */
    position?: number;
    /** Left out: the motor keeps its velocity. */
    spring?: JointSpring | null;
    /** N or N m, >= 0: greatest force or torque of the motor. */
    maxForce?: number;
}

/** Limits, motor and friction of one axis of a joint. By default the axis is free. */
export interface JointControl {
    /** Left out: no limits. */
    limits?: JointRange | null;
    /** Left out: no motor. */
    motor?: JointMotor | null;
    /** N or N m, >= 0: dry friction. The axis moves only under a greater force or torque. */
    friction?: number;
}

/** B keeps its position and rotation relative to A. */
export interface FixedJoint {
}

/** The origins of the two frames coincide; B rotates freely about that point, within the limits. */
export interface BallJoint {
    /** rad, 0 to pi: greatest angle between the x axes of the two frames (swing limit); Left out: none. */
    coneAngle?: number | null;
    /** rad, -pi to pi: limits of the angle about the x axis; Left out: none. */
    twist?: JointRange | null;
    /** N m, >= 0: friction torque about each axis. */
    friction?: number;
}

/**
 * B rotates about the x axis of A. While a limit, motor or friction acts on the angle, it counts full turns; otherwise
 * it is between -pi and pi.
 */
export interface HingeJoint {
    /** Angle about the x axis of A. */
    angle?: JointControl;
}

/** B moves along the x axis of A and does not rotate relative to A. */
export interface SliderJoint {
    /** Translation along the x axis of A. */
    translation?: JointControl;
}

/** B moves along the x axis of A and rotates about it. */
export interface CylindricalJoint {
    /** Translation along the x axis of A. */
    translation?: JointControl;
    /** Angle about the x axis of A. */
    angle?: JointControl;
}

/**
 * A universal (Cardan) joint: a cross with two axes at a right angle, the x axis of A and the y axis of B, about which
 * the bodies rotate.
 */
export interface UniversalJoint {
    /** Rotation about the x axis of A. */
    first?: JointControl;
    /** Rotation about the y axis of B. */
    second?: JointControl;
}

/**
 * Controls the distance (m) between the origins of the two frames. For a rod, set limits with lower = upper; for a
 * rope, lower = 0; for a spring, a motor with a spring and `position` = its rest length.
 */
export interface DistanceJoint {
    /** Distance between the origins of the two frames. */
    distance?: JointControl;
}

/**
 * A wheel B under a car A. The wheel moves along the x axis of A (suspension), rotates about it (steering), and spins
 * about its own y axis.
 */
export interface WheelJoint {
    /** Translation along the x axis of A. */
    suspension?: JointControl;
    /** Angle about the x axis of A. Left out: the wheel does not steer. */
    steering?: JointControl | null;
    /** Rotation about the y axis of the wheel. */
    spin?: JointControl;
}

/** A servo that pulls B to a target position and rotation in the frame of A. */
export interface ServoJoint {
    /** Target of the origin of frame B, in frame A, meters. */
    position?: Vec3Like;
    /** Target of the rotation of frame B in frame A; normalized. */
    rotation?: QuatLike;
    /** Spring that pulls B to the target position. */
    linear?: JointSpring;
    /** Spring that rotates B to the target rotation. */
    angular?: JointSpring;
    /** N, >= 0: greatest force along each axis. */
    maxForce?: number;
    /** N m, >= 0: greatest torque about each axis. */
    maxTorque?: number;
}

/**
 * Two meshing gears: (angular speed of A about the x axis of its frame) + ratio x (angular speed of B about that of its
 * frame) = 0. For external gears on parallel axes, ratio = teeth of B / teeth of A. Angular speeds are relative to the
 * world, so the bodies that carry the axles must not rotate about them.
 */
export interface GearJoint {
    /** Not 0; negative: both rotate in the same sense. */
    ratio?: number;
}

/**
 * A pinion A on a rack B: (translation of B along the x axis of its frame) = radius x (angle of A about the x axis of
 * its frame), both relative to the world.
 */
export interface RackJoint {
    /** m, not 0; negative: the rack moves in the opposite sense. */
    radius?: number;
}

/** A rope over two fixed pulleys: length at A + ratio x length at B <= length. */
export interface PulleyJoint {
    /** The pulley on the side of A, meters, world space. */
    groundA?: Vec3Like;
    /** The pulley on the side of B, meters, world space. */
    groundB?: Vec3Like;
    /** > 0: ratio of the block and tackle on the side of B. */
    ratio?: number;
    /** m, > 0; Left out: the length when the joint is created, which `World.jointDef` then returns. */
    length?: number | null;
}

/**
 * Limits a distance (m) or an angle (rad) between the two frames. With one axis it is the position along, or the angle
 * about, that axis. With two axes it is the distance from the line of the third axis, or the angle between the third
 * axes of both frames (a cone). With three axes it is the distance of the two origins, or the angle of the whole
 * rotation.
 */
export interface JointLimit {
    /** Whether it limits a distance or an angle. */
    kind?: JointAxis;
    /** Which of the axes x, y and z of frame A; one to three of them. */
    axes?: readonly (boolean)[];
    /** m or rad, min <= max; Left out: no bound on that side. */
    min?: number | null;
    /** m or rad, min <= max; Left out: no bound on that side. */
    max?: number | null;
    /** N/m or N m/rad, >= 0; Left out: rigid. */
    stiffness?: number | null;
    /** N s/m or N m s/rad, >= 0; used only with a stiffness. */
    damping?: number;
}

/**
 * A damped spring or motor along or about one axis. Its force (or torque) is stiffness x (positionTarget - position) +
 * damping x (velocityTarget - velocity).
 */
export interface JointDrive {
    /** Whether it drives a distance or an angle. */
    kind?: JointAxis;
    /** true: the formula gives an acceleration; false: a force or torque. */
    isAcceleration?: boolean;
    /** 0, 1 or 2: x, y or z of frame A. */
    axis?: number;
    /** N or N m, >= 0: greatest force or torque; Left out: no bound. */
    maxForce?: number | null;
    /** m or rad: target position of the spring. */
    positionTarget?: number;
    /** m/s or rad/s: target velocity of the damping. */
    velocityTarget?: number;
    /** N/m or N m/rad, >= 0: stiffness of the spring. */
    stiffness?: number;
    /** N s/m or N m s/rad, >= 0: damping of the spring. */
    damping?: number;
}

/**
 * The joint of the glTF draft KHR_physics_rigid_bodies: six degrees of freedom, any of which may have limits and
 * drives. It may have at most eight limits and drives, not counting limits that just lock axes.
 */
export interface GeneralJoint {
    /** Limits of distances and angles. */
    limits?: readonly (JointLimit)[];
    /** Drives of distances and angles. */
    drives?: readonly (JointDrive)[];
}

/** Everything that is needed to create a joint. */
export interface JointDef {
    /** Null: the world. The two bodies must differ, and at least one must be dynamic. */
    bodyA?: BodyId | Body | null;
    /** Null: the world. The two bodies must differ, and at least one must be dynamic. */
    bodyB?: BodyId | Body | null;
    /** Pose of the joint's frame relative to the frame of body A, or relative to the world. */
    frameA?: Transform;
    /** Pose of the joint's frame relative to the frame of body B, or relative to the world. */
    frameB?: Transform;
    /** The type of joint, with its limits, motors and springs. */
    joint?: Joint;
    /** true: the two bodies collide with each other. */
    enableCollision?: boolean;
    /** N, > 0: the joint breaks if its mean force in a step exceeds this. */
    breakForce?: number;
    /** N m, > 0: the joint breaks if its mean torque in a step exceeds this. */
    breakTorque?: number;
    /** How the joint is solved. */
    solver?: JointSolver;
    /** For display and `World.findJoint`; need not be unique. */
    name?: string;
    /** Stored for the application; the engine does not use it. */
    userData?: bigint | number;
    /** false: the joint does not act until `World.setJointEnabled`. */
    enabled?: boolean;
}

/** Forces, positions and errors of a joint in the last step. */
export interface JointState {
    /** N: mean force on B, world axes. */
    force: Vec3;
    /** N m: mean torque on B about the origin of its frame, world axes. */
    torque: Vec3;
    /**
     * Positions of its axes (m or rad), in the order of the members of its type: for a hinge its angle; for a
     * cylindrical joint translation and angle; for a general joint one for each of its limits and drives, except limits
     * that just lock axes.
     */
    positions: number[];
    /** Number of valid elements of `positions`. */
    positionCount: number;
    /** m: distance between the points that the joint holds together. */
    linearError: number;
    /** rad: rotation of B about the axes that the joint locks. */
    angularError: number;
}

/** An intersection of a ray with a shape. */
export interface RayHit {
    shape: ShapeId;
    body: BodyId;
    /** On the surface, meters, world space. */
    point: Vec3;
    /** Unit outward normal of the surface there. */
    normal: Vec3;
    /** Distance from the ray's origin, meters. */
    distance: number;
    /**
     * For a mesh: index of the triangle that was hit, in the order of the mesh's indices. For a height field: 2 x
     * (index of the cell, row by row), plus 1 for the triangle on the side of greater x. For other shapes: -1.
     */
    triangle: number;
}

/** The first contact of a shape that is moved along a line. */
export interface ShapeCastHit {
    shape: ShapeId;
    body: BodyId;
    /** Fraction of the translation before the contact, 0 to 1; 0 if the shapes overlap at the start. */
    fraction: number;
    /** Where the two shapes touch, meters, world space. */
    point: Vec3;
    /** Unit normal, out of the shape that was hit. */
    normal: Vec3;
    /** The triangle that was hit; as in RayHit. */
    triangle: number;
}

/** The point of the nearest shape that is closest to a given point. */
export interface ClosestPoint {
    shape: ShapeId;
    body: BodyId;
    /** On the surface, meters, world space; the given point itself if it is inside the shape. */
    point: Vec3;
    /** Meters; 0 if the given point is inside the shape. */
    distance: number;
    /** The triangle on which the point lies; as in RayHit. */
    triangle: number;
}

/**
 * A node of a tree of the broad phase. Its box encloses those of its children, of which there are at most eight; the
 * boxes of siblings may overlap.
 */
export interface BroadPhaseNode {
    /** Meters, world space; the box of a leaf is somewhat larger than its shape. */
    bounds: Complete<Bounds>;
    /** The tree to which the node belongs. */
    tree: BroadPhaseTree;
    /** Levels below the root of the tree; 0: the root. */
    depth: number;
    /** Index of the parent in the list of nodes; -1: the node is a root. */
    parent: number;
    /** true: the node is the box of a single shape. */
    isLeaf: boolean;
    /** The shape of a leaf; null for other nodes. */
    shape: ShapeId;
}

/** How the solver treats a touching pair of shapes, after the last step; for visualization and measurements. */
export interface SolverContact {
    shapeA: ShapeId;
    shapeB: ShapeId;
    bodyA: BodyId;
    bodyB: BodyId;
    /**
     * Color in the constraint graph. Contacts of one color share no dynamic body, so that they are solved in parallel.
     * Colors are solved in turn, lowest first; those of contacts with static and kinematic bodies come last. -1: no
     * color was free, and the contact is solved on its own, before all others.
     */
    color: number;
    /** Substeps of its island in the last step in which the island was awake; 0: it has not been solved yet. */
    substeps: number;
}

/** What `World.debugLines` shows. */
export interface DebugLinesDef {
    /**
     * Edges of shapes; an infinite plane is shown as a grid of 20 m. The color tells whether a body is static,
     * kinematic, awake or asleep; triggers have a color of their own.
     */
    shapes?: boolean;
    /** Axis-aligned bounding boxes of shapes; infinite planes have none. */
    bounds?: boolean;
    /** Principal axes of inertia at the centers of mass of dynamic bodies: x red, y green, z blue. */
    centers?: boolean;
    /** Lines from the center of mass of each moving body to where its velocity brings it in 0.1 s. */
    velocities?: boolean;
    /** The normal at each contact point. */
    contacts?: boolean;
    /** Lines from the centers of mass of both bodies to their anchors, and the axes of the joint at the anchor of A. */
    joints?: boolean;
    /** m, > 0: length of axes and normals. */
    size?: number;
    /**
     * m/(N s), >= 0. If > 0, the length of a normal is this times the normal impulse of its contact point in the last
     * step.
     */
    impulseScale?: number;
}

/** A straight line. */
export interface DebugLine {
    /** m, in world space. */
    begin: Vec3;
    /** m, in world space. */
    end: Vec3;
    /** Red, green and blue, 0 to 1. */
    color: Vec3;
}

/** Selects the shapes that a query can find. A shape must meet all conditions. */
export interface QueryFilter {
    /** The shape must be in one of these layers (`CollisionFilter.layers`). */
    layers?: bigint | number;
    /** The layers of the query itself: the shape must collide with one of them (`CollisionFilter.collidesWith`). */
    ownLayers?: bigint | number;
    /** true: shapes of static bodies are included. */
    staticBodies?: boolean;
    /** true: shapes of kinematic bodies are included. */
    kinematicBodies?: boolean;
    /** true: shapes of dynamic bodies are included. */
    dynamicBodies?: boolean;
    /** true: triggers are included, and found like other shapes. */
    triggers?: boolean;
    /**
     * true: the query may return any one result: the first that it finds instead of the nearest, and a single shape for
     * overlaps. Faster if it only matters whether there is any.
     */
    any?: boolean;
    /** Shapes of these bodies are excluded. Each body must exist. */
    ignoredBodies?: readonly (BodyId | Body | null)[];
}

/** Two shapes began to touch. */
export interface ContactBegin {
    shapeA: ShapeId;
    shapeB: ShapeId;
    bodyA: BodyId;
    bodyB: BodyId;
}

/** Two shapes ceased to touch, or one of them was removed (its handle is then stale). */
export interface ContactEnd {
    shapeA: ShapeId;
    shapeB: ShapeId;
    bodyA: BodyId;
    bodyB: BodyId;
}

/** Two shapes began to touch with an approach speed of at least `WorldDef.hitSpeed`. */
export interface ContactHit {
    shapeA: ShapeId;
    shapeB: ShapeId;
    bodyA: BodyId;
    bodyB: BodyId;
    /** Point of contact, meters, world space. */
    point: Vec3;
    /** Unit normal, from A to B. */
    normal: Vec3;
    /** Approach speed, m/s, > 0. */
    approachSpeed: number;
    /**
     * Time of the hit: seconds after the beginning of the last step, 0 to the step's length (except for rounding). Hits
     * are not sorted by it. For bodies that bounce, or that move far within the step, it is the time of impact on a
     * straight path through the step; at 60 Hz under gravity this path is within 0.4 mm of the true one. For bodies
     * that come to rest, that already touch others, or that have joints, it is the time at which the gap would close at
     * the approach speed at the beginning of the step (of the current pass through the step where a body spins),
     * ignoring forces and other contacts until then. It is then limited to the end of the step, because the solver may
     * stop the approach a substep early, and is 0 if the shapes overlapped at the beginning.
     */
    time: number;
    /**
     * Number of the material of the mesh or height field where it was hit (0: the material of the shape); 0 for other
     * shapes.
     */
    surfaceMaterial: number;
}

/**
 * A shape began or ceased to overlap a trigger (`ShapeDef.isTrigger`). Every trigger detects shapes of dynamic and
 * kinematic bodies, including characters; triggers on dynamic and kinematic bodies detect shapes of static bodies as
 * well. Triggers do not detect each other. Overlaps are tested at the beginning of each step, so that a shape that
 * enters in one step is reported by the next. A shape that enters and leaves within one step has both events in that
 * step; these are listed after those found at its beginning, sorted by time. Handles of removed shapes are stale.
 */
export interface TriggerEvent {
    trigger: ShapeId;
    other: ShapeId;
    triggerBody: BodyId;
    otherBody: BodyId;
    /** true: the shape entered; false: it left, or one of the two shapes was removed. */
    inside: boolean;
    /**
     * Seconds after the beginning of the last step, 0 to the step's length. It is 0 for overlaps found at the
     * beginning; for a shape that passes through within the step, it is the time at which the shape, on its path,
     * entered or left.
     */
    time: number;
}

/**
 * A joint was removed by the engine: it broke under its load, or one of its bodies was destroyed. Its handle is stale.
 */
export interface JointEvent {
    joint: JointId;
    /** Null stands for the world. */
    bodyA: BodyId;
    /** Null stands for the world. */
    bodyB: BodyId;
    /** true: it exceeded its break force or torque; false: one of its bodies was destroyed. */
    broke: boolean;
    /** N: force at which it broke. */
    force: number;
    /** N m: torque at which it broke. */
    torque: number;
    /** The `userData` from the definition of the joint. */
    userData: bigint;
}

/** A body fell asleep or woke up. */
export interface SleepEvent {
    body: BodyId;
    /** true: it fell asleep; false: it woke up. */
    asleep: boolean;
}

/** One contact point of a contact manifold. */
export interface ContactPoint {
    /** Midway between the two surfaces, meters, world space. */
    point: Vec3;
    /** Meters; negative when the shapes overlap. */
    separation: number;
    /** N s: normal impulse during the last step, >= 0. Divided by the length of the step it is the mean force. */
    normalImpulse: number;
}

/**
 * A contact manifold of a touching pair of shapes, after the last step. A shape that touches a mesh or height field may
 * have several manifolds with it, one for each normal and material.
 */
export interface Contact {
    shapeA: ShapeId;
    shapeB: ShapeId;
    bodyA: BodyId;
    bodyB: BodyId;
    /** Unit normal, from A to B. */
    normal: Vec3;
    /** N s: friction impulse on B during the last step, world axes. */
    frictionImpulse: Vec3;
    /** Number of contact points, 1 to 4. */
    pointCount: number;
    /** The contact points; only the first `pointCount` elements are valid. */
    points: ContactPoint[];
    /**
     * Number of the material of the mesh or height field at the contact (0: the material of the shape); 0 for other
     * shapes.
     */
    surfaceMaterial: number;
}

/** Settings of a world. All may be changed later with `World.setSettings`. */
export interface WorldDef {
    /** Acceleration of gravity, m/s^2, finite. */
    gravity?: Vec3Like;
    /**
     * Number of solver substeps in a step, 0 to 256. 0: as many as are needed for substeps of at most 1/360 s (6 at 60
     * Hz, 2 at 240 Hz).
     */
    substeps?: number;
    /**
     * true: more substeps for islands that need them: with joints (substeps of at most 1/660 s), high mass ratios, tall
     * stacks, or bodies less than 10 cm wide.
     */
    adaptiveSubsteps?: boolean;
    /** How free motion is integrated. */
    integrator?: Integrator;
    /** true: islands at rest fall asleep, and then cost no time. */
    enableSleep?: boolean;
    /** m/s, >= 0: a body is at rest if no point of its surface is faster. */
    sleepSpeed?: number;
    /** s, >= 0: time at rest before an island falls asleep, unless its speed grows steadily. */
    sleepTime?: number;
    /** m/s, >= 0: slower impacts do not bounce. */
    restitutionSpeed?: number;
    /** m/s, >= 0: least approach speed for a hit event. */
    hitSpeed?: number;
    /** m/s, > 0: greatest speed at which overlapping shapes are pushed apart. */
    recoverySpeed?: number;
    /** m/s, > 0, at most 1e15: higher speeds are reduced to this, and counted (`Statistics.clampedSpeeds`). */
    maxLinearSpeed?: number;
    /** rad/s, > 0: higher angular speeds are reduced to this, and counted. */
    maxAngularSpeed?: number;
}

/**
 * A field that acts on all dynamic bodies: an acceleration or a force, evaluated at the center of mass of each body, or
 * a fluid. A fluid (water, oil, air) fills a box below its surface, which is the plane through `center` perpendicular
 * to the world's gravity. Buoyancy equals the weight of the displaced fluid in the world's gravity (Archimedes). Drag
 * is computed over the surface of a body: a surface element that moves into the fluid with the normal speed s is pushed
 * back with a pressure of drag x density x s^2 / 2, and one that moves along the fluid with the tangential speed t with
 * a shear stress of skinFriction x density x t^2 / 2. A part of the fluid moves along with a body (`addedMass`). There
 * are no waves, but a body that bobs loses energy as if it made waves (`waveDamping`). A fluid acts on solid shapes,
 * not on triggers. At the sides of the box it acts on the part of a shape that is inside the box; at its bottom, on
 * shapes whose middle is above the bottom. Where fluids overlap, both act.
 */
export interface ForceField {
    /** The kind of the field. */
    kind?: ForceFieldKind;
    /** m/s^2 or N or m/s. Uniform: acceleration, or force if `isForce`. Fluid: velocity of its flow. */
    direction?: Vec3Like;
    /** Radial: the center of attraction, meters. Fluid: the middle of its surface, meters. */
    center?: Vec3Like;
    /** Radial: acceleration or force (m/s^2 or N) at a distance of 1 m; negative: repulsion. */
    strength?: number;
    /** Radial: -2, -1, 0 or 1. -2 is point gravity, 0 is constant, 1 is a spring. */
    exponent?: number;
    /** Uniform, radial: false: an acceleration, the same for all masses; true: a force. */
    isForce?: boolean;
    /**
     * Fluid: half extents of its box along the world axes, from `center`, meters, > 0; may be infinite. Along the axis
     * closest to the direction of gravity it is the depth.
     */
    halfExtents?: Vec3Like;
    /** Fluid: kg/m^3, >= 0. The default is the density of water. */
    density?: number;
    /** Fluid: coefficient of pressure drag, >= 0. A plate has this drag coefficient, a ball half of it. */
    drag?: number;
    /** Fluid: coefficient of skin friction, >= 0. */
    skinFriction?: number;
    /**
     * Fluid: mass of fluid that moves along with a body, as a fraction of the displaced mass, >= 0; for a ball it is
     * 0.5.
     */
    addedMass?: number;
    /** Fluid: damping of bobbing by waves, as a fraction of critical damping, >= 0. */
    waveDamping?: number;
}

/**
 * Wall-clock time of the stages of the last step, in milliseconds. Not part of snapshots: 0 after a world is restored.
 */
export interface StageTimes {
    /** Broad phase: pairs of shapes whose bounds overlap, ms. */
    broadPhase: number;
    /** Narrow phase: contact points, ms. */
    narrowPhase: number;
    /** Islands: bodies that are solved together, ms. */
    islands: number;
    /** Preparation of constraint rows, ms. */
    prepare: number;
    /** Substeps of the solver, ms. */
    solve: number;
    /** New poses of bodies, events, sleeping, ms. */
    finalize: number;
    /** The whole step, ms. */
    total: number;
}

/** Counts and times of the last step. */
export interface Statistics {
    /** Steps since the world was created. */
    steps: bigint;
    /** Simulated time since then, s. */
    time: number;
    /** Number of bodies. */
    bodies: number;
    /** Number of dynamic bodies. */
    dynamicBodies: number;
    /** Number of bodies that are awake. */
    awakeBodies: number;
    /** Number of shapes. */
    shapes: number;
    /** Pairs of shapes whose bounds overlap. */
    candidatePairs: number;
    /**
     * How many of these pairs the narrow phase tested in the last step. The others were well separated or asleep, or
     * their bodies have moved by at most a few millimeters since their last test.
     */
    testedPairs: number;
    /** Touching pairs of shapes, including sleeping ones. */
    contacts: number;
    /** Contact points of these pairs. */
    contactPoints: number;
    /** Awake islands. */
    islands: number;
    /** Islands that are asleep. */
    sleepingIslands: number;
    /** Colors of the constraint graph; contacts of different colors are solved in turn. */
    colors: number;
    /** Contacts for which no color of the constraint graph was free; they are solved one by one. */
    overflowContacts: number;
    /** How many times since the world was created a speed was reduced to the maximum. */
    clampedSpeeds: bigint;
    /** Greatest number of substeps of any awake island. */
    maxSubsteps: number;
    /** Deepest overlap, meters, >= 0. */
    maxPenetration: number;
    /** Pairs tested along their paths in the last step, because one of the bodies moved far. */
    sweptPairs: number;
    /** Impacts of bodies in free flight in the last step; one body may have several. */
    impacts: number;
    /** Bodies that were stopped in the last step where they met a shape with which the solver had no contact. */
    stoppedBodies: number;
    /** Times of the stages of the last step. */
    times: StageTimes;
}

/** How the size of a snapshot, in bytes, is made up. */
export interface SnapshotSizes {
    /**
     * Dynamic state of the bodies and their shapes: position, rotation, velocities, the pose at which they came to
     * rest, island, time at rest, forces. (bytes)
     */
    bodies: number;
    /** Pairs of shapes: contact points, and the impulses for warm starting the next step. (bytes) */
    contacts: number;
    /** Impulses for warm starting the next step, and positions. (bytes) */
    joints: number;
    /** Bounding boxes, their trees, and the list of pairs. (bytes) */
    broadPhase: number;
    /** Header, counters, and events that the next step will report. (bytes) */
    other: number;
    /** The definitions, which many snapshots may share. (bytes) */
    definitions: number;
}

/** Any shape. A compound is a body with several shapes. */
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
 * The data of a hull, mesh or height field. They never change, and many shapes, also of several worlds, may share them.
 * Shapes remain valid after their geometry is disposed of.
 */
export class Geometry {
    private constructor();
    /**
     * The convex hull of points: x, y, z of each, meters, in the frame of the shape. Throws invalidValue when a
     * coordinate is not finite or exceeds 1e6, when there are fewer than 4 points, or when all of them coincide, lie on
     * one line or lie in one plane.
     */
    static hull(points: readonly number[] | Float32Array | Float64Array): Geometry;
    /**
     * A triangle mesh. `vertices`: x, y, z of each, meters, in the frame of the shape. `indices`: three for each
     * triangle, counterclockwise as seen from outside. Triangles without area are omitted. `materials`: materials in
     * addition to that of the shape. `materialNumbers`: the material of each triangle, 0 for the material of the shape,
     * k for materials[k - 1]; empty: all have the material of the shape. Throws invalidValue when a coordinate is not
     * finite or exceeds 1e6, when an index is out of range, when the number of indices is not a multiple of three, or
     * when no triangle is left.
     */
    static mesh(
        vertices: readonly number[] | Float32Array | Float64Array,
        indices: readonly number[] | Uint32Array | Uint16Array,
        materials?: readonly Material[],
        materialNumbers?: readonly number[] | Uint16Array | Uint8Array,
    ): Geometry;
    /**
     * A surface over a grid, solid below. `heights`: columns x rows heights along y, row by row, meters. Triangles that
     * have a vertex with the height Infinity are holes. `spacing`: distance of neighboring points of the grid along x
     * and z, meters, > 0. Materials as for `mesh`, with a number for each cell, row by row. Throws invalidValue for
     * fewer than 2 columns or rows, another number of heights, a spacing that is not finite and > 0, a height that is
     * NaN or exceeds 1e6 and is not Infinity, or a field that consists of holes only.
     */
    static heightField(
        columns: number,
        rows: number,
        spacing: Vec2Like,
        heights: readonly number[] | Float32Array | Float64Array,
        materials?: readonly Material[],
        materialNumbers?: readonly number[] | Uint16Array | Uint8Array,
    ): Geometry;
    /**
     * The vertices of a hull or mesh, or the points of the grid of a height field with their heights: x, y, z of each,
     * meters; y of a hole is Infinity.
     */
    get vertices(): Float32Array;
    /**
     * The triangles of a mesh, or those of a height field that are not holes: three indices of `vertices` for each.
     * Throws invalidValue for a hull.
     */
    get indices(): Uint32Array;
    /** The materials of a mesh or height field in addition to that of the shape. Throws invalidValue for a hull. */
    get materials(): Material[];
    /**
     * The material number of each triangle of a mesh or cell of a height field; empty: all have the material of the
     * shape. Throws invalidValue for a hull.
     */
    get materialNumbers(): Uint16Array;
    /**
     * How many triangles of a mesh were omitted because they have no area. Throws invalidValue for other geometries.
     */
    get droppedTriangles(): number;
    /**
     * The faces of a hull: the indices of the vertices of each, counterclockwise as seen from outside. Throws
     * invalidValue for other geometries.
     */
    get faces(): number[][];
    /** Volume of a hull without rounding, m^3. Throws invalidValue for other geometries. */
    get volume(): number;
    /** The grid of a height field. Throws invalidValue for other geometries. */
    get grid(): { columns: number; rows: number; spacing: Vec2 };
    /** The heights of a height field, row by row, meters. Throws invalidValue for other geometries. */
    get heights(): Float32Array;
    /**
     * Frees the memory. A second call has no effect. If it is never called, the memory is freed when the object is
     * garbage collected.
     */
    dispose(): void;
    [Symbol.dispose](): void;
}

/** The complete state of a world at one time, to which it can be restored. */
export class Snapshot {
    private constructor();
    get sizes(): SnapshotSizes;
    /**
     * Frees the memory. A second call has no effect. If it is never called, the memory is freed when the object is
     * garbage collected.
     */
    dispose(): void;
    [Symbol.dispose](): void;
}

/**
 * A body of a world, identified by its handle. Every call throws invalidHandle once the body is destroyed. Setting a
 * property wakes the body.
 */
export class Body {
    private constructor();
    readonly world: World;
    readonly id: BodyId;
    /** Whether the body still exists. */
    get isValid(): boolean;
    /** See `World.addShape`. */
    addShape(shape: Shape, definition?: ShapeDef): ShapeId;
    /** See `World.destroyBody`. */
    destroy(): void;
    /** How the body moves. Setting: Makes the body static, kinematic or dynamic. */
    get type(): BodyType;
    set type(value: BodyType);
    /**
     * The name of the body, as in `BodyDef.name`. Setting: Sets the name, for display and `World.findBody`; it need not
     * be unique.
     */
    get name(): string;
    set name(value: string);
    /** The number that the application stored in `BodyDef.userData`. */
    get userData(): bigint;
    /**
     * Origin of the body's frame, meters. Setting: Teleports the origin of the body's frame: velocities stay, and
     * contacts are detected afresh in the next step.
     */
    get position(): Vec3;
    set position(value: Vec3Like);
    /**
     * Rotation of the body's frame, of unit length. Setting: Rotates the body about its origin at once: velocities
     * stay, and contacts are detected afresh in the next step. Normalized on entry; must not be zero.
     */
    get rotation(): Quat;
    set rotation(value: QuatLike);
    /** Position and rotation of the body's frame. */
    get transform(): Complete<Transform>;
    /**
     * Center of mass in world space, meters. For a kinematic body: its origin, unless `BodyDef.massProperties` gave a
     * center of mass.
     */
    get centerOfMass(): Vec3;
    /**
     * Velocity of the center of mass, m/s. Setting: Sets the velocity of the center of mass, m/s. Refused (wrongState)
     * for static bodies.
     */
    get linearVelocity(): Vec3;
    set linearVelocity(value: Vec3Like);
    /**
     * Angular velocity in world axes, rad/s. Setting: Sets the angular velocity, rad/s, world axes. Refused
     * (wrongState) for static bodies.
     */
    get angularVelocity(): Vec3;
    set angularVelocity(value: Vec3Like);
    /**
     * Velocity of the body's material at a point in world space, m/s. Throws invalidHandle, invalidValue, wrongState.
     */
    velocityAt(point: Vec3Like): Vec3;
    /** Mass, kg; +infinity for static and kinematic bodies. */
    get mass(): number;
    /**
     * Mass, center of mass and inertia, as set or computed from the shapes. Setting: Sets the mass properties, which
     * then do not follow the shapes. Dynamic bodies only; refused (wrongState) for others.
     */
    get massProperties(): Complete<MassProperties>;
    set massProperties(value: MassProperties);
    /** Inertia tensor about the center of mass, world axes, kg m^2. */
    get worldInertia(): number[];
    /** Angular momentum about the center of mass, kg m^2/s. */
    get angularMomentum(): Vec3;
    /** Linear and rotational kinetic energy, J; 0 for static and kinematic bodies. */
    get kineticEnergy(): number;
    /**
     * The factor by which gravity is multiplied for this body. Setting: Sets the factor by which gravity is multiplied
     * for this body; any finite value.
     */
    get gravityScale(): number;
    set gravityScale(value: number);
    /** Damping of the linear velocity, 1/s. */
    get linearDamping(): number;
    /** Damping of the angular velocity, 1/s. */
    get angularDamping(): number;
    /**
     * Whether the body is awake. A static or disabled body never is; a kinematic body is while one of its velocities is
     * not zero.
     */
    get isAwake(): boolean;
    /** Whether the body may fall asleep. Setting: false: the body and its island never fall asleep. */
    get allowSleep(): boolean;
    set allowSleep(value: boolean);
    /**
     * Whether the body takes part in the simulation. Setting: Takes the body out of the simulation (false) or puts it
     * back (true), and keeps its shapes, joints and handles. This suits bodies that are reused often, or that are
     * needed only later. A disabled body does not move but keeps its velocities; it has no contacts, queries do not
     * find it, its joints do not act, and energies and momenta of the world exclude it. Its properties may be changed,
     * but forces and impulses are refused (wrongState). When it is disabled, its contacts end with a ContactEnd, and
     * the bodies that it touched wake. If it overlaps others when it is enabled, it is pushed out of them like a newly
     * created body.
     */
    get enabled(): boolean;
    set enabled(value: boolean);
    /** The shapes of the body, oldest first. */
    get shapes(): ShapeId[];
    /**
     * Teleports the body: its velocities stay, and its contacts are detected afresh in the next step. Throws
     * invalidHandle, invalidValue, wrongState.
     */
    setTransform(position: Vec3Like, rotation: QuatLike): void;
    /**
     * Sets the velocities of a kinematic body such that it reaches `target` after `seconds` (> 0). It keeps these
     * velocities afterwards. Refused (wrongState) for bodies of other types. Throws invalidHandle, invalidValue,
     * wrongState.
     */
    moveTo(target: Transform, seconds: number): void;
    /**
     * Sets the damping of the linear and angular velocity, 1/s, >= 0: velocities decay as v' = -damping v. Throws
     * invalidHandle, invalidValue, wrongState.
     */
    setDamping(linear: number, angular: number): void;
    /**
     * Makes the mass properties follow the densities of the shapes again, scaled to a total of `mass` (kg, > 0) if it
     * is given. Dynamic bodies only; refused (wrongState) for others. Throws invalidHandle, invalidValue, wrongState.
     */
    setMassFromShapes(mass?: number | null): void;
    /** Wakes the body and its island. Throws invalidHandle, wrongState. */
    wake(): void;
    /**
     * Sets the velocities of a dynamic body to zero and puts it to sleep at the beginning of the next step, at its
     * present place, even in the air. This requires that `sleep` was called for all bodies of its island, that is, also
     * for those that it touches or is joined to, and that all of them may sleep. A level that is created asleep costs
     * no time until something wakes it; then it settles like newly created bodies. Calls that move or push the body
     * before that step wake it as usual. No effect on other types of bodies, and where `WorldDef.enableSleep` is false.
     * Throws invalidHandle, wrongState.
     */
    sleep(): void;
    /**
     * Adds a force, N, at the center of mass; it acts during the next step only. Throws invalidHandle, invalidValue,
     * wrongState.
     */
    addForce(force: Vec3Like): void;
    /**
     * Adds a force, N, at a point in world space; it acts during the next step only. Throws invalidHandle,
     * invalidValue, wrongState.
     */
    addForceAt(force: Vec3Like, point: Vec3Like): void;
    /** Adds a torque, N m; it acts during the next step only. Throws invalidHandle, invalidValue, wrongState. */
    addTorque(torque: Vec3Like): void;
    /**
     * Applies an impulse, N s, at the center of mass; it changes the velocity at once. Throws invalidHandle,
     * invalidValue, wrongState.
     */
    applyImpulse(impulse: Vec3Like): void;
    /**
     * Applies an impulse, N s, at a point in world space; it changes the velocities at once. Throws invalidHandle,
     * invalidValue, wrongState.
     */
    applyImpulseAt(impulse: Vec3Like, point: Vec3Like): void;
    /**
     * Applies an angular impulse, N m s; it changes the angular velocity at once. Throws invalidHandle, invalidValue,
     * wrongState.
     */
    applyAngularImpulse(impulse: Vec3Like): void;
    /** Whether the body is a character. */
    get isCharacter(): boolean;
    /**
     * The definition of the character. Refused (wrongState) if the body is no character. Setting: Makes a kinematic
     * body a character, or changes the definition of a character. From then on each step sets the velocities of the
     * body to those with which it moves the character. Setting its linear velocity then throws the character: with an
     * upward velocity, it leaves the ground.
     */
    get character(): Complete<CharacterDef>;
    set character(value: CharacterDef);
    /** Makes the character an ordinary kinematic body again, at rest. Throws invalidHandle, wrongState. */
    removeCharacter(): void;
    /**
     * The velocity with which the character tries to move, m/s, relative to the ground. Refused (wrongState) if the
     * body is no character. Setting: Sets the velocity with which a character tries to move, m/s, relative to the
     * ground; it holds until the next call. The character moves along the ground with this speed, in this direction as
     * seen from above. The component along `CharacterDef.up` is used only if the character flies
     * (`CharacterDef.flies`).
     */
    get walkVelocity(): Vec3;
    set walkVelocity(value: Vec3Like);
    /**
     * A character that stands on the ground leaves it in the next step with this upward speed, m/s, > 0. No effect on a
     * character that does not stand then. Throws invalidHandle, invalidValue, wrongState.
     */
    jump(speed: number): void;
    /**
     * The motion and support of the character after the last step. Refused (wrongState) if the body is no character.
     */
    get characterState(): CharacterState;
    /** The joints of one body, oldest first. */
    get joints(): JointId[];
    /** The contact manifolds of one body. */
    get contacts(): Contact[];
}

/**
 * The arrays that `World.readBodies` fills, with the bodies in the order of `World.bodies`. Quantities without an array
 * are not read.
 */
export interface BodyArrays {
    /** Origin of the frame of each body: x, y, z, meters. */
    positions?: Float64Array;
    /** Rotation of each body: x, y, z, w of a unit quaternion. */
    rotations?: Float32Array;
    /** Velocity of the center of mass of each body: x, y, z, m/s. */
    linearVelocities?: Float32Array;
    /** Angular velocity of each body, in world space: x, y, z, rad/s. */
    angularVelocities?: Float32Array;
}

/**
 * The surface of a shape as triangles for rendering, in the frame of the shape. Three indices for each triangle,
 * counterclockwise as seen from outside.
 */
export interface Triangles {
    vertices: Float32Array;
    /** The unit normal at each vertex; null: draw with flat shading. */
    normals: Float32Array | null;
    indices: Uint32Array;
}

/** A world of rigid bodies. */
export class World {
    /** Creates an empty world. Throws invalidValue. */
    constructor(definition?: WorldDef);
    /**
     * Creates a world from a scene: glTF with KHR_physics_rigid_bodies, as text (.gltf) or bytes (.gltf, .glb). `name`
     * identifies the scene in error messages. Throws invalidFile, unsupported (also if the scene refers to other
     * files), invalidValue.
     */
    static load(scene: string | ArrayBuffer | Uint8Array, name?: string): World;
    /** The present state of the world as the text of a .gltf file. Throws wrongState. */
    saveScene(): string;
    /** The default time step of `step`, seconds: 1/60, or that of the scene from which the world was loaded. */
    timeStep: number;
    /** Creates a body without shapes. Throws invalidValue, wrongState. */
    createBody(definition?: BodyDef): Body;
    /**
     * Destroys a body with its shapes and joints, and wakes bodies that rested on it. Throws invalidHandle, wrongState.
     */
    destroyBody(body: BodyId | Body): void;
    /** The body with a handle. The handle is not checked: see `Body.isValid`. */
    body(id: BodyId): Body;
    bodyIsValid(id: BodyId | Body | null): boolean;
    shapeIsValid(id: ShapeId | null): boolean;
    jointIsValid(id: JointId | null): boolean;
    forceFieldIsValid(id: ForceFieldId | null): boolean;
    /**
     * Advances the simulation by `count` steps (default: 1) of `seconds` each (default: `timeStep`; > 0, finite). The
     * results are best if all steps have the same length. The events are those of the last step. Throws invalidValue,
     * wrongState.
     */
    step(seconds?: number, count?: number): void;
    /** Saves the complete state. A world that is restored from it continues bit for bit. Throws wrongState. */
    save(): Snapshot;
    /** Restores the state that was saved. Handles of that time are valid again. Throws invalidValue, wrongState. */
    restore(snapshot: Snapshot): void;
    /**
     * The definition of a joint whose two frames coincide, for the present poses of the bodies: with their origin at
     * `anchor` (world space, meters) and x along `axis` (world space, any non-zero vector). Throws invalidHandle,
     * invalidValue, wrongState.
     */
    jointAt(bodyA: BodyId | Body | null, bodyB: BodyId | Body | null, anchor: Vec3Like, axis: Vec3Like, joint: Joint): Complete<JointDef>;
    /** The present definition of a joint. Throws invalidHandle, wrongState. */
    jointDef(joint: JointId): Complete<JointDef>;
    /**
     * Writes the positions, rotations and velocities of all bodies, in the order of `bodies`, into the given arrays,
     * and returns them. Throws invalidValue if the length of an array is not 3 or 4 numbers for each body; then no
     * array is changed.
     */
    readBodies<T extends BodyArrays>(arrays: T): T;
    get bodyCount(): number;
    /**
     * The positions of all bodies in a new array, as in `BodyArrays`; so are the rotations and velocities below.
     */
    get positions(): Float64Array;
    get rotations(): Float32Array;
    get linearVelocities(): Float32Array;
    get angularVelocities(): Float32Array;
    /**
     * The surface of a shape as triangles for rendering. Infinite planes are squares of 200 m. Throws invalidHandle,
     * wrongState.
     */
    shapeTriangles(shape: ShapeId): Triangles;
    /**
     * The color that the scene file gives to a shape, linear red, green and blue, each 0 to 1; null if it gives none.
     * Throws invalidHandle, wrongState.
     */
    shapeColor(shape: ShapeId): Vec3 | null;
    /**
     * Frees the memory of the world. Every call after that throws wrongState, except a second `dispose`, which has no
     * effect.
     */
    dispose(): void;
    [Symbol.dispose](): void;
    /**
     * Adds a shape to a body and, unless its mass properties were given, updates these. A dynamic body whose shapes
     * have no mass has its given mass, or 1 kg, at a point, and does not rotate. Planes, meshes and height fields are
     * refused on dynamic bodies (wrongState). Throws invalidHandle, invalidValue, wrongState.
     */
    addShape(body: BodyId | Body | null, shape: Shape, definition?: ShapeDef): ShapeId;
    /**
     * Removes a shape from its body and, unless the mass properties of the body were given, updates these. Throws
     * invalidHandle, wrongState.
     */
    removeShape(shape: ShapeId | null): void;
    /**
     * Replaces the geometry of a shape; its handle and its definition stay. The mass of the body is updated as when a
     * shape is added. If the new geometry is of the same type, contacts with shapes that it still touches continue
     * without events; otherwise its contacts end and begin anew. Shapes that overlap the new geometry are pushed out
     * with at most `WorldDef.recoverySpeed`. Rising ground therefore carries the bodies on it if it rises more slowly
     * than that, and in one call by less than the height of the body. Wakes the body of the shape, and bodies around
     * the old and the new geometry. Throws invalidHandle, invalidValue, wrongState.
     */
    setShape(shape: ShapeId | null, geometry: Shape): void;
    /**
     * Replaces the definition of a shape in the same way as its geometry: its pose on the body, density, material,
     * filter, and so on. To change only a part of it, begin with the present definition. Its contacts end and begin
     * anew if `isTrigger` or `filter` changes. Throws invalidHandle, invalidValue, wrongState.
     */
    setShapeDef(shape: ShapeId | null, definition: ShapeDef): void;
    /** The body to which a shape belongs. Throws invalidHandle, wrongState. */
    bodyOf(shape: ShapeId | null): BodyId;
    /** The geometry of a shape. Throws invalidHandle, wrongState. */
    shape(shape: ShapeId | null): Shape;
    /** The present definition of a shape. Throws invalidHandle, wrongState. */
    shapeDef(shape: ShapeId | null): Complete<ShapeDef>;
    /** The pose of a shape in world space. Throws invalidHandle, wrongState. */
    shapeTransform(shape: ShapeId | null): Complete<Transform>;
    /** Tight axis-aligned bounds of a shape, meters; infinite for infinite planes. Throws invalidHandle, wrongState. */
    shapeBounds(shape: ShapeId | null): Complete<Bounds>;
    /** Replaces the material of a shape. Throws invalidHandle, invalidValue, wrongState. */
    setMaterial(shape: ShapeId | null, material: Material): void;
    /** Replaces the collision filter of a shape. Throws invalidHandle, invalidValue, wrongState. */
    setFilter(shape: ShapeId | null, filter: CollisionFilter): void;
    /**
     * Sets `ShapeDef.surfaceVelocity`, m/s. Refused (wrongState) for a shape of a dynamic body. Throws invalidHandle,
     * invalidValue, wrongState.
     */
    setSurfaceVelocity(shape: ShapeId | null, velocity: Vec3Like): void;
    /** All bodies, in order of slot index. */
    get bodies(): BodyId[];
    /** The first body with that name. Throws wrongState. */
    findBody(name: string): BodyId | null;
    /** Joins two bodies, or a body and the world, and wakes them. Throws invalidValue, wrongState. */
    createJoint(definition: JointDef): JointId;
    /** Destroys a joint and wakes its bodies. Throws invalidHandle, wrongState. */
    destroyJoint(joint: JointId | null): void;
    /**
     * Replaces the type-specific part of a joint: limits, motors, springs, or its type. Wakes its bodies. Throws
     * invalidHandle, invalidValue, wrongState.
     */
    setJoint(id: JointId | null, joint: Joint): void;
    /**
     * Sets the force (N) and torque (N m) at which a joint breaks, > 0; may be infinite. Throws invalidHandle,
     * invalidValue, wrongState.
     */
    setJointStrength(joint: JointId | null, breakForce: number, breakTorque: number): void;
    /**
     * Disables or enables a joint. A disabled joint keeps its definition and its handle but does not act: its bodies
     * move and collide as if it had been destroyed. When it is enabled, it starts with zero impulses, and pulls its
     * bodies together if they have moved apart. Both wake its bodies. Throws invalidHandle, wrongState.
     */
    setJointEnabled(joint: JointId | null, enabled: boolean): void;
    /** Forces, positions and errors of a joint in the last step. Throws invalidHandle, wrongState. */
    jointState(joint: JointId | null): JointState;
    /** All joints, in order of slot index. */
    get joints(): JointId[];
    /** The first joint with that name. Throws wrongState. */
    findJoint(name: string): JointId | null;
    /**
     * The nearest intersection of a ray with a shape within `maxDistance` (meters). `direction` need not have unit
     * length. A ray that starts inside a shape does not hit that shape; only one that starts below an infinite plane
     * hits it, at distance 0. Throws invalidHandle, invalidValue, wrongState.
     */
    castRay(origin: Vec3Like, direction: Vec3Like, maxDistance: number, filter?: QueryFilter): RayHit | null;
    /**
     * The intersections of the ray with all shapes within `maxDistance` (meters), nearest first. Throws invalidHandle,
     * invalidValue, wrongState.
     */
    castRayAll(origin: Vec3Like, direction: Vec3Like, maxDistance: number, filter?: QueryFilter): RayHit[];
    /**
     * The first shape that the given convex shape hits when it moves by `translation` (meters) from `start` without
     * rotation. The accuracy is a millionth of the size of the smaller shape. If they overlap at the start, the
     * fraction is 0, and point and normal are those of the smallest separating translation; if several shapes overlap,
     * the one with the lowest slot index is returned. Planes, meshes and height fields are hit from outside only, and
     * cannot be cast (invalidValue). Throws invalidHandle, invalidValue, wrongState.
     */
    castShape(shape: Shape, start: Transform, translation: Vec3Like, filter?: QueryFilter): ShapeCastHit | null;
    /**
     * The shape nearest to a point, at most `maxDistance` (meters, >= 0) away. Points below a plane are inside it;
     * meshes and height fields have no inside. Throws invalidHandle, invalidValue, wrongState.
     */
    closestPoint(point: Vec3Like, maxDistance: number, filter?: QueryFilter): ClosestPoint | null;
    /**
     * All shapes that have a point in common with the given shape at `pose` (touching counts), in order of slot index.
     * A plane is solid below. Rectangles, strips, double-sided planes, meshes and height fields are surfaces without
     * thickness: a shape that touches or crosses them from any side overlaps them; a shape entirely below does not. Two
     * surfaces never overlap. Throws invalidHandle, invalidValue, wrongState.
     */
    overlap(shape: Shape, pose: Transform, filter?: QueryFilter): ShapeId[];
    /**
     * Shapes whose tight bounds overlap the box, in order of slot index. Throws invalidHandle, invalidValue,
     * wrongState.
     */
    overlapBounds(bounds: Bounds, filter?: QueryFilter): ShapeId[];
    /**
     * The present nodes of the broad phase down to `maxDepth` (>= 0), in order of depth, at most `maxCount` (>= 0): for
     * visualization, and to find out why a scene is slow. Throws invalidValue, wrongState.
     */
    broadPhaseNodes(maxDepth: number, maxCount: number): BroadPhaseNode[];
    /** How each touching pair of shapes is solved, in the order of `worldGetContacts`. */
    get solverContacts(): SolverContact[];
    /**
     * The contents of the world as lines, for programs with their own renderer: bodies in order of slot index, then
     * contacts, then joints. There is a line for each edge, which takes time for large meshes and height fields. Throws
     * invalidValue, wrongState.
     */
    debugLines(what?: DebugLinesDef): DebugLine[];
    /** Pairs of shapes that began to touch in the last step. */
    get contactBegins(): ContactBegin[];
    /** Pairs of shapes that ceased to touch in the last step. */
    get contactEnds(): ContactEnd[];
    /** Pairs of shapes that hit each other in the last step with an approach speed of at least `WorldDef.hitSpeed`. */
    get contactHits(): ContactHit[];
    /** Shapes that entered or left triggers in the last step. */
    get triggerEvents(): TriggerEvent[];
    /** Joints that broke, or of which a body was destroyed, in the last step or since then. */
    get jointEvents(): JointEvent[];
    /** Bodies that fell asleep or woke up in the last step. */
    get sleepEvents(): SleepEvent[];
    /** The contact manifolds of all touching pairs of shapes. */
    get contacts(): Contact[];
    /** The present settings of the world. Setting: Replaces the settings. Wakes all bodies if gravity changes. */
    get settings(): Complete<WorldDef>;
    set settings(value: WorldDef);
    /**
     * The number of substeps in a step of `dt` seconds for islands that need no more: `WorldDef.substeps`, or, if that
     * is 0, the number for which it stands. Refused (invalidValue) unless `dt` is finite and > 0. Throws invalidValue,
     * wrongState.
     */
    usualSubsteps(dt: number): number;
    /**
     * The number of threads that a step may use. Setting: Sets the number of threads that a step may use, 1 to 256: the
     * caller's, and `count` - 1 that the world keeps. Default: 1. Results do not depend on it, and it is not part of
     * snapshots. Refused (invalidValue) outside that range, and (unsupported) if the system cannot create the threads.
     */
    get threads(): number;
    set threads(value: number);
    /** Adds a force field, which acts on all dynamic bodies from the next step on. Throws invalidValue, wrongState. */
    addForceField(field: ForceField): ForceFieldId;
    /** Replaces a force field by another. Throws invalidHandle, invalidValue, wrongState. */
    setForceField(id: ForceFieldId | null, field: ForceField): void;
    /** Removes a force field from the world. Throws invalidHandle, wrongState. */
    removeForceField(id: ForceFieldId | null): void;
    /** The present definition of a force field. Throws invalidHandle, wrongState. */
    forceField(id: ForceFieldId | null): Complete<ForceField>;
    /** All force fields, in order of slot index. */
    get forceFields(): ForceFieldId[];
    /** Number of steps since the world was created. */
    get stepCount(): bigint;
    /** Simulated time since the world was created, seconds. */
    get time(): number;
    /** Kinetic energy of all dynamic bodies, J. */
    get kineticEnergy(): number;
    /** Potential energy in the world's gravity, relative to the origin, J. */
    get potentialEnergy(): number;
    /** Linear momentum of all dynamic bodies, kg m/s. */
    get linearMomentum(): Vec3;
    /** Angular momentum of all dynamic bodies about the origin, kg m^2/s. */
    get angularMomentum(): Vec3;
    /** A hash of the bits of all positions, rotations and velocities. */
    get stateHash(): bigint;
    /** Counts and times of the last step. */
    get statistics(): Statistics;
}
