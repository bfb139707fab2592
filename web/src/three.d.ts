import type * as Three from 'three';
import type { BodyId, World } from './index.js';

/**
 * The shapes of a world as meshes of three.js, one for all shapes that look the same, and the surfaces of its fluids. `group` goes into
 * the scene; each mesh of shapes in it has in `userData.bodies` the body of each instance.
 */
export class WorldView {
    /** `THREE`: the module of three.js, so that a page has one copy of it. Throws CairnError (invalidValue, wrongState). */
    constructor(THREE: typeof Three, world: World);
    readonly group: Three.Group;
    readonly world: World;
    /** The bodies that are drawn. */
    readonly ids: BodyId[];
    /** Makes the meshes anew: after bodies, shapes or fluids came, went or were changed, or bodies enabled or disabled: those are not seen. */
    rebuild(): void;
    /** Puts everything where it is now. Throws CairnError (invalidValue) if bodies came or went since `rebuild`. */
    sync(): void;
    /** Frees the memory of the meshes; the world is not touched. */
    dispose(): void;
}
