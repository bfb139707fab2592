// The shaders must also compile for WebGL, whose GLSL is stricter.
#include "viewer/shaders.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <string>

namespace {

using namespace cairn::viewer;

class WebShaders : public testing::Test {
  protected:
    void SetUp() override {
        if (!epoxy_has_egl() || !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
            GTEST_SKIP() << "no surfaceless EGL here";
        display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        ASSERT_TRUE(eglInitialize(display_, nullptr, nullptr));
        ASSERT_TRUE(eglBindAPI(EGL_OPENGL_ES_API));
        const EGLint config_attributes[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        ASSERT_TRUE(eglChooseConfig(display_, config_attributes, &config, 1, &count));
        if (count < 1) GTEST_SKIP() << "no OpenGL ES 3 here";
        const EGLint context_attributes[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, context_attributes);
        ASSERT_NE(context_, EGL_NO_CONTEXT);
        ASSERT_TRUE(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_));
    }
    void TearDown() override {
        if (context_ == EGL_NO_CONTEXT) return;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }

    // The compiler's error messages; empty if it compiled.
    static std::string compile(GLenum stage, const std::string& source) {
        const GLuint shader = glCreateShader(stage);
        const char* parts[] = {shaders::web_header, source.c_str()};
        glShaderSource(shader, 2, parts, nullptr);
        glCompileShader(shader);
        GLint ok = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
        char log[2048] = "";
        glGetShaderInfoLog(shader, sizeof log, nullptr, log);
        glDeleteShader(shader);
        return ok ? std::string() : std::string("failed: ") + log;
    }

  private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

TEST_F(WebShaders, VertexShadersCompile) {
    for (std::size_t kind = 0; kind < shaders::body_kind_count; ++kind) {
        const std::string constant = shaders::body_kind(shaders::BodyKind(kind));
        EXPECT_EQ(compile(GL_VERTEX_SHADER, constant + shaders::body_vertex), "");
    }
    for (const char* source : {shaders::ground_vertex, shaders::sky_vertex, shaders::line_vertex,
                               shaders::line_box_vertex, shaders::smoothing_vertex})
        EXPECT_EQ(compile(GL_VERTEX_SHADER, source), "");
}

TEST_F(WebShaders, FragmentShadersCompile) {
    for (std::size_t kind = 0; kind < shaders::body_kind_count; ++kind) {
        const std::string constant = shaders::body_kind(shaders::BodyKind(kind));
        EXPECT_EQ(compile(GL_FRAGMENT_SHADER, constant + shaders::lighting + shaders::body_fragment), "");
        EXPECT_EQ(compile(GL_FRAGMENT_SHADER, constant + shaders::shadow_fragment), "");
    }
    for (const char* source : {shaders::ground_fragment, shaders::sky_fragment})
        EXPECT_EQ(compile(GL_FRAGMENT_SHADER, std::string(shaders::lighting) + source), "");
    for (const char* source : {shaders::line_fragment, shaders::smoothing_fragment})
        EXPECT_EQ(compile(GL_FRAGMENT_SHADER, source), "");
}

TEST_F(WebShaders, MistakesAreNoticed) { EXPECT_NE(compile(GL_VERTEX_SHADER, "void main() { nonsense; }"), ""); }

} // namespace
