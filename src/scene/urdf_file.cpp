#include "scene/urdf_file.h"

#include <cairn/error.h>

#include <console_bridge/console.h>
#include <tinyxml.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

namespace cairn::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_robot_bytes = std::size_t{16} << 20;
constexpr int max_xml_depth = 64; // the parser calls itself for every level
constexpr int folders_above = 8;  // that may be the package of a robot

// The end of what starts at `from` and is closed by `mark`.
std::size_t end_of(std::string_view text, std::size_t from, std::string_view mark) {
    const std::size_t found = text.find(mark, from);
    return found == std::string_view::npos ? text.size() : found + mark.size();
}

// The end of a tag, and whether it closes itself. A ">" in quotes belongs to a value.
std::size_t end_of_tag(std::string_view text, std::size_t from, bool& closes_itself) {
    char quote = 0;
    for (std::size_t i = from; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '>') {
            closes_itself = text[i - 1] == '/';
            return i + 1;
        }
    }
    return text.size();
}

void check_depth(std::string_view text, const std::string& name) {
    int depth = 0;
    for (std::size_t i = text.find('<'); i < text.size(); i = text.find('<', i)) {
        const std::string_view rest = text.substr(i);
        bool closes_itself = false;
        if (rest.substr(0, 4) == "<!--") {
            i = end_of(text, i + 4, "-->");
        } else if (rest.substr(0, 9) == "<![CDATA[") {
            i = end_of(text, i + 9, "]]>");
        } else if (rest.substr(0, 2) == "<!" || rest.substr(0, 2) == "<?") {
            i = end_of(text, i + 2, ">");
        } else if (rest.substr(0, 2) == "</") {
            --depth;
            i = end_of(text, i + 2, ">");
        } else {
            i = end_of_tag(text, i + 1, closes_itself);
            if (!closes_itself && ++depth > max_xml_depth) {
                throw Error(ErrorCode::invalid_file, name, {},
                            "must have at most " + std::to_string(max_xml_depth) + " elements inside each other");
            }
        }
    }
}

// Where the text is no XML; urdfdom does not say.
void check_syntax(const std::string& text, const std::string& name) {
    TiXmlDocument document;
    document.Parse(text.c_str());
    if (!document.Error()) return;
    throw Error(ErrorCode::invalid_file, name + ":" + std::to_string(document.ErrorRow()), {},
                std::string("is not valid XML: ") + document.ErrorDesc());
}

// urdfdom says what is wrong to a log that all of the process shares.
class Complaints final : public console_bridge::OutputHandler {
  public:
    Complaints() : before_(console_bridge::getOutputHandler()), level_(console_bridge::getLogLevel()) {
        console_bridge::useOutputHandler(this);
        console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
    }
    ~Complaints() override {
        console_bridge::setLogLevel(level_);
        console_bridge::useOutputHandler(before_);
    }
    Complaints(const Complaints&) = delete;
    Complaints& operator=(const Complaints&) = delete;

    void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
        if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR || first_.size() > 1000) return;
        std::string shown; // of one line, and printable
        for (const char c : text.substr(0, 400)) shown += c >= ' ' && c <= '~' ? c : ' ';
        while (!shown.empty() && shown.back() == ' ') shown.pop_back();
        first_ += (first_.empty() ? "" : "; ") + shown;
    }
    const std::string& text() const { return first_; }

  private:
    console_bridge::OutputHandler* before_;
    console_bridge::LogLevel level_;
    std::string first_;
};

// Every link hangs on the root, in one place.
void check_tree(const urdf::ModelInterface& model, const std::string& name) {
    std::set<std::string> seen;
    std::vector<urdf::LinkConstSharedPtr> open{model.getRoot()};
    while (!open.empty()) {
        const urdf::LinkConstSharedPtr link = open.back();
        open.pop_back();
        if (!seen.insert(link->name).second) {
            throw Error(ErrorCode::invalid_file, name + ": link \"" + link->name + "\"", {},
                        "must be the child of one joint only");
        }
        for (const urdf::JointSharedPtr& joint : link->child_joints) {
            const urdf::LinkConstSharedPtr child = model.getLink(joint->child_link_name);
            if (!child) {
                throw Error(ErrorCode::invalid_file, name + ": joint \"" + joint->name + "\": child",
                            "\"" + joint->child_link_name + "\"", "must be a link of the robot");
            }
            open.push_back(child);
        }
    }
    for (const auto& [key, link] : model.links_) {
        if (seen.count(key) == 0) {
            throw Error(ErrorCode::invalid_file, name + ": link \"" + key + "\"", {},
                        "must hang on the root link, \"" + model.getRoot()->name + "\"");
        }
    }
}

bool is_in(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

// The first folder from `folder` upwards of which `holds` is true.
template <class Test> std::optional<fs::path> folder_above(fs::path folder, Test&& holds) {
    for (int i = 0; i < folders_above; ++i) {
        if (holds(folder)) return folder;
        if (folder == folder.parent_path()) break;
        folder = folder.parent_path();
    }
    return std::nullopt;
}

} // namespace

bool is_xml(std::span<const std::byte> bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '<';
}

urdf::ModelInterfaceSharedPtr parse_urdf(std::span<const std::byte> bytes, const std::string& name) {
    if (bytes.size() > max_robot_bytes) {
        throw Error(ErrorCode::invalid_file, name, std::to_string(bytes.size()) + " bytes",
                    "must be an URDF file of at most " + std::to_string(max_robot_bytes) + " bytes");
    }
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.find('\0') != std::string::npos) {
        throw Error(ErrorCode::invalid_file, name, {}, "must be text, without zero bytes");
    }
    check_depth(text, name);
    check_syntax(text, name);
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    const Complaints complaints;
    urdf::ModelInterfaceSharedPtr model;
    std::string why;
    try {
        model = urdf::parseURDF(text);
    } catch (const std::exception& error) { // from the depths of the parser
        why = error.what();
    }
    if (!complaints.text().empty()) why = complaints.text();
    if (!why.empty() || !model || !model->getRoot()) {
        throw Error(ErrorCode::invalid_file, name, {},
                    why.empty() ? "must be a URDF file with a robot of at least one link" : why);
    }
    try {
        check_tree(*model, name);
    } catch (const Error&) { // links in a circle would keep each other forever
        for (const auto& [key, link] : model->links_) link->child_links.clear();
        throw;
    }
    return model;
}

fs::path find_robot_mesh(const std::string& filename, const std::optional<fs::path>& folder, const std::string& place) {
    const std::string shown = "\"" + filename.substr(0, 200) + "\"";
    if (!folder) {
        throw Error(ErrorCode::unsupported, place, shown,
                    "other files cannot be read by a robot that comes from memory");
    }
    std::error_code code;
    const fs::path here = fs::canonical(folder->empty() ? fs::path(".") : *folder, code);
    if (code) throw Error(ErrorCode::io, folder->generic_string(), {}, code.message());
    const auto package = folder_above(here, [&](const fs::path& f) { return fs::exists(f / "package.xml", code); });
    fs::path root = package.value_or(here), file;
    constexpr std::string_view of_package = "package://", of_file = "file://";
    if (filename.substr(0, of_package.size()) == of_package) {
        const std::string path = filename.substr(of_package.size());
        const std::size_t slash = std::min(path.find('/'), path.size());
        const std::string owner = path.substr(0, slash), rest = path.substr(std::min(slash + 1, path.size()));
        const auto named = folder_above(here, [&](const fs::path& f) { return f.filename() == owner; });
        if (named) {
            root = *named;
        } else if (!package && !owner.empty() && fs::is_directory(here / owner, code)) {
            root = here / owner;
        }
        file = root / rest;
    } else {
        file = here / (filename.substr(0, of_file.size()) == of_file ? filename.substr(of_file.size()) : filename);
    }
    const fs::path found = fs::canonical(file, code);
    if (code || !fs::is_regular_file(found, code)) {
        throw Error(ErrorCode::io, place, shown, "there is no such file: " + file.generic_string());
    }
    if (!is_in(found, root)) {
        throw Error(ErrorCode::invalid_file, place, shown,
                    "must name a file in " + root.generic_string() + " or below it, also where links lead");
    }
    return found;
}

} // namespace cairn::scene
