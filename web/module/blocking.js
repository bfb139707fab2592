// A library for Emscripten's linker. Its own function warns on the console that the main thread of a page waits. It does only
// when World.threads changes or a world is disposed of: until threads that have nothing to do have ended.
mergeInto(LibraryManager.library, { emscripten_check_blocking_allowed: function () {} });
