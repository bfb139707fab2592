#include "viewer/gl_objects.h"

#include "viewer/render_frame.h"

#include <cairn/error.h>

#include <epoxy/gl.h>

#include <cstddef>

namespace cairn::viewer {

namespace {

template <class Make> unsigned generate(Make make) {
    GLuint name = 0;
    make(1, &name);
    return name;
}

GlObject compile(unsigned stage, const char* header, const std::string& source) {
    GlObject shader(glCreateShader(stage), [](unsigned name) { glDeleteShader(name); });
    const char* parts[] = {header, source.c_str()};
    glShaderSource(shader.name(), 2, parts, nullptr);
    glCompileShader(shader.name());
    GLint ok = 0;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &ok);
    if (!ok) {
        char log[1024] = "";
        glGetShaderInfoLog(shader.name(), sizeof log, nullptr, log);
        throw Error(ErrorCode::unsupported, "shader", log, "must compile on this graphics driver");
    }
    return shader;
}

void attribute(unsigned location, int components, std::size_t stride, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, GLsizei(stride),
                          // An offset into the buffer, passed as a pointer by OpenGL's convention.
                          reinterpret_cast<const void*>(offset));
}

void mesh_attributes(const GlObject& array, const GlObject& vertices, const GlObject& indices) {
    glBindVertexArray(array.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
    attribute(0, 3, sizeof(MeshVertex), offsetof(MeshVertex, corner));
    attribute(1, 3, sizeof(MeshVertex), offsetof(MeshVertex, inset));
    attribute(2, 3, sizeof(MeshVertex), offsetof(MeshVertex, normal));
}

} // namespace

GlObject make_buffer() {
    return {generate([](GLsizei n, GLuint* out) { glGenBuffers(n, out); }),
            [](unsigned name) { glDeleteBuffers(1, &name); }};
}

GlObject make_vertex_array() {
    return {generate([](GLsizei n, GLuint* out) { glGenVertexArrays(n, out); }),
            [](unsigned name) { glDeleteVertexArrays(1, &name); }};
}

GlObject make_framebuffer() {
    return {generate([](GLsizei n, GLuint* out) { glGenFramebuffers(n, out); }),
            [](unsigned name) { glDeleteFramebuffers(1, &name); }};
}

GlObject make_renderbuffer() {
    return {generate([](GLsizei n, GLuint* out) { glGenRenderbuffers(n, out); }),
            [](unsigned name) { glDeleteRenderbuffers(1, &name); }};
}

GlObject make_texture() {
    return {generate([](GLsizei n, GLuint* out) { glGenTextures(n, out); }),
            [](unsigned name) { glDeleteTextures(1, &name); }};
}

GlProgram::GlProgram(const char* header, const std::string& vertex, const std::string& fragment) {
    const GlObject vertex_shader = compile(GL_VERTEX_SHADER, header, vertex);
    const GlObject fragment_shader = compile(GL_FRAGMENT_SHADER, header, fragment);
    program_ = GlObject(glCreateProgram(), [](unsigned name) { glDeleteProgram(name); });
    glAttachShader(program_.name(), vertex_shader.name());
    glAttachShader(program_.name(), fragment_shader.name());
    glLinkProgram(program_.name());
    GLint ok = 0;
    glGetProgramiv(program_.name(), GL_LINK_STATUS, &ok);
    if (!ok) {
        char log[1024] = "";
        glGetProgramInfoLog(program_.name(), sizeof log, nullptr, log);
        throw Error(ErrorCode::unsupported, "shader program", log, "must link on this graphics driver");
    }
}

void GlProgram::use() const { glUseProgram(program_.name()); }

int GlProgram::place_of(const char* uniform) const { return glGetUniformLocation(program_.name(), uniform); }

void GlProgram::set(const char* uniform, const glm::mat4& value) const {
    glUniformMatrix4fv(place_of(uniform), 1, GL_FALSE, &value[0][0]);
}

void GlProgram::set(const char* uniform, const Vec3& value) const {
    glUniform3f(place_of(uniform), value.x, value.y, value.z);
}

void GlProgram::set(const char* uniform, const glm::vec4& value) const {
    glUniform4f(place_of(uniform), value.x, value.y, value.z, value.w);
}

void GlProgram::set(const char* uniform, const glm::vec2& value) const {
    glUniform2f(place_of(uniform), value.x, value.y);
}

void GlProgram::set(const char* uniform, float value) const { glUniform1f(place_of(uniform), value); }

void GlProgram::set(const char* uniform, int value) const { glUniform1i(place_of(uniform), value); }

void GlProgram::set(const char* uniform, int x, int y) const { glUniform2i(place_of(uniform), x, y); }

GlMesh::GlMesh(const TriangleMesh& mesh)
    : vertices_(make_buffer()), indices_(make_buffer()), instances_(make_buffer()), array_(make_vertex_array()),
      plain_array_(make_vertex_array()), index_count_(int(mesh.indices.size())) {
    mesh_attributes(plain_array_, vertices_, indices_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof(MeshVertex)), mesh.vertices.data(),
                 GL_STATIC_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(std::uint32_t)), mesh.indices.data(),
                 GL_STATIC_DRAW);
    mesh_attributes(array_, vertices_, indices_);
    constexpr unsigned tint = 7;
    if (mesh.colors.empty()) {
        glVertexAttrib3f(tint, 1.0f, 1.0f, 1.0f); // white, for all meshes without vertex colors
    } else {
        colors_ = make_buffer();
        glBindBuffer(GL_ARRAY_BUFFER, colors_.name());
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.colors.size() * sizeof(Vec3)), mesh.colors.data(),
                     GL_STATIC_DRAW);
        attribute(tint, 3, sizeof(Vec3), 0);
    }
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    for (unsigned i = 0; i < 4; ++i) {
        attribute(3 + i, 4, sizeof(Instance), 16u * i);
        glVertexAttribDivisor(3 + i, 1);
    }
    glBindVertexArray(0);
}

void GlMesh::upload(const void* instances, std::size_t count) {
    instance_count_ = int(count);
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(count * sizeof(Instance)), instances, GL_STREAM_DRAW);
}

void GlMesh::draw() const { draw(0, std::size_t(index_count_)); }

void GlMesh::draw(std::size_t first, std::size_t count) const {
    if (instance_count_ == 0) return;
    glBindVertexArray(array_.name());
    // Passed as a pointer by OpenGL's convention.
    const void* offset = reinterpret_cast<const void*>(first * sizeof(std::uint32_t));
    glDrawElementsInstanced(GL_TRIANGLES, GLsizei(count), GL_UNSIGNED_INT, offset, instance_count_);
}

void GlMesh::draw_once() const {
    glBindVertexArray(plain_array_.name());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

} // namespace cairn::viewer
