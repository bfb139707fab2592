// Module loading, shared by both entries of the package, index.js and mt.js: once, from any source of its bytes.
import { CairnError, refuse } from './error.js';
import { M, stringAt } from './memory.js';

// Not in the form that bundlers recognize, because files loaded from here are chosen by the user.
const HERE = import.meta.url;

let started = null; // the entry that started loading, and its promise

/**
 * The promise of `load()`, which is called once. Both entries have the same classes, which use a single module:
 * therefore loading the other entry is an error.
 */
export function once(entry, load) {
    if (started !== null && started.entry !== entry) {
        const expected = `must be imported from '${started.entry}', which was initialized before`;
        return new Promise(() => refuse('init', `init() of '${entry}'`, expected, 'wrongState'));
    }
    started ??= {
        entry,
        promise: load().catch((error) => {
            started = null; // another source can be tried
            throw error;
        }),
    };
    return started.promise;
}

/** The WebAssembly.Module for the argument of `init`: a URL, a Response, bytes, or the module itself. */
export async function compiled(source, field) {
    if (source instanceof WebAssembly.Module) return source;
    if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return fromBytes(source, field);
    if (typeof Response !== 'undefined' && source instanceof Response) return fromResponse(source, field);
    if (typeof source !== 'string' && !(source instanceof URL)) {
        refuse(field, source, 'must be a URL, a string, a Response, bytes or a WebAssembly.Module');
    }
    const url = new URL(source, globalThis.location?.href ?? HERE);
    if (url.protocol !== 'file:') return fromResponse(await fetch(url), url.href);
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises');
    return fromBytes(await readFile(url).catch((error) => unreadable(url.href, error.code)), url.href);
}

function unreadable(where, why) {
    throw new CairnError('io', `${where}: must be a file that can be read, got ${why}; ${HINT}`, where, String(why));
}

async function fromResponse(response, field) {
    const where = response.url || field;
    if (!response.ok) unreadable(where, `status ${response.status}`);
    return fromBytes(await response.arrayBuffer(), where);
}

const HINT = `if a bundler is used, see "Bundlers" in the README of cairn-physics`;
const MAGIC = [0, 0x61, 0x73, 0x6d];

// Servers of single-page applications answer requests for missing files with a page and a success status.
async function fromBytes(bytes, where) {
    const view = ArrayBuffer.isView(bytes) ? bytes : new Uint8Array(bytes);
    const first = new Uint8Array(view.buffer, view.byteOffset, Math.min(view.byteLength, 16));
    if (MAGIC.some((byte, i) => first[i] !== byte)) {
        const found = JSON.stringify(String.fromCharCode(...first));
        damaged(where, found, `bytes that begin with ${found}; ${HINT}`);
    }
    return WebAssembly.compile(bytes).catch((error) => damaged(where, error.message, error.message));
}

function damaged(where, value, found) {
    const message = `${where}: must be the file cairn.wasm of this package, got ${found}`;
    throw new CairnError('invalidFile', message, where, value);
}

/** The version of the engine, such as "0.1.0". */
export function version() {
    return stringAt((M ?? refuse('init', 'not done', 'must be awaited first', 'wrongState'))._cairn_version());
}
