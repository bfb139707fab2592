/// \file visual_notes.h
/// The meshes that a scene has for its looks, as text for notes in recordings.
#pragma once

#include "viewer/scene_source.h"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace cairn::viewer {

using Notes = std::map<std::string, std::string>;

/// "mesh N": the triangles of a mesh, which several may share; "texture N",
/// "coordinates N" and "textured": pictures, where in them vertices of a mesh lie, and which mesh has which; "finish N"
/// and "tints N": how a mesh meets the light, and the colors of its vertices; "weights
/// N" and "bones": how meshes bend; "visuals": a line each for those whose bodies are in the world. Nothing at all if
/// it came to more than `max_bytes`.
Notes notes_of(std::span<const Visual> visuals, const World& world, std::size_t max_bytes = std::size_t(64) << 20);

/// What `notes_of` wrote, of the bodies in the same slots. What makes no sense is left out.
std::vector<Visual> visuals_of(const Notes& notes, const World& world);

} // namespace cairn::viewer
