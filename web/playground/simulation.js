// A running scene: its world, the properties of its file, and whether anything but time has changed it.
import { World } from 'cairn-physics';
import { cameraOf } from './cameras.js';

export class Simulation {
    /**
     * `scene`: text or bytes of a .gltf or .glb file. `hashes`: the state hashes on other machines, by the number of
     * steps.
     */
    constructor(scene, { name, hashes = {} }) {
        this.scene = scene;
        this.name = name;
        this.hashes = hashes;
        this.world = World.load(scene, name);
        const json = JSON.parse(typeof scene === 'string' ? scene : jsonOf(scene));
        const own = settingsOf(json);
        this.title = own.title ?? name;
        this.hint = own.hint ?? '';
        this.camera = cameraOf(json);
        this.touched = false;
        this.compared = null; // the last state that was compared: steps, hash here, hash there
    }

    step() {
        const { world } = this;
        world.step();
        const steps = Number(world.stepCount);
        const there = this.hashes[steps];
        if (there && !this.touched)
            this.compared = { steps, here: world.stateHash.toString(16).padStart(16, '0'), there };
    }

    /** The same scene from its beginning. */
    again() {
        return new Simulation(this.scene, this);
    }

    dispose() {
        this.world.dispose();
    }
}

// The CAIRN_world extension of a file's scene. The world has read the file already: malformed files were rejected.
function settingsOf(json) {
    return json.scenes?.[json.scene ?? 0]?.extensions?.CAIRN_world ?? {};
}

// The text of a .gltf file, or the first chunk of a .glb file.
function jsonOf(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const isBinary = bytes.length > 20 && view.getUint32(0, true) === 0x46546c67;
    return new TextDecoder().decode(isBinary ? bytes.subarray(20, 20 + view.getUint32(12, true)) : bytes);
}
