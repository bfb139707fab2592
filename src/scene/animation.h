/// \file animation.h
/// Exports a run as an animated glTF file that any glTF viewer plays: it has no physics, only moving meshes.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace cairn::scene {

/// Records how the bodies of a scene move, and writes the animation. A body is shown by its visual meshes, or by its
/// shapes if it has none, but never by its triggers. Times are measured from the first recorded moment.
class AnimationBaker {
  public:
    /// The file shows the bodies, shapes and visual meshes that the scene has at this time.
    explicit AnimationBaker(const Scene& scene);

    /// Records the present state of the world, which must be later than the previous one. The bodies must still exist.
    void add(const World& world);

    /// Returns a binary glTF file. Positions are interpolated linearly between the recorded moments, rotations
    /// spherically. Throws `Error` (wrong_state) if no moment was recorded, and (io) when the file would be larger than
    /// 4 GiB.
    std::string container() const;
    /// Returns the same animation as the text of a `.gltf` file with embedded data. Throws as `container` does.
    std::string text() const;
    /// Writes the file: text if its name ends in `.gltf`, else binary. Throws `Error` (io, wrong_state).
    void write(const std::filesystem::path& path) const;

  private:
    std::string document(bool as_text) const;
    struct Part {
        Transform local; // in the body's frame
        std::size_t surface;
        Vec3 color;
        std::shared_ptr<const Texture> texture{};
        std::vector<Bone> bones{};
        std::shared_ptr<const Finish> finish{};
    };
    struct Track {
        BodyId body;
        std::string name;
        bool is_static = false;
        std::vector<Part> parts;
        std::vector<Vec3> positions;
        std::vector<Quat> rotations;
        bool moves() const;
    };
    std::size_t surface_of(const Shape& shape);
    std::size_t surface_of(const std::shared_ptr<const Surface>& surface);

    std::vector<Track> tracks_;
    std::vector<std::shared_ptr<const Surface>> surfaces_;
    // Surface indices by the key of the shape or surface; looked up, never iterated.
    std::unordered_map<std::string, std::size_t> known_;
    std::vector<double> times_;
};

} // namespace cairn::scene
