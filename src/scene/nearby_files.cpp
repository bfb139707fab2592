#include "scene/nearby_files.h"

#include <cairn/error.h>

#include <algorithm>
#include <system_error>

namespace cairn::scene {

namespace fs = std::filesystem;

namespace {

bool is_in(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

} // namespace

fs::path folder_on_disk(const fs::path& folder) {
    std::error_code code;
    const fs::path found = fs::canonical(folder.empty() ? fs::path(".") : folder, code);
    if (code) throw Error(ErrorCode::io, folder.generic_string(), {}, "cannot be looked up: " + code.message());
    return found;
}

NearbyFile nearby_file(std::string_view name, const fs::path& from, const fs::path& root) {
    using Verdict = NearbyFile::Verdict;
    if (name.empty() || name.find('\0') != std::string_view::npos) return {Verdict::outside, {}, {}};
    const fs::path written = (from / name).lexically_normal();
    if (!is_in(written, root)) return {Verdict::outside, {}, {}};
    std::error_code code;
    const fs::path found = fs::canonical(written, code);
    if (code) return {Verdict::missing, {}, code.message()};
    if (!is_in(found, root)) return {Verdict::outside, {}, {}};
    if (!fs::is_regular_file(found, code)) return {Verdict::not_a_file, {}, {}};
    return {Verdict::found, found, {}};
}

} // namespace cairn::scene
