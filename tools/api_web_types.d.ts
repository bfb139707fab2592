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

// From the table: the structs and enums.
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
    // From the table: Body.
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
    // From the table: World.
}
