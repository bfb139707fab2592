// A project with the package installed from its tarball: it is bundled by esbuild, checked by the TypeScript compiler,
// and run in Node and in browsers, where three.js draws falling boxes.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { cp, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { brotliCompressSync } from 'node:zlib';
import { build } from 'esbuild';
import { BROWSERS, colorsOf, inBrowser, pictureOf } from './browser.mjs';

const run = promisify(execFile);
const modules = fileURLToPath(new URL('node_modules', import.meta.url));
let folder;

before(async () => {
    folder = await mkdtemp(join(tmpdir(), 'cairn-web-'));
    const [tarball] = (await readdir(process.env.CAIRN_WEB)).filter((name) => name.endsWith('.tgz'));
    await mkdir(join(folder, 'node_modules/cairn-physics'), { recursive: true });
    await run('tar', [
        'xzf',
        join(process.env.CAIRN_WEB, tarball),
        '--strip-components',
        '1',
        '-C',
        join(folder, 'node_modules/cairn-physics'),
    ]);
    await cp(join(modules, 'three'), join(folder, 'node_modules/three'), { recursive: true });
    await writeFile(join(folder, 'package.json'), '{ "type": "module" }');
});
after(() => rm(folder, { recursive: true, force: true }));

const FALL = `
export function fall(World) {
    const world = new World({ gravity: [0, -10, 0] });
    world.createBody({ type: 'static' }).addShape({ kind: 'plane' });
    for (let i = 0; i < 40; ++i) {
        const body = world.createBody({ position: [0.3 * (i % 3), 0.6 + 1.1 * i, 0.2 * (i % 5)] });
        body.addShape({ kind: 'box', halfExtents: [0.4, 0.5, 0.3] });
    }
    return world;
}
`;

test('the module is smaller than 900 kB in Brotli compression', async () => {
    const bytes = await readFile(join(folder, 'node_modules/cairn-physics/dist/cairn.wasm'));
    const size = brotliCompressSync(bytes).length;
    assert.ok(size < 900e3, `${size} bytes`);
});

// If the upper two of the four lanes of a shuffle are unused, their indices are arbitrary. WebAssembly engines have a
// single instruction only for the form `known`, not for the form with zeros.
test('shuffles have the form that WebAssembly engines recognize', async () => {
    const known = Buffer.from([0xfd, 0x0d, 8, 9, 10, 11, 24, 25, 26, 27, 12, 13, 14, 15, 28, 29, 30, 31]);
    const withZeros = Buffer.concat([known.subarray(0, 10), Buffer.alloc(8)]);
    for (const file of ['cairn.wasm', 'mt/cairn.wasm']) {
        const bytes = await readFile(join(folder, 'node_modules/cairn-physics/dist', file));
        assert.ok(bytes.includes(known), file);
        assert.ok(!bytes.includes(withZeros), file);
    }
});

test('boxes fall in Node', async () => {
    await writeFile(
        join(folder, 'fall.mjs'),
        `import init, { World } from 'cairn-physics';${FALL}
await init();
const world = fall(World);
world.step(1 / 60, 600);
console.log(JSON.stringify(Array.from(world.positions).filter((_, i) => i % 3 === 1)));`,
    );
    const { stdout } = await run('node', ['fall.mjs'], { cwd: folder });
    const heights = JSON.parse(stdout);
    assert.equal(heights.length, 41);
    for (const y of heights.slice(1)) assert.ok(y > 0.29 && y < 44, `a box at the height ${y}`);
    assert.ok(Math.min(...heights.slice(1)) < 0.52);
});

test('boxes fall in a page that esbuild bundled', async (context) => {
    await writeFile(
        join(folder, 'page.js'),
        `import init, { World } from 'cairn-physics';
import wasm from 'cairn-physics/cairn.wasm';
import { WorldView } from 'cairn-physics/three';
import * as THREE from 'three';
${FALL}
await init(new URL(wasm, import.meta.url));
const world = fall(World);
const view = new WorldView(THREE, world);
const scene = new THREE.Scene();
scene.add(view.group, new THREE.HemisphereLight(0xffffff, 0x444444, 3));
const camera = new THREE.PerspectiveCamera(50, 960 / 600, 0.1, 100);
camera.position.set(8, 6, 10);
camera.lookAt(0, 2, 0);
const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
renderer.setSize(960, 600);
document.body.append(renderer.domElement);
globalThis.look = (steps) => {
    world.step(1 / 60, steps);
    view.sync();
    renderer.render(scene, camera);
    return Array.from(world.positions);
};
globalThis.ready = true;`,
    );
    const site = join(folder, 'site');
    await build({
        entryPoints: [join(folder, 'page.js')],
        bundle: true,
        format: 'esm',
        minify: true,
        outdir: site,
        loader: { '.wasm': 'file' },
        external: ['node:*'],
        logLevel: 'silent',
    });
    await writeFile(
        join(site, 'index.html'),
        '<!doctype html><link rel="icon" href="data:,"><body style="margin:0">' +
            '<script type="module" src="page.js"></script>',
    );
    const visit = async (page, address) => {
        await page.goto(address);
        await page.waitForFunction(() => globalThis.ready, { timeout: 30000 });
        const begin = await page.evaluate(() => globalThis.look(0));
        const first = await page.screenshot({ encoding: 'base64' });
        const end = await page.evaluate(() => globalThis.look(240));
        const last = await pictureOf(page, join(process.env.CAIRN_WEB, 'bundled.png'));
        assert.ok(begin[3 * 40 + 1] > 43 && end[3 * 40 + 1] < 30, 'the last box has fallen');
        assert.notEqual(first, last);
        const { colors, foreground } = await colorsOf(page, last);
        assert.ok(colors > 10 && foreground > 0.05, `${colors} colors, ${foreground} of the pixels in the foreground`);
    };
    for (const browser of BROWSERS)
        await context.test(`in ${browser.name}`, { skip: browser.skipDrawing }, () =>
            inBrowser(site, visit, { browser }),
        );
});

test('the types accept valid code, and refuse code that the package refuses', async () => {
    await writeFile(
        join(folder, 'good.ts'),
        `import init, { World, Geometry, CairnError, type BodyDef, type Shape } from 'cairn-physics';
import initThreads, { World as OfThreads, type InitOptions } from 'cairn-physics/mt';
const options: InitOptions = { threads: 4, worker: new URL('file:///worker.js') };
await (options.threads === 1 ? init() : initThreads(options));
const same: typeof OfThreads = World;
same.name;
const def: BodyDef = { type: 'kinematic', position: [0, 1, 2], rotation: { x: 0, y: 0, z: 0, w: 1 }, mass: null };
const shape: Shape = { kind: 'hull', geometry: Geometry.hull([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]) };
using world = new World({ substeps: 4 });
const body = world.createBody(def);
body.addShape(shape, { material: { restitution: 0.5 } });
const hinge = world.jointAt(body, null, [0, 0, 0], [1, 0, 0], { kind: 'hinge', angle: { motor: null } });
const joint = world.createJoint(hinge);
const y: number = body.position.y;
const hash: bigint = world.stateHash;
const g: number = world.settings.gravity.z;
const hit: number | undefined = world.castRay([0, 9, 0], [0, -1, 0], 10)?.distance;
const { positions } = world.readBodies({ positions: new Float64Array(3) });
world.settings = { ...world.settings, gravity: [0, 0, 0] };
try { world.step(); } catch (error) { if (error instanceof CairnError && error.code === 'invalidValue') throw error; }
console.log(y, hash, g, hit, positions, joint);
`,
    );
    await writeFile(
        join(folder, 'bad.ts'),
        `import { World } from 'cairn-physics'; import initThreads from 'cairn-physics/mt';
const world = new World();
world.createBody({ positon: [0, 0, 0] });
world.createBody({ type: 'floating' });
world.createBody().addShape({ kind: 'sphere', halfExtents: [1, 1, 1] });
world.readBodies({ positions: new Float32Array(3) });
world.body(12);
initThreads({ workers: 4 });
`,
    );
    const check = (file) =>
        run(
            'node',
            [
                join(modules, 'typescript/lib/tsc.js'),
                '--noEmit',
                '--strict',
                '--target',
                'esnext',
                '--module',
                'nodenext',
                '--lib',
                'esnext,dom',
                file,
            ],
            { cwd: folder },
        ).then(
            () => '',
            (error) => error.stdout,
        );
    assert.equal(await check('good.ts'), '');
    const wrong = await check('bad.ts');
    for (const line of [3, 4, 5, 6, 7, 8]) assert.match(wrong, new RegExp(`bad\\.ts\\(${line},`), wrong);
});
