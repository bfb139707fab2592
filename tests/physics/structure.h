// Structures of boxes for tests, at any place and heading, with gravity in any direction.
#pragma once

#include "support.h"

#include "validation/random_starts.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace cairn_test {

// A plane, and boxes on it, given in the frame of a random start.
class Structure {
  public:
    explicit Structure(const RandomStart& start) : world(with_turned_gravity(start)), start_(start) {
        BodyDef def;
        def.type = BodyType::static_;
        def.position = start.place({0, 0, 0});
        def.rotation = start.quat();
        add_body(world, Plane{}, def);
    }
    // `turn`: angle about the vertical, rad.
    void add(const glm::dvec3& at, const Vec3& half, double turn = 0) {
        BodyDef def;
        def.position = start_.place(at);
        def.rotation = start_.quat() * glm::angleAxis(float(turn), Vec3(0, 1, 0));
        places_.emplace_back(add_body(world, Box{half}, def), def.position);
    }
    // The greatest distance of a box from where it was created, m.
    double way() const {
        double way = 0;
        for (const auto& [id, place] : places_)
            way = std::max(way, double(glm::length(world.body(id).position() - place)));
        return way;
    }
    bool is_asleep() const {
        return std::none_of(places_.begin(), places_.end(),
                            [&](const auto& made) { return world.body(made.first).is_awake(); });
    }

    World world;

  private:
    RandomStart start_;
    std::vector<std::pair<BodyId, Position>> places_;
};

} // namespace cairn_test
