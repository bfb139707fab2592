// Resolves file names that occur in files; all readers use this function only. Scene files are untrusted: they choose
// the name, never the folder that it must stay in.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cairn::scene {

// Returns the canonical path of a folder, without symbolic links. Throws Error (io).
std::filesystem::path folder_on_disk(const std::filesystem::path& folder);

struct NearbyFile {
    enum class Verdict { found, outside, missing, not_a_file };
    Verdict verdict = Verdict::missing;
    std::filesystem::path path; // without symbolic links, if the file was found
    std::string reason;         // why the file is missing, as the system reports it
};

// Finds the regular file of that name, relative to `from`: it must lie in `root` or below it, both as the name is
// written and after symbolic links are followed. `root` and `from` are as `folder_on_disk` returns them. For a name
// that leads out of `root`, nothing outside of it is accessed.
NearbyFile nearby_file(std::string_view name, const std::filesystem::path& from, const std::filesystem::path& root);

} // namespace cairn::scene
