// RAII owners of the libraries that a window needs: GLFW, OpenGL and Dear ImGui.
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
// Opens a window with a current OpenGL 3.3 context. Throws Error (unsupported) without OpenGL 3.3.
WindowHandle open_window(int width, int height);

class ImguiLibrary {
  public:
    ImguiLibrary(GLFWwindow* window, std::string layout);
    ~ImguiLibrary();
    ImguiLibrary(const ImguiLibrary&) = delete;
    ImguiLibrary& operator=(const ImguiLibrary&) = delete;

  private:
    std::string layout_; // file name, which ImGui does not copy
};

} // namespace cairn::viewer
