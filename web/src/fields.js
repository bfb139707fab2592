// Access to single values in the module's memory. Functions that write a value check it, and use `where` as its name in
// errors.
import { refuse } from './error.js';
import { M, boolOf, handleOf, indexOf, numberOf, room, stringAt, textAt, u64Of, wholeOf } from './memory.js';
import { geometryAddress, ownedGeometry } from './geometry.js';

export function putBool(at, value, where) {
    M.HEAPU8[at] = boolOf(value, where) ? 1 : 0;
}
export function putInt(at, value, where) {
    M.HEAP32[at >> 2] = wholeOf(value, where);
}
export function putFloat(at, value, where) {
    M.HEAPF32[at >> 2] = numberOf(value, where);
}
export function putDouble(at, value, where) {
    M.HEAPF64[at >> 3] = numberOf(value, where);
}
export function putU32(at, value, where) {
    if (!Number.isInteger(value) || value < 0 || value > 0xffffffff)
        refuse(where, value, 'must be a whole number from 0 to 4294967295');
    M.HEAPU32[at >> 2] = value;
}
export const putSize = putU32;
export function putU64(at, value, where) {
    [M.HEAP32[at >> 2], M.HEAP32[(at + 4) >> 2]] = u64Of(value, where);
}
export function putHandle(at, value, where) {
    [M.HEAP32[at >> 2], M.HEAP32[(at + 4) >> 2]] = handleOf(value, where);
}
export function putString(at, value, where) {
    const text = textAt(value, where);
    M.HEAPU32[at >> 2] = text;
}
export function putEnum(at, value, names, where) {
    M.HEAP32[at >> 2] = indexOf(names, value, where);
}
export function putGeometry(at, value, where) {
    M.HEAPU32[at >> 2] = geometryAddress(value, where);
}

const AXES = ['x', 'y', 'z', 'w'];

// Writes the components of a vector: an object with x, y, ..., or an array of that many numbers.
function putComponents(memory, first, value, count, where) {
    if (typeof value !== 'object' || value === null) {
        refuse(where, value, `must be {${AXES.slice(0, count).join(', ')}} or an array of ${count} numbers`);
    }
    const isArray = Array.isArray(value) || ArrayBuffer.isView(value);
    if (isArray && value.length !== count) refuse(where, value, `must have ${count} numbers`);
    const numbers = [0, 0, 0, 0]; // reading the user's values may run code that moves the memory
    for (let i = 0; i < count; ++i) {
        const x = isArray ? value[i] : value[AXES[i]];
        if (typeof x !== 'number') refuse(isArray ? `${where}[${i}]` : `${where}.${AXES[i]}`, x, 'must be a number');
        numbers[i] = x;
    }
    const view = M[memory];
    for (let i = 0; i < count; ++i) view[first + i] = numbers[i];
}

function putFloats(at, value, count, where) {
    putComponents('HEAPF32', at >> 2, value, count, where);
}
function putDoubles(at, value, where) {
    putComponents('HEAPF64', at >> 3, value, 3, where);
}
export function putVec2(at, value, where) {
    putFloats(at, value, 2, where);
}
export function putVec3(at, value, where) {
    putFloats(at, value, 3, where);
}
export function putQuat(at, value, where) {
    putFloats(at, value, 4, where);
}
export const putPosition = putDoubles;
export const putDVec3 = putDoubles;

function arrayOf(value, where) {
    if (!Array.isArray(value) && !ArrayBuffer.isView(value)) refuse(where, value, 'must be an array');
    return value;
}

/** An array of exactly `count` elements, each written by `put(at, x, i, where)`. */
export function putMany(at, value, count, where, put) {
    if (arrayOf(value, where).length !== count) refuse(where, value, `must have ${count} elements`);
    for (let i = 0; i < count; ++i) put(at, value[i], i, `${where}[${i}]`);
}

/** Writes a list: its address, and its number of elements of `size` bytes; `put(at, x, where)` writes an element. */
export function putList(at, countAt, value, size, where, put) {
    const { length } = arrayOf(value, where);
    const list = room(size * length);
    for (let i = 0; i < length; ++i) put(list + size * i, value[i], `${where}[${i}]`);
    M.HEAPU32[at >> 2] = list;
    M.HEAPU32[countAt >> 2] = length;
}

export const getBool = (at) => M.HEAPU8[at] !== 0;
export const getInt = (at) => M.HEAP32[at >> 2];
export const getFloat = (at) => M.HEAPF32[at >> 2];
export const getDouble = (at) => M.HEAPF64[at >> 3];
export const getU32 = (at) => M.HEAPU32[at >> 2];
export const getSize = getU32;
export const getU64 = (at) => (BigInt(M.HEAPU32[(at + 4) >> 2]) << 32n) | BigInt(M.HEAPU32[at >> 2]);
export const getString = (at) => stringAt(M.HEAPU32[at >> 2]);
export const getGeometry = (at) => ownedGeometry(M.HEAPU32[at >> 2]);

export function getVec2(at) {
    return { x: M.HEAPF32[at >> 2], y: M.HEAPF32[(at >> 2) + 1] };
}
export function getVec3(at) {
    const i = at >> 2,
        f = M.HEAPF32;
    return { x: f[i], y: f[i + 1], z: f[i + 2] };
}
export function getQuat(at) {
    const i = at >> 2,
        f = M.HEAPF32;
    return { x: f[i], y: f[i + 1], z: f[i + 2], w: f[i + 3] };
}
export function getPosition(at) {
    const i = at >> 3,
        f = M.HEAPF64;
    return { x: f[i], y: f[i + 1], z: f[i + 2] };
}
export const getDVec3 = getPosition;
/** Nine numbers in column-major order. */
export function getMat3(at) {
    return Array.from(M.HEAPF32.subarray(at >> 2, (at >> 2) + 9));
}
export function getMany(at, count, size, read) {
    return Array.from({ length: count }, (_, i) => read(at + size * i));
}
/** The list at an address; an empty one if the module gives only its length. */
export function getList(at, countAt, size, read) {
    const list = M.HEAPU32[at >> 2];
    return list === 0 ? [] : getMany(list, M.HEAPU32[countAt >> 2], size, read);
}
