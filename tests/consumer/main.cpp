// A program that uses Cairn: it drops a crate onto the ground and prints its final height.
#include <cairn/cairn.h>

#include <cmath>
#include <cstdio>
#include <cstring>

int main() {
    cairn::World world;
    world.set_threads(2); // so that the thread library is linked too
    const cairn::BodyId ground = world.create_body({.type = cairn::BodyType::static_});
    world.add_shape(ground, cairn::Plane{});
    const cairn::BodyId crate = world.create_body({.position = {0, 5, 0}});
    world.add_shape(crate, cairn::Box{.half_extents = {0.5f, 0.5f, 0.5f}}, {.density = 600});
    for (int i = 0; i < 600; ++i) world.step(1.0f / 60.0f);
    const double height = world.body(crate).position().y;
    std::printf("cairn %s: the crate lies at %.4f m\n", cairn::version_string, height);
#ifdef PACKAGE_VERSION
    if (std::strcmp(cairn::version_string, PACKAGE_VERSION) != 0) {
        std::printf("the package says that it is %s\n", PACKAGE_VERSION);
        return 1;
    }
#endif
    return std::abs(height - 0.5) < 0.005 ? 0 : 1;
}
