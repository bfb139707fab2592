// Parses XML model files, with limits. Readers ask elements for their attributes and children by name; attributes and
// elements that were never asked for are listed in a warning at the end, so that nothing is ignored silently.
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

// Returns the name of the first element without parsing the file; empty if there is none.
std::string root_tag(std::span<const std::byte> bytes);

// A value of a file and its place there, for messages.
struct XmlText {
    std::string text, place;

    [[noreturn]] void fail(const std::string& expected) const; // throws Error (invalid_file)
    double number(double least = -1e30, double most = 1e30) const;
    long whole(long least, long most) const;
    // Numbers separated by spaces. Fails if there are fewer than `least` or more than `most`.
    std::vector<double> numbers(std::size_t least, std::size_t most) const;
    glm::dvec3 vector3() const;
    bool boolean() const; // true, false, 1 or 0
    // Returns the index of the text among the words.
    std::size_t choice(std::initializer_list<std::string_view> words) const;
};

// Text of a file shortened to one line, for messages.
std::string printable(std::string_view text, std::size_t most = 100);

class XmlFile;

// An element of a file; cheap to copy, and valid as long as the file.
class XmlElement {
  public:
    XmlElement(XmlFile& file, const tinyxml2::XMLElement& element) : file_(&file), element_(&element) {}

    std::string_view tag() const { return element_->Name(); }
    std::string place() const; // for messages: walker.xml:12: geom "torso"
    [[noreturn]] void fail(const std::string& expected) const;

    // `attribute` returns nothing if the attribute is absent; `require` throws.
    std::optional<XmlText> attribute(const char* name) const;
    XmlText require(const char* name) const;
    std::string text_of(const char* name) const; // text of the attribute; empty if it is absent
    // The text between the tags of the element, without spaces around it.
    XmlText text() const;
    std::optional<XmlText> child_text(const char* name) const;
    std::optional<XmlElement> child(const char* name) const;
    // The children of that name, or all; the content of included files is among them.
    std::vector<XmlElement> children(const char* name) const;
    std::vector<XmlElement> children() const;
    // Returns all attributes, without counting any of them as read.
    std::vector<std::pair<std::string, XmlText>> attributes() const;
    void mark_read(const char* child) const; // counts the child elements as read, as `children(child)` does
    const tinyxml2::XMLElement* key() const { return element_; }

  private:
    XmlFile* file_;
    const tinyxml2::XMLElement* element_;
};

class XmlFile {
  public:
    // `name` stands for the file in messages, and `kind` for its format. Throws Error (invalid_file).
    XmlFile(std::span<const std::byte> bytes, std::string name, const char* kind);
    XmlFile(const XmlFile&) = delete;
    XmlFile& operator=(const XmlFile&) = delete;

    XmlElement root();
    // Each `include` element with an attribute `file` is replaced by the content of the root element of that file,
    // which must lie in `folder` or below it; without a folder there must not be any such element.
    void resolve_includes(const std::optional<std::filesystem::path>& folder);

    // Returns a warning on one line that lists attributes and elements that were never read; nothing if all were.
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
    std::map<const tinyxml2::XMLElement*, const tinyxml2::XMLElement*> included_; // the root element of each include
    // Pairs of the name of an element and of its attribute or child.
    std::set<std::pair<std::string, std::string>> asked_attributes_, asked_elements_;
};

} // namespace cairn::scene
