#include "viewer/headless.h"

#include "viewer/gl_objects.h"

#include <cairn/error.h>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <optional>
#include <string>

namespace cairn::viewer {

namespace {

constexpr int min_size = 16, greatest_size = 8192; // pixels

Error no_egl(const std::string& what) {
    return Error(ErrorCode::unsupported, "EGL", what,
                 "pictures without a window need EGL with OpenGL 3.3 (on Debian: libegl1 and libgl1-mesa-dri)");
}

} // namespace

/// An OpenGL context without a surface, current during its lifetime.
class EglContext {
  public:
    EglContext() {
        if (!epoxy_has_egl()) throw no_egl("no libEGL");
        if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
            display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        else
            display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
        if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) throw no_egl("no display");
        const EGLint config_attributes[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        const EGLint context_attributes[] = {
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display_, config_attributes, &config, 1, &count) ||
            count < 1)
            throw no_egl("no EGL configuration for OpenGL");
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, context_attributes);
        if (context_ == EGL_NO_CONTEXT) throw no_egl("no context of OpenGL 3.3");
        if (!make_current()) {
            eglDestroyContext(display_, context_);
            throw no_egl("a context needs a surface");
        }
    }
    bool make_current() { return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE; }
    ~EglContext() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

  private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

struct HeadlessRenderer::Impl {
    int width, height;
    EglContext context; // must precede the members that need it
    GlRenderer renderer;
    GlObject color, framebuffer;
    std::vector<std::uint8_t> pixels, bottom_up;

    Impl(int width_, int height_)
        : width(width_), height(height_), color(make_renderbuffer()), framebuffer(make_framebuffer()) {
        glBindRenderbuffer(GL_RENDERBUFFER, color.name());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color.name());
        pixels.resize(3u * std::size_t(width) * std::size_t(height));
        bottom_up.resize(pixels.size());
    }
};

std::string opengl_renderer() {
    const EglContext context;
    const auto text_of = [](GLenum name) {
        const GLubyte* text = glGetString(name);
        return text ? std::string(reinterpret_cast<const char*>(text)) : std::string("unnamed");
    };
    return text_of(GL_RENDERER) + ", OpenGL " + text_of(GL_VERSION);
}

HeadlessRenderer::HeadlessRenderer(int width, int height) {
    for (const auto& [name, size] : {std::pair<const char*, int>{"width", width}, {"height", height}})
        if (size < min_size || size > greatest_size)
            throw Error(ErrorCode::invalid_value, std::string("HeadlessRenderer.") + name, std::to_string(size),
                        "must be 16 to 8192 pixels");
    impl_ = std::make_unique<Impl>(width, height);
}

HeadlessRenderer::~HeadlessRenderer() {
    if (impl_) impl_->context.make_current(); // the members are deleted in this context
}

int HeadlessRenderer::width() const noexcept { return impl_->width; }

int HeadlessRenderer::height() const noexcept { return impl_->height; }

void HeadlessRenderer::draw(const RenderFrame& frame, Smoothing smoothing, float scale) {
    Impl& impl = *impl_;
    impl.context.make_current(); // there may be several renderers
    impl.renderer.draw(frame, {impl.framebuffer.name(), 0, 0, impl.width, impl.height}, smoothing, scale);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, impl.width, impl.height, GL_RGB, GL_UNSIGNED_BYTE, impl.bottom_up.data());
    const std::size_t row = 3u * std::size_t(impl.width);
    for (std::size_t y = 0; y < std::size_t(impl.height); ++y)
        std::copy_n(impl.bottom_up.begin() + std::ptrdiff_t(y * row), row,
                    impl.pixels.end() - std::ptrdiff_t((y + 1) * row));
}

const std::vector<std::uint8_t>& HeadlessRenderer::pixels() const noexcept { return impl_->pixels; }

void HeadlessRenderer::save_picture(const std::filesystem::path& path) const {
    write_picture(path, impl_->width, impl_->height, impl_->pixels);
}

} // namespace cairn::viewer
