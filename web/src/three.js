// The bodies of a world as instanced meshes of three.js.
import { refuse } from './error.js';

const PALETTE = [0x4e79a7, 0xf28e2b, 0xe15759, 0x76b7b2, 0x59a14f, 0xedc948, 0xb07aa1, 0xff9da7, 0x9c755f];
const FIXED = 0xb8bcc4;
const WATER = 0x2f7fb5;
const FARTHEST = 1000; // extent of an infinite fluid, m

/**
 * Draws the shapes of a world, and the surfaces of its fluids. `THREE` is the module of three.js, so that there is one
 * copy of it in the page. Add `group` to the scene; `sync` updates all poses. Call `rebuild` after bodies, shapes or
 * fluids were added, removed or changed, or bodies enabled or disabled: disabled bodies are not drawn.
 */
export class WorldView {
    constructor(THREE, world) {
        if (typeof THREE?.InstancedMesh !== 'function')
            refuse('WorldView.THREE', THREE, 'must be the module of three.js');
        this.THREE = THREE;
        this.world = world;
        this.group = new THREE.Group();
        this.meshes = [];
        this.waters = [];
        this.rebuild();
    }

    /** Creates the meshes again: one for all shapes of the same appearance. */
    rebuild() {
        const { THREE, world } = this;
        this.clear();
        const alike = new Map();
        this.ids = world.bodies;
        this.ids.forEach((id, index) => {
            const body = world.body(id);
            if (!body.enabled) return;
            const fixed = body.type === 'static';
            for (const shape of body.shapes) {
                const kind = world.shape(shape);
                const def = world.shapeDef(shape);
                const look = keyOf(kind);
                if (!alike.has(look)) alike.set(look, { shape, parts: [] });
                alike.get(look).parts.push({ index, fixed, def, color: world.shapeColor(shape) });
                kind.geometry?.dispose();
            }
        });
        for (const { shape, parts } of alike.values()) this.add(geometryOf(THREE, world.shapeTriangles(shape)), parts);
        this.addFluids();
        this.positions = new Float64Array(3 * this.ids.length);
        this.rotations = new Float32Array(4 * this.ids.length);
        this.sync();
    }

    add(geometry, parts) {
        const { THREE } = this;
        const material = new THREE.MeshStandardMaterial({ roughness: 0.75, metalness: 0.05 });
        const mesh = new THREE.InstancedMesh(geometry, material, parts.length);
        mesh.frustumCulled = false; // the bounds of an instanced mesh do not include its instances
        mesh.castShadow = mesh.receiveShadow = true;
        mesh.userData.bodies = parts.map(({ index }) => this.ids[index]);
        const color = new THREE.Color();
        parts.forEach(({ index, fixed, color: own }, i) => {
            if (own) color.setRGB(own.x, own.y, own.z);
            else color.setHex(fixed ? FIXED : PALETTE[index % PALETTE.length]);
            mesh.setColorAt(i, color);
        });
        const local = parts.map(({ def }) =>
            new THREE.Matrix4().compose(
                vectorOf(THREE, def.position),
                new THREE.Quaternion(def.rotation.x, def.rotation.y, def.rotation.z, def.rotation.w),
                new THREE.Vector3(1, 1, 1),
            ),
        );
        this.meshes.push({ mesh, parts, local });
        this.group.add(mesh);
    }

    addFluids() {
        const { THREE, world } = this;
        const up = vectorOf(THREE, world.settings.gravity).negate().normalize();
        if (up.lengthSq() === 0) return;
        for (const id of world.forceFields) {
            const field = world.forceField(id);
            if (field.kind !== 'fluid') continue;
            const { x, y, z } = field.halfExtents;
            // The two axes perpendicular to the one closest to gravity, and the extent along them.
            const along = [Math.abs(up.x), Math.abs(up.y), Math.abs(up.z)];
            const vertical = along.indexOf(Math.max(...along));
            const corners = [];
            for (const [s, t] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
                const p = [0, 0, 0];
                [s, t].forEach((side, i) => {
                    const axis = (vertical + 1 + i) % 3;
                    p[axis] = side * Math.min([x, y, z][axis], FARTHEST);
                    p[vertical] -= (up.getComponent(axis) * p[axis]) / up.getComponent(vertical);
                });
                corners.push(...p);
            }
            const geometry = new THREE.BufferGeometry();
            geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(corners), 3));
            geometry.setIndex([0, 1, 2, 0, 2, 3]);
            const material = new THREE.MeshBasicMaterial({
                color: WATER,
                transparent: true,
                opacity: 0.45,
                depthWrite: false,
                side: THREE.DoubleSide,
            });
            const mesh = new THREE.Mesh(geometry, material);
            mesh.position.copy(vectorOf(THREE, field.center));
            mesh.raycast = () => {}; // rays pass through the surface to the bodies
            this.waters.push(mesh);
            this.group.add(mesh);
        }
    }

    /** Updates all poses. Throws CairnError (invalidValue) if bodies were added or removed since `rebuild`. */
    sync() {
        const { THREE, positions, rotations } = this;
        this.world.readBodies({ positions, rotations });
        const pose = new THREE.Matrix4(),
            place = new THREE.Vector3(),
            turn = new THREE.Quaternion(),
            one = new THREE.Vector3(1, 1, 1);
        for (const { mesh, parts, local } of this.meshes) {
            parts.forEach(({ index }, i) => {
                place.fromArray(positions, 3 * index);
                turn.fromArray(rotations, 4 * index);
                mesh.setMatrixAt(i, pose.compose(place, turn, one).multiply(local[i]));
            });
            mesh.instanceMatrix.needsUpdate = true;
            mesh.boundingSphere = null; // recomputed from the current positions when a ray is cast
        }
    }

    clear() {
        for (const { mesh } of this.meshes) {
            this.group.remove(mesh);
            mesh.geometry.dispose();
            mesh.material.dispose();
            mesh.dispose();
        }
        this.meshes = [];
        for (const mesh of this.waters) {
            this.group.remove(mesh);
            mesh.geometry.dispose();
            mesh.material.dispose();
        }
        this.waters = [];
    }

    dispose() {
        this.clear();
    }
}

function vectorOf(THREE, { x, y, z }) {
    return new THREE.Vector3(x, y, z);
}

// A key that is equal for shapes of the same appearance. Hulls, meshes and height fields are drawn one by one:
// comparing them would require reading all their data.
function keyOf(kind) {
    return kind.geometry ? Symbol() : JSON.stringify(kind);
}

function geometryOf(THREE, { vertices, normals, indices }) {
    let geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(vertices, 3));
    geometry.setIndex(new THREE.BufferAttribute(indices, 1));
    if (normals) geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
    else {
        geometry = geometry.toNonIndexed();
        geometry.computeVertexNormals();
    }
    return geometry;
}
