// Places of Dear ImGui's windows when the size of the viewer's window changes, also from one run to the next: what is
// in the right or lower half of the picture keeps its distance from that edge.
#pragma once

namespace cairn::viewer {

// Stores the size of the picture beside the places of the windows, and moves those places when they are read. Called
// once, after the context has been created.
void remember_picture_size();
// Moves the windows. Called in each frame, after ImGui::NewFrame.
void follow_picture_size();

} // namespace cairn::viewer
