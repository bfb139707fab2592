// The module, a scratch area in its memory for arguments and results of calls, and checks shared by all calls.
import { CairnError, CODES, refuse } from './error.js';

/** The Emscripten module: its functions and the views of its memory. Null until `init` has finished. */
export let M = null;

let shared = null; // the module's memory, if other threads may grow it

export const ALL_LAYERS = 0xffffffffffffffffn;

const SCRATCH_BYTES = 1 << 16;
let scratch = 0; // address of the scratch area
let top = 0; // first unused address in it
let taken = []; // allocations that did not fit into it, by malloc

/** Sets the module. `memory`: its memory, if threads share it. */
export function attach(module, memory = null) {
    M = module;
    shared = memory;
    scratch = top = reserve(SCRATCH_BYTES);
}

function reserve(bytes) {
    const at = M._malloc(bytes);
    if (at === 0) throw new CairnError('outOfMemory', `out of memory: ${bytes} bytes`);
    renewViews();
    return at;
}

// When another thread has grown the shared memory, the views of this thread remain valid, but still end at the old
// size. Emscripten updates them when this thread grows the memory, and for memory that is not shared.
function renewViews() {
    if (shared === null || shared.buffer === M.HEAPU8.buffer) return;
    const { buffer } = shared;
    M.HEAPU8 = new Uint8Array(buffer);
    M.HEAPU16 = new Uint16Array(buffer);
    M.HEAP32 = new Int32Array(buffer);
    M.HEAPU32 = new Uint32Array(buffer);
    M.HEAPF32 = new Float32Array(buffer);
    M.HEAPF64 = new Float64Array(buffer);
}

/**
 * Begins a call. Its result must be passed to `leave`. Calls may be nested, as reading an argument can run user code.
 */
export function enter() {
    if (M === null) {
        throw new CairnError(
            'wrongState',
            'cairn-physics: must be initialized first (await init()), got a call before that',
            'init',
            'not done',
        );
    }
    return [top, taken.length];
}

/** Ends a call: frees the memory that `room` has allocated since `enter`. */
export function leave([before, count]) {
    top = before;
    while (taken.length > count) M._free(taken.pop());
}

/** Allocates zeroed bytes for an argument or a result until the call ends, aligned for any number. */
export function room(bytes) {
    const size = (bytes + 7) & ~7;
    if (bytes > 0x7fff0000) throw new CairnError('outOfMemory', `out of memory: ${bytes} bytes`);
    let at = top;
    if (top + size <= scratch + SCRATCH_BYTES) {
        top += size;
    } else {
        at = reserve(size);
        taken.push(at);
    }
    M.HEAPU8.fill(0, at, at + size);
    return at;
}

/** Allocates memory for an argument, which `put` writes. */
export function placed(bytes, put) {
    const at = room(bytes);
    put(at);
    return at;
}

/** Throws the error of a call that did not return CAIRN_OK. */
export function check(result) {
    renewViews();
    if (result === 0) return;
    const text = stringAt(M._cairn_last_error()),
        its = stringAt(M._cairn_last_error_field()),
        field = camelField(its);
    throw new CairnError(
        CODES[result] ?? 'other',
        text.startsWith(`${its}:`) ? field + text.slice(its.length) : text,
        field,
        stringAt(M._cairn_last_error_value()),
    );
}

// Converts names of members from C to JavaScript.
function camelField(field) {
    return field.replaceAll('::', '.').replace(/_([a-z])/g, (_, letter) => letter.toUpperCase());
}

/** The address of a world, if it has not been disposed of. */
export function use(world) {
    if (world.address === 0) refuse('World', 'disposed', 'must not be disposed', 'wrongState');
    return world.address;
}

// --- arguments

export function objectOf(value, where) {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) refuse(where, value, 'must be an object');
    return value;
}

/** The names of an object's own members. */
export function keysOf(value, where) {
    return Object.keys(objectOf(value, where));
}

export function unknown(struct, key, names) {
    refuse(`${struct}.${key}`, key, `must be a member of ${struct}, which has ${names.join(', ') || 'no members'}`);
}

export function indexOf(names, value, where) {
    const index = names.indexOf(value);
    if (index < 0) refuse(where, value, `must be one of ${names.join(', ')}`);
    return index;
}

export function numberOf(value, where) {
    if (typeof value !== 'number') refuse(where, value, 'must be a number');
    return value;
}

export function wholeOf(value, where) {
    if (!Number.isInteger(value) || value < -0x80000000 || value > 0x7fffffff) {
        refuse(where, value, 'must be a whole number from -2147483648 to 2147483647');
    }
    return value;
}

export function boolOf(value, where) {
    if (typeof value !== 'boolean') refuse(where, value, 'must be true or false');
    return value;
}

/** The lower and the upper half of a 64-bit number. */
export function u64Of(value, where) {
    if (typeof value === 'number' && Number.isSafeInteger(value) && value >= 0)
        return [(value % 0x100000000) | 0, Math.floor(value / 0x100000000) | 0];
    if (typeof value !== 'bigint' || value < 0n || value > ALL_LAYERS) {
        refuse(where, value, 'must be a bigint from 0 to 2^64 - 1, or a whole number from 0 to 2^53 - 1');
    }
    return [Number(value & 0xffffffffn) | 0, Number(value >> 32n) | 0];
}

/** The lower and the upper half of a handle: a bigint, or a Body. Null is the null handle. */
export function handleOf(value, where) {
    if (value === null) return [0, 0];
    if (typeof value === 'bigint') return u64Of(value, where);
    if (typeof value === 'object' && typeof value.id === 'bigint') return u64Of(value.id, where);
    return refuse(where, value, 'must be a handle (a bigint, a Body or null)', 'invalidHandle');
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** Copies a string to the module's memory until the call ends: UTF-8, zero-terminated. */
export function textAt(value, where) {
    if (typeof value !== 'string') refuse(where, value, 'must be a string');
    if (value.includes('\0')) refuse(where, value, 'must not contain the character 0');
    const bytes = encoder.encode(value);
    const at = room(bytes.length + 1);
    M.HEAPU8.set(bytes, at);
    return at;
}

// --- results

/** The zero-terminated string at an address. */
export function stringAt(at) {
    if (at === 0) return '';
    const bytes = M.HEAPU8;
    return decoder.decode(bytes.slice(at, bytes.indexOf(0, at)));
}

/** A string from a call that writes it into a buffer: `call(text, capacity, length)`. */
export function textOf(call) {
    const length = room(4);
    check(call(0, 0, length));
    const bytes = M.HEAPU32[length >> 2];
    const text = room(bytes + 1);
    check(call(text, bytes + 1, length));
    return decoder.decode(M.HEAPU8.slice(text, text + bytes));
}

/** A list from a call that writes elements of `size` bytes into an array: `call(list, capacity, count)`. */
export function listOf(size, call, read) {
    const count = room(4);
    check(call(0, 0, count));
    const length = M.HEAPU32[count >> 2];
    const list = room(size * length);
    check(call(list, length, count));
    return Array.from({ length }, (_, i) => read(list + size * i));
}
