// Invalid calls throw an error that names the invalid argument, change nothing, and leak no memory.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import init, { Body, CairnError, Geometry, World, springFromFrequency } from 'cairn-physics';

test('calls before init throw an error that names init', () => {
    assert.throws(() => new World(), { name: 'CairnError', code: 'wrongState', field: 'init' });
});

test('a source that cannot be read is an error, and init can be called again', async () => {
    await assert.rejects(init(5), { code: 'invalidValue', field: 'init.source', value: '5' });
    await assert.rejects(init(new Uint8Array([0, 1, 2])), { code: 'invalidFile', field: 'init.source' });
    const cut = new Uint8Array([0, 0x61, 0x73, 0x6d, 1]);
    await assert.rejects(init(cut), { code: 'invalidFile', field: 'init.source' });
    await assert.rejects(init(new TextEncoder().encode('<!doctype html>')), { value: '"<!doctype html>"' });
    await assert.rejects(init('file:///nothing/cairn.wasm'), { code: 'io', value: 'ENOENT' });
    await init();
    await init(new URL('https://example.invalid/never.wasm')); // ignored: the module is loaded already
});

// A world with a box on a plane.
function boxWorld() {
    const world = new World();
    world.createBody({ type: 'static', name: 'ground' }).addShape({ kind: 'plane' });
    const box = world.createBody({ position: [0, 0.5, 0], name: 'box' });
    const shape = box.addShape({ kind: 'box', halfExtents: [0.5, 0.5, 0.5] });
    return { world, box, shape };
}
// The state that a rejected call must leave unchanged.
const stateOf = (world) => [world.stateHash, world.bodies.length, world.saveScene()];

function refused(world, call, expected) {
    const before = stateOf(world);
    assert.throws(call, (error) => {
        assert.ok(error instanceof CairnError, `${error}`);
        for (const [key, value] of Object.entries(expected))
            assert.equal(error[key], value, `${key} of: ${error.message}`);
        assert.ok(error.message.length > 10);
        return true;
    });
    assert.deepEqual(stateOf(world), before);
}

const wrong = [
    ['NaN', (w) => w.createBody({ position: [0, NaN, 0] }), { code: 'invalidValue', field: 'BodyDef.position' }],
    ['an infinite velocity', (w, b) => (b.linearVelocity = { x: Infinity, y: 0, z: 0 }), { code: 'invalidValue' }],
    [
        'a number out of its range',
        (w) => w.createBody({ mass: -2 }),
        { code: 'invalidValue', field: 'BodyDef.mass', value: '-2' },
    ],
    [
        'a string for a number',
        (w) => w.createBody({ mass: '3' }),
        { code: 'invalidValue', field: 'BodyDef.mass', value: '"3"' },
    ],
    [
        'a vector of two',
        (w) => w.createBody({ position: [1, 2] }),
        { code: 'invalidValue', field: 'BodyDef.position', value: 'Array of 2' },
    ],
    [
        'a vector of four',
        (w) => w.createBody({ position: new Float32Array(4) }),
        { code: 'invalidValue', field: 'BodyDef.position' },
    ],
    [
        'a vector without z',
        (w) => w.createBody({ position: { x: 1, y: 2 } }),
        { code: 'invalidValue', field: 'BodyDef.position.z', value: 'undefined' },
    ],
    [
        'a misspelled member',
        (w) => w.createBody({ positon: [0, 0, 0] }),
        { code: 'invalidValue', field: 'BodyDef.positon' },
    ],
    [
        'an unknown kind of body',
        (w) => w.createBody({ type: 'floating' }),
        { code: 'invalidValue', field: 'BodyDef.type', value: '"floating"' },
    ],
    [
        'an unknown kind of shape',
        (w, b) => b.addShape({ kind: 'torus' }),
        { code: 'invalidValue', field: 'Shape.kind', value: '"torus"' },
    ],
    ['null as a shape', (w, b) => b.addShape(null), { code: 'invalidValue', field: 'Shape', value: 'null' }],
    [
        'a radius of zero',
        (w, b) => b.addShape({ kind: 'sphere', radius: 0 }),
        { code: 'invalidValue', field: 'Sphere.radius', value: '0' },
    ],
    ['a half extent of NaN', (w, b) => b.addShape({ kind: 'box', halfExtents: [1, NaN, 1] }), { code: 'invalidValue' }],
    ['a plane on a dynamic body', (w, b) => b.addShape({ kind: 'plane' }), {}],
    [
        'a hull whose geometry is no Geometry',
        (w, b) => b.addShape({ kind: 'hull', geometry: {} }),
        { code: 'invalidValue', field: 'Hull.geometry' },
    ],
    [
        'a hull with an undefined geometry',
        (w, b) => b.addShape({ kind: 'hull' }),
        { code: 'invalidValue', field: 'Hull.geometry' },
    ],
    ['a step of zero', (w) => w.step(0), { code: 'invalidValue' }],
    ['a step of NaN', (w) => w.step(NaN), { code: 'invalidValue' }],
    ['half a step', (w) => w.step(0.01, 0.5), { code: 'invalidValue', field: 'count', value: '0.5' }],
    ['steps backwards', (w) => w.step(0.01, -1), { code: 'invalidValue', field: 'count', value: '-1' }],
    ['a ray with the direction zero', (w) => w.castRay([0, 9, 0], [0, 0, 0], 10), { code: 'invalidValue' }],
    [
        'layers below zero',
        (w) => w.castRay([0, 9, 0], [0, -1, 0], 10, { layers: -1n }),
        { code: 'invalidValue', field: 'QueryFilter.layers', value: '-1n' },
    ],
    [
        'layers of 65 bits',
        (w) => w.castRay([0, 9, 0], [0, -1, 0], 10, { layers: 1n << 64n }),
        { code: 'invalidValue', field: 'QueryFilter.layers' },
    ],
    ['a handle that is a number', (w) => w.destroyBody(12), { code: 'invalidHandle', field: 'body', value: '12' }],
    ['undefined as a handle', (w) => w.destroyBody(undefined), { code: 'invalidHandle', field: 'body' }],
    ['the null handle', (w) => w.destroyBody(null), { code: 'invalidHandle' }],
    ['the handle of a shape instead of a body', (w, b, s) => w.destroyBody(s + (1n << 40n)), { code: 'invalidHandle' }],
    ['a joint without bodies', (w) => w.createJoint({ joint: { kind: 'ball' } }), {}],
    [
        'a joint limit with too few axes',
        (w, b) => w.createJoint({ bodyB: b, joint: { kind: 'general', limits: [{ axes: [true] }] } }),
        { code: 'invalidValue', field: 'JointLimit.axes', value: 'Array of 1' },
    ],
    ['a string with the character 0', (w) => w.findBody('a\0b'), { code: 'invalidValue', field: 'name' }],
    [
        'too short an array',
        (w) => w.readBodies({ positions: new Float64Array(5) }),
        { code: 'invalidValue', field: 'arrays.positions', value: 'Float64Array of 5' },
    ],
    [
        'too long an array',
        (w) => w.readBodies({ rotations: new Float32Array(9) }),
        { code: 'invalidValue', field: 'arrays.rotations' },
    ],
    [
        'an array of another type',
        (w) => w.readBodies({ positions: new Float32Array(6) }),
        { code: 'invalidValue', field: 'arrays.positions' },
    ],
    [
        'an unknown array',
        (w) => w.readBodies({ places: new Float32Array(6) }),
        { code: 'invalidValue', field: 'arrays.places' },
    ],
    ['no arrays', (w) => w.readBodies(null), { code: 'invalidValue', field: 'arrays' }],
    ['an object that is no snapshot', (w) => w.restore({}), { code: 'invalidValue', field: 'snapshot' }],
    [
        'a negative number of substeps',
        (w) => (w.settings = { substeps: -1 }),
        { code: 'invalidValue', field: 'WorldDef.substeps', value: '-1' },
    ],
    ['a second thread', (w) => (w.threads = 2), { code: 'unsupported', field: 'World.threads', value: '2' }],
];
for (const [name, call, expected] of wrong) {
    test(`${name} is refused`, () => {
        const { world, box, shape } = boxWorld();
        refused(world, () => call(world, box, shape), expected);
        world.step();
        world.dispose();
    });
}

test('a stale handle stays stale when its slot is reused', () => {
    const { world, box, shape } = boxWorld();
    box.destroy();
    const other = world.createBody({ name: 'other' });
    assert.equal(box.isValid, false);
    assert.equal(other.isValid, true);
    refused(world, () => box.position, { code: 'invalidHandle' });
    refused(world, () => box.addShape({ kind: 'sphere', radius: 1 }), { code: 'invalidHandle' });
    refused(world, () => world.removeShape(shape), { code: 'invalidHandle' });
    refused(world, () => box.destroy(), { code: 'invalidHandle' });
    world.dispose();
});

test('a body of another world is refused', () => {
    const one = boxWorld(),
        other = boxWorld();
    refused(one.world, () => one.world.destroyBody(other.box), { code: 'invalidHandle' });
    refused(other.world, () => other.world.body(one.box.id).position, { code: 'invalidHandle' });
    one.world.dispose();
    other.world.dispose();
});

test('a disposed world refuses everything, and may be disposed of again', () => {
    const { world, box, shape } = boxWorld();
    const snapshot = world.save();
    world.dispose();
    world.dispose();
    const expected = { name: 'CairnError', code: 'wrongState', field: 'World', value: 'disposed' };
    for (const call of [
        () => world.step(),
        () => world.createBody(),
        () => box.position,
        () => box.destroy(),
        () => world.stateHash,
        () => world.bodies,
        () => world.save(),
        () => world.restore(snapshot),
        () => world.saveScene(),
        () => world.positions,
        () => world.bodyIsValid(box),
        () => world.shapeTriangles(shape),
        () => (world.settings = {}),
        () => world.jointAt(null, box, [0, 0, 0], [1, 0, 0], { kind: 'ball' }),
    ]) {
        assert.throws(call, expected);
    }
    const next = boxWorld().world;
    next.restore(snapshot);
    snapshot.dispose();
    snapshot.dispose();
    assert.throws(() => next.restore(snapshot), { code: 'wrongState', field: 'Snapshot' });
    next.dispose();
});

test('a disposed geometry is refused, and shapes that use it remain valid', () => {
    const { world, box } = boxWorld();
    const hull = Geometry.hull([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
    box.addShape({ kind: 'hull', geometry: hull });
    hull.dispose();
    refused(world, () => box.addShape({ kind: 'hull', geometry: hull }), {
        code: 'wrongState',
        field: 'Geometry',
        value: 'disposed',
    });
    world.step();
    assert.ok(Math.abs(world.shape(box.shapes[1]).geometry.volume - 1 / 6) < 1e-6);
    world.dispose();
});

const shapeless = [
    [() => Geometry.hull([0, 0, 0]), 'invalidValue'],
    [() => Geometry.hull([0, 0, 0, 1, 0, 0, 0, 1]), 'invalidValue'],
    [() => Geometry.hull('points'), 'invalidValue'],
    [() => Geometry.hull([NaN, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]), 'invalidValue'],
    [() => Geometry.hull([null, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]), 'invalidValue'],
    [() => Geometry.mesh([0, 0, 0, 1, 0, 0, 0, 0, 1], [0, 1, 3]), 'invalidValue'],
    [() => Geometry.mesh([0, 0, 0, 1, 0, 0, 0, 0, 1], [0, 1]), 'invalidValue'],
    [() => Geometry.mesh([0, 0, 0, 1, 0, 0, 0, 0, 1], [0, 1, -1]), 'invalidValue'],
    [() => Geometry.heightField(2, 2, [1, 1], [0, 0, 0]), 'invalidValue'],
    [() => Geometry.heightField(2, 2, [1, 0], [0, 0, 0, 0]), 'invalidValue'],
    [() => Geometry.heightField(2.5, 2, [1, 1], [0, 0, 0, 0]), 'invalidValue'],
    [() => new Geometry(1), 'wrongState'],
    [() => new Body(null, 'x'), 'invalidHandle'],
    [() => springFromFrequency(0, 1), 'invalidValue'],
    [() => springFromFrequency(1, NaN), 'invalidValue'],
    [() => World.load('{'), 'invalidFile'],
    [() => World.load('<robot/>'), 'unsupported'],
    [() => World.load(new Uint8Array()), 'invalidFile'],
    [() => World.load(5), 'invalidValue'],
];
test('invalid data of shapes and scenes is refused', () => {
    for (const [call, code] of shapeless) assert.throws(call, { name: 'CairnError', code }, String(call));
});

test('a getter that disposes of the world during a call causes an error', () => {
    const { world } = boxWorld();
    const definition = {
        get mass() {
            world.dispose();
            return 1;
        },
    };
    assert.throws(() => world.createBody(definition), { code: 'wrongState', value: 'disposed' });
});

test('a getter that calls other worlds during a call does not affect the call', () => {
    const { world, box } = boxWorld(),
        other = boxWorld();
    const position = {
        get x() {
            other.world.step();
            return other.world.bodies.length;
        },
        y: 7,
        z: 8,
    };
    box.position = position;
    assert.deepEqual(box.position, { x: 2, y: 7, z: 8 });
    world.dispose();
    other.world.dispose();
});

test('rejected calls leak no memory', () => {
    const { world, box } = boxWorld();
    const many = Array.from({ length: 20000 }, () => ({ kind: 'angular', axes: [true, true, true], min: 0, max: NaN }));
    const before = process.memoryUsage().rss;
    for (let i = 0; i < 400; ++i) {
        // each call would leak a megabyte
        assert.throws(() => world.createJoint({ bodyB: box, joint: { kind: 'general', limits: many } }), CairnError);
    }
    const grown = process.memoryUsage().rss - before;
    assert.ok(grown < 150e6, `${grown} bytes more`);
    world.dispose();
});
