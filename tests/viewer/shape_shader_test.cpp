// The vertices of capsules and cylinders as the vertex shader computes them, read back from the graphics card and
// compared with the support functions of the shapes.
#include "viewer/gl_objects.h"
#include "viewer/headless.h"
#include "viewer/shaders.h"

#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

struct PlacedVertex {
    Vec3 place, normal;
};

// Support function: the extent of a capsule or cylinder (lower radius, half height, upper radius) along a unit vector.
float reach(shaders::BodyKind kind, const Vec3& size, const Vec3& along) {
    const float sideways = kind == shaders::BodyKind::capsule ? 1.0f : std::hypot(along.x, along.z);
    return std::max(-size.y * along.y + size.x * sideways, size.y * along.y + size.z * sideways);
}

class ShapeShaders : public testing::Test {
  protected:
    void SetUp() override {
        try {
            context_ = std::make_unique<HeadlessRenderer>(16, 16);
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
    }

    // A program that only computes vertex positions.
    static GlObject program_of(shaders::BodyKind kind) {
        GlObject program(glCreateProgram(), [](unsigned name) { glDeleteProgram(name); });
        const std::string constant = shaders::body_kind(kind);
        for (const auto& [stage, source] :
             {std::pair(GL_VERTEX_SHADER, shaders::body_vertex), {GL_FRAGMENT_SHADER, shaders::shadow_fragment}}) {
            const GLuint shader = glCreateShader(GLenum(stage));
            const char* parts[] = {shaders::desktop_header, constant.c_str(), source};
            glShaderSource(shader, 3, parts, nullptr);
            glCompileShader(shader);
            glAttachShader(program.name(), shader);
            glDeleteShader(shader);
        }
        const char* outputs[] = {"v_world", "v_normal"};
        glTransformFeedbackVaryings(program.name(), 2, outputs, GL_INTERLEAVED_ATTRIBS);
        glLinkProgram(program.name());
        GLint linked = 0;
        glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
        EXPECT_TRUE(linked);
        return program;
    }

    // The vertices of all triangles as the shader positions them.
    std::vector<PlacedVertex> place(shaders::BodyKind kind, const TriangleMesh& triangles, const Instance& instance) {
        GlMesh mesh(triangles);
        mesh.upload(&instance, 1);
        const GlObject program = program_of(kind);
        glUseProgram(program.name());
        glUniform4f(glGetUniformLocation(program.name(), "u_viewer"), viewer_.x, viewer_.y, viewer_.z, viewer_.w);
        std::vector<PlacedVertex> placed(triangles.indices.size());
        const GlObject buffer = make_buffer();
        glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer.name());
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, GLsizeiptr(placed.size() * sizeof(PlacedVertex)), nullptr,
                     GL_STREAM_READ);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer.name());
        glEnable(GL_RASTERIZER_DISCARD);
        glBeginTransformFeedback(GL_TRIANGLES);
        mesh.draw();
        glEndTransformFeedback();
        glDisable(GL_RASTERIZER_DISCARD);
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, GLsizeiptr(placed.size() * sizeof(PlacedVertex)),
                           placed.data());
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        return placed;
    }

    // Every vertex must lie on the supporting plane of the shape along the vertex's normal, no vertex may be outside
    // the shape, and no part of the shape may be missing.
    void check(shaders::BodyKind kind, const TriangleMesh& mesh, const Vec3& size, float allowed_gap) {
        const float extent = size.y + std::max(size.x, size.z), rounding = 2e-6f * extent;
        // In that case one ball contains the other, and the vertices of the smaller ball are inside the shape.
        const bool one_holds_the_other =
            kind == shaders::BodyKind::capsule && std::abs(size.x - size.z) > 2.0f * size.y;
        Instance instance;
        instance.half_size = size;
        const std::vector<PlacedVertex> placed = place(kind, mesh, instance);
        for (const PlacedVertex& vertex : placed) {
            ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-5f);
            const float touched = glm::dot(vertex.place, vertex.normal), outermost = reach(kind, size, vertex.normal);
            ASSERT_LE(touched, outermost + rounding);
            if (!one_holds_the_other) {
                ASSERT_GE(touched, outermost - rounding);
            }
        }
        for (std::size_t i = 0; i < placed.size(); i += 3) {
            const Vec3 area = glm::cross(placed[i + 1].place - placed[i].place, placed[i + 2].place - placed[i].place);
            if (glm::length(area) < 1e-4f * extent * extent) continue; // a sliver at a tip
            const Vec3 normals = placed[i].normal + placed[i + 1].normal + placed[i + 2].normal;
            ASSERT_GT(glm::dot(area, normals), 0.0f);
        }
        for (int i = 0; i < 200; ++i) {
            const Vec3 along = glm::normalize(Vec3(normal_(random_), normal_(random_), normal_(random_)));
            float farthest = -1e30f;
            for (const PlacedVertex& vertex : placed) farthest = std::max(farthest, glm::dot(vertex.place, along));
            ASSERT_LE(farthest, reach(kind, size, along) + rounding);
            ASSERT_GE(farthest, reach(kind, size, along) - allowed_gap);
        }
    }

    float random_size() { return std::exp(0.8f * normal_(random_)); }

    std::mt19937 random_{7};
    std::normal_distribution<float> normal_;
    glm::vec4 viewer_{0.0f, 0.0f, 1.0f, 0.0f};

  private:
    std::unique_ptr<HeadlessRenderer> context_;
};

// The camera is anywhere outside the ball, sometimes far away.
TEST_F(ShapeShaders, CapsAreWhatIsSeenOfABall) {
    for (int i = 0; i < 60; ++i) {
        Instance instance;
        const float radius = random_size();
        const bool is_far = i % 3 == 0;
        instance.half_size = Vec3(radius);
        instance.position = Vec3(normal_(random_), normal_(random_), normal_(random_)) * 10.0f;
        const Vec3 way = glm::normalize(Vec3(normal_(random_), i % 5 ? normal_(random_) : 40.0f, normal_(random_)));
        const float distance = radius * (1.0f + random_size());
        viewer_ = is_far ? glm::vec4(way, 0.0f) : glm::vec4(instance.position + way * distance, 1.0f);
        const float rim = is_far ? 0.0f : radius / distance; // cosine of the angle between the middle and the rim
        float lowest = 1.0f, highest = -1.0f;
        const std::vector<PlacedVertex> placed = place(shaders::BodyKind::sphere, cap_mesh(24, 2), instance);
        for (std::size_t k = 0; k < placed.size(); ++k) {
            ASSERT_NEAR(glm::length(placed[k].normal), 1.0f, 1e-5f);
            ASSERT_LT(glm::distance(placed[k].place, instance.position + radius * placed[k].normal), 1e-4f);
            const float height = glm::dot(placed[k].normal, way);
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
            if (k % 3 != 2) continue;
            const Vec3 a = placed[k - 2].place, b = placed[k - 1].place, c = placed[k].place;
            ASSERT_GT(glm::dot(glm::cross(b - a, c - a), placed[k].normal), 0.0f);
        }
        ASSERT_NEAR(lowest, rim, 1e-4f);
        ASSERT_NEAR(highest, 1.0f, 1e-4f);
    }
}

TEST_F(ShapeShaders, CapsulesOfAnySizesAreTheHullOfTheirBalls) {
    const TriangleMesh mesh = capsule_mesh(96, 16);
    for (int i = 0; i < 40; ++i) {
        // Every fourth one has no upper ball; with random sizes one ball often contains the other.
        const Vec3 size(random_size(), random_size(), i % 4 == 3 ? 0.0f : i % 4 == 2 ? -1.0f : random_size());
        const Vec3 used(size.x, size.y, size.z < 0.0f ? size.x : size.z);
        check(shaders::BodyKind::capsule, mesh, used, 0.01f * std::max(used.x, used.z));
    }
}

TEST_F(ShapeShaders, CylindersOfAnySizesReachTheirRimsUpToTheBevel) {
    const TriangleMesh mesh = cylinder_mesh(48);
    for (int i = 0; i < 40; ++i) {
        const Vec3 size(random_size(), random_size(), i % 4 == 3 ? 0.0f : random_size());
        check(shaders::BodyKind::cylinder, mesh, size, (0.07f * 1.5f + 0.01f) * std::max(size.x, size.z));
    }
}

TEST_F(ShapeShaders, ShapesTurnAndMoveWithTheirBodies) {
    Instance instance;
    instance.half_size = {0.3f, 0.5f, 0.1f};
    const std::vector<PlacedVertex> plain = place(shaders::BodyKind::capsule, capsule_mesh(12, 3), instance);
    const Quat turn = glm::angleAxis(0.7f, glm::normalize(Vec3(1.0f, 2.0f, -0.5f)));
    instance.position = {3.0f, -1.0f, 2.0f};
    instance.rotation = {turn.x, turn.y, turn.z, turn.w};
    const std::vector<PlacedVertex> moved = place(shaders::BodyKind::capsule, capsule_mesh(12, 3), instance);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        ASSERT_LT(glm::distance(moved[i].place, instance.position + turn * plain[i].place), 1e-5f);
        ASSERT_LT(glm::distance(moved[i].normal, turn * plain[i].normal), 1e-5f);
    }
}

} // namespace
