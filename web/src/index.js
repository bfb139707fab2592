// cairn-physics: rigid bodies in WebAssembly. docs/web.md is the manual, index.d.ts the reference.
import createModule from '../dist/cairn.js';
import { CairnError, refuse } from './error.js';
import { attach, M, stringAt } from './memory.js';

export { ALL_LAYERS } from './memory.js';
export { CairnError } from './error.js';
export { Geometry } from './geometry.js';
export { Body, Snapshot, World, springFromFrequency } from './world.js';

let started = null;

/** Loads the module; every other call needs it. Further calls return the same promise. */
export default function init(source) {
    started ??= load(source).catch((error) => {
        started = null; // so that another source can be tried
        throw error;
    });
    return started;
}
export { init };

async function load(source) {
    const module = await compiled(await (source ?? new URL('../dist/cairn.wasm', import.meta.url)));
    attach(
        await new Promise((resolve, reject) => {
            createModule({
                instantiateWasm(imports, done) {
                    WebAssembly.instantiate(module, imports).then((instance) => done(instance, module), reject);
                    return {};
                },
            }).then(resolve, reject);
        }),
    );
}

async function compiled(source) {
    if (source instanceof WebAssembly.Module) return source;
    if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
    if (typeof Response !== 'undefined' && source instanceof Response) return fromResponse(source);
    if (typeof source !== 'string' && !(source instanceof URL)) {
        refuse('init.source', source, 'must be a URL, a string, a Response, bytes or a WebAssembly.Module');
    }
    const url = new URL(source, import.meta.url);
    if (url.protocol !== 'file:') return fromResponse(await fetch(url));
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises');
    return WebAssembly.compile(await readFile(url));
}

async function fromResponse(response) {
    if (!response.ok)
        throw new CairnError(
            'io',
            `${response.url}: cannot be read: status ${response.status}`,
            response.url,
            String(response.status),
        );
    return WebAssembly.compile(await response.arrayBuffer());
}

/** The version of the engine, such as "0.1.0". */
export function version() {
    return stringAt((M ?? refuse('init', 'not done', 'must be awaited first', 'wrongState'))._cairn_version());
}
