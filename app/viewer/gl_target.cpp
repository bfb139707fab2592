#include "viewer/gl_target.h"

#include "viewer/shaders.h"

#include <cairn/error.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

namespace cairn::viewer {

namespace {

constexpr int wanted_samples = 4; // per pixel
constexpr int edge_reach = 8;     // pixels; search distance for the end of an edge, in each direction

} // namespace

GlTarget::GlTarget()
    : program_(shaders::desktop_header, shaders::smoothing_vertex, shaders::smoothing_fragment),
      square_(rectangle_mesh()) {}

void GlTarget::resize(int width, int height, Smoothing smoothing) {
    if (width == width_ && height == height_ && smoothing == smoothing_) return;
    GLint max_samples = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
    const GLsizei samples = smoothing == Smoothing::samples ? std::min<GLint>(wanted_samples, max_samples) : 0;
    framebuffer_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    if (smoothing == Smoothing::samples) {
        color_ = make_renderbuffer();
        glBindRenderbuffer(GL_RENDERBUFFER, color_.name());
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.name());
    } else {
        color_ = make_texture();
        glBindTexture(GL_TEXTURE_2D, color_.name());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
    }
    depth_ = make_renderbuffer();
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorCode::unsupported, "picture size", std::to_string(width) + "x" + std::to_string(height),
                    "must be supported by this graphics driver");
    width_ = width;
    height_ = height;
    smoothing_ = smoothing;
}

void GlTarget::begin(int width, int height, Smoothing smoothing) {
    resize(width, height, smoothing);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, width, height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void GlTarget::finish(const PicturePlace& place) {
    const bool is_stretched = width_ != place.width || height_ != place.height;
    if (smoothing_ == Smoothing::samples || is_stretched) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, place.framebuffer);
        glBlitFramebuffer(0, 0, width_, height_, place.left, place.bottom, place.left + place.width,
                          place.bottom + place.height, GL_COLOR_BUFFER_BIT, is_stretched ? GL_LINEAR : GL_NEAREST);
        glBindFramebuffer(GL_FRAMEBUFFER, place.framebuffer);
        return;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, place.framebuffer);
    glViewport(place.left, place.bottom, width_, height_);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, color_.name());
    program_.use();
    program_.set("u_picture", 0);
    program_.set("u_corner", place.left, place.bottom);
    program_.set("u_reach", edge_reach);
    square_.draw_once();
}

} // namespace cairn::viewer
