#include "viewer/window.h"

#include "viewer/draw_scale.h"
#include "viewer/glfw_keys.h"
#include "viewer/headless.h"
#include "viewer/new_files.h"
#include "viewer/pages.h"
#include "viewer/panel.h"
#include "viewer/physics_thread.h"
#include "viewer/picture_area.h"
#include "viewer/report.h"
#include "viewer/screen_pixels.h"
#include "viewer/screen_video.h"
#include "viewer/script.h"
#include "viewer/window_libraries.h"
#include "viewer/window_places.h"

#include "files/output_file.h"

#include <cairn/error.h>

#include <epoxy/gl.h>
// Keeps GLFW from including OpenGL headers of its own.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

namespace cairn::viewer {

namespace {

constexpr double notice_seconds = 5.0;
constexpr double rate_window = 0.5;      // s; period of the frame rate measurement
constexpr double minimized_pause = 0.05; // s between checks of a minimized window
constexpr float font_size = 15.0f;       // units, in a window of 1280 x 720 units at scale 1

class Application {
  public:
    explicit Application(const ViewerOptions& options);
    void run();

  private:
    using Clock = std::chrono::steady_clock;
    void install_callbacks();
    void on_key(int key, int action, int modifiers);
    void on_button(int button, int action);
    void on_cursor(double x, double y);
    void use_gamepad(float seconds);
    void on_wheel(double notches);
    void press(MouseButton button);
    void release(MouseButton button);
    void set_modifiers(int modifiers);
    void play_script(double seconds);
    void play(const ScriptLine& line);
    void show_script_mouse() const;
    void fit_interface();
    void rebuild_fonts();
    void save_picture(const std::filesystem::path& path);
    void write_screen(const std::filesystem::path& path);
    void save_what_was_asked_for();
    void update_notice(const StageState& state);
    void say(const std::string& text);
    void count_frame(double seconds);
    void write_report(const std::filesystem::path& path);
    void place_picture(const StageState& state);

    const ViewerOptions& options_;
    GlfwLibrary glfw_;
    WindowHandle window_;
    ImguiLibrary imgui_;
    PictureArea area_;
    Gamepad gamepad_;
    PhysicsThread physics_;
    Controller controller_;
    Panel panel_;
    ScriptPlayer script_;
    struct {
        bool is_used = false; // replaces the mouse from its first use until the real mouse moves
        float x = 0.0f, y = 0.0f;
        std::array<bool, 3> down{}; // indexed by ImGui's button number
    } script_mouse_;
    WindowFacts facts_;
    std::filesystem::path window_picture_;   // path for a picture of this frame
    int frame_width_ = 0, frame_height_ = 0; // of the whole window, pixels
    std::size_t cursor_pane_ = 0;
    float font_pixels_ = 0.0f, pixels_per_unit_ = 1.0f; // for which the fonts were built
    float interface_scale_ = 1.0f;
    bool light_theme_ = false; // for which the style was set
    ScreenVideo video_;
    DrawScale draw_scale_;
    bool is_software_ = area_.is_software();
    std::uint64_t seen_message_ = 0;
    double notice_left_ = 0.0;
    double rate_seconds_ = 0.0;
    int rate_frames_ = 0;
};

Application::Application(const ViewerOptions& options)
    : options_(options), window_(open_window(options.width, options.height)),
      imgui_((install_callbacks(), window_.get()), options.layout.string()),
      physics_(options.loader, options.scene, options.savers),
      controller_([this](Command command) { physics_.post(std::move(command)); }, options.scenes, options.file_types) {
    controller_.svg_of_chart = options.svg_of_chart;
    if (!options.script.empty()) script_ = ScriptPlayer(load_script(options.script));
}

// Must be called before ImGui installs its own callbacks, which chain to these.
void Application::install_callbacks() {
    GLFWwindow* window = window_.get();
    glfwSetWindowUserPointer(window, this);
    const auto self = [](GLFWwindow* w) { return static_cast<Application*>(glfwGetWindowUserPointer(w)); };
    static const auto application = self;
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
        application(w)->on_key(key, action, modifiers);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
        application(w)->set_modifiers(modifiers);
        application(w)->on_button(button, action);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        application(w)->script_mouse_.is_used = false;
        application(w)->on_cursor(x, y);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double notches) { application(w)->on_wheel(notches); });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        const std::vector<std::string> dropped(paths, paths + count);
        application(w)->controller_.drop_files(dropped);
    });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
        if (!focused) application(w)->controller_.release_all();
    });
}

void Application::on_key(int key, int action, int modifiers) {
    // GLFW reports the modifiers before the event, so the press or release of a modifier key itself is added here.
    const bool down = action != GLFW_RELEASE;
    if (key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT)
        modifiers = down ? modifiers | GLFW_MOD_SHIFT : modifiers & ~GLFW_MOD_SHIFT;
    if (key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL)
        modifiers = down ? modifiers | GLFW_MOD_CONTROL : modifiers & ~GLFW_MOD_CONTROL;
    set_modifiers(modifiers);
    const std::string name = glfw_key_name(key);
    if (name.empty()) return;
    if (!down)
        controller_.key_up(name);
    else if (!ImGui::GetIO().WantTextInput)
        controller_.key_down(glfw_modifier_names(modifiers), name, action == GLFW_REPEAT);
}

void Application::set_modifiers(int modifiers) {
    controller_.set_constraint(modifiers & GLFW_MOD_SHIFT     ? DragConstraint::vertical
                               : modifiers & GLFW_MOD_CONTROL ? DragConstraint::ground
                                                              : DragConstraint::view_plane);
}

void Application::on_button(int button, int action) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    const MouseButton which = button == GLFW_MOUSE_BUTTON_LEFT    ? MouseButton::left
                              : button == GLFW_MOUSE_BUTTON_RIGHT ? MouseButton::right
                                                                  : MouseButton::middle;
    if (action == GLFW_RELEASE)
        release(which);
    else if (!ImGui::GetIO().WantCaptureMouse)
        press(which);
}

void Application::press(MouseButton button) {
    area_.hold(cursor_pane_);
    controller_.button_down(button);
}

void Application::release(MouseButton button) {
    controller_.button_up(button);
    area_.let_go();
}

// Only the focused window uses the gamepad.
void Application::use_gamepad(float seconds) {
    const PaneRect& pane = area_.pane(cursor_pane_);
    const bool is_ours = glfwGetWindowAttrib(window_.get(), GLFW_FOCUSED) == GLFW_TRUE && pane.height > 0.0f;
    gamepad_.update(is_ours ? glfw_gamepad() : std::nullopt, seconds, is_ours ? pane.width / pane.height : 1.0f,
                    controller_);
}

void Application::on_cursor(double x, double y) {
    cursor_pane_ = area_.pane_under(float(x), float(y));
    const PaneRect& pane = area_.pane(cursor_pane_);
    if (pane.width <= 0.0f || pane.height <= 0.0f) return;
    controller_.is_in_first_pane = cursor_pane_ == 0;
    controller_.move_cursor({2.0 * (x - double(pane.left)) / double(pane.width) - 1.0,
                             1.0 - 2.0 * (y - double(pane.top)) / double(pane.height)},
                            pane.width / pane.height);
}

void Application::on_wheel(double notches) {
    if (!ImGui::GetIO().WantCaptureMouse) controller_.wheel(float(notches));
}

void Application::play_script(double seconds) {
    while (const ScriptLine* line = script_.next(std::exchange(seconds, 0.0))) {
        play(*line);
        if (!window_picture_.empty()) break; // taken at the end of the frame, before the following script lines
        // Panels process the mouse once per frame, and only then report whether they capture it.
        using Kind = ScriptLine::Kind;
        if (line->kind == Kind::cursor || line->kind == Kind::press || line->kind == Kind::release) break;
    }
}

void Application::play(const ScriptLine& line) {
    const std::size_t plus = line.word.size() > 1 ? line.word.rfind('+') : std::string::npos;
    const std::size_t name = plus == std::string::npos ? 0 : plus + 1;
    const std::string modifiers = line.word.substr(0, name), key = line.word.substr(name);
    const MouseButton button = key == "left"    ? MouseButton::left
                               : key == "right" ? MouseButton::right
                                                : MouseButton::middle;
    const std::size_t number = key == "left"    ? ImGuiMouseButton_Left
                               : key == "right" ? ImGuiMouseButton_Right
                                                : ImGuiMouseButton_Middle;
    const bool is_over_panel = script_mouse_.is_used && ImGui::GetIO().WantCaptureMouse;
    switch (line.kind) {
    case ScriptLine::Kind::wait:
        break;
    case ScriptLine::Kind::key:
        controller_.key_down(modifiers, key);
        controller_.key_up(key);
        break;
    case ScriptLine::Kind::down:
        controller_.key_down(modifiers, key);
        break;
    case ScriptLine::Kind::up:
        controller_.key_up(key);
        break;
    case ScriptLine::Kind::cursor:
        on_cursor(line.x, line.y);
        script_mouse_.is_used = true;
        script_mouse_.x = float(line.x), script_mouse_.y = float(line.y);
        break;
    case ScriptLine::Kind::press:
        set_modifiers((modifiers.find("Shift+") != std::string::npos ? GLFW_MOD_SHIFT : 0) |
                      (modifiers.find("Ctrl+") != std::string::npos ? GLFW_MOD_CONTROL : 0));
        script_mouse_.down[number] = true;
        if (!is_over_panel) press(button);
        break;
    case ScriptLine::Kind::release:
        script_mouse_.down[number] = false;
        release(button);
        set_modifiers(0);
        break;
    case ScriptLine::Kind::wheel:
        if (is_over_panel)
            ImGui::GetIO().MouseWheel += float(line.x);
        else
            controller_.wheel(float(line.x));
        break;
    case ScriptLine::Kind::drop:
        controller_.drop_files(std::array{line.word});
        break;
    case ScriptLine::Kind::report:
        write_report(line.word);
        break;
    case ScriptLine::Kind::picture:
        save_picture(line.word);
        break;
    case ScriptLine::Kind::window:
        window_picture_ = line.word;
        break;
    case ScriptLine::Kind::quit:
        controller_.quit = true;
        break;
    }
}

// Overrides the real mouse in ImGui's input, after the backend has set it.
void Application::show_script_mouse() const {
    if (!script_mouse_.is_used) return;
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {script_mouse_.x, script_mouse_.y};
    for (std::size_t i = 0; i < script_mouse_.down.size(); ++i) io.MouseDown[i] |= script_mouse_.down[i];
}

// Scales the interface in proportion to the window, for any pixel density, within the limits of legibility.
void Application::fit_interface() {
    int width = 0, height = 0;
    float scale = 1.0f, scale_y = 1.0f;
    glfwGetWindowContentScale(window_.get(), &scale, &scale_y);
    glfwGetWindowSize(window_.get(), &width, &height);
    glfwGetFramebufferSize(window_.get(), &frame_width_, &frame_height_);
    if (width <= 0 || height <= 0) return; // minimized
    // Systems that measure windows in points have several pixels per point; fonts are built for pixels, to be sharp.
    const float pixels_per_unit = std::max(float(frame_width_) / float(width), 1.0f);
    const float density = scale / pixels_per_unit; // window units per unscaled unit
    const float share = interface_share(float(width) / density, float(height) / density);
    const float pixels = std::round(font_size * scale * share);
    interface_scale_ = pixels / (font_size * pixels_per_unit);
    if (light_theme_ != controller_.light_theme) {
        light_theme_ = controller_.light_theme;
        apply_style(interface_scale_, light_theme_);
    }
    if (pixels == font_pixels_ && pixels_per_unit == pixels_per_unit_) return;
    font_pixels_ = pixels;
    pixels_per_unit_ = pixels_per_unit;
    rebuild_fonts();
}

void Application::rebuild_fonts() {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    const char* nicer = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    ImFontConfig config;
    config.SizePixels = font_pixels_;
    if (std::filesystem::exists(nicer))
        io.Fonts->AddFontFromFileTTF(nicer, config.SizePixels);
    else
        io.Fonts->AddFontDefault(&config); // built in, of lower quality
    io.FontGlobalScale = 1.0f / pixels_per_unit_;
    apply_style(interface_scale_, light_theme_);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

// The views take the area beside the panel's column, so that the panel does not cover their centers.
void Application::place_picture(const StageState& state) {
    int window_width = 0, window_height = 0;
    glfwGetWindowSize(window_.get(), &window_width, &window_height);
    const float column = Panel::column_width(controller_, interface_scale_, float(window_width));
    area_.place(frame_width_, frame_height_, window_width, column, panel_.bar_height(), 1 + state.panes.size());
    const PicturePlace first = area_.first_place();
    facts_.left = first.left;
    facts_.width = first.width;
    facts_.height = first.height;
    facts_.panes.clear();
    for (std::size_t i = 0; i < area_.count(); ++i) facts_.panes.push_back(area_.pane(i));
}

void Application::save_picture(const std::filesystem::path& path) {
    const LatestState latest = physics_.latest();
    if (1 + latest.stage.panes.size() != area_.count()) place_picture(latest.stage);
    area_.draw_without_panel(latest, controller_);
    write_screen(path);
}

void Application::write_screen(const std::filesystem::path& path) {
    const std::vector<std::uint8_t> pixels = read_screen(frame_width_, frame_height_);
    try {
        write_picture(path, frame_width_, frame_height_, pixels);
        say("Saved " + path.string());
    } catch (const Error& error) {
        say(error.what());
    }
}

void Application::save_what_was_asked_for() {
    const auto new_file = [this](const std::string& extension) {
        return unused_path(options_.screenshot_folder, name_of_now(), extension);
    };
    if (std::exchange(controller_.screenshot, false)) save_picture(new_file(".png"));
    if (const std::string page = std::exchange(controller_.page, {}); !page.empty())
        say(open_page(options_.docs, page));
    if (std::exchange(controller_.save_recording, false))
        physics_.post(command::SaveRecording{new_file(".mcap").string(), 30.0, controller_.camera.pose()});
    if (std::exchange(controller_.save_scene, false))
        physics_.post(command::SaveScene{new_file(".gltf").string(), controller_.camera.pose()});
    std::string saved;
    try {
        if (std::exchange(controller_.video, false)) {
            if (video_.is_running()) {
                saved = video_.stop();
            } else {
                video_.start(new_file(".mp4"), frame_width_, frame_height_);
                saved = "A video is being recorded: F10 ends it.";
            }
        }
        for (const Export& file : std::exchange(controller_.exports, {})) {
            const std::filesystem::path path = unused_path(options_.screenshot_folder, file.name, file.extension);
            files::write_file(path, file.text);
            saved += (saved.empty() ? "Saved " : ", ") + path.string();
        }
    } catch (const Error& error) {
        saved = error.what();
    }
    if (!saved.empty()) say(saved);
}

void Application::say(const std::string& text) {
    facts_.notice = text;
    notice_left_ = notice_seconds;
}

void Application::update_notice(const StageState& state) {
    if (state.message.serial == seen_message_) return;
    seen_message_ = state.message.serial;
    say(state.message.text);
}

void Application::count_frame(double seconds) {
    ++facts_.frames;
    ++rate_frames_;
    rate_seconds_ += seconds;
    if (rate_seconds_ >= rate_window) {
        facts_.frames_per_second = rate_frames_ / rate_seconds_;
        rate_seconds_ = 0.0;
        rate_frames_ = 0;
    }
    notice_left_ -= seconds;
    if (notice_left_ <= 0.0) facts_.notice.clear();
}

void Application::write_report(const std::filesystem::path& path) {
    files::write_file(path, report_json(physics_.latest().stage, controller_, facts_));
}

void Application::run() {
    const Clock::time_point start = Clock::now();
    Clock::time_point last = start;
    std::string title;
    while (!glfwWindowShouldClose(window_.get()) && !controller_.quit) {
        glfwPollEvents();
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - std::exchange(last, now)).count();
        if (options_.exit_after && std::chrono::duration<double>(now - start).count() >= *options_.exit_after) break;
        fit_interface();
        const LatestState latest = physics_.latest();
        place_picture(latest.stage);
        controller_.update(latest.stage);
        use_gamepad(float(seconds));
        update_notice(latest.stage);
        if (facts_.width <= 0 || facts_.height <= 0) { // minimized: nothing to draw on
            glfwWaitEventsTimeout(minimized_pause);
            continue;
        }
        play_script(seconds);
        if (title != latest.stage.title) {
            title = latest.stage.title;
            glfwSetWindowTitle(window_.get(), ("Cairn: " + title).c_str());
        }
        save_what_was_asked_for();
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        show_script_mouse();
        ImGui::NewFrame();
        follow_picture_size();
        panel_.draw(latest.stage, controller_, facts_, interface_scale_);
        ImGui::Render();
        facts_.scene_lines = panel_.scene_lines();
        facts_.scene_is_listed = panel_.scene_is_listed();
        facts_.bar_left = panel_.timeline().left();
        facts_.bar_right = panel_.timeline().right();
        facts_.bar_middle = panel_.timeline().middle();
        area_.draw(latest, controller_, draw_scale_.value());
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        if (const std::string told = video_.add_frame(seconds, frame_width_, frame_height_); !told.empty()) say(told);
        if (!window_picture_.empty()) write_screen(std::exchange(window_picture_, {}));
        glfwSwapBuffers(window_.get());
        count_frame(seconds);
        if (is_software_) draw_scale_.count_frame(seconds);
    }
    if (!options_.report.empty()) write_report(options_.report);
}

} // namespace

int run_viewer(const ViewerOptions& options) {
    try {
        if (!options.loader) throw Error(ErrorCode::invalid_value, "ViewerOptions.loader", "", "must be given");
        if (options.width < 1 || options.height < 1)
            throw Error(ErrorCode::invalid_value, "ViewerOptions size",
                        std::to_string(options.width) + "x" + std::to_string(options.height), "must be at least 1x1");
        Application application(options);
        application.run();
        return 0;
    } catch (const std::bad_alloc&) { // handled by the caller
        throw;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cairn: %s\n", error.what());
        return 1;
    }
}

} // namespace cairn::viewer
