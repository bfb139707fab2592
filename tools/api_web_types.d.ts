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

// From the table: the structs and enums.
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
    // From the table: Body.
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
    // From the table: World.
}
