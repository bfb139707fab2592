// World, Body and Snapshot: the hand-written part beside the generated calls.
import { refuse } from './error.js';
import { M, check, enter, handleOf, leave, listOf, numberOf, room, textAt, textOf, use, wholeOf } from './memory.js';
import * as fields from './fields.js';
import * as values from './generated/values.js';
import { BodyCalls, WorldCalls } from './generated/calls.js';

// Release worlds and snapshots that were not disposed of.
const lostWorlds = new FinalizationRegistry((address) => M._cairn_world_destroy(address));
const lostSnapshots = new FinalizationRegistry((address) => M._cairn_snapshot_release(address));

/** Runs `call` between `enter` and `leave`. */
function during(call) {
    const mark = enter();
    try {
        return call();
    } finally {
        leave(mark);
    }
}

// The complete state of a world at one time.
export class Snapshot {
    constructor(world) {
        this.address = 0;
        this.address = during(() => {
            const out = room(4);
            check(M._cairn_world_save(use(world), out));
            return M.HEAPU32[out >> 2];
        });
        lostSnapshots.register(this, this.address, this);
    }
    get sizes() {
        return during(() => {
            const out = room(values.SNAPSHOT_SIZES_BYTES);
            check(M._cairn_snapshot_get_sizes(snapshotAddress(this), out));
            return values.getSnapshotSizes(out);
        });
    }
    dispose() {
        if (this.address === 0) return;
        lostSnapshots.unregister(this);
        M._cairn_snapshot_release(this.address);
        this.address = 0;
    }
}

function snapshotAddress(snapshot) {
    if (!(snapshot instanceof Snapshot)) refuse('snapshot', snapshot, 'must be a Snapshot');
    if (snapshot.address === 0) refuse('Snapshot', 'disposed', 'must not be disposed', 'wrongState');
    return snapshot.address;
}

// A body of a world, identified by its handle.
export class Body extends BodyCalls {
    constructor(world, id) {
        super();
        [this.low, this.high] = handleOf(id, 'id');
        this.world = world;
        this.id = BigInt.asUintN(64, typeof id === 'bigint' ? id : id === null ? 0n : id.id);
    }
    get isValid() {
        return this.world.bodyIsValid(this.id);
    }
    addShape(shape, definition = {}) {
        return this.world.addShape(this.id, shape, definition);
    }
    destroy() {
        this.world.destroyBody(this.id);
    }
}

// The arrays of readBodies: the number of components, and the class that each must have.
const COLUMNS = {
    positions: { components: 3, kind: Float64Array },
    rotations: { components: 4, kind: Float32Array },
    linearVelocities: { components: 3, kind: Float32Array },
    angularVelocities: { components: 3, kind: Float32Array },
};

const MAX_THREADS = 256; // the engine's limit

export class World extends WorldCalls {
    constructor(definition = {}) {
        super();
        this.address = 0;
        this.adopt(
            during(() => {
                const def = room(values.WORLD_DEF_BYTES);
                M._cairn_default_world_def(def);
                values.putWorldDef(def, definition, 'WorldDef');
                const out = room(4);
                check(M._cairn_world_create(def, out));
                return M.HEAPU32[out >> 2];
            }),
        );
        this.timeStep = 1 / 60;
    }

    /** Makes this object own the world at an address in the module. */
    adopt(address) {
        this.dispose();
        this.address = address;
        lostWorlds.register(this, address, this);
    }

    static load(bytes, name = 'scene') {
        return during(() => {
            const data =
                typeof bytes === 'string'
                    ? new TextEncoder().encode(bytes)
                    : bytes instanceof ArrayBuffer
                      ? new Uint8Array(bytes)
                      : bytes;
            if (!(data instanceof Uint8Array))
                refuse('bytes', bytes, 'must be a Uint8Array, an ArrayBuffer or a string');
            const at = room(data.length);
            M.HEAPU8.set(data, at);
            const text = textAt(name, 'name');
            const out = room(4),
                step = room(4);
            check(M._cairn_scene_load_from_memory(at, data.length, text, out, step));
            const world = Object.create(World.prototype);
            world.address = 0;
            world.adopt(M.HEAPU32[out >> 2]);
            world.timeStep = fields.getFloat(step);
            return world;
        });
    }

    saveScene() {
        return during(() =>
            textOf((text, capacity, length) => M._cairn_scene_save_to_memory(use(this), text, capacity, length)),
        );
    }

    createBody(definition = {}) {
        const id = during(() => {
            const def = room(values.BODY_DEF_BYTES);
            M._cairn_default_body_def(def);
            values.putBodyDef(def, definition, 'BodyDef');
            const out = room(8);
            check(M._cairn_world_create_body(use(this), def, out));
            return fields.getU64(out);
        });
        return new Body(this, id);
    }

    destroyBody(body) {
        during(() => {
            const [low, high] = handleOf(body, 'body');
            check(M._cairn_world_destroy_body(use(this), low, high));
        });
    }

    body(id) {
        return new Body(this, id);
    }

    bodyIsValid(id) {
        return isValid(this, id, M?._cairn_body_is_valid);
    }
    shapeIsValid(id) {
        return isValid(this, id, M?._cairn_shape_is_valid);
    }
    jointIsValid(id) {
        return isValid(this, id, M?._cairn_joint_is_valid);
    }
    forceFieldIsValid(id) {
        return isValid(this, id, M?._cairn_force_field_is_valid);
    }

    step(seconds = this.timeStep, count = 1) {
        during(() => {
            numberOf(seconds, 'seconds');
            if (wholeOf(count, 'count') < 0) refuse('count', count, 'must be 0 or more');
            check(M._cairn_world_steps(use(this), seconds, count));
        });
    }

    get threads() {
        return super.threads;
    }
    set threads(count) {
        const most = mostThreads(this);
        if (Number.isInteger(count) && count > most && count <= MAX_THREADS) {
            const expected =
                M.PThread === undefined
                    ? `must be 1 with 'cairn-physics'; 'cairn-physics/mt' has more threads`
                    : `must be at most ${most}: other worlds use the rest of the ${M.workers + 1} threads of init`;
            refuse('World.threads', count, expected, 'unsupported');
        }
        // The engine requests new workers before it releases its current ones: there may not be enough workers for
        // both.
        if (count >= 1 && count <= most && count !== super.threads) super.threads = 1;
        super.threads = count;
    }

    save() {
        return new Snapshot(this);
    }
    restore(snapshot) {
        during(() => check(M._cairn_world_restore(use(this), snapshotAddress(snapshot))));
    }

    jointAt(bodyA, bodyB, anchor, axis, joint) {
        return during(() => {
            const a = handleOf(bodyA, 'bodyA'),
                b = handleOf(bodyB, 'bodyB');
            const at = room(24),
                along = room(12),
                kind = room(values.JOINT_BYTES),
                out = room(values.JOINT_DEF_BYTES);
            fields.putPosition(at, anchor, 'anchor');
            fields.putVec3(along, axis, 'axis');
            values.putJoint(kind, joint, 'Joint');
            M._cairn_default_joint_def(out);
            check(M._cairn_world_joint_at(use(this), ...a, ...b, at, along, kind, out));
            return values.getJointDef(out);
        });
    }

    jointDef(joint) {
        return during(() => {
            const id = handleOf(joint, 'joint'),
                out = room(values.JOINT_DEF_BYTES);
            M._cairn_default_joint_def(out);
            check(M._cairn_world_get_joint_def(use(this), ...id, out));
            const def = values.getJointDef(out);
            def.name = textOf((text, capacity, length) =>
                M._cairn_joint_get_name(use(this), ...id, text, capacity, length),
            );
            if (def.joint.kind === 'general') {
                const list = (size, call, read) =>
                    listOf(size, (at, capacity, count) => call(use(this), ...id, at, capacity, count), read);
                def.joint.limits = list(values.JOINT_LIMIT_BYTES, M._cairn_joint_get_limits, values.getJointLimit);
                def.joint.drives = list(values.JOINT_DRIVE_BYTES, M._cairn_joint_get_drives, values.getJointDrive);
            }
            return def;
        });
    }

    readBodies(arrays) {
        during(() => {
            const names = Object.keys(arrays ?? refuse('arrays', arrays, 'must be an object')).filter(
                (name) => arrays[name] !== undefined,
            );
            const count = this.bodyCount;
            for (const name of names) {
                const column =
                    COLUMNS[name] ??
                    refuse(`arrays.${name}`, name, `must be one of ${Object.keys(COLUMNS).join(', ')}`);
                if (!(arrays[name] instanceof column.kind))
                    refuse(`arrays.${name}`, arrays[name], `must be a ${column.kind.name}`);
                if (arrays[name].length !== count * column.components) {
                    refuse(
                        `arrays.${name}`,
                        arrays[name],
                        `must have ${count * column.components} numbers, ${column.components} for each body`,
                    );
                }
            }
            const table = room(values.BODY_ARRAYS_BYTES);
            M._cairn_default_body_arrays(table);
            for (const name of names)
                M.HEAPU32[(table + values.BODY_ARRAYS_OFFSETS[name]) >> 2] = room(arrays[name].byteLength);
            check(M._cairn_world_read_bodies(use(this), 0, count, table));
            for (const name of names) {
                const at = M.HEAPU32[(table + values.BODY_ARRAYS_OFFSETS[name]) >> 2];
                arrays[name].set(new COLUMNS[name].kind(M.HEAPU8.buffer, at, arrays[name].length));
            }
        });
        return arrays;
    }

    get bodyCount() {
        return during(() => {
            const count = room(4);
            check(M._cairn_world_get_bodies(use(this), 0, 0, count));
            return M.HEAPU32[count >> 2];
        });
    }
    get positions() {
        return this.readBodies({ positions: new Float64Array(3 * this.bodyCount) }).positions;
    }
    get rotations() {
        return this.readBodies({ rotations: new Float32Array(4 * this.bodyCount) }).rotations;
    }
    get linearVelocities() {
        return this.readBodies({ linearVelocities: new Float32Array(3 * this.bodyCount) }).linearVelocities;
    }
    get angularVelocities() {
        return this.readBodies({ angularVelocities: new Float32Array(3 * this.bodyCount) }).angularVelocities;
    }

    shapeTriangles(shape) {
        return during(() => {
            const out = room(24);
            check(M._cairn_web_shape_triangles(use(this), ...handleOf(shape, 'shape'), out));
            const [surface, vertices, normals, count, indices, length] = M.HEAPU32.subarray(out >> 2, (out >> 2) + 6);
            const floats = (at) => M.HEAPF32.slice(at >> 2, (at >> 2) + 3 * count);
            const triangles = {
                vertices: floats(vertices),
                normals: normals === 0 ? null : floats(normals),
                indices: M.HEAPU32.slice(indices >> 2, (indices >> 2) + length),
            };
            M._cairn_web_triangles_release(surface);
            return triangles;
        });
    }
    shapeColor(shape) {
        return during(() => {
            const color = room(12),
                found = room(1);
            check(M._cairn_web_shape_color(use(this), ...handleOf(shape, 'shape'), color, found));
            return fields.getBool(found) ? fields.getVec3(color) : null;
        });
    }

    dispose() {
        if (this.address === 0) return;
        lostWorlds.unregister(this);
        M._cairn_world_destroy(this.address);
        this.address = 0;
    }
}

// The greatest number of threads of a world: the calling thread, its own workers, and the unused ones.
function mostThreads(world) {
    return M?.PThread === undefined ? 1 : world.threads + M.PThread.unusedWorkers.length;
}

function isValid(world, id, call) {
    return during(() => {
        const [low, high] = handleOf(id, 'id');
        return call(use(world), low, high) !== 0;
    });
}

if (Symbol.dispose) {
    World.prototype[Symbol.dispose] = World.prototype.dispose;
    Snapshot.prototype[Symbol.dispose] = Snapshot.prototype.dispose;
}

/** The spring with which a jointed body oscillates at `hertz`, with that damping ratio. */
export function springFromFrequency(hertz, dampingRatio) {
    return during(() => {
        const spring = room(values.JOINT_SPRING_BYTES);
        if (!(numberOf(hertz, 'hertz') > 0 && Number.isFinite(hertz))) refuse('hertz', hertz, 'must be > 0 and finite');
        if (!(numberOf(dampingRatio, 'dampingRatio') >= 0 && Number.isFinite(dampingRatio)))
            refuse('dampingRatio', dampingRatio, 'must be >= 0 and finite');
        M._cairn_spring_from_frequency(spring, hertz, dampingRatio);
        return values.getJointSpring(spring);
    });
}
