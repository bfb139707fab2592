/// \file animation.h
/// A run as an animated glTF file, which any viewer of such files plays: no physics in it, only meshes that move.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace cairn::scene {

/// Notes how the bodies of a scene move, and writes it. A body is shown by its visual meshes, or else by its shapes,
/// but not by triggers. Times are measured from the first moment that is added.
class AnimationBaker {
  public:
    /// The bodies, shapes and visual meshes that the scene has now are those of the file.
    explicit AnimationBaker(const Scene& scene);

    /// Notes the present moment; later than the one before. The bodies must still be there.
    void add(const World& world);

    /// A binary glTF file. Between the moments positions are interpolated linearly, and rotations spherically. Throws
    /// `Error` (wrong_state) without any moment, and (io) when it would be larger than 4 GiB.
    std::string container() const;
    /// The same as the text of a `.gltf` file, with its data inside. Throws as `container` does.
    std::string text() const;
    /// Writes a file: text if its name ends in `.gltf`, else binary. Throws `Error` (io, wrong_state).
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
    std::unordered_map<std::string, std::size_t> known_; // surfaces by what they were made of; never walked through
    std::vector<double> times_;
};

} // namespace cairn::scene
