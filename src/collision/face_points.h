// The contact of a reference face with the opposite feature: which face it is, and the points between the two.
#pragma once

#include "collision/contact_axis.h"
#include "collision/contact_features.h"
#include "collision/convex_contact.h"
#include "collision/face_outline.h"

#include <limits>
#include <optional>

namespace cairn {

// A cached best_face of one shape of a pair, as it is requested several times with different floors.
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
    std::optional<FaceAxis> best_;                           // the best of all faces
    double floor_ = std::numeric_limits<double>::infinity(); // else no face has a greater separation
};

// The contact points of one pair of shapes between a face and the opposite feature, cached: they are requested again
// with another axis, but mostly for the same face, and mostly only for their least separation.
struct FacePoints {
    FaceSearch on_a, on_b;
    FaceReach known;
    bool is_found = false;       // false: at most their least separation is known
    std::optional<Feature> disc; // the face, if it or the opposite feature is a disc
    FaceOutline outline;         // of a polygonal face
    ContactPoints points;

    bool is_of(const FaceAxis& axis) const { return known.face == axis.face && known.is_second == axis.is_second; }
    void find(const Convex& c, const Convex& other, const FaceAxis& axis, double extent);
    // Whether the mean of the points with separations up to `reach` is farther from the border of the face than
    // `distance`.
    bool are_amid(const Convex& c, double reach, double distance) const;
};

// Writes the points of the face unless they are all farther apart than `least` by more than `tolerance`; true if there
// are any.
bool face_manifold(const Convex& a, const Convex& b, const FaceAxis& axis, double least, double tolerance,
                   double extent, double margin, FacePoints& found, Manifold& out);

} // namespace cairn
