#include "viewer/solver_view.h"

#include "viewer/palette.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace cairn::viewer {

namespace {

constexpr std::size_t most_strokes = 40000;
constexpr float longest = 0.14f;     // length of the arrow of the greatest force, as a share of the camera's distance
constexpr float cone_height = 0.05f; // share of the camera's distance
constexpr float second = 0.25f;      // s; a velocity arrow spans the motion in this time
// Linear; distinguishable for color-blind viewers too.
const Vec3 force_color(1.0f, 0.62f, 0.08f), friction_color(0.15f, 0.55f, 1.0f), sliding_color(1.0f, 0.20f, 0.10f);
const Vec3 velocity_color(0.25f, 0.85f, 0.45f), turning_color(0.85f, 0.30f, 0.70f), bound_color(0.45f, 0.60f, 0.75f);
const Vec3 link_color(0.75f, 0.80f, 0.25f), joint_link_color(0.30f, 0.65f, 1.0f);

constexpr SolverPart parts[] = {
    {"contacts and forces", &SolverShown::contacts,
     "Dots: contact points. Orange arrows: normal forces on moving bodies; blue: friction. Their lengths are "
     "proportional to the square root of the force. If a body is selected, only forces on it are shown.",
     "guide/queries_and_events.md"},
    {"friction cones", &SolverShown::cones,
     "The contact force stays within the friction cone of half angle atan(mu). Blue: sticking. Red: the force is on "
     "the cone, the contact slides.",
     "decisions/friction.md"},
    {"velocities", &SolverShown::velocities,
     "Green: the distance that the center of mass moves in 0.25 s. Purple: the axis of rotation, by the right-hand "
     "rule.",
     "solver.md"},
    {"bounding boxes", &SolverShown::bounds,
     "The broad phase finds the pairs of shapes whose bounding boxes overlap; only these are tested further.",
     "decisions/fat_boxes.md"},
    {"tree of the broad phase", &SolverShown::tree,
     "The broad phase finds these pairs with trees: a box contains up to eight smaller boxes, down to those of single "
     "shapes. Static, awake, large and sleeping shapes have trees of their own. If a body is selected, only the boxes "
     "on the path to it are shown.",
     "decisions/fat_boxes.md"},
    {"axes of inertia", &SolverShown::axes,
     "Semi-axes of the ellipsoid with the same mass and inertia. The moment of inertia is least about the longest "
     "axis; rotation about the intermediate axis is unstable.",
     "decisions/free_rotation.md"},
    {"islands", &SolverShown::islands,
     "Lines connect bodies that are solved together: yellow by contacts, blue by joints. All bodies of an island fall "
     "asleep together.",
     "decisions/sleep.md"},
    {"substeps of islands", &SolverShown::substeps,
     "Colors show the number of substeps of each contact's island: more where light bodies carry heavy loads, as at "
     "the bottom of a high stack.",
     "decisions/substeps.md"},
    {"colors of contacts", &SolverShown::colors,
     "Contacts of one color share no dynamic body, so that they are solved in parallel. Colors are solved one after "
     "the other, contacts with static bodies last.",
     "solver.md"},
    {"Minkowski difference and GJK", &SolverShown::difference,
     "For the selected body and the nearest convex shape: all differences between points of the two shapes. The white "
     "dot, at the center of the other shape, is the origin: if it is inside, the shapes overlap. Orange: the final "
     "simplex of the GJK algorithm; red: the shortest distance.",
     "shapes.md"},
};

float combined(float a, float b, CombineRule rule) {
    switch (rule) {
    case CombineRule::average:
        return 0.5f * (a + b);
    case CombineRule::minimum:
        return std::min(a, b);
    case CombineRule::maximum:
        return std::max(a, b);
    case CombineRule::multiply:
        break;
    }
    return a * b;
}

// Combined as in the engine: the rule of lower number applies, and static friction is at least dynamic friction.
float static_friction(const Material& a, const Material& b) {
    const CombineRule rule = std::min(a.friction_combine, b.friction_combine);
    return std::max(combined(a.static_friction, b.static_friction, rule),
                    combined(a.dynamic_friction, b.dynamic_friction, rule));
}

void read_contacts(SolverView& view, const World& world, float per_second, BodyId selected) {
    const bool is_of_one = selected && world.is_valid(selected);
    for (const Contact& contact : is_of_one ? world.contacts(selected) : world.contacts()) {
        float sum = 0.0f;
        for (int i = 0; i < contact.point_count; ++i) sum += contact.points[i].normal_impulse;
        const float coefficient =
            static_friction(world.shape_def(contact.shape_a).material, world.shape_def(contact.shape_b).material);
        // Shows the force on the selected body, else on the dynamic body, and of two dynamic bodies on the upper one,
        // which the lower one supports.
        const auto moves = [&](BodyId body) { return world.body(body).type() == BodyType::dynamic; };
        const bool on_b = is_of_one ? contact.body_b == selected
                                    : moves(contact.body_b) && (!moves(contact.body_a) || contact.normal.y >= 0.0f);
        const float sign = on_b ? 1.0f : -1.0f;
        for (int i = 0; i < contact.point_count; ++i) {
            const ContactPoint& point = contact.points[i];
            const float share = sum > 0.0f ? point.normal_impulse / sum : 1.0f / float(contact.point_count);
            view.points.push_back({point.point, contact.normal * sign, point.normal_impulse * per_second,
                                   contact.friction_impulse * (sign * share * per_second), coefficient});
        }
    }
}

void read_movers(SolverView& view, const World& world) {
    for (const BodyId id : world.bodies()) {
        const Body body = world.body(id);
        if (body.type() != BodyType::dynamic) continue;
        const MassProperties mass = body.mass_properties();
        SolverView::Mover mover{body.center_of_mass(), body.linear_velocity(), body.angular_velocity(),
                                body.rotation() * mass.inertia_orientation, Vec3(0.0f)};
        // Solid ellipsoid: I_x = m (b^2 + c^2) / 5.
        const Vec3 moments = mass.inertia_diagonal;
        const float sum = 0.5f * (moments.x + moments.y + moments.z);
        for (int i = 0; i < 3; ++i)
            if (std::isfinite(mass.mass))
                mover.half_axes[i] = std::sqrt(std::max(5.0f * (sum - moments[i]) / mass.mass, 0.0f));
        view.movers.push_back(mover);
    }
}

void read_links(SolverView& view, const World& world) {
    const auto link = [&](BodyId a, BodyId b, bool is_joint) {
        if (!a || !b || world.body(a).type() != BodyType::dynamic || world.body(b).type() != BodyType::dynamic) return;
        view.links.push_back({world.body(a).center_of_mass(), world.body(b).center_of_mass(), is_joint});
    };
    for (const Contact& contact : world.contacts()) link(contact.body_a, contact.body_b, false);
    for (const JointId joint : world.joints()) link(world.joint_def(joint).body_a, world.joint_def(joint).body_b, true);
}

void read_order(SolverView& view, const World& world, BodyId selected) {
    const std::vector<SolverContact> order = world.solver_contacts();
    const std::vector<Contact> contacts = world.contacts();
    const bool is_of_one = selected && world.is_valid(selected);
    const auto center = [&](BodyId body) {
        const bool moves = world.body(body).type() == BodyType::dynamic;
        return moves ? std::optional(world.body(body).center_of_mass()) : std::nullopt;
    };
    for (std::size_t i = 0; i < order.size(); ++i) {
        const SolverContact& one = order[i];
        if (is_of_one && one.body_a != selected && one.body_b != selected) continue;
        Position sum(0.0);
        for (int k = 0; k < contacts[i].point_count; ++k) sum += contacts[i].points[k].point;
        view.solved.push_back(
            {sum / double(contacts[i].point_count), center(one.body_a), center(one.body_b), one.color, one.substeps});
    }
}

// Whether bounds are finite; boxes of infinite shapes cannot be drawn.
bool has_end(const Bounds& bounds) {
    constexpr double far = 1e6; // m
    for (int i = 0; i < 3; ++i)
        if (!(bounds.min[i] > -far && bounds.max[i] < far)) return false;
    return true;
}

void read_tree(SolverView& view, const World& world, int depth, BodyId selected) {
    constexpr int every = std::numeric_limits<int>::max();
    const bool is_of_one = selected && world.is_valid(selected);
    std::vector<BroadPhaseNode> nodes = world.broad_phase_nodes(is_of_one ? every : depth, every);
    if (is_of_one) {
        std::vector<char> is_above(nodes.size());
        for (std::size_t i = nodes.size(); i-- > 0;) { // children follow their parents
            is_above[i] |= char(nodes[i].is_leaf && world.body_of(nodes[i].shape) == selected);
            if (is_above[i] && nodes[i].parent >= 0) is_above[std::size_t(nodes[i].parent)] = 1;
        }
        std::size_t at = 0;
        std::erase_if(nodes, [&](const BroadPhaseNode& node) { return !is_above[at++] || node.depth > depth; });
    }
    std::erase_if(nodes, [](const BroadPhaseNode& node) { return !has_end(node.bounds); });
    view.nodes = std::move(nodes);
}

// Draws arrows and other marks, relative to the frame's origin.
class Pen {
  public:
    explicit Pen(RenderFrame& frame)
        : frame_(frame),
          scale_(lens_of(frame.camera) * float(glm::length(frame.camera.position - frame.camera.target))) {}

    float scale() const { return scale_; }
    Vec3 at(const Position& place) const { return Vec3(place - frame_.origin); }
    void line(const Vec3& from, const Vec3& to, const Vec3& color, float width) {
        if (frame_.strokes.size() < most_strokes) frame_.strokes.push_back({from, to, color, width});
    }
    void arrow(const Vec3& from, const Vec3& way, const Vec3& color, float width = 2.5f) {
        const float length = glm::length(way);
        if (!(length > 1e-4f * scale_)) return;
        const Vec3 to = from + way, along = way / length;
        line(from, to, color, width);
        const Vec3 side =
            std::abs(along.y) < 0.9f ? glm::cross(along, Vec3(0, 1, 0)) : glm::cross(along, Vec3(1, 0, 0));
        const float head = std::min(0.3f * length, 0.012f * scale_);
        for (const float sign : {-1.0f, 1.0f}) line(to, to - along * head + side * (0.6f * sign * head), color, width);
    }
    // A cone with its apex at `tip`.
    void cone(const Vec3& tip, const Vec3& axis, float half_angle, const Vec3& color) {
        constexpr int sides = 12;
        const Vec3 other = std::abs(axis.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
        const Vec3 u = glm::normalize(glm::cross(axis, other)), v = glm::cross(axis, u);
        const float height = cone_height * scale_ * std::cos(half_angle),
                    radius = cone_height * scale_ * std::sin(half_angle);
        const auto rim = [&](int i) {
            const float angle = 6.2831853f * float(i) / sides;
            return tip + axis * height + (u * std::cos(angle) + v * std::sin(angle)) * radius;
        };
        for (int i = 0; i < sides; ++i) {
            line(rim(i), rim(i + 1), color, 1.2f);
            if (i % 3 == 0) line(tip, rim(i), color, 0.8f);
            frame_.veils.push_back({tip, rim(i), rim(i + 1), color});
        }
    }

  private:
    RenderFrame& frame_;
    float scale_;
};

void draw_points(Pen& pen, const SolverView& view) {
    float greatest = 0.0f;
    for (const SolverView::Point& point : view.points) greatest = std::max(greatest, point.normal_force);
    const auto arrow_of = [&](const Vec3& force) {
        const float size = glm::length(force);
        return size > 0.0f && greatest > 0.0f ? force * (longest * pen.scale() * std::sqrt(size / greatest) / size)
                                              : Vec3(0.0f);
    };
    for (const SolverView::Point& point : view.points) {
        const Vec3 at = pen.at(point.place);
        if (view.shown.contacts) {
            pen.line(at, at, force_color, 6.0f);
            pen.arrow(at, arrow_of(point.normal * point.normal_force), force_color);
            pen.arrow(at, arrow_of(point.friction), friction_color);
        }
        if (!view.shown.cones || point.normal_force <= 0.0f) continue;
        constexpr float nearly = 0.97f; // share of the friction limit
        const bool slides = glm::length(point.friction) >= nearly * point.coefficient * point.normal_force;
        pen.cone(at, point.normal, std::atan(point.coefficient), slides ? sliding_color : friction_color);
    }
}

void draw_box(Pen& pen, const Bounds& bounds, const Vec3& color, float width) {
    const auto corner = [&](int i) {
        return pen.at({i & 1 ? bounds.max.x : bounds.min.x, i & 2 ? bounds.max.y : bounds.min.y,
                       i & 4 ? bounds.max.z : bounds.min.z});
    };
    for (int i = 0; i < 8; ++i)
        for (const int axis : {1, 2, 4})
            if (!(i & axis)) pen.line(corner(i), corner(i | axis), color, width);
}

// Bounding boxes of shapes and of broad-phase tree nodes.
void draw_boxes(RenderFrame& frame, Pen& pen, const SolverView& view) {
    const bool are_wide = view.bounds.size() + view.nodes.size() <= max_wide_boxes;
    const auto draw = [&](const Bounds& bounds, const Vec3& color, float width) {
        if (are_wide)
            draw_box(pen, bounds, color, width);
        else
            frame.line_boxes.push_back({pen.at(bounds.min), pen.at(bounds.max), color});
    };
    for (const Bounds& bounds : view.bounds) draw(bounds, bound_color, 1.0f);
    for (const BroadPhaseNode& node : view.nodes)
        draw(node.bounds, tree_color(node.depth), node.depth == view.shown.tree_depth ? 2.2f : 1.2f);
}

// If both colors and substeps are shown, the graph colors take precedence.
void draw_order(Pen& pen, const SolverView& view) {
    for (const SolverView::Solved& contact : view.solved) {
        const Vec3 at = pen.at(contact.place);
        const Vec3 color = view.shown.colors ? contact_color(contact.color) : substep_color(contact.substeps);
        pen.line(at, at, color, 7.0f);
        for (const std::optional<Position>& from : {contact.from_a, contact.from_b})
            if (from) pen.line(at, pen.at(*from), color, 2.5f);
    }
}

void draw_difference(RenderFrame& frame, Pen& pen, const PairDifference& difference) {
    const Vec3 origin = pen.at(difference.origin), white(0.95f);
    const auto at = [&](const glm::dvec3& point) { return origin + Vec3(point); };
    for (const auto& [a, b, c] : difference.triangles) {
        const Vec3 corners[] = {origin + difference.points[a], origin + difference.points[b],
                                origin + difference.points[c]};
        frame.veils.push_back({corners[0], corners[1], corners[2], bound_color});
        for (int i = 0; i < 3; ++i) frame.lines.push_back({corners[i], corners[(i + 1) % 3], bound_color});
    }
    const std::vector<glm::dvec3>& simplex = difference.gjk.simplex;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
        pen.line(at(simplex[i]), at(simplex[i]), force_color, 9.0f);
        for (std::size_t k = 0; k < i; ++k) pen.line(at(simplex[i]), at(simplex[k]), force_color, 3.0f);
    }
    pen.line(origin, at(difference.gjk.nearest), sliding_color, 3.0f);
    pen.line(origin, origin, white, 11.0f);
}

} // namespace

std::span<const SolverPart> solver_parts() { return parts; }

// Consecutive depths differ in hue and in lightness.
Vec3 tree_color(int depth) {
    static const Vec3 colors[] = {linear_color(0xf0f0f0), linear_color(0xe6a01e), linear_color(0x3f8fd8),
                                  linear_color(0xf2e25a), linear_color(0xc0507a), linear_color(0x6fd8c8)};
    return colors[std::size_t(depth) % std::size(colors)];
}

Vec3 contact_color(int color) {
    static const Vec3 colors[] = {linear_color(0x3f8fd8), linear_color(0xe6a01e), linear_color(0x6fd8c8),
                                  linear_color(0xc0507a), linear_color(0xf2e25a), linear_color(0x7a5cc8),
                                  linear_color(0xa8d850), linear_color(0xd05838), linear_color(0x9cc8f0),
                                  linear_color(0x2f8a5a)};
    return color < 0 ? linear_color(0xf0f0f0) : colors[std::size_t(color + color / 8) % std::size(colors)];
}

Vec3 substep_color(int substeps) {
    constexpr float most = 32.0f; // beyond which the color stays the same
    return speed_ramp(std::min(std::log2(1.0f + float(substeps)) / std::log2(1.0f + most), 1.0f));
}

std::shared_ptr<const SolverView> read_solver(const World& world, const SolverShown& shown, double step_length,
                                              BodyId selected) {
    if (!shown.any()) return nullptr;
    auto view = std::make_shared<SolverView>();
    view->shown = shown;
    if (shown.contacts || shown.cones) read_contacts(*view, world, float(1.0 / step_length), selected);
    if (shown.velocities || shown.axes) read_movers(*view, world);
    if (shown.islands) read_links(*view, world);
    if (shown.colors || shown.substeps) read_order(*view, world, selected);
    if (shown.bounds)
        for (const BodyId body : world.bodies())
            for (const ShapeId shape : world.body(body).shapes()) {
                const Bounds bounds = world.shape_bounds(shape);
                if (std::isfinite(bounds.min.x) && std::isfinite(bounds.max.x) && std::isfinite(bounds.min.y) &&
                    std::isfinite(bounds.max.y))
                    view->bounds.push_back(bounds);
            }
    if (shown.tree) read_tree(*view, world, shown.tree_depth, selected);
    if (shown.difference) view->difference = nearest_difference(world, selected);
    return view;
}

void draw_solver(RenderFrame& frame, const SolverView& view) {
    Pen pen(frame);
    draw_points(pen, view);
    draw_order(pen, view);
    for (const SolverView::Link& link : view.links)
        pen.line(pen.at(link.a), pen.at(link.b), link.is_joint ? joint_link_color : link_color, 2.0f);
    for (const SolverView::Mover& mover : view.movers) {
        const Vec3 at = pen.at(mover.center);
        if (view.shown.velocities) {
            pen.arrow(at, mover.velocity * second, velocity_color);
            pen.arrow(at, mover.angular_velocity * (0.02f * pen.scale()), turning_color, 1.8f);
        }
        if (!view.shown.axes) continue;
        const Vec3 colors[] = {force_color, velocity_color, friction_color};
        for (int i = 0; i < 3; ++i) {
            Vec3 axis(0.0f);
            axis[i] = mover.half_axes[i];
            const Vec3 half = mover.axes * axis;
            pen.line(at - half, at + half, colors[i], 3.0f);
        }
    }
    draw_boxes(frame, pen, view);
    if (view.difference) draw_difference(frame, pen, *view.difference);
}

} // namespace cairn::viewer
