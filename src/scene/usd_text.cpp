#include "scene/usd_text.h"

#include "scene/decimal.h"

#include <cairn/error.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cairn::scene {

namespace {

constexpr std::size_t max_layer_bytes = std::size_t{64} << 20, max_prims = 200000,
                      max_layer_numbers = std::size_t{1} << 25;
constexpr int max_depth = 64; // nesting of prims, and of brackets in values

std::string_view layer_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == ':' ||
           c == '.' || c == '-' || c == '+' || static_cast<unsigned char>(c) >= 0x80;
}

class LayerReader {
  public:
    LayerReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    UsdLayer read() {
        UsdLayer layer;
        layer_ = &layer;
        skip_spaces(); // also skips the first line, which is a comment
        if (peek() == '(') metadata(layer.metadata, nullptr);
        while (!at_end()) prim(layer.prims, "", 0);
        return layer;
    }

  private:
    [[noreturn]] void fail(const std::string& expected, std::string_view found = {}) const {
        std::string shown;
        for (const char c : found.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
        throw Error(ErrorCode::invalid_file, name_ + ":" + std::to_string(line_),
                    shown.empty() ? shown : "\"" + shown + "\"", expected);
    }

    void advance(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) line_ += text_[at_ + i] == '\n';
        at_ += count;
    }
    void skip_spaces() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '#' || text_.substr(at_, 2) == "//") {
                advance(std::min(text_.find('\n', at_), text_.size()) - at_);
            } else if (text_.substr(at_, 2) == "/*") {
                advance(std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2 - at_);
            } else if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
                advance(1);
            } else {
                return;
            }
        }
    }
    bool at_end() {
        skip_spaces();
        return at_ >= text_.size();
    }
    char peek() {
        skip_spaces();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char c) {
        if (peek() != c) return false;
        advance(1);
        return true;
    }
    void require(char c) {
        if (!take(c)) fail(std::string("must have ") + c + " here", text_.substr(at_, 20));
    }
    // Returns a run of letters, digits and the punctuation of names and numbers; empty if there is none.
    std::string_view word() {
        skip_spaces();
        std::size_t end = at_;
        while (end < text_.size() && is_word(text_[end])) ++end;
        const std::string_view result = text_.substr(at_, end - at_);
        at_ = end;
        return result;
    }
    std::string_view peek_word() {
        skip_spaces();
        std::size_t end = at_;
        while (end < text_.size() && is_word(text_[end])) ++end;
        return text_.substr(at_, end - at_);
    }

    // Reads "text", 'text', """text""", @asset@ or <path>. Escapes are kept as written; an escaped quote does not end
    // the text.
    std::string quoted() {
        const char mark = peek();
        const bool is_path = mark == '<';
        std::string_view closing = is_path ? std::string_view(">") : text_.substr(at_, 1);
        const std::string_view triple = text_.substr(at_, 3);
        if (!is_path && triple.size() == 3 && triple[1] == mark && triple[2] == mark) closing = triple;
        std::size_t end = at_ + closing.size();
        for (;; ++end) {
            if (end >= text_.size()) fail("must close the quotation here", text_.substr(at_, 20));
            if (text_[end] == '\\' && (mark == '"' || mark == '\'')) {
                ++end;
            } else if (text_.substr(end, closing.size()) == closing) {
                break;
            }
        }
        std::string result(text_.substr(at_ + closing.size(), end - at_ - closing.size()));
        advance(end + closing.size() - at_);
        return result;
    }
    static bool opens_quote(char c) { return c == '"' || c == '\'' || c == '@' || c == '<'; }

    void number(UsdValue& value, std::string_view text) {
        std::optional<double> parsed = parse_decimal(text);
        if (text == "inf" || text == "+inf") parsed = std::numeric_limits<double>::infinity();
        if (text == "-inf") parsed = -std::numeric_limits<double>::infinity();
        if (!parsed) fail("must be a value", text);
        if (++numbers_ > max_layer_numbers) fail("must not have more numbers");
        value.numbers.push_back(*parsed);
    }

    void value(UsdValue& into, int depth) {
        if (depth > max_depth) fail("must have at most 64 brackets inside each other");
        const char c = peek();
        if (opens_quote(c)) {
            into.words.push_back(quoted());
            if (peek() == '<') quoted();                 // prim path of an asset reference
            if (peek() == '(') skip_brackets(depth + 1); // time offset of a layer
            return;
        }
        if (c == '(' || c == '[') {
            const char closing = c == '(' ? ')' : ']';
            advance(1);
            while (!take(closing)) {
                value(into, depth + 1);
                take(',');
            }
            return;
        }
        if (c == '{') return skip_brackets(depth + 1); // dictionaries and time samples are not used
        const std::string_view text = word();
        if (text.empty()) fail("must have a value here", text_.substr(at_, 20));
        if (text == "None") return;
        if (text == "true" || text == "false") {
            into.numbers.push_back(text == "true" ? 1.0 : 0.0);
        } else if (text == "nan") {
            fail("must be a number", text);
        } else {
            number(into, text);
        }
    }

    // Skips everything up to the matching closing bracket.
    void skip_brackets(int depth) {
        if (depth > max_depth) fail("must have at most 64 brackets inside each other");
        const char opening = peek();
        const char closing = opening == '(' ? ')' : opening == '[' ? ']' : '}';
        advance(1);
        while (!take(closing)) {
            const char c = peek();
            if (c == '\0') fail(std::string("must have ") + closing + " before it ends");
            if (opens_quote(c)) {
                quoted();
            } else if (c == '(' || c == '[' || c == '{') {
                skip_brackets(depth + 1);
            } else {
                advance(1);
            }
        }
    }

    void leave_out(std::string_view what) { ++layer_->left_out[std::string(what)]; }

    // Reads the metadata in parentheses after a prim, a property or the first line.
    void metadata(std::map<std::string, UsdValue>& into, std::vector<std::string>* schemas) {
        require('(');
        while (!take(')')) {
            if (peek() == '\0') fail("must have ) before it ends");
            if (opens_quote(peek())) {
                quoted(); // a comment
            } else {
                std::string_view key = word();
                for (const char* way : {"prepend", "append", "add", "delete", "reorder"}) {
                    if (key != way) continue;
                    key = word();
                    break;
                }
                if (key.empty()) fail("must have a name here", text_.substr(at_, 20));
                require('=');
                UsdValue read;
                read.line = line_;
                value(read, 0);
                if (key == "references" || key == "payload" || key == "inherits" || key == "specializes" ||
                    key == "subLayers") {
                    if (!read.words.empty()) leave_out(key);
                } else if (key == "apiSchemas" && schemas != nullptr) {
                    schemas->insert(schemas->end(), read.words.begin(), read.words.end());
                }
                into[std::string(key)] = std::move(read);
            }
            if (!take(',')) take(';');
        }
    }

    void prim(std::vector<UsdPrim>& into, const std::string& path, int depth) {
        if (depth > max_depth) fail("must have at most 64 prims inside each other");
        if (++prims_ > max_prims) fail("must not have more prims");
        UsdPrim made;
        made.kind = std::string(word());
        if (made.kind != "def" && made.kind != "over" && made.kind != "class")
            fail("must be def, over or class", made.kind);
        if (peek() != '"' && peek() != '\'') made.type = std::string(word());
        if (peek() != '"' && peek() != '\'') fail("must have the name of a prim", text_.substr(at_, 20));
        made.line = line_;
        made.name = quoted();
        made.path = path + "/" + made.name;
        std::map<std::string, UsdValue> said;
        if (peek() == '(') metadata(said, &made.schemas);
        const auto active = said.find("active");
        made.is_active = active == said.end() || active->second.numbers != std::vector<double>{0.0};
        require('{');
        while (!take('}')) {
            if (peek() == '\0') fail("must have } before it ends");
            const std::string_view next = peek_word();
            if (next == "def" || next == "over" || next == "class") {
                prim(made.children, made.path, depth + 1);
            } else if (next == "variantSet") {
                word(), quoted(), require('=');
                skip_brackets(0);
                leave_out("variantSet");
            } else {
                property(made);
            }
            take(';');
        }
        into.push_back(std::move(made));
    }

    void property(UsdPrim& prim) {
        std::string_view type = word(), name;
        bool is_edit = false;
        while (type == "custom" || type == "uniform" || type == "varying" || type == "config" || type == "prepend" ||
               type == "append" || type == "add" || type == "delete" || type == "reorder") {
            is_edit = is_edit || type == "delete" || type == "reorder";
            type = word();
        }
        if (type.empty()) fail("must have a property here", text_.substr(at_, 20));
        if (take('[')) require(']'); // an array type
        name = word();
        if (name.empty()) fail("must have the name of a property", text_.substr(at_, 20));
        UsdValue read;
        read.line = line_;
        bool has_value = false;
        if (take('=')) {
            value(read, 0);
            has_value = true;
        }
        std::map<std::string, UsdValue> unused;
        if (peek() == '(') metadata(unused, nullptr);
        const std::size_t dot = name.find('.');
        const bool is_of_shader = name.substr(0, 7) == "inputs:" || name.substr(0, 8) == "outputs:";
        if (dot != std::string_view::npos && is_of_shader && name.substr(dot) == ".connect" && has_value && !is_edit) {
            prim.properties[std::string(name)] = std::move(read);
        } else if (dot != std::string_view::npos) { // .timeSamples and the like
            leave_out(name.substr(dot + 1));
        } else if (has_value && !is_edit) {
            prim.properties[std::string(name)] = std::move(read);
        }
    }

    std::string_view text_;
    const std::string& name_;
    UsdLayer* layer_ = nullptr;
    std::size_t at_ = 0, prims_ = 0, numbers_ = 0;
    int line_ = 1;
};

} // namespace

UsdKind usd_kind(std::span<const std::byte> bytes) {
    const std::string_view text = layer_text(bytes);
    if (text.substr(0, 5) == "#usda") return UsdKind::text;
    if (text.substr(0, 8) == "PXR-USDC") return UsdKind::binary;
    if (text.substr(0, 4) == "PK\x03\x04") return UsdKind::package;
    return UsdKind::none;
}

UsdLayer parse_usd(std::span<const std::byte> bytes, const std::string& name) {
    if (bytes.size() > max_layer_bytes) {
        throw Error(ErrorCode::invalid_file, name, std::to_string(bytes.size()) + " bytes",
                    "must be a layer of USD of at most " + std::to_string(max_layer_bytes) + " bytes");
    }
    if (layer_text(bytes).find('\0') != std::string_view::npos) {
        throw Error(ErrorCode::invalid_file, name, {}, "must be text, without zero bytes");
    }
    return LayerReader(layer_text(bytes), name).read();
}

} // namespace cairn::scene
