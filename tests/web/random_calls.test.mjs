// Calls in random order with random arguments, valid and invalid: they throw nothing but CairnError, rejected calls
// change nothing, and the same calls give the same states again.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import init, { CairnError, Geometry, World } from 'cairn-physics';
import { CALLS, ENUMS } from './generated/calls.mjs';

await init();
const hull = Geometry.hull([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
const springy = [{ restitution: 0.8 }, { dynamicFriction: 0.1 }];
const mesh = Geometry.mesh([-9, 0, -9, 9, 0, -9, 0, 0, 9], [0, 2, 1], springy, [2]);
const field = Geometry.heightField(3, 3, [1, 1], [0, 1, 0, 0, 0.5, 0, 1, 0, Infinity], springy, [0, 1, 2, 1]);
const WORDS = [
    'static',
    'kinematic',
    'dynamic',
    'average',
    'multiply',
    'uniform',
    'radial',
    'fluid',
    'rk4',
    'angular',
    'direct',
];
const ODD = [NaN, Infinity, -Infinity, 0, -0, 1e-40, 1e30, -1, undefined, null, 'x', {}, [], true, 5n];
const JOINTS = [
    'fixed',
    'ball',
    'hinge',
    'slider',
    'cylindrical',
    'universal',
    'distance',
    'wheel',
    'servo',
    'gear',
    'rack',
];

function player(seed) {
    let state = seed;
    const next = (below) => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return Math.floor((state / 2 ** 32) * below);
    };
    const pick = (list) => list[next(list.length)];
    const number = () => (next(12) === 0 ? pick(ODD) : (next(2000) - 1000) / 100);
    const size = () => (next(12) === 0 ? pick(ODD) : (next(100) + 1) / 50);
    const vector = (count) => Array.from({ length: next(20) === 0 ? next(6) : count }, number);
    const world = new World();
    const known = { BodyId: [null, 0n], ShapeId: [null, 0n], JointId: [null, 0n], ForceFieldId: [null, 0n] };
    const shape = () => ({
        kind: pick(['sphere', 'box', 'plane', 'capsule', 'cylinder', 'hull', 'mesh', 'heightField', 'none']),
        ...pick([
            {},
            { radius: size() },
            { halfExtents: [size(), size(), size()] },
            { geometry: pick([hull, mesh, field, 3]) },
        ]),
    });
    const one = (type) => {
        if (next(25) === 0) return pick(ODD);
        if (type in known) return pick(known[type]);
        if (ENUMS.includes(type)) return pick(WORDS);
        const others = {
            bool: () => next(2) === 0,
            int: () => next(12) - 2,
            float: number,
            'float?': size,
            double: number,
            u64: () => BigInt(next(5)),
            string: () => pick(['', 'a', 'böx', 'name']),
            Vec3: () => vector(3),
            Position: () => vector(3),
            Quat: () => vector(4),
            Transform: () => ({ position: vector(3) }),
            Bounds: () => ({ min: vector(3), max: vector(3) }),
            Shape: shape,
            Joint: () => ({ kind: pick(JOINTS) }),
            ShapeDef: () => ({ density: size(), position: vector(3), isTrigger: next(5) === 0 }),
            JointDef: () => ({
                bodyA: one('BodyId'),
                bodyB: one('BodyId'),
                frameA: { position: vector(3) },
                joint: { kind: pick(JOINTS) },
            }),
            WorldDef: () => ({ gravity: vector(3), substeps: next(8) }),
            ForceField: () => ({ strength: number(), kind: pick(WORDS) }),
            MassProperties: () => ({ mass: size() }),
            DebugLinesDef: () => ({ contacts: next(2) === 0, bounds: next(2) === 0, size: size() }),
            Material: () => ({ restitution: size() }),
            CollisionFilter: () => ({ layers: BigInt(next(4)) }),
            QueryFilter: () => ({
                layers: BigInt(next(4)),
                any: next(2) === 0,
                triggers: next(2) === 0,
                dynamicBodies: next(4) !== 0,
                ignoredBodies: Array.from({ length: next(3) }, () => one('BodyId')),
            }),
            CharacterDef: () => ({ up: vector(3), stepHeight: size(), mass: size(), skin: size() }),
        };
        return others[type]();
    };
    const keep = (result) => {
        if (typeof result !== 'bigint') return;
        for (const [type, test] of [
            ['BodyId', 'bodyIsValid'],
            ['ShapeId', 'shapeIsValid'],
            ['JointId', 'jointIsValid'],
            ['ForceFieldId', 'forceFieldIsValid'],
        ]) {
            if (world[test](result)) known[type].push(result);
        }
    };
    const act = () => {
        if (next(8) === 0 && known.BodyId.length < 60)
            return keep(world.createBody({ type: pick(WORDS.slice(0, 3)), position: vector(3) }).id);
        if (next(12) === 0) return world.step(next(9) === 0 ? number() : 1 / 60);
        if (next(60) === 0) return world.destroyBody(one('BodyId'));
        const call = pick(CALLS);
        const target = call.owner === 'World' ? world : world.body(one('BodyId'));
        const args = call.types.map(one);
        if (!call.isSetter) return keep(target[call.name](...args));
        [target[call.name]] = args;
        return undefined;
    };
    return { world, act };
}

function play(seed, count) {
    const { world, act } = player(seed);
    const hashes = [];
    let refused = 0;
    for (let i = 0; i < count; ++i) {
        const before = world.stateHash;
        try {
            act();
        } catch (error) {
            if (!(error instanceof CairnError)) throw error;
            ++refused;
            assert.equal(world.stateHash, before, `call ${i} of seed ${seed}: ${error.message}`);
        }
        hashes.push(world.stateHash);
    }
    const bodies = world.bodyCount;
    world.dispose();
    return { hashes, refused, bodies };
}

for (let seed = 1; seed <= 8; ++seed) {
    test(`random calls, seed ${seed}`, () => {
        const first = play(seed, 1500);
        assert.ok(first.refused > 100 && first.refused < 1400, `${first.refused} calls were refused`);
        assert.ok(first.bodies > 5, `${first.bodies} bodies`);
        assert.deepEqual(play(seed, 1500).hashes, first.hashes);
    });
}
