// A page of ten lines is built from the tarball in an empty folder by each bundler, with and without threads, and
// opened in browsers. The boxes must fall to the same positions as in Node, to the bit.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { cp, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import * as esbuild from 'esbuild';
import webpack from 'webpack';
import { BROWSERS, colorsOf, inBrowser, pictureOf } from './browser.mjs';
import { ISOLATED } from '../../web/playground/serve.mjs';

const run = promisify(execFile);
// The Node of Debian 12 is too old for Vite.
const [major, minor] = process.versions.node.split('.').map(Number);
const noVite =
    major > 20 || (major === 20 && minor >= 19) ? false : `vite 8 requires Node 20.19, this is ${process.version}`;
const vite = noVite ? null : await import('vite');
let folder, expected;

const program = (entry, init, threads, imports = '') => `${imports}
import init, { World } from '${entry}';
${init}
const world = new World();
world.threads = ${threads};
world.createBody({ type: 'static' }).addShape({ kind: 'plane' });
const place = (i) => [0.3 * (i % 3), 0.6 + 1.1 * i, 0.2 * (i % 5)];
const boxes = Array.from({ length: 60 }, (_, i) => world.createBody({ position: place(i) }));
for (const box of boxes) box.addShape({ kind: 'box', halfExtents: [0.4, 0.5, 0.3] });
world.step(1 / 60, 600);
const fallen = { hash: String(world.stateHash), heights: boxes.map((box) => box.position.y) };
globalThis.document ? (globalThis.fallen = fallen) : console.log(JSON.stringify(fallen));
`;
const PROGRAMS = {
    'one.js': program('cairn-physics', 'await init();', 1),
    'mt.js': program('cairn-physics/mt', 'await init({ threads: 3 });', 3),
    'one_esbuild.js': program(
        'cairn-physics',
        'await init(new URL(wasm, import.meta.url));',
        1,
        `import wasm from 'cairn-physics/cairn.wasm';`,
    ),
    'mt_esbuild.js': program(
        'cairn-physics/mt',
        `const worker = new URL('worker.js', import.meta.url);
await init({ threads: 3, source: new URL(wasm, import.meta.url), worker });`,
        3,
        `import wasm from 'cairn-physics/mt/cairn.wasm';`,
    ),
};
const page = (script) =>
    `<!doctype html><link rel="icon" href="data:,"><script type="module" src="${script}"></script>`;

before(async () => {
    folder = await mkdtemp(join(tmpdir(), 'cairn-bundlers-'));
    const [tarball] = (await readdir(process.env.CAIRN_WEB)).filter((name) => name.endsWith('.tgz'));
    await writeFile(join(folder, 'package.json'), '{ "type": "module" }');
    await run('npm', ['install', '--offline', '--no-audit', '--no-fund', join(process.env.CAIRN_WEB, tarball)], {
        cwd: folder,
    });
    for (const [name, text] of Object.entries(PROGRAMS)) await writeFile(join(folder, name), text);
    for (const name of ['one', 'mt']) await writeFile(join(folder, `${name}.html`), page(`./${name}.js`));
    await writeFile(join(folder, 'blank.html'), page('data:text/javascript,'));
    expected = JSON.parse((await run('node', ['one.js'], { cwd: folder })).stdout);
    const { heights } = expected;
    assert.ok(Math.max(...heights) < 20 && Math.min(...heights) > 0.2, `boxes that were up to 65 m high: ${heights}`);
});
after(() => rm(folder, { recursive: true, force: true }));

test('with threads, the boxes fall to the same positions in Node', async () =>
    assert.deepEqual(JSON.parse((await run('node', ['mt.js'], { cwd: folder })).stdout), expected));

async function fallenIn(site, file, options) {
    await inBrowser(
        site,
        async (page, address) => {
            await page.goto(address + file);
            await page.waitForFunction(() => globalThis.fallen, { timeout: 60000 });
            assert.deepEqual(await page.evaluate(() => globalThis.fallen), expected);
        },
        options,
    );
}

// Each function builds a page, and returns where it is: `site`, a folder to be served or an address, and `file`.
const BUNDLERS = {
    async none(name) {
        const map = { imports: { 'cairn-physics': './node_modules/cairn-physics/src/index.js' } };
        map.imports['cairn-physics/mt'] = './node_modules/cairn-physics/src/mt.js';
        const text = `<script type="importmap">${JSON.stringify(map)}</script>`;
        await writeFile(join(folder, `none_${name}.html`), text + page(`./${name}.js`));
        return { site: folder, file: `none_${name}.html` };
    },
    async esbuild(name) {
        const site = join(folder, `esbuild_${name}`);
        const worker = name === 'mt' ? [{ in: 'cairn-physics/mt/worker', out: 'worker' }] : [];
        await esbuild.build({
            absWorkingDir: folder,
            entryPoints: [{ in: `./${name}_esbuild.js`, out: 'page' }, ...worker],
            bundle: true,
            format: 'esm',
            minify: true,
            outdir: site,
            loader: { '.wasm': 'file' },
            external: ['node:*'],
            logLevel: 'silent',
        });
        await writeFile(join(site, 'index.html'), page('./page.js'));
        return { site, file: '' };
    },
    async vite(name) {
        const site = join(folder, `vite_${name}`);
        const rolldownOptions = { input: join(folder, `${name}.html`) };
        await vite.build({ root: folder, logLevel: 'error', build: { outDir: site, rolldownOptions } });
        return { site, file: `${name}.html` };
    },
    async 'the server of vite'(name) {
        const server = await vite.createServer({
            root: folder,
            logLevel: 'error',
            cacheDir: join(folder, `vite_cache_${name}`),
            server: { host: '127.0.0.1', port: 0, headers: ISOLATED },
        });
        await server.listen();
        return { site: server.resolvedUrls.local[0], file: `${name}.html`, end: () => server.close() };
    },
    async webpack(name) {
        const site = join(folder, `webpack_${name}`);
        const compiler = webpack({
            context: folder,
            mode: 'production',
            entry: `./${name}.js`,
            output: { path: site, filename: 'page.js' },
            performance: false,
        });
        const stats = await promisify(compiler.run.bind(compiler))();
        await promisify(compiler.close.bind(compiler))();
        assert.ok(
            !stats.hasErrors() && !stats.hasWarnings(),
            stats.toString({ all: false, errors: true, warnings: true }),
        );
        await writeFile(join(site, 'index.html'), page('./page.js'));
        return { site, file: '' };
    },
};

for (const [bundler, build] of Object.entries(BUNDLERS)) {
    for (const name of ['one', 'mt']) {
        const entry = name === 'mt' ? 'cairn-physics/mt' : 'cairn-physics';
        let built;
        test(
            `${bundler === 'none' ? 'no bundler' : bundler} makes a page of ${entry}`,
            { skip: bundler.includes('vite') && noVite },
            async (context) => {
                built = await build(name);
                try {
                    for (const browser of BROWSERS)
                        await context.test(`boxes have fallen in ${browser.name}`, { skip: browser.skip }, () =>
                            fallenIn(built.site, built.file, { browser }),
                        );
                } finally {
                    await built.end?.();
                }
            },
        );
    }
}

test('the page of the guide, built by vite, shows falling boxes', { skip: noVite }, async (context) => {
    const guide = await readFile(new URL('../../docs/guide/web.md', import.meta.url), 'utf8');
    const [, html] = guide.match(/```html\n(.*?)```/s);
    const root = join(folder, 'guide');
    await mkdir(root);
    await cp(fileURLToPath(new URL('node_modules/three', import.meta.url)), join(folder, 'node_modules/three'), {
        recursive: true,
    });
    // Without this link, browsers would request an icon, which does not exist.
    const icon = html.replace('<body', '<link rel="icon" href="data:," /><body');
    await writeFile(join(root, 'index.html'), icon.replace('</script>', 'globalThis.world = world;</script>'));
    await vite.build({ root, logLevel: 'error' });
    const visit = async (browser, page, address) => {
        const stepped = (count) =>
            page.waitForFunction((n) => globalThis.world?.stepCount >= BigInt(n), { timeout: 60000 }, count);
        await page.goto(address);
        await stepped(1);
        const first = await page.screenshot({ encoding: 'base64' });
        await stepped(200);
        const last = await pictureOf(page, join(process.env.CAIRN_WEB, `guide_${browser.name.toLowerCase()}.png`));
        assert.notEqual(first, last);
        const { colors, foreground } = await colorsOf(page, last);
        assert.ok(colors > 10 && foreground > 0.05, `${colors} colors, ${foreground} of the pixels in the foreground`);
        const heights = await page.evaluate(() =>
            Array.from(globalThis.world.positions).filter((_, i) => i > 3 && i % 3 === 1),
        );
        assert.ok(
            heights.every((y, i) => y > 0.38 && y < 0.7 + i),
            `boxes at ${heights}`,
        );
        assert.ok(heights[60] < 20, `a box that was 61 m high is ${heights[60]} m high`);
    };
    for (const browser of BROWSERS)
        await context.test(`in ${browser.name}`, { skip: browser.skipDrawing }, () =>
            inBrowser(join(root, 'dist'), (...page) => visit(browser, ...page), { browser }),
        );
});

test('in a page that is not cross-origin isolated, the error names the headers that the server must send', () =>
    inBrowser(
        folder,
        async (page, address) => {
            await page.goto(`${address}blank.html`);
            const { code, message } = await page.evaluate(async () => {
                const { default: init } = await import('/node_modules/cairn-physics/src/mt.js');
                return init().catch(({ code, message }) => ({ code, message }));
            });
            assert.equal(code, 'unsupported');
            assert.match(
                message,
                /Cross-Origin-Opener-Policy: same-origin.*Cross-Origin-Embedder-Policy: require-corp/,
            );
        },
        { headers: {} },
    ));
