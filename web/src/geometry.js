// Hulls, meshes and height fields, whose data are in the module's memory.
import { refuse } from './error.js';
import { M, check, enter, leave, listOf, numberOf, room, wholeOf } from './memory.js';
import * as fields from './fields.js';
import * as values from './generated/values.js';

// Releases geometries that were not disposed of.
const lost = new FinalizationRegistry((address) => M._cairn_geometry_release(address));
const SECRET = Symbol('made by Geometry');

/** The data of a hull, mesh or height field; they never change, and many shapes may share them. */
export class Geometry {
    constructor(address, secret) {
        if (secret !== SECRET)
            refuse(
                'Geometry',
                'new',
                'must be created by Geometry.hull, Geometry.mesh or Geometry.heightField',
                'wrongState',
            );
        this.address = address;
        lost.register(this, address, this);
    }

    static hull(points) {
        return made((out) => {
            const [at, count] = floatsOf(points, 3, 'points');
            return M._cairn_geometry_create_hull(at, count / 3, 0, out);
        });
    }

    static mesh(vertices, indices, materials = [], materialNumbers = []) {
        return made((out) => {
            const [at, count] = floatsOf(vertices, 3, 'vertices');
            const [corners, length] = indicesOf(indices);
            const own = materialsOf(materials, materialNumbers);
            return M._cairn_geometry_create_mesh_with_materials(at, count / 3, 0, corners, length, ...own, out);
        });
    }

    static heightField(columns, rows, spacing, heights, materials = [], materialNumbers = []) {
        return made((out) => {
            wholeOf(columns, 'columns');
            wholeOf(rows, 'rows');
            const between = room(8);
            fields.putVec2(between, spacing, 'spacing');
            const [at, count] = floatsOf(heights, 1, 'heights');
            const own = materialsOf(materials, materialNumbers);
            return M._cairn_geometry_create_height_field_with_materials(
                columns,
                rows,
                between,
                at,
                count,
                ...own,
                out,
            );
        });
    }

    get vertices() {
        return numbersOf(this, 12, M._cairn_geometry_get_vertices, (at, count) =>
            M.HEAPF32.slice(at >> 2, (at >> 2) + 3 * count),
        );
    }
    get indices() {
        return numbersOf(this, 4, M._cairn_geometry_get_indices, (at, count) =>
            M.HEAPU32.slice(at >> 2, (at >> 2) + count),
        );
    }
    get heights() {
        return numbersOf(this, 4, M._cairn_geometry_get_heights, (at, count) =>
            M.HEAPF32.slice(at >> 2, (at >> 2) + count),
        );
    }
    get materials() {
        const mark = enter();
        try {
            return listOf(
                values.MATERIAL_BYTES,
                (list, capacity, length) =>
                    M._cairn_geometry_get_materials(addressOf(this), list, capacity, length),
                values.getMaterial,
            );
        } finally {
            leave(mark);
        }
    }
    get materialNumbers() {
        return numbersOf(this, 2, M._cairn_geometry_get_material_numbers, (at, count) =>
            M.HEAPU16.slice(at >> 1, (at >> 1) + count),
        );
    }
    get droppedTriangles() {
        return oneOf(this, 4, M._cairn_geometry_get_dropped_triangles, fields.getSize);
    }
    get volume() {
        return oneOf(this, 8, M._cairn_geometry_get_volume, fields.getDouble);
    }
    get faces() {
        const count = oneOf(this, 4, M._cairn_geometry_get_face_count, fields.getSize);
        const mark = enter();
        try {
            return Array.from({ length: count }, (_, face) =>
                listOf(
                    4,
                    (list, capacity, length) =>
                        M._cairn_geometry_get_face(addressOf(this), face, list, capacity, length),
                    fields.getU32,
                ),
            );
        } finally {
            leave(mark);
        }
    }
    get grid() {
        const mark = enter();
        try {
            const columns = room(4),
                rows = room(4),
                spacing = room(8);
            check(M._cairn_geometry_get_grid(addressOf(this), columns, rows, spacing));
            return { columns: fields.getInt(columns), rows: fields.getInt(rows), spacing: fields.getVec2(spacing) };
        } finally {
            leave(mark);
        }
    }

    dispose() {
        if (this.address === 0) return;
        lost.unregister(this);
        M._cairn_geometry_release(this.address);
        this.address = 0;
    }
}
if (Symbol.dispose) Geometry.prototype[Symbol.dispose] = Geometry.prototype.dispose;

/** Takes ownership of a geometry that the module has returned. */
export function ownedGeometry(address) {
    return new Geometry(address, SECRET);
}

/** The address of the user's geometry. */
export function geometryAddress(value, where) {
    if (!(value instanceof Geometry)) refuse(where, value, 'must be a Geometry');
    return addressOf(value);
}

function addressOf(geometry) {
    if (geometry.address === 0) refuse('Geometry', 'disposed', 'must not be disposed', 'wrongState');
    return geometry.address;
}

function made(call) {
    const mark = enter();
    try {
        const out = room(4);
        check(call(out));
        return ownedGeometry(M.HEAPU32[out >> 2]);
    } finally {
        leave(mark);
    }
}

// Copies the user's numbers to the module's memory: returns their address and their count, which must be a multiple of
// `each`.
function floatsOf(list, each, where) {
    if (!Array.isArray(list) && !(list instanceof Float32Array) && !(list instanceof Float64Array)) {
        refuse(where, list, 'must be an array of numbers, a Float32Array or a Float64Array');
    }
    if (list.length % each !== 0) refuse(where, list, `must have a multiple of ${each} numbers`);
    if (Array.isArray(list)) list.forEach((x, i) => numberOf(x, `${where}[${i}]`));
    const at = room(4 * list.length);
    M.HEAPF32.set(list, at >> 2);
    return [at, list.length];
}

function indicesOf(list) {
    if (list instanceof Uint32Array || list instanceof Uint16Array) {
        const at = room(4 * list.length);
        M.HEAPU32.set(list, at >> 2);
        return [at, list.length];
    }
    if (!Array.isArray(list))
        refuse('indices', list, 'must be an array of whole numbers, a Uint32Array or a Uint16Array');
    const at = room(4 * list.length);
    list.forEach((x, i) => fields.putU32(at + 4 * i, x, `indices[${i}]`));
    return [at, list.length];
}

// Materials and the material indices of the parts: address and count of each list.
function materialsOf(materials, numbers) {
    if (!Array.isArray(materials)) refuse('materials', materials, 'must be an array of materials');
    const table = room(values.MATERIAL_BYTES * materials.length);
    materials.forEach((x, i) => values.putMaterial(table + i * values.MATERIAL_BYTES, x, `materials[${i}]`));
    if (!Array.isArray(numbers) && !(numbers instanceof Uint16Array) && !(numbers instanceof Uint8Array))
        refuse('materialNumbers', numbers, 'must be an array of whole numbers, a Uint16Array or a Uint8Array');
    const list = room(2 * numbers.length);
    numbers.forEach((x, i) => {
        if (!(Number.isInteger(x) && x >= 0 && x <= 65535))
            refuse(`materialNumbers[${i}]`, x, 'must be a whole number from 0 to 65535');
        M.HEAPU16[(list >> 1) + i] = x;
    });
    return [table, materials.length, list, numbers.length];
}

// A typed array from a call that writes `count` elements of `size` bytes.
function numbersOf(geometry, size, call, copy) {
    const mark = enter();
    try {
        const count = room(4);
        check(call(addressOf(geometry), 0, 0, count));
        const length = M.HEAPU32[count >> 2];
        const list = room(size * length);
        check(call(addressOf(geometry), list, length, count));
        return copy(list, length);
    } finally {
        leave(mark);
    }
}

function oneOf(geometry, size, call, read) {
    const mark = enter();
    try {
        const out = room(size);
        check(call(addressOf(geometry), out));
        return read(out);
    } finally {
        leave(mark);
    }
}
