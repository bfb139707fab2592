// Scenes in the fragment of the page's address: by name, or as a compressed .gltf file.
const LONGEST = 8 << 20; // characters of a fragment, and bytes of its decompressed contents

/** The fragment for the scene in its current state. Throws TypeError if it is too large for an address. */
export async function toFragment(simulation) {
    if (!simulation.touched && simulation.world.stepCount === 0n && Object.keys(simulation.hashes).length > 0) {
        return `#scene=${encodeURIComponent(simulation.name)}`;
    }
    const stream = new Blob([simulation.world.saveScene()]).stream().pipeThrough(new CompressionStream('deflate-raw'));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    let text = '';
    for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
    const fragment = `#gltf=${btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
    if (fragment.length > 1 << 20)
        throw new TypeError(`the scene is too large for a link: ${fragment.length} characters`);
    return fragment;
}

/** Decodes a fragment: {scene: name}, {gltf: text}, or null if it is empty. Throws TypeError for anything else. */
export async function fromFragment(fragment) {
    if (fragment === '' || fragment === '#') return null;
    if (fragment.length > LONGEST) throw new TypeError(`the link is too long: ${fragment.length} characters`);
    const [key, value] = fragment.slice(1).split('=', 2);
    if (key === 'scene' && value) return { scene: decodeURIComponent(value) };
    if (key !== 'gltf' || !value) throw new TypeError(`the link has no scene: ${fragment.slice(0, 40)}`);
    try {
        const bytes = Uint8Array.from(atob(value.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
        return { gltf: await inflated(bytes) };
    } catch (error) {
        throw new TypeError(`the link is damaged: ${error.message}`);
    }
}

// Decompresses piece by piece, so that a small link cannot exhaust the memory.
async function inflated(bytes) {
    const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw')).getReader();
    const pieces = [];
    for (let length = 0; ; ) {
        const { done, value } = await reader.read();
        if (done) return new Blob(pieces).text();
        length += value.length;
        if (length > LONGEST) throw new TypeError(`more than ${LONGEST} bytes`);
        pieces.push(value);
    }
}
