#include "scene/urdf_file.h"

#include "scene/nearby_files.h"

#include <cairn/error.h>

#include <console_bridge/console.h>
#include <tinyxml.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

namespace cairn::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_robot_bytes = std::size_t{16} << 20;
constexpr int max_xml_depth = 64; // the parser recurses once per level
constexpr int folders_above = 8;  // number of folders, from the robot's upward, that are searched for its package
constexpr std::string_view of_package = "package://";

// Returns the end of a section that starts at `from` and ends with `mark`.
std::size_t end_of(std::string_view text, std::size_t from, std::string_view mark) {
    const std::size_t found = text.find(mark, from);
    return found == std::string_view::npos ? text.size() : found + mark.size();
}

// Returns the end of a tag, and whether it is an empty-element tag. A ">" in quotes belongs to a value.
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

// Returns the first element of the macro language xacro, or with a macro expression in an attribute; null if there is
// none.
const TiXmlElement* find_macro(const TiXmlElement* element) {
    for (; element != nullptr; element = element->NextSiblingElement()) {
        if (std::string_view(element->Value()).substr(0, 6) == "xacro:") return element;
        for (const TiXmlAttribute* a = element->FirstAttribute(); a != nullptr; a = a->Next()) {
            const std::string_view value = a->Value();
            if (value.find("${") != std::string_view::npos || value.find("$(") != std::string_view::npos)
                return element;
        }
        if (const TiXmlElement* below = find_macro(element->FirstChildElement())) return below;
    }
    return nullptr;
}

// Throws Error with the line if the text is not XML, which urdfdom does not report, or if it is a xacro file.
void check_syntax(const std::string& text, const std::string& name) {
    TiXmlDocument document;
    document.Parse(text.c_str());
    if (document.Error()) {
        throw Error(ErrorCode::invalid_file, name + ":" + std::to_string(document.ErrorRow()), {},
                    std::string("is not valid XML: ") + document.ErrorDesc());
    }
    if (const TiXmlElement* macro = find_macro(document.RootElement())) {
        throw Error(ErrorCode::unsupported, name + ":" + std::to_string(macro->Row()), {},
                    "is a xacro file (\"" + std::string(macro->Value()).substr(0, 60) +
                        "\"), from which the program xacro of ROS makes a URDF file: xacro " + name + " > robot.urdf");
    }
}

// Captures the error messages of urdfdom, which it writes to a log shared by the whole process.
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
        std::string shown; // on one line, and printable
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

// Checks that every link is reachable from the root, by one path.
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
                        "must be connected to the root link, \"" + model.getRoot()->name + "\"");
        }
    }
}

// Returns the first package from `folder` upward, with that name or any. A package must have a package.xml, because the
// robot chooses the name: otherwise "package://home/..." would make a package of everything below /home.
std::optional<fs::path> package_above(fs::path folder, const std::optional<std::string>& name) {
    for (int i = 0; i < folders_above; ++i) {
        std::error_code code;
        const bool is_package = fs::is_regular_file(folder / "package.xml", code);
        if (is_package && (!name || folder.filename() == *name)) return folder;
        if (folder == folder.parent_path()) break;
        folder = folder.parent_path();
    }
    return std::nullopt;
}

struct MeshPlace {
    fs::path root, from; // the folder that the file must stay in, and the folder that its name is relative to
    std::string name;
};

// Resolves NAME/PATH for a robot in the folder `here`. The name is empty if the path is invalid.
MeshPlace place_in_package(const std::string& path, const fs::path& here) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    const std::string owner = path.substr(0, slash), rest = path.substr(std::min(slash + 1, path.size()));
    if (owner.empty() || owner == "." || owner == "..") return {here, here, {}};
    if (const auto named = package_above(here, owner)) return {*named, *named, rest};
    if (const auto any = package_above(here, {})) return {*any, *any, rest};
    std::error_code code;
    if (here.filename() != owner && fs::is_directory(here / owner, code)) return {here, here / owner, rest};
    return {here, here, rest};
}

} // namespace

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
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) { // from inside the parser
        why = error.what();
    }
    if (!complaints.text().empty()) why = complaints.text();
    if (!why.empty() || !model || !model->getRoot()) {
        throw Error(ErrorCode::invalid_file, name, {},
                    why.empty() ? "must be a URDF file with a robot of at least one link" : why);
    }
    try {
        check_tree(*model, name);
    } catch (const Error&) { // links in a cycle of shared pointers would never be freed
        for (const auto& [key, link] : model->links_) link->child_links.clear();
        throw;
    }
    return model;
}

std::string without_spare_slashes(const std::string& filename) {
    if (filename.substr(0, of_package.size()) != of_package) return filename;
    const std::size_t name = filename.find_first_not_of('/', of_package.size());
    return std::string(of_package) + (name == std::string::npos ? std::string() : filename.substr(name));
}

NamedFile find_robot_file(const std::string& filename, const std::optional<fs::path>& folder,
                          const std::string& place) {
    const std::string shown = "\"" + filename.substr(0, 200) + "\"";
    if (!folder) {
        throw Error(ErrorCode::unsupported, place, shown,
                    "other files cannot be read by a robot that comes from memory");
    }
    const fs::path here = folder_on_disk(*folder);
    constexpr std::string_view of_file = "file://";
    MeshPlace where{package_above(here, {}).value_or(here), here, filename};
    if (filename.substr(0, of_package.size()) == of_package) {
        where = place_in_package(filename.substr(of_package.size()), here);
        if (where.name.empty()) throw Error(ErrorCode::io, place, shown, "must be package://NAME/PATH");
    } else if (filename.substr(0, of_file.size()) == of_file) {
        where.name = filename.substr(of_file.size());
    }
    const NearbyFile file = nearby_file(where.name, where.from, where.root);
    switch (file.verdict) {
    case NearbyFile::Verdict::found:
        return {file.path, where.root, place, filename.substr(0, 200)};
    case NearbyFile::Verdict::outside:
        throw Error(ErrorCode::io, place, shown,
                    "must name a file in " + where.root.generic_string() + " or below it, also where links lead");
    case NearbyFile::Verdict::not_a_file:
        throw Error(ErrorCode::io, place, shown, "must name a file, not a folder or a device");
    case NearbyFile::Verdict::missing:
        break;
    }
    throw Error(ErrorCode::io, place, shown,
                "there is no such file: " + (where.from / where.name).lexically_normal().generic_string());
}

} // namespace cairn::scene
