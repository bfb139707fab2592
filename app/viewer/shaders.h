/// \file shaders.h
/// The shaders, without their first line. The same text compiles as GLSL 3.30 and, for the web, as GLSL ES 3.00.
#pragma once

namespace cairn::viewer::shaders {

inline constexpr const char* desktop_header = "#version 330 core\n";
inline constexpr const char* web_header = "#version 300 es\n"
                                          "precision highp float;\n"
                                          "precision highp int;\n"
                                          "precision highp sampler2DShadow;\n";

/// Light, sky, shadow and tone, shared by the fragment shaders.
inline constexpr const char* lighting = R"(
uniform vec3 u_eye;
uniform vec3 u_to_light;
uniform mat4 u_shadow_from_world;
uniform float u_shadow_texel;   // size of one texel of the shadow map in the world
uniform float u_shadow_step;    // and in the map itself
uniform float u_shadow_strength;
uniform sampler2DShadow u_shadow_map;

// Squares and square roots stand for powers throughout: they cost a software renderer a tenth of pow().
vec3 sky_color(vec3 direction) {
    vec3 color = mix(vec3(0.62, 0.74, 0.84), vec3(0.09, 0.22, 0.46), sqrt(clamp(direction.y, 0.0, 1.0)));
    float towards_sun = max(dot(direction, u_to_light), 0.0);
    float glow = towards_sun * towards_sun * towards_sun;
    glow *= glow;
    color += vec3(1.0, 0.86, 0.66) * (0.22 * glow * glow);
    return mix(color, vec3(0.42, 0.45, 0.47), smoothstep(0.0, 0.25, -direction.y));
}

// The fraction of the sun that reaches a point: comparisons, each already smoothed over four texels, on a disk. Where
// the outer ones agree the inner ones would too, so only the edges of shadows cost all of them.
float lit_fraction(vec3 world, vec3 normal) {
    float slope = clamp(1.0 - dot(normal, u_to_light), 0.0, 1.0);
    vec3 place = (u_shadow_from_world * vec4(world + normal * u_shadow_texel * (0.8 + 2.2 * slope), 1.0)).xyz;
    vec2 margin = abs(place.xy - 0.5);
    float inside = 1.0 - smoothstep(0.44, 0.5, max(margin.x, margin.y));
    if (inside * u_shadow_strength <= 0.0 || place.z >= 1.0) return 1.0;
    float s = u_shadow_step;
    float lit = texture(u_shadow_map, place + vec3(2.0, 0.8, 0.0) * s) +
                texture(u_shadow_map, place + vec3(-0.8, 2.0, 0.0) * s) +
                texture(u_shadow_map, place + vec3(-2.0, -0.8, 0.0) * s) +
                texture(u_shadow_map, place + vec3(0.8, -2.0, 0.0) * s);
    if (lit > 0.0 && lit < 4.0) {
        lit += texture(u_shadow_map, place + vec3(1.2, -0.5, 0.0) * s) +
               texture(u_shadow_map, place + vec3(0.5, 1.2, 0.0) * s) +
               texture(u_shadow_map, place + vec3(-1.2, 0.5, 0.0) * s) +
               texture(u_shadow_map, place + vec3(-0.5, -1.2, 0.0) * s) + texture(u_shadow_map, place);
        lit *= 4.0 / 9.0;
    }
    return 1.0 - (1.0 - 0.25 * lit) * inside * u_shadow_strength;
}

vec3 shade(vec3 world, vec3 normal, vec3 color, float gloss) {
    vec3 to_eye = normalize(u_eye - world);
    float facing = max(dot(normal, u_to_light), 0.0);
    float lit = facing > 0.0 ? lit_fraction(world, normal) : 0.0;
    vec3 sun = vec3(1.0, 0.93, 0.82) * (1.85 * facing * lit);
    vec3 around = mix(vec3(0.22, 0.21, 0.20), vec3(0.36, 0.43, 0.54), 0.5 + 0.5 * normal.y);
    float shine = max(dot(normal, normalize(to_eye + u_to_light)), 0.0);
    shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine; // to the 64th
    float edge = 1.0 - max(dot(normal, to_eye), 0.0);
    edge *= edge;
    float up = clamp(0.5 + reflect(-to_eye, normal).y, 0.0, 1.0);
    vec3 mirrored = mix(vec3(0.42, 0.45, 0.47), vec3(0.45, 0.60, 0.76), up);
    return color * (sun + around) +
           gloss * (vec3(0.90, 0.86, 0.81) * (shine * facing * lit) + mirrored * (0.16 * edge * edge));
}

// Narkowicz's fit of the ACES film curve, then the display's own curve (a fit of sRGB by roots, within 0.3 %).
vec3 to_display(vec3 color) {
    color *= 0.80;
    color = clamp(color * (2.51 * color + 0.03) / (color * (2.43 * color + 0.59) + 0.14), 0.0, 1.0);
    vec3 root = sqrt(color), fourth = sqrt(root);
    return clamp(0.585122381 * root + 0.783140355 * fourth - 0.368262736 * sqrt(fourth), 0.0, 1.0);
}

// How much of a line of a grid with lines at every whole number covers this pixel.
float grid_line(vec2 place, float pixels) {
    vec2 width = max(fwidth(place), vec2(1e-6));
    vec2 line = clamp(0.5 * pixels + 0.5 - abs(fract(place - 0.5) - 0.5) / width, 0.0, 1.0);
    line *= 1.0 - smoothstep(0.15, 0.5, width);
    return max(line.x, line.y);
}
)";

/// The values of `u_kind` in the body shaders: which mesh is drawn.
enum class BodyKind : int { sphere, box, rectangle, capsule, cylinder, facets, surface, terrain, visual };

inline constexpr const char* body_vertex = R"(
layout(location = 0) in vec3 a_corner;
layout(location = 1) in vec3 a_inset;
layout(location = 2) in vec3 a_normal;
layout(location = 3) in vec4 a_position;  // w: emphasis
layout(location = 4) in vec4 a_rotation;
layout(location = 5) in vec4 a_half_size; // w: pattern
layout(location = 6) in vec4 a_color;
uniform mat4 u_clip_from_world;
uniform int u_kind;
out vec3 v_world;
out vec3 v_normal;
out vec3 v_corner;
out vec3 v_local;
out vec3 v_local_normal;
out vec4 v_color;
out float v_pattern;
flat out vec4 v_rotation;

vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// Two balls and the cone that touches both. On it the normal's height is (lower - upper radius) / distance: there each
// ball's part begins. Where one ball holds the other, it is all that is left.
void place_capsule(vec3 size, out vec3 place, out vec3 normal) {
    float end = a_corner.y;
    // Away from the axis and up: where the ball's part begins, in the middle, and at the pole. The middle comes from
    // the formulas of half angles; asin() is good to four digits only on some drivers.
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
    vec2 upwards = normalize(vec2(size.z - size.x, 2.0 * size.y)); // along the side, away from the axis and up
    vec2 profile = vec2(radius, end * size.y);
    if (a_inset.x > 1.5) {
        profile -= end * bevel * upwards;
        normal = vec3(a_normal.x * upwards.y, -upwards.x, a_normal.z * upwards.y);
    } else {
        profile.x -= bevel; // the middle has no direction from the axis
        normal = a_normal;
    }
    place = vec3(a_corner.x * profile.x, profile.y, a_corner.z * profile.x);
}

void main() {
    vec3 local, normal = a_normal;
    if (u_kind == 3) {
        place_capsule(a_half_size.xyz, local, normal);
    } else if (u_kind == 4) {
        place_cylinder(a_half_size.xyz, local, normal);
    } else {
        float bevel = 0.07 * min(a_half_size.x, min(a_half_size.y, a_half_size.z));
        local = a_corner * a_half_size.xyz - a_inset * bevel;
    }
    v_world = a_position.xyz + rotate(a_rotation, local);
    v_normal = rotate(a_rotation, normal);
    v_corner = a_corner;
    v_local = local;
    v_local_normal = normal;
    v_color = vec4(a_color.rgb, a_position.w);
    v_pattern = a_half_size.w;
    v_rotation = a_rotation;
    gl_Position = u_clip_from_world * vec4(v_world, 1.0);
}
)";

inline constexpr const char* body_fragment = R"(
in vec3 v_world;
in vec3 v_normal;
in vec3 v_corner;
in vec3 v_local;
in vec3 v_local_normal;
in vec4 v_color;
in float v_pattern;
flat in vec4 v_rotation;
uniform int u_kind; // 0 sphere, 1 box, 2 rectangle, 3 capsule, 4 cylinder, 5 facets, 6 surface, 7 terrain, 8 visual
uniform float u_grid;
uniform float u_spacing; // of the finer lines of the grid, meters
uniform float u_fade;    // distance at which large surfaces have half become sky, meters
out vec4 o_color;

// Eight panels, alternately lighter and darker, so that rolling can be seen.
float panels(vec3 side) {
    vec3 panel = clamp(side / max(fwidth(side), vec3(1e-5)), -1.0, 1.0);
    return 1.0 - 0.13 * v_pattern * (1.0 - panel.x * panel.y * panel.z);
}

float grid_at(vec2 place) { return max(0.5 * grid_line(place, 1.0), grid_line(place * 0.1, 1.6)); }

vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// On capsules and cylinders the normal leans away from the axis exactly as the place does. Between the corners of a
// triangle that holds only roughly, and near the tip of a cone not at all.
vec3 round_normal() {
    float away = length(v_local.xz);
    if (away <= 0.0) return v_normal;
    vec2 lean = v_local.xz * (length(v_local_normal.xz) / away);
    return rotate(v_rotation, vec3(lean.x, v_local_normal.y, lean.y));
}

// A grid on whatever side the surface faces most.
float surface_grid(vec3 place, vec3 facing) {
    vec3 size = abs(facing);
    if (size.y >= max(size.x, size.z)) return grid_at(place.xz);
    return size.x > size.z ? grid_at(place.zy) : grid_at(place.xy);
}

void main() {
    bool is_round = u_kind == 3 || u_kind == 4;
    vec3 normal = normalize(is_round ? round_normal() : v_normal);
    vec3 color = v_color.rgb;
    float gloss = 1.0, haze = 0.0;
    vec3 ray = v_world - u_eye;
    if (u_kind == 0) {
        color *= panels(normalize(v_corner));
    } else if (u_kind == 2) {
        gloss = 0.15;
        color *= 1.0 - 0.13 * u_grid * grid_line(v_local.xz, 1.0);
    } else if (is_round) {
        color *= panels(v_local);
    } else if (u_kind == 6 || u_kind == 7) {
        gloss = 0.10;
        vec3 facing = normalize(v_local_normal);
        vec3 place = v_local / u_spacing;
        if (u_kind == 7) {
            float steep = smoothstep(0.03, 0.35, 1.0 - facing.y);
            color = mix(color, color * vec3(1.15, 0.78, 0.62), v_pattern * steep);
        }
        color *= 1.0 - 0.22 * u_grid * (u_kind == 7 ? grid_at(place.xz) : surface_grid(place, facing));
        float far = dot(ray, ray) / (u_fade * u_fade);
        haze = far / (1.0 + far);
    }
    if (u_kind == 8) gloss = 0.5;
    if (u_kind >= 6 && !gl_FrontFacing) { // from behind
        normal = -normal;
        if (u_kind != 8) color *= 0.6;
    }
    vec3 to_eye = normalize(u_eye - v_world);
    vec3 shaded = shade(v_world, normal, color, gloss);
    float rim = pow(1.0 - max(dot(normal, to_eye), 0.0), 2.0);
    shaded = mix(shaded, vec3(1.9, 0.95, 0.12), v_color.a * (0.12 + 0.8 * rim));
    if (haze > 0.0) {
        vec3 horizon = normalize(vec3(ray.x, max(ray.y, 0.0), ray.z) + vec3(0.0, 1e-4, 0.0));
        shaded = mix(shaded, sky_color(horizon), haze);
    }
    o_color = vec4(to_display(shaded), 1.0);
}
)";

inline constexpr const char* shadow_fragment = R"(
void main() {}
)";

inline constexpr const char* ground_vertex = R"(
layout(location = 0) in vec3 a_corner;
uniform mat4 u_clip_from_world;
uniform vec3 u_center;
uniform vec3 u_axis_x;
uniform vec3 u_axis_z;
uniform float u_extent;
out vec3 v_world;

void main() {
    v_world = u_center + (u_axis_x * a_corner.x + u_axis_z * a_corner.z) * u_extent;
    gl_Position = u_clip_from_world * vec4(v_world, 1.0);
}
)";

inline constexpr const char* ground_fragment = R"(
in vec3 v_world;
uniform vec3 u_normal;
uniform vec3 u_axis_x;
uniform vec3 u_axis_z;
uniform vec3 u_point;        // a point of the plane ...
uniform vec2 u_grid_offset;  // ... and where it lies on the grid, meters
uniform vec3 u_ground_color;
uniform float u_grid;
uniform float u_spacing;     // of the finer lines, meters
uniform float u_fade;        // distance at which the ground has half become sky, meters
out vec4 o_color;

void main() {
    vec3 offset = v_world - u_point;
    vec2 place = (vec2(dot(offset, u_axis_x), dot(offset, u_axis_z)) + u_grid_offset) / u_spacing;
    vec3 color = u_ground_color;
    color *= 1.0 - u_grid * max(0.11 * grid_line(place, 1.0), 0.22 * grid_line(place * 0.1, 1.6));
    vec3 shaded = shade(v_world, u_normal, color, 0.12);
    vec3 ray = v_world - u_eye;
    float far = dot(ray, ray) / (u_fade * u_fade);
    float haze = far / (1.0 + far);
    vec3 horizon = normalize(vec3(ray.x, max(ray.y, 0.0), ray.z) + vec3(0.0, 1e-4, 0.0));
    o_color = vec4(to_display(mix(shaded, sky_color(horizon), haze)), 1.0);
}
)";

inline constexpr const char* sky_vertex = R"(
layout(location = 0) in vec3 a_corner;
uniform vec3 u_ray_forward;
uniform vec3 u_ray_right;
uniform vec3 u_ray_up;
out vec3 v_ray;

void main() {
    v_ray = u_ray_forward + u_ray_right * a_corner.x + u_ray_up * a_corner.z;
    gl_Position = vec4(a_corner.x, a_corner.z, 1.0, 1.0);
}
)";

inline constexpr const char* sky_fragment = R"(
in vec3 v_ray;
out vec4 o_color;
void main() { o_color = vec4(to_display(sky_color(normalize(v_ray))), 1.0); }
)";

inline constexpr const char* line_vertex = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_color;
uniform mat4 u_clip_from_world;
out vec3 v_color;
void main() {
    v_color = a_color;
    gl_Position = u_clip_from_world * vec4(a_position, 1.0);
}
)";

inline constexpr const char* line_fragment = R"(
in vec3 v_color;
out vec4 o_color;
void main() { o_color = vec4(v_color, 1.0); }
)";

} // namespace cairn::viewer::shaders
