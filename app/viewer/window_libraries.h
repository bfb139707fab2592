// What a window stands on: GLFW, OpenGL and Dear ImGui, as long as they are needed.
#pragma once

#include <memory>
#include <string>

struct GLFWwindow;

namespace cairn::viewer {

class GlfwLibrary {
  public:
    GlfwLibrary(); // throws Error (unsupported) without a display
    ~GlfwLibrary();
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

struct WindowCloser {
    void operator()(GLFWwindow* window) const;
};
using WindowHandle = std::unique_ptr<GLFWwindow, WindowCloser>;
// With OpenGL 3.3, which is current then. Throws Error (unsupported) without.
WindowHandle open_window(int width, int height);

class ImguiLibrary {
  public:
    ImguiLibrary(GLFWwindow* window, std::string layout);
    ~ImguiLibrary();
    ImguiLibrary(const ImguiLibrary&) = delete;
    ImguiLibrary& operator=(const ImguiLibrary&) = delete;

  private:
    std::string layout_; // its file, whose name is not copied
};

} // namespace cairn::viewer
