// Runs a scene of the determinism tests, in Node or in a page.

/**
 * Throws at the first state whose hash differs from that of native code. `options`: properties to be set on the world,
 * such as `threads`.
 */
export function replay({ settings, hashes, run }, { World, Geometry }, options = {}) {
    const world = Object.assign(new World(settings), options);
    const handles = new Map();
    const keep = (name, handle) => handles.set(name, handle);
    const at = (name) => {
        if (!handles.has(name)) throw new Error(`the scene uses a handle ${name} that no call has returned`);
        return handles.get(name);
    };
    let steps = 0,
        compared = 0;
    for (const _ of run(world, { keep, at, Geometry })) {
        ++steps;
        if (hashes[steps] === undefined) continue;
        ++compared;
        const found = world.stateHash.toString(16),
            right = hashes[steps].toString(16);
        if (found !== right) throw new Error(`after step ${steps}: hash ${found}, in native code ${right}`);
    }
    const expected = Object.keys(hashes).length;
    if (compared !== expected) throw new Error(`${compared} of ${expected} hashes were compared`);
    world.dispose();
}
