/// \file shaders.h
/// The shaders, without their first line. The same text compiles as GLSL 3.30 and, for the web, as GLSL ES 3.00.
#pragma once

#include <cstddef>
#include <string>

namespace cairn::viewer::shaders {

inline constexpr const char* desktop_header = "#version 330 core\n";
inline constexpr const char* web_header = "#version 300 es\n"
                                          "precision highp float;\n"
                                          "precision highp int;\n"
                                          "precision highp sampler2DShadow;\n";

/// Light, sky, shadow and tone, shared by the fragment shaders.
inline constexpr const char* lighting = R"(
uniform vec3 u_eye;
uniform vec4 u_viewer; // the eye and 1, or the direction towards it and 0 where rays are parallel
uniform vec3 u_to_light;
uniform vec3 u_sun;             // color of a white surface that faces that light
const int c_max_lamps = 8;      // what shines without a shadow
uniform int u_lamp_count;
uniform vec4 u_lamp_place[c_max_lamps]; // and 1, or the direction towards it and 0
uniform vec4 u_lamp_color[c_max_lamps]; // and 1 over the square of its range
uniform vec4 u_lamp_axis[c_max_lamps];  // what a cone adds to, by the cosine to its axis; of others 0 and 1
uniform mat4 u_shadow_from_world;
uniform float u_shadow_texel;   // size of one texel of the shadow map in the world
uniform float u_shadow_step;    // and in the map itself
uniform float u_shadow_strength;
uniform int u_shadow_rings;     // 2: how often lit_fraction() looks, at most
uniform sampler2DShadow u_shadow_map;

vec3 towards_viewer(vec3 world) { return normalize(u_viewer.xyz - u_viewer.w * world); }

// Squares and square roots stand for powers throughout: they cost a software renderer a tenth of pow().
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

// The fraction of the sun that reaches a point: comparisons, each already smoothed over four texels, on two rings.
// Where the outer ones agree the inner ones would too, so only the edges of shadows cost both. It is a loop of unknown
// length because software renderers go through both sides of an "if", but leave a loop when every pixel has.
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

// KHR_lights_punctual's laws of distance and cone.
vec3 shade_by_lamps(vec3 world, vec3 normal, vec3 to_eye, vec3 color, float gloss) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < u_lamp_count; ++i) {
        vec3 way = u_lamp_place[i].xyz - u_lamp_place[i].w * world;
        float square = max(dot(way, way), 1e-4);
        vec3 to_lamp = way * inversesqrt(square);
        float fade = square * u_lamp_color[i].w;
        float cone = clamp(dot(u_lamp_axis[i].xyz, to_lamp) + u_lamp_axis[i].w, 0.0, 1.0);
        float reach = cone * cone * mix(1.0, clamp(1.0 - fade * fade, 0.0, 1.0) / square, u_lamp_place[i].w);
        vec3 light = u_lamp_color[i].rgb * (reach * max(dot(normal, to_lamp), 0.0));
        float shine = max(dot(normal, normalize(to_eye + to_lamp)), 0.0);
        shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
        sum += light * (color + 0.5 * gloss * shine);
    }
    return sum;
}

const vec3 c_mirrored_sun = vec3(0.4865, 0.49985, 0.53395); // a little whiter

vec3 shade(vec3 world, vec3 normal, vec3 color, float gloss) {
    vec3 to_eye = towards_viewer(world);
    float facing = max(dot(normal, u_to_light), 0.0);
    float lit = facing > 0.0 ? lit_fraction(world, normal) : 0.0;
    vec3 sun = u_sun * (facing * lit);
    vec3 around = mix(vec3(0.22, 0.21, 0.20), vec3(0.36, 0.43, 0.54), 0.5 + 0.5 * normal.y);
    float shine = max(dot(normal, normalize(to_eye + u_to_light)), 0.0);
    shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine; // to the 64th
    float edge = 1.0 - max(dot(normal, to_eye), 0.0);
    edge *= edge;
    float up = clamp(0.5 + reflect(-to_eye, normal).y, 0.0, 1.0);
    vec3 mirrored = mix(vec3(0.42, 0.45, 0.47), vec3(0.45, 0.60, 0.76), up);
    return color * (sun + around) +
           gloss * (c_mirrored_sun * sun * shine + mirrored * (0.16 * edge * edge)) +
           shade_by_lamps(world, normal, to_eye, color, gloss);
}

// Narkowicz's fit of the ACES film curve, then the display's own curve (a fit of sRGB by roots, within 0.3 %).
vec3 to_display(vec3 color) {
    color *= 0.80;
    color = clamp(color * (2.51 * color + 0.03) / (color * (2.43 * color + 0.59) + 0.14), 0.0, 1.0);
    vec3 root = sqrt(color), fourth = sqrt(root);
    return clamp(0.585122381 * root + 0.783140355 * fourth - 0.368262736 * sqrt(fourth), 0.0, 1.0);
}

// A pixel and, in alpha, its brightness, by which smoothing finds edges.
vec4 pixel_of(vec3 color) { return vec4(color, dot(color, vec3(0.299, 0.587, 0.114))); }

// How much of a line of a grid with lines at every whole number covers this pixel.
float grid_line(vec2 place, float pixels) {
    vec2 width = max(fwidth(place), vec2(1e-6));
    vec2 line = clamp(0.5 * pixels + 0.5 - abs(fract(place - 0.5) - 0.5) / width, 0.0, 1.0);
    line *= 1.0 - smoothstep(0.15, 0.5, width);
    return max(line.x, line.y);
}
)";

/// Which mesh the body shaders draw.
enum class BodyKind : int { sphere, box, rectangle, capsule, cylinder, facets, surface, terrain, visual, textured };
inline constexpr std::size_t body_kind_count = 10;

/// Goes before a body shader. It is a constant, as software renderers go through both sides of an "if".
inline std::string body_kind(BodyKind kind) { return "const int c_kind = " + std::to_string(int(kind)) + ";\n"; }

inline constexpr const char* body_vertex = R"(
layout(location = 0) in vec3 a_corner;
layout(location = 1) in vec3 a_inset;
layout(location = 2) in vec3 a_normal;
layout(location = 3) in vec4 a_position;  // w: emphasis
layout(location = 4) in vec4 a_rotation;
layout(location = 5) in vec4 a_half_size; // w: pattern
layout(location = 6) in vec4 a_color;
uniform mat4 u_clip_from_world;
uniform vec4 u_viewer; // from where balls are seen: the eye and 1, or the direction towards it or a light and 0
out vec3 v_world;
out vec3 v_normal;       // of balls: the place on the cap, from the center, in radii
out vec3 v_local;        // of balls: the radius
out vec3 v_local_normal; // of boxes: half of the edges
out vec4 v_color;
out float v_pattern;
out vec2 v_texel;        // of what has a texture: the place in it
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

// The direction from a ball's center to a point of the cap that is seen of it: `a_corner` is the way around the cap's
// middle in x and y, and in z how far from there to the rim. From within the ball nothing is seen.
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
uniform float u_grid;
uniform float u_spacing; // of the finer lines of the grid, meters
uniform float u_fade;    // distance at which large surfaces have half become sky, meters
uniform float u_opacity; // 1, or that of ghosts, which are paler, too
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

// Boxes are shaded as if their edges were rounded: within a bevel of an edge the normal leans over it; where the bevel
// is narrower than a pixel, within a pixel and accordingly less.
vec3 box_normal() {
    vec3 size = v_local_normal;
    float bevel = 0.07 * min(size.x, min(size.y, size.z));
    vec3 face = rotate(vec4(-v_rotation.xyz, v_rotation.w), v_normal);
    vec3 width = max(vec3(bevel), fwidth(v_local));
    vec3 lean = sign(v_local) * clamp((abs(v_local) - size) / width + 1.0, 0.0, 1.0) * (bevel / width);
    return rotate(v_rotation, face + lean * (1.0 - abs(face)));
}

// Moves a point of a ball's cap, which is flat between its corners, along the ray onto the ball.
void meet_ball(inout vec3 world, inout vec3 normal) {
    vec3 along = -towards_viewer(world);
    float middle = dot(normal, along), way = sqrt(max(middle * middle + 1.0 - dot(normal, normal), 0.0)) + middle;
    normal -= along * way;
    world -= along * (way * v_local.x);
}

// A grid on whatever side the surface faces most.
float surface_grid(vec3 place, vec3 facing) {
    vec3 size = abs(facing);
    if (size.y >= max(size.x, size.z)) return grid_at(place.xz);
    return size.x > size.z ? grid_at(place.zy) : grid_at(place.xy);
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
    if (c_kind == 9) {
        vec4 texel = texture(u_texture, v_texel);
        if (texel.a < u_alpha_cutoff) discard;
        color *= mix(vec3(1.0), texel.rgb, v_pattern);
    }
    if (c_kind >= 6 && !gl_FrontFacing) { // from behind
        normal = -normal;
        if (c_kind < 8) color *= 0.6;
    }
    vec3 to_eye = towards_viewer(world);
    vec3 shaded = shade(world, normal, color, gloss);
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
    if (c_kind == 9 && texture(u_texture, v_texel).a < u_alpha_cutoff) discard;
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

/// Smooths the steps of edges. Where a pixel differs from its neighbors, the edge between it and the one across is
/// followed both ways to its ends. What a straight edge from end to end would leave of the pixel to the other side is
/// the share that it gets of the color there. (The idea of morphological antialiasing, Reshetov 2009.)
inline constexpr const char* smoothing_fragment = R"(
uniform sampler2D u_picture;
uniform ivec2 u_corner; // of the picture in the window
uniform int u_reach;    // pixels that an edge is followed each way, at most
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
    vec2 ends = vec2(float(u_reach) + 0.5), stops = vec2(0.0); // pixels to the ends; how the mean differs there
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
    // At the nearer end the edge steps to this pixel's side, or away from it.
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

// Edge 4 i + k of a box goes along its axis i from the k-th corner of the face that it begins at.
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
