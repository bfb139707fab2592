/// \file shaders.h
/// The shaders, without their version line. The same text compiles as GLSL 3.30 and, for the web, as GLSL ES 3.00.
#pragma once

#include "viewer/body_shaders.h"

namespace cairn::viewer::shaders {

inline constexpr const char* desktop_header = "#version 330 core\n";
inline constexpr const char* web_header = "#version 300 es\n"
                                          "precision highp float;\n"
                                          "precision highp int;\n"
                                          "precision highp sampler2DShadow;\n";

/// Lighting, sky, shadows and tone mapping, shared by the fragment shaders.
inline constexpr const char* lighting = R"(
uniform vec3 u_eye;
uniform vec4 u_viewer; // eye and 1; or, for parallel rays, direction to the eye, and 0
uniform vec3 u_to_light;
uniform vec3 u_sun;             // color of a white surface that faces the sun
const int c_max_lamps = 8;      // lamps cast no shadows
uniform int u_lamp_count;
uniform vec4 u_lamp_place[c_max_lamps]; // position and 1; or direction to the lamp, and 0
uniform vec4 u_lamp_color[c_max_lamps]; // w: 1 / range^2; 0: unlimited
uniform vec4 u_lamp_axis[c_max_lamps];  // spot: scaled axis and offset; others: 0 and 1
uniform mat4 u_shadow_from_world;
uniform float u_shadow_texel;   // size of a texel of the shadow map, meters
uniform float u_shadow_step;    // the same in texture coordinates
uniform float u_shadow_strength;
uniform int u_shadow_rings;     // 2: greatest number of sample rings in lit_fraction()
uniform sampler2DShadow u_shadow_map;

vec3 towards_viewer(vec3 world) { return normalize(u_viewer.xyz - u_viewer.w * world); }

// Squares and square roots replace pow() in this file: they cost a software renderer a tenth of it.
vec3 sky_color(vec3 direction) {
    vec3 color = mix(vec3(0.62, 0.74, 0.84), vec3(0.09, 0.22, 0.46), sqrt(clamp(direction.y, 0.0, 1.0)));
    float towards_sun = max(dot(direction, u_to_light), 0.0);
    float glow = towards_sun * towards_sun * towards_sun;
    glow *= glow;
    color += vec3(1.0, 0.86, 0.66) * (0.22 * glow * glow);
    return mix(color, vec3(0.42, 0.45, 0.47), smoothstep(0.0, 0.25, -direction.y));
}

float lit_around(vec3 place, vec2 offset) {
    return texture(u_shadow_map, place + vec3(offset, 0.0)) + texture(u_shadow_map, place - vec3(offset, 0.0)) +
           texture(u_shadow_map, place + vec3(-offset.y, offset.x, 0.0)) +
           texture(u_shadow_map, place + vec3(offset.y, -offset.x, 0.0));
}

// The fraction of the sunlight that reaches a point, from depth comparisons on two rings, each smoothed over four
// texels. If all comparisons of the outer ring agree, the inner ring is skipped, so that only edges of shadows cost
// both. A loop with a uniform bound, because software renderers execute both branches of an "if", but leave a loop once
// all pixels have left it.
float lit_fraction(vec3 world, vec3 normal) {
    float slope = clamp(1.0 - dot(normal, u_to_light), 0.0, 1.0);
    vec3 place = (u_shadow_from_world * vec4(world + normal * u_shadow_texel * (0.8 + 2.2 * slope), 1.0)).xyz;
    vec2 margin = abs(place.xy - 0.5);
    float inside = 1.0 - smoothstep(0.44, 0.5, max(margin.x, margin.y));
    if (place.z >= 1.0) inside = 0.0;
    vec2 offset = vec2(2.0, 0.8) * u_shadow_step;
    float lit = 0.0, compared = 0.0;
    for (int i = 0; i < u_shadow_rings; ++i) {
        lit += lit_around(place, offset);
        compared += 4.0;
        if (lit <= 0.0 || lit >= 4.0) break;
        offset = vec2(1.1, -0.4) * u_shadow_step;
    }
    return 1.0 - (1.0 - lit / compared) * inside * u_shadow_strength;
}

// The light of a lamp at a point, and the direction to the lamp: attenuation by distance and cone as in
// KHR_lights_punctual.
vec3 lamp_light(int i, vec3 world, out vec3 to_lamp) {
    vec3 way = u_lamp_place[i].xyz - u_lamp_place[i].w * world;
    float square = max(dot(way, way), 1e-4);
    to_lamp = way * inversesqrt(square);
    float fade = square * u_lamp_color[i].w;
    float cone = clamp(dot(u_lamp_axis[i].xyz, to_lamp) + u_lamp_axis[i].w, 0.0, 1.0);
    float reach = cone * cone * mix(1.0, clamp(1.0 - fade * fade, 0.0, 1.0) / square, u_lamp_place[i].w);
    return u_lamp_color[i].rgb * reach;
}

vec3 shade_by_lamps(vec3 world, vec3 normal, vec3 to_eye, vec3 color, float gloss) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < u_lamp_count; ++i) {
        vec3 to_lamp;
        vec3 light = lamp_light(i, world, to_lamp) * max(dot(normal, to_lamp), 0.0);
        float shine = max(dot(normal, normalize(to_eye + to_lamp)), 0.0);
        shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
        sum += light * (color + 0.5 * gloss * shine);
    }
    return sum;
}

const vec3 c_mirrored_sun = vec3(0.4865, 0.49985, 0.53395); // makes highlights a little whiter than the sun

// Ambient light from sky and ground.
vec3 light_around(vec3 normal) {
    return mix(vec3(0.22, 0.21, 0.20), vec3(0.36, 0.43, 0.54), 0.5 + 0.5 * normal.y);
}

vec3 shade(vec3 world, vec3 normal, vec3 color, float gloss) {
    vec3 to_eye = towards_viewer(world);
    float facing = max(dot(normal, u_to_light), 0.0);
    float lit = facing > 0.0 ? lit_fraction(world, normal) : 0.0;
    vec3 sun = u_sun * (facing * lit);
    vec3 around = light_around(normal);
    float shine = max(dot(normal, normalize(to_eye + u_to_light)), 0.0);
    shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine; // 64th power
    float edge = 1.0 - max(dot(normal, to_eye), 0.0);
    edge *= edge;
    float up = clamp(0.5 + reflect(-to_eye, normal).y, 0.0, 1.0);
    vec3 mirrored = mix(vec3(0.42, 0.45, 0.47), vec3(0.45, 0.60, 0.76), up);
    return color * (sun + around) +
           gloss * (c_mirrored_sun * sun * shine + mirrored * (0.16 * edge * edge)) +
           shade_by_lamps(world, normal, to_eye, color, gloss);
}

// Tone mapping: Narkowicz's fit of the ACES film curve; then sRGB encoding (a fit by roots, within 0.3 %).
vec3 to_display(vec3 color) {
    color *= 0.80;
    color = clamp(color * (2.51 * color + 0.03) / (color * (2.43 * color + 0.59) + 0.14), 0.0, 1.0);
    vec3 root = sqrt(color), fourth = sqrt(root);
    return clamp(0.585122381 * root + 0.783140355 * fourth - 0.368262736 * sqrt(fourth), 0.0, 1.0);
}

// A pixel, with its brightness in alpha, which the edge smoothing uses.
vec4 pixel_of(vec3 color) { return vec4(color, dot(color, vec3(0.299, 0.587, 0.114))); }

// Coverage of this pixel by a grid line `pixels` wide; the lines are at integer coordinates.
float grid_line(vec2 place, float pixels) {
    vec2 width = max(fwidth(place), vec2(1e-6));
    vec2 line = clamp(0.5 * pixels + 0.5 - abs(fract(place - 0.5) - 0.5) / width, 0.0, 1.0);
    line *= 1.0 - smoothstep(0.15, 0.5, width);
    return max(line.x, line.y);
}
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
uniform vec3 u_point;        // a point of the plane
uniform vec2 u_grid_offset;  // grid coordinates of that point, meters
uniform vec3 u_ground_color;
uniform float u_grid;
uniform float u_spacing;     // spacing of the finer lines, meters
uniform float u_fade;        // distance at which the ground is blended half with the sky, meters
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
    o_color = pixel_of(to_display(mix(shaded, sky_color(horizon), haze)));
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
void main() { o_color = pixel_of(to_display(sky_color(normalize(v_ray)))); }
)";

inline constexpr const char* smoothing_vertex = R"(
layout(location = 0) in vec3 a_corner;
void main() { gl_Position = vec4(a_corner.x, a_corner.z, 0.0, 1.0); }
)";

/// Anti-aliases edges. Where a pixel differs from a neighbor, the edge between the two is followed in both directions
/// to its ends. The share of the pixel that a straight edge between these ends would assign to the neighbor's side is
/// the blending weight of the neighbor's color. (The idea of morphological antialiasing, Reshetov 2009.)
inline constexpr const char* smoothing_fragment = R"(
uniform sampler2D u_picture;
uniform ivec2 u_corner; // origin of the picture in the window, pixels
uniform int u_reach;    // greatest distance to which an edge is followed in each direction, pixels
out vec4 o_color;

float brightness(ivec2 place) { return texelFetch(u_picture, place, 0).a; }

void main() {
    ivec2 last = textureSize(u_picture, 0) - 1, here = ivec2(gl_FragCoord.xy) - u_corner;
    ivec2 inner = clamp(here, ivec2(1), last - 1);
    vec4 color = texelFetch(u_picture, here, 0);
    float up = brightness(inner + ivec2(0, 1)), down = brightness(inner - ivec2(0, 1));
    float right = brightness(inner + ivec2(1, 0)), left = brightness(inner - ivec2(1, 0));
    float across_y = max(abs(up - color.a), abs(down - color.a));
    float across_x = max(abs(right - color.a), abs(left - color.a));
    bool lies_flat = across_y >= across_x;
    float step = max(across_y, across_x);
    bool plain = step < max(0.04, 0.1 * color.a);
    ivec2 along = lies_flat ? ivec2(1, 0) : ivec2(0, 1);
    bool forwards = lies_flat ? abs(up - color.a) >= abs(down - color.a) : abs(right - color.a) >= abs(left - color.a);
    ivec2 across = (forwards ? 1 : -1) * ivec2(along.y, along.x);
    float other = lies_flat ? (forwards ? up : down) : (forwards ? right : left);
    float middle = 0.5 * (color.a + other), side = color.a - middle;
    vec2 ends = vec2(float(u_reach) + 0.5), stops = vec2(0.0); // pixels to the ends; mean there, relative to middle
    bvec2 found = bvec2(plain);
    for (int i = 1; i <= u_reach; ++i) {
        ivec2 ahead = clamp(inner + i * along, ivec2(1), last - 1);
        ivec2 behind = clamp(inner - i * along, ivec2(1), last - 1);
        float mean_ahead = 0.5 * (brightness(ahead) + brightness(ahead + across)) - middle;
        float mean_behind = 0.5 * (brightness(behind) + brightness(behind + across)) - middle;
        if (!found.x && abs(mean_ahead) > 0.5 * abs(side)) {
            found.x = true;
            ends.x = float(i) - 0.5;
            stops.x = mean_ahead;
        }
        if (!found.y && abs(mean_behind) > 0.5 * abs(side)) {
            found.y = true;
            ends.y = float(i) - 0.5;
            stops.y = mean_behind;
        }
        if (found.x && found.y) break;
    }
    // The neighbor's color is blended in only if the edge steps towards this pixel's side at its nearer end.
    float stop = ends.x < ends.y ? stops.x : stops.y;
    float share = plain || stop * side >= 0.0 ? 0.0 : max(0.5 - min(ends.x, ends.y) / (ends.x + ends.y), 0.0);
    o_color = mix(color, texelFetch(u_picture, inner + across, 0), share);
}
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

// Edge 4 i + k of a box is parallel to its axis i, and starts at the k-th corner of the lower face across that axis.
inline constexpr const char* line_box_vertex = R"(
layout(location = 0) in vec3 a_min;
layout(location = 1) in vec3 a_max;
layout(location = 2) in vec3 a_color;
uniform mat4 u_clip_from_world;
out vec3 v_color;
void main() {
    int edge = gl_VertexID / 2;
    vec3 t = vec3(float(gl_VertexID % 2), float(edge % 2), float(edge / 2 % 2));
    t = edge < 4 ? t.xyz : edge < 8 ? t.zxy : t.yzx;
    v_color = a_color;
    gl_Position = u_clip_from_world * vec4(mix(a_min, a_max, t), 1.0);
}
)";

inline constexpr const char* line_fragment = R"(
in vec3 v_color;
out vec4 o_color;
void main() { o_color = vec4(v_color, dot(v_color, vec3(0.299, 0.587, 0.114))); }
)";

} // namespace cairn::viewer::shaders
