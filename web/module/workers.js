// Prepended to the loader that Emscripten generates for cairn-physics/mt. The loader's `Worker` and `postMessage` are
// those that web/src/mt provides: of browsers or of Node.
var Worker = Module['Worker'],
    postMessage = Module['postMessage'];
