/// \file visual_notes.h
/// The visual meshes of a scene as text, for notes in recordings.
#pragma once

#include "viewer/scene_source.h"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace cairn::viewer {

using Notes = std::map<std::string, std::string>;

/// Keys of the notes: "mesh N": the triangles of a mesh, which several visuals may share; "texture N", "coordinates N"
/// and "textured": textures, texture coordinates, and which mesh has which; "finish N" and "tints N": materials and
/// vertex colors; "weights N" and "bones": skinning; "visuals": a line for each visual whose body is in the world.
/// Empty if the notes exceed `max_bytes`.
Notes notes_of(std::span<const Visual> visuals, const World& world, std::size_t max_bytes = std::size_t(64) << 20);

/// Parses the notes of `notes_of`, for bodies in the same slots. Malformed notes are ignored.
std::vector<Visual> visuals_of(const Notes& notes, const World& world);

} // namespace cairn::viewer
