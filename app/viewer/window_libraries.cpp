#include "viewer/window_libraries.h"

#include "viewer/window_places.h"

#include <cairn/error.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <utility>

namespace cairn::viewer {

namespace {

// The text of GLFW's last error, which GLFW passes to a callback.
std::string& last_error() {
    static std::string text;
    return text;
}

} // namespace

GlfwLibrary::GlfwLibrary() {
    glfwSetErrorCallback([](int, const char* text) { last_error() = text; });
    if (!glfwInit())
        throw Error(ErrorCode::unsupported, "window", last_error(), "the viewer needs a display (set DISPLAY)");
}
GlfwLibrary::~GlfwLibrary() { glfwTerminate(); }

void WindowCloser::operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }

WindowHandle open_window(int width, int height) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_SAMPLES, 0); // the renderer does its own multisampling
    WindowHandle window(glfwCreateWindow(width, height, "Cairn", nullptr, nullptr));
    if (!window) throw Error(ErrorCode::unsupported, "window", last_error(), "the viewer needs OpenGL 3.3");
    glfwMakeContextCurrent(window.get());
    glfwSwapInterval(1);
    return window;
}

ImguiLibrary::ImguiLibrary(GLFWwindow* window, std::string layout) : layout_(std::move(layout)) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = layout_.empty() ? nullptr : layout_.c_str();
    remember_picture_size();
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}
ImguiLibrary::~ImguiLibrary() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

} // namespace cairn::viewer
