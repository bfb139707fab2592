// From a name that stands in a file to a file on the disk: the one way for all readers, and the only one. What comes
// from strangers chooses the name, never the folder that it stays in.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cairn::scene {

// The folder of a file as the disk knows it, without links. Throws Error (io).
std::filesystem::path folder_on_disk(const std::filesystem::path& folder);

struct NearbyFile {
    enum class Verdict { found, outside, missing, not_a_file };
    Verdict verdict = Verdict::missing;
    std::filesystem::path path; // without links, if it was found
    std::string reason;         // why it is missing, in the words of the system
};

// The regular file of that name, which starts at `from`: it must lie in `root` or below it, both as the name is written
// and where links lead. `root` and `from` are as `folder_on_disk` gives them. Nothing outside of `root` is looked at
// for a name that leads out of it.
NearbyFile nearby_file(std::string_view name, const std::filesystem::path& from, const std::filesystem::path& root);

} // namespace cairn::scene
