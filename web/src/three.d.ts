import type * as Three from 'three';
import type { BodyId, World } from './index.js';

/**
 * The shapes of a world as meshes of three.js, one for all shapes of the same appearance, and the surfaces of its fluids. Add `group`
 * to the scene; `userData.bodies` of each mesh of shapes in it contains the body of each instance.
 */
export class WorldView {
    /** `THREE`: the module of three.js, so that a page has one copy of it. Throws CairnError (invalidValue, wrongState). */
    constructor(THREE: typeof Three, world: World);
    readonly group: Three.Group;
    readonly world: World;
    /** The bodies that are drawn. */
    readonly ids: BodyId[];
    /**
     * Creates the meshes again: needed after bodies, shapes or fluids were added, removed or changed, or bodies enabled or disabled
     * (disabled ones are not drawn).
     */
    rebuild(): void;
    /** Updates all poses. Throws CairnError (invalidValue) if bodies were added or removed since `rebuild`. */
    sync(): void;
    /** Frees the memory of the meshes; the world is not touched. */
    dispose(): void;
}
