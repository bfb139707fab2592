/// \file body_shaders.h
/// The shaders of bodies, for desktop and web. They use the lighting functions in shaders.h.
#pragma once

#include <cstddef>
#include <string>

namespace cairn::viewer::shaders {

/// The kind of mesh that the body shaders draw.
enum class BodyKind : int {
    sphere,
    box,
    rectangle,
    capsule,
    cylinder,
    facets,
    surface,
    terrain,
    visual,
    textured,
    finished
};
inline constexpr std::size_t body_kind_count = 11;

/// Prefix of a body shader. The kind is a constant, because software renderers execute both branches of an "if".
inline std::string body_kind(BodyKind kind) { return "const int c_kind = " + std::to_string(int(kind)) + ";\n"; }

inline constexpr const char* body_vertex = R"(
layout(location = 0) in vec3 a_corner;
layout(location = 1) in vec3 a_inset;
layout(location = 2) in vec3 a_normal;
layout(location = 3) in vec4 a_position;  // w: emphasis
layout(location = 4) in vec4 a_rotation;
layout(location = 5) in vec4 a_half_size; // w: pattern
layout(location = 6) in vec4 a_color;
layout(location = 7) in vec3 a_tint;      // color of the vertex; white if the mesh has none
uniform mat4 u_clip_from_world;
uniform vec4 u_viewer; // viewpoint of balls: eye and 1; or direction to the eye or to a light, and 0
out vec3 v_world;
out vec3 v_normal;       // balls: point of the cap, relative to the center, in radii
out vec3 v_local;        // balls: radius
out vec3 v_local_normal; // boxes: half extents
out vec4 v_color;
out float v_pattern;
out vec2 v_texel;        // texture coordinates
flat out vec4 v_rotation;

vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// A capsule: two balls and the cone tangent to both. The y of the normal on the cone is (lower - upper radius) /
// distance of the centers. This is also the height, in radii above its center, of each ball's seam with the cone. If
// one ball contains the other, only the larger one remains.
void place_capsule(vec3 size, out vec3 place, out vec3 normal) {
    float end = a_corner.y;
    // Unit vectors (away from the axis, up) at the seam, halfway to the pole, and at the pole. The second uses the
    // half-angle formulas, because asin() is accurate to only four digits on some drivers.
    float height = clamp((size.x - size.z) / (2.0 * size.y), -1.0, 1.0);
    vec2 seam = vec2(sqrt(1.0 - height * height), height);
    vec2 middle = vec2(sqrt(0.5 - 0.5 * end * height), end * sqrt(0.5 + 0.5 * end * height));
    float part = 2.0 * a_inset.x;
    vec2 lean = normalize(part < 1.0 ? mix(seam, middle, part) : mix(middle, vec2(0.0, end), part - 1.0));
    normal = vec3(a_corner.x * lean.x, lean.y, a_corner.z * lean.x);
    place = vec3(0.0, end * size.y, 0.0) + normal * (end < 0.0 ? size.x : size.z);
}

void place_cylinder(vec3 size, out vec3 place, out vec3 normal) {
    float end = a_corner.y;
    float radius = end < 0.0 ? size.x : size.z;
    float bevel = min(0.07 * min(size.y, max(size.x, size.z)), radius);
    vec2 upwards = normalize(vec2(size.z - size.x, 2.0 * size.y)); // along the side: (away from the axis, up)
    vec2 profile = vec2(radius, end * size.y);
    if (a_inset.x > 1.5) {
        profile -= end * bevel * upwards;
        normal = vec3(a_normal.x * upwards.y, -upwards.x, a_normal.z * upwards.y);
    } else {
        profile.x -= bevel; // in the middle of the disk `a_corner` is 0
        normal = a_normal;
    }
    place = vec3(a_corner.x * profile.x, profile.y, a_corner.z * profile.x);
}

// The direction from a ball's center to a point of its visible cap. `a_corner`: direction around the cap's center in
// x and y, distance from there to the rim (0 to 1) in z. From inside the ball the cap is empty.
vec3 cap_direction(vec3 center, float radius) {
    vec3 towards = u_viewer.xyz - u_viewer.w * center;
    float distance = length(towards), rim = u_viewer.w * min(radius / distance, 1.0);
    towards /= distance;
    vec3 right = normalize(cross(abs(towards.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), towards));
    vec2 lean = normalize(mix(vec2(1.0, 0.0), vec2(rim, sqrt(1.0 - rim * rim)), a_corner.z));
    return towards * lean.x + (right * a_corner.x + cross(towards, right) * a_corner.y) * lean.y;
}

void main() {
    vec3 local, normal = a_normal;
    if (c_kind == 3) {
        place_capsule(a_half_size.xyz, local, normal);
    } else if (c_kind == 4) {
        place_cylinder(a_half_size.xyz, local, normal);
    } else {
        local = a_corner * a_half_size.xyz;
    }
    v_world = a_position.xyz + rotate(a_rotation, local);
    v_normal = rotate(a_rotation, normal);
    v_local = local;
    v_local_normal = c_kind == 1 ? a_half_size.xyz : normal;
    if (c_kind == 0) {
        v_normal = cap_direction(a_position.xyz, a_half_size.x);
        v_world = a_position.xyz + a_half_size.x * v_normal;
        v_local = a_half_size.xyz;
    }
    v_color = vec4(a_color.rgb, a_position.w);
    if (c_kind >= 8) v_color.rgb *= mix(vec3(1.0), a_tint, a_half_size.w);
    v_pattern = a_half_size.w;
    v_texel = a_inset.xy;
    v_rotation = a_rotation;
    gl_Position = u_clip_from_world * vec4(v_world, 1.0);
}
)";

inline constexpr const char* body_fragment = R"(
in vec3 v_world;
in vec3 v_normal;
in vec3 v_local;
in vec3 v_local_normal;
in vec4 v_color;
in float v_pattern;
in vec2 v_texel;
flat in vec4 v_rotation;
uniform sampler2D u_texture;
uniform float u_alpha_cutoff;
uniform sampler2D u_normals;    // this and the next five: bodies with a finish only
uniform float u_normal_scale;
uniform sampler2D u_rough;
uniform vec2 u_rough_metal;
uniform sampler2D u_glows;
uniform vec3 u_glow;
uniform float u_grid;
uniform float u_spacing; // spacing of the finer grid lines, meters
uniform float u_fade;    // distance at which large surfaces are blended half with the sky, meters
uniform float u_opacity; // 1; less for ghosts, which are also paler
out vec4 o_color;

// Eight panels, alternately lighter and darker, which make rolling visible.
float panels(vec3 side) {
    vec3 panel = clamp(side / max(fwidth(side), vec3(1e-5)), -1.0, 1.0);
    return 1.0 - 0.13 * v_pattern * (1.0 - panel.x * panel.y * panel.z);
}

float grid_at(vec2 place) { return max(0.5 * grid_line(place, 1.0), grid_line(place * 0.1, 1.6)); }

vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// The normal of a capsule or cylinder lies in the plane through the axis and the point. The interpolated normal lies
// there only roughly, and near the tip of a cone not at all, so its horizontal direction is taken from the point.
vec3 round_normal() {
    float away = length(v_local.xz);
    if (away <= 0.0) return v_normal;
    vec2 lean = v_local.xz * (length(v_local_normal.xz) / away);
    return rotate(v_rotation, vec3(lean.x, v_local_normal.y, lean.y));
}

// Boxes are shaded as if their edges were rounded: within the width of a bevel the normal tilts over the edge. A bevel
// narrower than a pixel is widened to one pixel, and the tilt reduced by the same factor.
vec3 box_normal() {
    vec3 size = v_local_normal;
    float bevel = 0.07 * min(size.x, min(size.y, size.z));
    vec3 face = rotate(vec4(-v_rotation.xyz, v_rotation.w), v_normal);
    vec3 width = max(vec3(bevel), fwidth(v_local));
    vec3 lean = sign(v_local) * clamp((abs(v_local) - size) / width + 1.0, 0.0, 1.0) * (bevel / width);
    return rotate(v_rotation, face + lean * (1.0 - abs(face)));
}

// Moves a point of a ball's cap, which is flat between its vertices, along the view ray onto the ball.
void meet_ball(inout vec3 world, inout vec3 normal) {
    vec3 along = -towards_viewer(world);
    float middle = dot(normal, along), way = sqrt(max(middle * middle + 1.0 - dot(normal, normal), 0.0)) + middle;
    normal -= along * way;
    world -= along * (way * v_local.x);
}

// A grid in the coordinate plane that the surface faces most.
float surface_grid(vec3 place, vec3 facing) {
    vec3 size = abs(facing);
    if (size.y >= max(size.x, size.z)) return grid_at(place.xz);
    return size.x > size.z ? grid_at(place.zy) : grid_at(place.xy);
}

// The normal from the normal map. The tangent frame follows from the screen-space derivatives of the texture
// coordinates, so that meshes need no tangents (Mikkelsen 2020, "Surface Gradient").
vec3 mapped_normal(vec3 world, vec3 normal) {
    vec3 along_x = dFdx(world), along_y = dFdy(world);
    vec2 texel_x = dFdx(v_texel), texel_y = dFdy(v_texel);
    vec3 a = cross(along_y, normal), b = cross(normal, along_x);
    vec3 right = a * texel_x.x + b * texel_y.x, down = a * texel_x.y + b * texel_y.y;
    float side = dot(along_x, a) < 0.0 ? -1.0 : 1.0;
    float size = max(dot(right, right), dot(down, down));
    if (size <= 0.0) return normal;
    vec3 lean = texture(u_normals, v_texel).xyz * 2.0 - 1.0;
    lean.xy *= u_normal_scale * side * inversesqrt(size);
    return normalize(lean.x * right - lean.y * down + max(lean.z, 1e-3) * normal);
}

// Normalized Blinn-Phong highlight: its total light does not depend on its width. Relative to the light that a white
// surface reflects.
vec3 highlight(vec3 normal, vec3 half_way, vec3 mirror, float power) {
    return mirror * ((power + 8.0) * 0.125 * pow(max(dot(normal, half_way), 1e-4), power));
}

// A surface with roughness and metalness: dielectrics mirror 4 % of the light, metals all of it, in their color.
vec3 shade_finished(vec3 world, vec3 normal, vec3 color, vec2 rough) {
    vec3 to_eye = towards_viewer(world);
    float roughness = clamp(rough.x, 0.06, 1.0), slope = roughness * roughness;
    float power = 2.0 / (slope * slope) - 2.0;
    vec3 own = color * (1.0 - rough.y), mirror = mix(vec3(0.04), color, rough.y);
    float edge = 1.0 - max(dot(normal, to_eye), 0.0);
    mirror += (max(vec3(1.0 - roughness), mirror) - mirror) * (edge * edge * edge * edge * edge);
    float facing = max(dot(normal, u_to_light), 0.0);
    vec3 sun = u_sun * (facing > 0.0 ? facing * lit_fraction(world, normal) : 0.0);
    vec3 mirrored = mix(sky_color(reflect(-to_eye, normal)), light_around(normal), roughness);
    vec3 sum = own * (sun + light_around(normal)) + mirror * mirrored +
               sun * highlight(normal, normalize(to_eye + u_to_light), mirror, power);
    for (int i = 0; i < u_lamp_count; ++i) {
        vec3 to_lamp;
        vec3 light = lamp_light(i, world, to_lamp) * max(dot(normal, to_lamp), 0.0);
        sum += light * (own + highlight(normal, normalize(to_eye + to_lamp), mirror, power));
    }
    return sum;
}

void main() {
    bool is_round = c_kind == 3 || c_kind == 4;
    vec3 world = v_world, normal = v_normal;
    if (c_kind == 0) meet_ball(world, normal);
    if (c_kind == 1) normal = box_normal();
    if (is_round) normal = round_normal();
    normal = normalize(normal);
    vec3 color = v_color.rgb;
    float gloss = 1.0, haze = 0.0;
    vec3 ray = world - u_eye;
    if (c_kind == 0) {
        color *= panels(rotate(vec4(-v_rotation.xyz, v_rotation.w), normal));
    } else if (c_kind == 2) {
        gloss = 0.15;
        color *= 1.0 - 0.13 * u_grid * grid_line(v_local.xz, 1.0);
    } else if (is_round) {
        color *= panels(v_local);
    } else if (c_kind == 6 || c_kind == 7) {
        gloss = 0.10;
        vec3 facing = normalize(v_local_normal);
        vec3 place = v_local / u_spacing;
        if (c_kind == 7) {
            float steep = smoothstep(0.03, 0.35, 1.0 - facing.y);
            color = mix(color, color * vec3(1.15, 0.78, 0.62), v_pattern * steep);
        }
        color *= 1.0 - 0.22 * u_grid * (c_kind == 7 ? grid_at(place.xz) : surface_grid(place, facing));
        float far = dot(ray, ray) / (u_fade * u_fade);
        haze = far / (1.0 + far);
    }
    if (c_kind >= 8) gloss = 0.5;
    if (c_kind >= 9) {
        vec4 texel = texture(u_texture, v_texel);
        if (texel.a < u_alpha_cutoff) discard;
        color *= mix(vec3(1.0), texel.rgb, v_pattern);
    }
    if (c_kind >= 6 && !gl_FrontFacing) { // seen from behind
        normal = -normal;
        if (c_kind < 8) color *= 0.6;
    }
    vec3 to_eye = towards_viewer(world);
    vec3 shaded;
    if (c_kind == 10) { // colors that show data (pattern 0) hide the finish
        vec2 rough = u_rough_metal * texture(u_rough, v_texel).gb;
        if (v_pattern > 0.0) normal = mapped_normal(world, normal);
        shaded = shade_finished(world, normal, color, mix(vec2(0.42, 0.0), rough, v_pattern));
        shaded += v_pattern * u_glow * texture(u_glows, v_texel).rgb;
    } else {
        shaded = shade(world, normal, color, gloss);
    }
    float rim = 1.0 - max(dot(normal, to_eye), 0.0);
    shaded = mix(shaded, vec3(1.9, 0.95, 0.12), v_color.a * (0.12 + 0.8 * rim * rim));
    if (haze > 0.0) {
        vec3 horizon = normalize(vec3(ray.x, max(ray.y, 0.0), ray.z) + vec3(0.0, 1e-4, 0.0));
        shaded = mix(shaded, sky_color(horizon), haze);
    }
    shaded = mix(vec3(0.55, 0.72, 0.95), shaded, 0.4 + 0.6 * u_opacity);
    o_color = pixel_of(to_display(shaded));
}
)";

inline constexpr const char* shadow_fragment = R"(
in vec2 v_texel;
uniform sampler2D u_texture;
uniform float u_alpha_cutoff;
void main() {
    if (c_kind >= 9 && texture(u_texture, v_texel).a < u_alpha_cutoff) discard;
}
)";

} // namespace cairn::viewer::shaders
