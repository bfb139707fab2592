// Writes API calls as a JavaScript program: the hand-written part of the recorder of scenes. The other part is
// generated from the table of the API (generated/recorded_world.h).
#pragma once

#include <cairn/cairn.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cairn {

inline std::string js(bool x) { return x ? "true" : "false"; }
inline std::string js(int x) { return std::to_string(x); }
inline std::string js(std::uint32_t x) { return std::to_string(x); }
inline std::string js(std::uint64_t x) { return std::to_string(x) + "n"; }
// 17 digits identify every double, and therefore every float.
inline std::string js(double x) {
    if (std::isnan(x)) return "NaN";
    if (std::isinf(x)) return x > 0 ? "Infinity" : "-Infinity";
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    return text;
}
inline std::string js(float x) { return js(double(x)); }
inline std::string js(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}
inline std::string js(const std::string& text) { return js(std::string_view(text)); }

inline std::string object(std::initializer_list<std::pair<const char*, std::string>> members) {
    std::string text = "{";
    for (const auto& [name, value] : members) text += (text.size() > 1 ? ", " : "") + std::string(name) + ": " + value;
    return text + "}";
}
inline std::string of_kind(const std::string& kind, const std::string& members) {
    return "{kind: '" + kind + "'" + (members == "{}" ? "" : ", ") + members.substr(1);
}

inline std::string js(const glm::vec2& v) { return object({{"x", js(v.x)}, {"y", js(v.y)}}); }
inline std::string js(const Vec3& v) { return object({{"x", js(v.x)}, {"y", js(v.y)}, {"z", js(v.z)}}); }
inline std::string js(const Position& v) { return object({{"x", js(v.x)}, {"y", js(v.y)}, {"z", js(v.z)}}); }
inline std::string js(const Quat& q) {
    return object({{"x", js(q.x)}, {"y", js(q.y)}, {"z", js(q.z)}, {"w", js(q.w)}});
}

// In the program, a handle is identified by its bits in this recording; when the program runs, its bits may differ.
template <class Tag> std::string name(Handle<Tag> handle) { return '"' + std::to_string(handle.bits) + '"'; }
template <class Tag> std::string js(Handle<Tag> handle) { return handle ? "at(" + name(handle) + ")" : "null"; }

template <class T> std::string js(const std::optional<T>& x) { return x ? js(*x) : "null"; }
template <class List> std::string list(const List& items) {
    std::string text = "[";
    for (const auto& item : items) text += (text.size() > 1 ? ", " : "") + js(item);
    return text + "]";
}
template <class T> std::string js(const std::vector<T>& items) { return list(items); }
template <class T, std::size_t N> std::string js(const std::array<T, N>& items) { return list(items); }

inline std::string numbers(std::span<const Vec3> points) {
    std::vector<float> flat;
    for (const Vec3& point : points) flat.insert(flat.end(), {point.x, point.y, point.z});
    return list(flat);
}
inline std::string js(const Hull& x) {
    return object({{"geometry", "Geometry.hull(" + numbers(x.vertices()) + ")"}, {"rounding", js(x.rounding)}});
}
inline std::string js(const Mesh& x) {
    return object({{"geometry", "Geometry.mesh(" + numbers(x.vertices()) + ", " + list(x.indices()) + ")"}});
}
inline std::string js(const HeightField& x) {
    return object({{"geometry", "Geometry.heightField(" + js(x.columns()) + ", " + js(x.rows()) + ", " +
                                    js(x.spacing()) + ", " + list(x.heights()) + ")"}});
}

// A world, and the JavaScript program that repeats all calls of this world for another one.
class Recording {
  public:
    explicit Recording(const WorldDef& def = {}) : world_(def) {}
    void step(float dt) {
        world_.step(dt);
        note("world.step(" + js(dt) + ");");
        note("yield;");
    }
    World& real() { return world_; }
    const std::string& program() const { return program_; }
    void note(const std::string& call) { program_ += "    " + call + "\n"; }

  protected:
    World world_;

  private:
    std::string program_;
};

class RecordedBodyBase {
  public:
    RecordedBodyBase(Recording& recording, BodyId id) : recording_(&recording), id_(id) {}
    BodyId id() const { return id_; }

  protected:
    Body real() const { return recording_->real().body(id_); }
    std::string body_text() const { return "world.body(" + js(id_) + ")"; }
    void note(const std::string& call) { recording_->note(call); }

  private:
    Recording* recording_;
    BodyId id_;
};

} // namespace cairn
