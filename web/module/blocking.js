// A library for Emscripten's linker. The original function logs a warning when the main thread of a page blocks, as it
// does when World.threads changes or a world is disposed of: it then waits until idle threads have ended.
mergeInto(LibraryManager.library, { emscripten_check_blocking_allowed: function () {} });
