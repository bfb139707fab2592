/// \file gl_objects.h
/// RAII owners of OpenGL objects. The context that created them must be current when they are destroyed.
#pragma once

#include "viewer/meshes.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <string>
#include <utility>

namespace cairn::viewer {

/// Deletes an OpenGL object by the given function.
class GlObject {
  public:
    using Destroy = void (*)(unsigned name);
    GlObject() = default;
    GlObject(unsigned name, Destroy destroy) : name_(name), destroy_(destroy) {}
    ~GlObject() { reset(); }
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0u)), destroy_(other.destroy_) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        std::swap(destroy_, other.destroy_);
        return *this;
    }
    unsigned name() const noexcept { return name_; }
    void reset() {
        if (name_ != 0) destroy_(std::exchange(name_, 0u));
    }

  private:
    unsigned name_ = 0;
    Destroy destroy_ = nullptr;
};

GlObject make_buffer();
GlObject make_vertex_array();
GlObject make_framebuffer();
GlObject make_renderbuffer();
GlObject make_texture();

/// A compiled and linked shader program. Setting a uniform that the program does not use does nothing.
class GlProgram {
  public:
    GlProgram() = default;
    /// Prepends `header` to both sources and compiles. Throws `Error` (unsupported) with the compiler's message.
    GlProgram(const char* header, const std::string& vertex, const std::string& fragment);
    void use() const;
    void set(const char* uniform, const glm::mat4& value) const;
    void set(const char* uniform, const Vec3& value) const;
    void set(const char* uniform, const glm::vec4& value) const;
    void set(const char* uniform, const glm::vec2& value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, int value) const;
    void set(const char* uniform, int x, int y) const;

  private:
    int place_of(const char* uniform) const;
    GlObject program_;
};

/// A mesh in GPU memory, drawn as many instances by one call.
class GlMesh {
  public:
    explicit GlMesh(const TriangleMesh& mesh);
    /// Uploads the instances to draw (64 bytes each, see `Instance`).
    void upload(const void* instances, std::size_t count);
    /// Draws the instances that were uploaded last.
    void draw() const;
    /// Draws only `count` indices of the mesh, from index `first`, of all instances.
    void draw(std::size_t first, std::size_t count) const;
    /// Draws the mesh once, without instances.
    void draw_once() const;

  private:
    GlObject vertices_, indices_, colors_, instances_, array_, plain_array_;
    int index_count_ = 0;
    int instance_count_ = 0;
};

} // namespace cairn::viewer
