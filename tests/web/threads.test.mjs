// cairn-physics/mt in Node: the same hashes as in native code on any number of threads, and invalid calls.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import init, { Geometry, World } from 'cairn-physics/mt';
import { recordedScenes } from './recorded.mjs';
import { replay } from './replay.mjs';

const THREADS = 3;
const M = async () => (await import('./node_modules/cairn-physics/src/memory.js')).M;

for (const [what, options, expected] of [
    ['no object', 4, { code: 'invalidValue', field: 'init.options' }],
    ['an unknown option', { workers: 2 }, { code: 'invalidValue', field: 'InitOptions.workers' }],
    ['zero threads', { threads: 0 }, { code: 'invalidValue', field: 'InitOptions.threads', value: '0' }],
    ['half a thread', { threads: 1.5 }, { code: 'invalidValue', field: 'InitOptions.threads', value: '1.5' }],
    ['257 threads', { threads: 257 }, { code: 'invalidValue', field: 'InitOptions.threads', value: '257' }],
    ['a number as the source', { source: 5 }, { code: 'invalidValue', field: 'InitOptions.source', value: '5' }],
    ['a source that is a page', { source: new TextEncoder().encode('<!doctype html>') }, { code: 'invalidFile' }],
    ['a file that does not exist', { source: 'file:///nothing/cairn.wasm' }, { code: 'io', value: 'ENOENT' }],
    [
        'a worker script that does not exist',
        { worker: 'file:///nothing/worker.js', threads: 2 },
        { code: 'other', field: 'worker' },
    ],
])
    test(`init refuses ${what}`, { timeout: 20000 }, () => assert.rejects(init(options), expected));

test('after these errors, the module can be loaded', () => init({ threads: THREADS }));
test('a second init has no effect', () => Promise.all([init(), init({ threads: THREADS })]));
test('a second init with another number of threads is refused', () =>
    assert.rejects(init({ threads: 2 }), { code: 'wrongState', field: 'InitOptions.threads', value: '2' }));
test('the entry without threads cannot be initialized as well', async () => {
    const { default: other } = await import('cairn-physics');
    await assert.rejects(other(), { code: 'wrongState', field: 'init', message: /'cairn-physics\/mt'/ });
});

const scenes = await recordedScenes();
test('all scenes of the determinism tests are there', () => assert.equal(scenes.length, 17));
for (let threads = 1; threads <= THREADS; ++threads)
    for (const [name, scene] of scenes)
        test(`${name} has the same state on ${threads} threads as in native code`, () =>
            replay(scene, { World, Geometry }, { threads }));

// A world with enough islands and chunks for all threads; the scenes above are too small.
function crowd() {
    const world = new World({ enableSleep: false });
    world.createBody({ type: 'static' }).addShape({ kind: 'plane' });
    for (let i = 0; i < 1500; ++i) {
        const place = [1.2 * (i % 30), 0.6 + 1.1 * Math.floor(i / 300), 1.2 * (Math.floor(i / 30) % 10)];
        world.createBody({ position: place }).addShape({ kind: 'box', halfExtents: [0.5, 0.5, 0.5] });
    }
    return world;
}

test('a crowd of boxes has the same state on any number of threads, which may change between steps', () => {
    const hashes = [1, 2, 3, 'other'].map((threads) => {
        const world = crowd();
        for (let i = 0; i < 4; ++i) {
            world.threads = threads === 'other' ? 1 + ((i + 1) % THREADS) : threads;
            world.step(1 / 60, 15);
        }
        const hash = world.stateHash;
        world.dispose();
        return hash;
    });
    assert.deepEqual(new Set(hashes).size, 1);
});

test('worlds share the workers, and release them', () => {
    const a = new World(),
        b = new World();
    a.threads = 2;
    b.threads = 2;
    for (const count of [3, 4])
        assert.throws(() => (b.threads = count), {
            code: 'unsupported',
            field: 'World.threads',
            value: `${count}`,
        });
    assert.equal(b.threads, 2);
    assert.throws(() => (b.threads = 257), { code: 'invalidValue', value: '257' });
    assert.throws(() => (b.threads = 1.5), { code: 'invalidValue', value: '1.5' });
    b.step();
    a.dispose();
    assert.throws(() => (a.threads = 2), { code: 'wrongState' });
    b.threads = 3;
    b.step();
    b.dispose();
    for (let i = 0; i < 50; ++i) {
        const world = new World();
        world.threads = THREADS;
        world.step();
        world.dispose();
    }
});

test('memory that another thread has grown is accessible', async () => {
    const module = await M();
    const before = module.HEAPU8.length;
    module.wasmMemory.grow(1024); // as by a worker: the loader of this thread is not notified
    const world = new World();
    for (let i = 0; i < 20000; ++i) world.createBody({ position: [i, 0, 0] }).addShape({ kind: 'sphere', radius: 1 });
    assert.equal(world.positions[3 * 19999], 19999);
    const points = Array.from({ length: 1 << 21 }, (_, i) => (i % 3) + Math.sin(i));
    const surface = Geometry.heightField(1 << 11, 1 << 10, [1, 1], points);
    assert.deepEqual(surface.heights.at(-1), Math.fround(points.at(-1)));
    assert.ok(module.HEAPU8.length > before, `${module.HEAPU8.length} bytes, ${before} before`);
    surface.dispose();
    world.dispose();
});

test('Node exits at the end of the program, although a world has threads', { timeout: 30000 }, async () => {
    const program = `import init, { World } from 'cairn-physics/mt';
        await init({ threads: 3 });
        const world = new World();
        world.threads = 3;
        world.step();
        console.log(world.threads);`;
    const { stdout } = await promisify(execFile)('node', ['--input-type=module', '--eval', program], {
        cwd: fileURLToPath(new URL('.', import.meta.url)),
    });
    assert.equal(stdout, '3\n');
});
