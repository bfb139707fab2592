// XML files of models, taken apart with limits. Who reads them asks elements for their attributes and children by
// name; what nobody has asked for is named in a warning at the end, so that nothing is dropped in silence.
#pragma once

#include <cairn/math.h>

#include <tinyxml2.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cairn::scene {

// The name of the first element, without taking the file apart; empty if there is none.
std::string root_tag(std::span<const std::byte> bytes);

// A value of a file, and where it stands.
struct XmlText {
    std::string text, place;

    [[noreturn]] void fail(const std::string& expected) const; // throws Error (invalid_file)
    double number(double least = -1e30, double most = 1e30) const;
    long whole(long least, long most) const;
    // Of numbers between spaces. Fails if there are fewer or more.
    std::vector<double> numbers(std::size_t least, std::size_t most) const;
    glm::dvec3 vector3() const;
    bool boolean() const; // true, false, 1 or 0
    // Its place among the words.
    std::size_t choice(std::initializer_list<std::string_view> words) const;
};

// What is named in a file, on one line.
std::string printable(std::string_view text, std::size_t most = 100);

class XmlFile;

// An element of a file; light, and valid as long as the file.
class XmlElement {
  public:
    XmlElement(XmlFile& file, const tinyxml2::XMLElement& element) : file_(&file), element_(&element) {}

    std::string_view tag() const { return element_->Name(); }
    std::string place() const; // walker.xml:12: geom "torso"
    [[noreturn]] void fail(const std::string& expected) const;

    // Empty if it is not there. Throws if `require` is meant.
    std::optional<XmlText> attribute(const char* name) const;
    XmlText require(const char* name) const;
    std::string text_of(const char* name) const; // of the attribute; empty without one
    // What stands between its tags, without spaces around it.
    XmlText text() const;
    std::optional<XmlText> child_text(const char* name) const;
    std::optional<XmlElement> child(const char* name) const;
    // Those of that name, or all; what files that it includes have is among them.
    std::vector<XmlElement> children(const char* name) const;
    std::vector<XmlElement> children() const;
    // All attributes, which counts as having asked for none of them.
    std::vector<std::pair<std::string, XmlText>> attributes() const;
    void know(const char* child) const; // as `children(child)` does
    const tinyxml2::XMLElement* key() const { return element_; }

  private:
    XmlFile* file_;
    const tinyxml2::XMLElement* element_;
};

class XmlFile {
  public:
    // `name` stands for the file in messages. `kind` says what it is, for them. Throws Error (invalid_file).
    XmlFile(std::span<const std::byte> bytes, std::string name, const char* kind);
    XmlFile(const XmlFile&) = delete;
    XmlFile& operator=(const XmlFile&) = delete;

    XmlElement root();
    // Elements `include` with an attribute `file` stand for what is in the root element of that file, which must lie
    // in `folder` or below it; without a folder there must not be any.
    void resolve_includes(const std::optional<std::filesystem::path>& folder);

    // One line that names what nobody has asked for; nothing if all was.
    std::optional<std::string> unused() const;

  private:
    friend class XmlElement;
    struct Part {
        std::string name;
        std::unique_ptr<tinyxml2::XMLDocument> document;
    };
    void add(std::span<const std::byte> bytes, std::string name);
    void include(const tinyxml2::XMLElement& element, const std::filesystem::path& folder,
                 std::set<std::filesystem::path>& seen, int depth);
    void include_below(const tinyxml2::XMLElement& element, const std::optional<std::filesystem::path>& folder,
                       std::set<std::filesystem::path>& seen, int depth);
    const std::string& name_of(const tinyxml2::XMLElement& element) const;

    std::string kind_;
    std::size_t bytes_ = 0, elements_ = 0;
    std::vector<Part> parts_;
    std::map<const tinyxml2::XMLElement*, const tinyxml2::XMLElement*> included_;     // an include, and its root
    std::set<std::pair<std::string, std::string>> asked_attributes_, asked_elements_; // of elements of a name
};

} // namespace cairn::scene
