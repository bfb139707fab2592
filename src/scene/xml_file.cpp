#include "scene/xml_file.h"

#include "scene/gltf_file.h"
#include "scene/nearby_files.h"

#include <cairn/error.h>

#include <algorithm>

namespace cairn::scene {

namespace {

constexpr std::size_t max_xml_bytes = std::size_t{16} << 20, max_xml_elements = 500000;
constexpr std::size_t max_included_files = 100;
constexpr int max_include_depth = 16;
constexpr std::size_t max_named = 40; // names in the warning about unused elements and attributes

std::string_view text_of_bytes(std::span<const std::byte> bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    return text;
}

bool is_include(const tinyxml2::XMLElement& element) { return std::string_view(element.Name()) == "include"; }

// Makes an error name readable: "XML_ERROR_PARSING_ATTRIBUTE" becomes "parsing attribute".
std::string readable(std::string_view error) {
    constexpr std::string_view prefix = "XML_ERROR_";
    if (error.substr(0, prefix.size()) == prefix) error.remove_prefix(prefix.size());
    std::string result;
    for (const char c : error) result += c == '_' ? ' ' : static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return result;
}

} // namespace

std::string printable(std::string_view text, std::size_t most) {
    std::string result;
    for (const char c : text.substr(0, most)) result += c >= ' ' && c <= '~' ? c : '?';
    return result;
}

std::string root_tag(std::span<const std::byte> bytes) {
    std::string_view text = text_of_bytes(bytes);
    for (;;) {
        const std::size_t begin = text.find('<');
        if (begin == std::string_view::npos) return {};
        text.remove_prefix(begin);
        const bool is_comment = text.substr(0, 4) == "<!--";
        if (!is_comment && text.substr(0, 2) != "<?" && text.substr(0, 2) != "<!") break;
        const std::string_view mark = is_comment ? "-->" : ">";
        const std::size_t end = text.find(mark, is_comment ? 4 : 2);
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + mark.size());
    }
    return std::string(text.substr(1, std::min<std::size_t>(text.find_first_of(" \t\r\n/>", 1), 64) - 1));
}

XmlFile::XmlFile(std::span<const std::byte> bytes, std::string name, const char* kind) : kind_(kind) {
    add(bytes, std::move(name));
}

void XmlFile::add(std::span<const std::byte> bytes, std::string name) {
    bytes_ += bytes.size();
    if (bytes_ > max_xml_bytes) {
        throw Error(ErrorCode::invalid_file, name, std::to_string(bytes_) + " bytes",
                    "must be " + kind_ + " of at most " + std::to_string(max_xml_bytes) +
                        " bytes, with all that it includes");
    }
    const std::string_view text = text_of_bytes(bytes);
    if (text.find('\0') != std::string_view::npos) {
        throw Error(ErrorCode::invalid_file, name, {}, "must be text, without zero bytes");
    }
    Part part{std::move(name), std::make_unique<tinyxml2::XMLDocument>()};
    part.document->Parse(text.data(), text.size());
    if (part.document->Error()) {
        throw Error(ErrorCode::invalid_file, part.name + ":" + std::to_string(part.document->ErrorLineNum()), {},
                    "is not valid XML: " + readable(tinyxml2::XMLDocument::ErrorIDToName(part.document->ErrorID())));
    }
    const tinyxml2::XMLElement* root = part.document->RootElement();
    if (root == nullptr)
        throw Error(ErrorCode::invalid_file, part.name, {}, "must be " + kind_ + ", and has no element");
    parts_.push_back(std::move(part));
    std::vector<const tinyxml2::XMLElement*> open{root};
    while (!open.empty()) {
        const tinyxml2::XMLElement& element = *open.back();
        open.pop_back();
        if (++elements_ > max_xml_elements) {
            throw Error(ErrorCode::invalid_file, parts_.back().name, {},
                        "must have at most " + std::to_string(max_xml_elements) + " elements");
        }
        for (const auto* c = element.FirstChildElement(); c != nullptr; c = c->NextSiblingElement()) open.push_back(c);
    }
}

XmlElement XmlFile::root() { return {*this, *parts_[0].document->RootElement()}; }

const std::string& XmlFile::name_of(const tinyxml2::XMLElement& element) const {
    for (const Part& part : parts_) {
        if (part.document.get() == element.GetDocument()) return part.name;
    }
    return parts_[0].name;
}

void XmlFile::resolve_includes(const std::optional<std::filesystem::path>& folder) {
    std::set<std::filesystem::path> seen;
    include_below(*parts_[0].document->RootElement(), folder, seen, 0);
}

void XmlFile::include_below(const tinyxml2::XMLElement& element, const std::optional<std::filesystem::path>& folder,
                            std::set<std::filesystem::path>& seen, int depth) {
    std::vector<const tinyxml2::XMLElement*> open{&element};
    while (!open.empty()) {
        const tinyxml2::XMLElement& here = *open.back();
        open.pop_back();
        if (is_include(here)) {
            if (!folder) XmlElement(*this, here).fail("other files cannot be read by a model that comes from memory");
            include(here, *folder, seen, depth);
            continue;
        }
        for (const auto* c = here.FirstChildElement(); c != nullptr; c = c->NextSiblingElement()) open.push_back(c);
    }
}

void XmlFile::include(const tinyxml2::XMLElement& element, const std::filesystem::path& folder,
                      std::set<std::filesystem::path>& seen, int depth) {
    const XmlText file = XmlElement(*this, element).require("file");
    const std::filesystem::path root = folder_on_disk(folder);
    const NearbyFile found = nearby_file(file.text, root, root);
    if (found.verdict == NearbyFile::Verdict::outside) {
        file.fail("must name a file in the model's folder or below it, also where links lead");
    }
    if (found.verdict != NearbyFile::Verdict::found) {
        throw Error(ErrorCode::io, file.place, "\"" + printable(file.text) + "\"", "there is no such file");
    }
    if (depth >= max_include_depth || parts_.size() > max_included_files) file.fail("must not include so many files");
    if (!seen.insert(found.path).second) file.fail("must not be included twice");
    add(read_file(found.path), found.path.lexically_relative(root).generic_string());
    const tinyxml2::XMLElement* below = parts_.back().document->RootElement();
    included_[&element] = below;
    include_below(*below, folder, seen, depth + 1);
}

std::optional<std::string> XmlFile::unused() const {
    std::map<std::string, int> elements, attributes;
    std::vector<const tinyxml2::XMLElement*> open{parts_[0].document->RootElement()};
    while (!open.empty()) {
        const tinyxml2::XMLElement& element = *open.back();
        open.pop_back();
        const std::string tag = element.Name();
        for (const tinyxml2::XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
            const bool is_name = std::string_view(a->Name()) == "name"; // every element may have a name
            if (is_name || asked_attributes_.count({tag, a->Name()}) != 0) continue;
            ++attributes[tag + " " + printable(a->Name())];
        }
        const auto look_below = [&](const tinyxml2::XMLElement& owner) {
            std::vector<const tinyxml2::XMLElement*> inside;
            for (const auto* c = owner.FirstChildElement(); c != nullptr; c = c->NextSiblingElement()) {
                const auto included = included_.find(c);
                if (included != included_.end()) {
                    for (const auto* i = included->second->FirstChildElement(); i; i = i->NextSiblingElement()) {
                        inside.push_back(i);
                    }
                } else {
                    inside.push_back(c);
                }
            }
            return inside;
        };
        for (const tinyxml2::XMLElement* c : look_below(element)) {
            const auto included = included_.find(c); // an include within an included file
            if (included != included_.end()) {
                for (const tinyxml2::XMLElement* i : look_below(*included->second)) open.push_back(i);
            } else if (asked_elements_.count({tag, c->Name()}) != 0) {
                open.push_back(c);
            } else {
                ++elements[tag + "/" + printable(c->Name())];
            }
        }
    }
    std::string line;
    std::size_t named = 0;
    const auto list = [&](const std::map<std::string, int>& names, const char* what) {
        std::string part;
        for (const auto& [name, count] : names) {
            if (++named > max_named) break;
            part += (part.empty() ? "" : ", ") + name + (count > 1 ? " (" + std::to_string(count) + ")" : "");
        }
        if (!part.empty()) line += (line.empty() ? "" : "; ") + std::string(what) + part;
    };
    list(elements, "elements ");
    list(attributes, "attributes ");
    if (line.empty()) return std::nullopt;
    if (named > max_named) line += " and more";
    return parts_[0].name + ": has no effect here: " + line;
}

std::string XmlElement::place() const {
    std::string result =
        file_->name_of(*element_) + ":" + std::to_string(element_->GetLineNum()) + ": " + printable(element_->Name());
    if (const char* name = element_->Attribute("name")) result += " \"" + printable(name) + "\"";
    return result;
}

void XmlElement::fail(const std::string& expected) const {
    throw Error(ErrorCode::invalid_file, place(), {}, expected);
}

std::optional<XmlText> XmlElement::attribute(const char* name) const {
    file_->asked_attributes_.insert({std::string(tag()), name});
    const char* value = element_->Attribute(name);
    if (value == nullptr) return std::nullopt;
    return XmlText{value, place() + ": " + name};
}

XmlText XmlElement::require(const char* name) const {
    auto found = attribute(name);
    if (!found) fail(std::string("must have the attribute ") + name);
    return *found;
}

std::string XmlElement::text_of(const char* name) const {
    const auto found = attribute(name);
    return found ? found->text : std::string();
}

XmlText XmlElement::text() const {
    const char* value = element_->GetText();
    std::string_view text = value == nullptr ? "" : value;
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) text = {};
    if (!text.empty()) text = text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
    return {std::string(text), place()};
}

std::optional<XmlText> XmlElement::child_text(const char* name) const {
    const auto found = child(name);
    if (!found) return std::nullopt;
    XmlText text = found->text();
    text.place = place() + ": " + name;
    return text;
}

std::optional<XmlElement> XmlElement::child(const char* name) const {
    const std::vector<XmlElement> found = children(name);
    if (found.empty()) return std::nullopt;
    return found.front();
}

void XmlElement::mark_read(const char* child) const { file_->asked_elements_.insert({std::string(tag()), child}); }

std::vector<XmlElement> XmlElement::children(const char* name) const {
    mark_read(name);
    std::vector<XmlElement> result;
    for (const XmlElement& each : children()) {
        if (each.tag() == name) result.push_back(each);
    }
    return result;
}

std::vector<XmlElement> XmlElement::children() const {
    std::vector<XmlElement> result;
    for (const auto* c = element_->FirstChildElement(); c != nullptr; c = c->NextSiblingElement()) {
        const auto included = file_->included_.find(c);
        if (included == file_->included_.end()) {
            result.push_back({*file_, *c});
            continue;
        }
        const std::vector<XmlElement> inside = XmlElement(*file_, *included->second).children();
        result.insert(result.end(), inside.begin(), inside.end());
    }
    return result;
}

std::vector<std::pair<std::string, XmlText>> XmlElement::attributes() const {
    std::vector<std::pair<std::string, XmlText>> result;
    for (const tinyxml2::XMLAttribute* a = element_->FirstAttribute(); a != nullptr; a = a->Next()) {
        result.push_back({a->Name(), {a->Value(), place() + ": " + printable(a->Name())}});
    }
    return result;
}

} // namespace cairn::scene
