// The contact of a face with what is opposite: which face, and the points between the two.
#pragma once

#include "collision/contact_axis.h"
#include "collision/contact_features.h"
#include "collision/convex_contact.h"
#include "collision/face_outline.h"

#include <limits>
#include <optional>

namespace cairn {

// The best face of one shape of a pair (best_face), which is asked for again with another axis.
class FaceSearch {
  public:
    FaceAxis find(const Convex& c, const Convex& other, const math::DVec3& p, const FaceAxis& floor) {
        if (!best_ && !(floor.separation >= floor_)) {
            const FaceAxis found = best_face(c, other, p, floor);
            floor_ = floor.separation;
            if (found.face >= 0) best_ = found;
        }
        return best_ && best_->separation > floor.separation ? *best_ : floor;
    }

  private:
    std::optional<FaceAxis> best_;                           // of all
    double floor_ = std::numeric_limits<double>::infinity(); // else none is farther
};

// The points of one pair of shapes between a face and what is opposite. They are asked for again with another axis, and
// the face is mostly the same, and how far its points reach is mostly enough.
struct FacePoints {
    FaceSearch on_a, on_b;
    FaceReach known;
    bool is_found = false;       // else only how far they reach may be known
    std::optional<Feature> disc; // the face, if it or what is opposite is one
    FaceOutline outline;         // of a face with corners
    ContactPoints points;

    bool is_of(const FaceAxis& axis) const { return known.face == axis.face && known.is_second == axis.is_second; }
    void find(const Convex& c, const Convex& other, const FaceAxis& axis, double extent);
    // Whether the middle of the points that reach so far is farther from the border of the face than `distance`.
    bool are_amid(const Convex& c, double reach, double distance) const;
};

// Writes the points of the face unless they all stay farther apart than `least` by more than `tolerance`; true if there
// are any.
bool face_manifold(const Convex& a, const Convex& b, const FaceAxis& axis, double least, double tolerance,
                   double extent, double margin, FacePoints& found, Manifold& out);

} // namespace cairn
