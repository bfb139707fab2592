// The brightness of a scene's lights in the picture.
#include "viewer/lights.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace {

using namespace cairn;
using namespace cairn::viewer;

TEST(Lights, WithoutAnyItIsThatOfEveryScene) {
    const Lighting lighting = lighting_of({}, {});
    EXPECT_EQ(lighting.sun, Lighting().sun);
    EXPECT_TRUE(lighting.lamps.empty());
}

TEST(Lights, TheFirstFromFarAwayIsTheSun) {
    const Light lights[] = {{.kind = Light::Kind::point, .position = {0, 3, 0}},
                            {.color = {1.0f, 0.5f, 0.0f}, .towards = {1.0f, 0.0f, 0.0f}},
                            {.towards = {0.0f, 0.0f, 1.0f}}};
    const Lighting lighting = lighting_of(lights, {0, 0, 0});
    EXPECT_EQ(lighting.to_sun, Vec3(1, 0, 0));
    EXPECT_EQ(lighting.sun, Vec3(1.85f, 0.925f, 0.0f));
    ASSERT_EQ(lighting.lamps.size(), 2u);
    EXPECT_EQ(lighting.lamps[0].light.kind, Light::Kind::directional) << "brighter than a candela 3 m away";
}

TEST(Lights, KeepTheirProportions) {
    const Light lights[] = {{.intensity = 1000.0f},
                            {.kind = Light::Kind::point, .intensity = 500.0f, .position = {0, 1, 0}}};
    const Lighting lighting = lighting_of(lights, {0, 0, 0});
    EXPECT_NEAR(lighting.lamps[0].color.x, 0.5f * lighting.sun.x, 1e-6f);
    EXPECT_NEAR(lighting.sun.x, 1.85f * 1.6f, 1e-5f) << "no picture is brighter";
}

TEST(Lights, WithoutASunThatOfEverySceneIsDimmed) {
    const Light lights[] = {{.kind = Light::Kind::point, .position = {0, 1, 0}}};
    EXPECT_LT(glm::length(lighting_of(lights, {}).sun * 3.0f - Lighting().sun), 1e-5f);
}

TEST(Lights, TheBrightestEightShine) {
    std::vector<Light> lights;
    for (int i = 1; i <= 20; ++i) lights.push_back({.kind = Light::Kind::point, .position = {0.0, double(i), 0.0}});
    const Lighting lighting = lighting_of(lights, {0, 20, 0});
    ASSERT_EQ(lighting.lamps.size(), max_lamps);
    EXPECT_EQ(lighting.lamps[0].light.position.y, 20.0);
    EXPECT_EQ(lighting.lamps[7].light.position.y, 13.0);
}

TEST(Lights, WhatDoesNotShineIsDark) {
    const Light lights[] = {{.intensity = 0.0f}};
    EXPECT_EQ(lighting_of(lights, {}).sun, Vec3(0.0f));
}

} // namespace
