#include "world/state_check.h"

#include "contacts/pairs.h"
#include "core/sound.h"
#include "islands/coloring.h"
#include "state/joint_links.h"
#include "world/character_rules.h"

#include <cmath>
#include <optional>

namespace cairn {

namespace {

// Runs in linear time. Linked lists are verified in both directions, so that a list cannot loop.
class StateCheck final : PairReader {
  public:
    explicit StateCheck(State& s)
        : s_(s), bodies_(s.bodies), shapes_(s.shapes), contacts_(s.contacts), islands_(s.islands), joints_(s.joints),
          body_count_(s.bodies.slots.size()), shape_count_(s.shapes.slots.size()) {}

    void run() {
        check_sizes();
        check_bodies();
        check_islands();
        check_shapes();
        check_characters();
        check_joints();
        pair_of_.assign(contacts_.info.size(), {no_shape, no_shape});
        s_.broad_phase.check(shape_count_, *this);
        check_contacts();
        require_count("contacts.pairs", pairs_, groups_and_pairs_);
        check_whereabouts();
        check_counts();
    }

  private:
    // Contact and joint counts and used colors of a body, recomputed to be compared with its links.
    static constexpr int shape_classes = 2 * (int(ShapeType::height_field) + 1);
    struct Counted {
        std::int32_t contacts = 0, joints = 0;
        std::uint64_t colors = 0, joint_colors = 0;
    };

    bool is_body(std::int32_t b) const { return std::uint32_t(b) < body_count_; }
    bool is_live_body(std::int32_t b) const { return bodies_.slots.is_live(std::uint32_t(b)); }

    void check_sizes() const {
        for (const std::size_t size :
             {bodies_.motion.size(), bodies_.forces.size(), bodies_.links.size(), bodies_.counted.size(),
              bodies_.travel.size(), bodies_.ahead.size(), bodies_.boxes_until.size()})
            require_count("bodies", size, body_count_);
        require_count("shapes.links", shapes_.links.size(), shape_count_);
        require_count("shapes.poses", shapes_.poses.size(), shape_count_);
        require_count("contacts.records", contacts_.records.places(), contacts_.info.size());
        require_count("contacts.separation_budgets", contacts_.separation_budgets.size(), contacts_.info.size());
    }

    void check_bodies() const {
        for (std::size_t i = 0; i < body_count_; ++i) {
            const BodyMotion& m = bodies_.motion[i];
            const double sum = (m.x.x + m.x.y + m.x.z) + double(m.v.x + m.v.y + m.v.z) + double(m.w.x + m.w.y + m.w.z) +
                               double(m.turned.x + m.turned.y + m.turned.z + m.turned.w) +
                               double(m.v_rest.x + m.v_rest.y + m.v_rest.z) +
                               double(m.w_rest.x + m.w_rest.y + m.w_rest.z);
            const double square = m.q.x * m.q.x + m.q.y * m.q.y + m.q.z * m.q.z + m.q.w * m.q.w;
            require_sound(std::isfinite(sum), {"bodies", i, "motion"}, 0, "must be finite");
            require_sound(square > 0.5 && square < 2, {"bodies", i, "rotation"}, 0, "must be a unit quaternion");
            const BodyLinks& links = bodies_.links[i];
            require_sound(links.radius >= 0 && links.inner_radius >= 0, {"bodies", i, "radius"}, 0,
                          "must be 0 or more");
        }
        for (std::size_t k = 0; k < bodies_.pushed.size(); ++k)
            require_sound(is_body(bodies_.pushed[k]), {"bodies.pushed", k}, bodies_.pushed[k], "must be a body");
    }

    void check_characters() const {
        std::int32_t last = none;
        for (std::size_t i = 0; i < s_.characters.all.size(); ++i) {
            const Character& c = s_.characters.all[i];
            require_sound(c.body > last && is_body(c.body) && is_live_body(c.body) &&
                              bodies_.settings[c.body].own_type == BodyType::kinematic,
                          {"characters", i, "body"}, c.body, "must be a kinematic body behind that of the one before");
            last = c.body;
            const std::int32_t ground = c.ground_shape;
            require_sound(c.ground_body == none ? ground == none
                                                : is_body(c.ground_body) && is_live_body(c.ground_body) &&
                                                      std::uint32_t(ground) < shape_count_ &&
                                                      shapes_.slots.is_live(std::uint32_t(ground)) &&
                                                      shapes_.links[ground].body == c.ground_body,
                          {"characters", i, "ground_shape"}, ground, "must be a shape of its ground");
            require_sound(c.support <= CharacterSupport::ground, {"characters", i, "support"}, int(c.support),
                          "must be one of the enumerators");
            require_sound(is_sound_character(c), {"characters", i}, 0, "must be as `Body::set_character` lets it be");
        }
    }

    void check_island_list(std::int32_t i) {
        const Island& island = islands_.all[std::size_t(i)];
        std::int32_t last = none, count = 0;
        for (std::int32_t b = island.first_body; b != none; b = bodies_.links[b].next_in_island) {
            require_sound(is_live_body(b) && bodies_.is_dynamic(b), {"islands", std::size_t(i), "body"}, b,
                          "must be a dynamic body");
            const BodyLinks& links = bodies_.links[b];
            require_sound(links.island == i && links.previous_in_island == last,
                          {"bodies", std::size_t(b), "previous_in_island"}, links.previous_in_island,
                          "must be the one before it in its island");
            last = b;
            ++count;
        }
        require_sound(island.last_body == last, {"islands", std::size_t(i), "last_body"}, island.last_body,
                      "must be the last of its bodies");
        require_sound(island.body_count == count && count > 0, {"islands", std::size_t(i), "body_count"},
                      island.body_count, "must be how many bodies it has");
        in_islands_ += std::size_t(count);
    }

    void check_islands() {
        const std::size_t count = islands_.all.size();
        key_wakes_.assign(count, 0);
        std::size_t in_use = 0, awake = 0, falling = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Island& island = islands_.all[i];
            require_sound(island.in_use <= 1, {"islands", i, "in_use"}, island.in_use, "must be 0 or 1");
            in_use += island.in_use, awake += island.position != none;
            if (!island.in_use) {
                require_sound(island.position == none, {"islands", i, "position"}, island.position,
                              "must be none, -1, of an island that is not in use");
                continue;
            }
            check_island_list(std::int32_t(i));
            falling += island.position == none && island.key == none;
            require_sound(island.key == none || (island.key == std::int32_t(i) && island.position == none),
                          {"islands", i, "key"}, island.key, "must be none, -1, or of what sleeps its own number");
        }
        require_count("islands.awake", islands_.awake.size(), awake);
        for (std::size_t k = 0; k < islands_.awake.size(); ++k) {
            const std::int32_t i = islands_.awake[k];
            require_sound(std::uint32_t(i) < count && islands_.all[i].position == std::int32_t(k), {"islands.awake", k},
                          i, "must be an island that has this place");
        }
        std::vector<std::uint8_t> listed(count);
        require_count("islands.free", islands_.free.size(), count - in_use);
        require_count("islands.falling_asleep", islands_.falling_asleep.size(), falling);
        for (std::size_t k = 0; k < islands_.free.size(); ++k) {
            const std::int32_t i = islands_.free[k];
            require_sound(std::uint32_t(i) < count && !islands_.all[i].in_use && !listed[std::size_t(i)],
                          {"islands.free", k}, i, "must be an island that is not in use, once");
            listed[std::size_t(i)] = 1;
        }
        for (std::size_t k = 0; k < islands_.falling_asleep.size(); ++k) {
            const std::int32_t i = islands_.falling_asleep[k];
            require_sound(std::uint32_t(i) < count && !listed[std::size_t(i)] && islands_.all[i].position == none &&
                              islands_.all[i].key == none,
                          {"islands.falling_asleep", k}, i, "must be an island that falls asleep, once");
            listed[std::size_t(i)] = 1;
        }
        for (std::size_t k = 0; k < islands_.waking.size(); ++k) {
            const std::int32_t key = islands_.waking[k];
            require_sound(std::uint32_t(key) < count, {"islands.waking", k}, key, "must be the number of an island");
            key_wakes_[std::size_t(key)] = 1;
        }
        for (std::size_t k = 0; k < islands_.sleep_requests.size(); ++k)
            require_sound(is_body(islands_.sleep_requests[k]), {"islands.sleep_requests", k},
                          islands_.sleep_requests[k], "must be a body");
    }

    void check_shapes() const {
        std::size_t live_dynamic = 0, listed = 0;
        for (std::size_t i = 0; i < body_count_; ++i) {
            if (!is_live_body(std::int32_t(i))) continue;
            const BodyLinks& links = bodies_.links[i];
            const bool is_dynamic = bodies_.is_dynamic(std::int32_t(i));
            live_dynamic += is_dynamic;
            require_sound(is_dynamic || links.island == none, {"bodies", i, "island"}, links.island,
                          "must be none, -1, of a body that is not dynamic");
            std::int32_t last = none;
            for (std::int32_t k = links.first_shape; k != none; k = shapes_.links[k].next, ++listed) {
                require_sound(shapes_.slots.is_live(std::uint32_t(k)), {"bodies", i, "shape"}, k, "must be a shape");
                const ShapeLinks& shape = shapes_.links[k];
                require_sound(shape.body == std::int32_t(i) && shape.previous == last,
                              {"shapes", std::size_t(k), "previous"}, shape.previous,
                              "must be the one before it of its body");
                require_sound(!is_dynamic || !is_surface(shapes_.geometry[k].type), {"shapes", std::size_t(k), "type"},
                              int(shapes_.geometry[k].type), "must have mass on a dynamic body");
                last = k;
            }
            require_sound(links.last_shape == last, {"bodies", i, "last_shape"}, links.last_shape,
                          "must be the last of its shapes");
        }
        require_count("islands.bodies", in_islands_, live_dynamic);
        require_count("shapes.listed", listed, shapes_.slots.live_count());
        for (std::size_t i = 0; i < shape_count_; ++i) {
            const ShapeLinks& links = shapes_.links[i];
            const ShapePose& p = shapes_.poses[i];
            require_sound(is_body(links.body), {"shapes", i, "body"}, links.body, "must be a body");
            float sum = links.arm.x + links.arm.y + links.arm.z;
            for (int k = 0; k < 4; ++k) sum += 0 * (p.high[k] + p.low[k]) + 0 * (p.q[k] + p.size[k]);
            require_sound(std::isfinite(sum), {"shapes", i, "pose"}, 0, "must be finite");
        }
    }

    void check_joint(std::size_t i) {
        const JointInfo& joint = joints_.info[i];
        for (const std::int32_t b : {joint.body_a, joint.body_b})
            require_sound(b == none || is_live_body(b), {"joints", i, "body"}, b, "must be a body, or none, -1");
        require_sound(joint.body_a != joint.body_b, {"joints", i, "body_b"}, joint.body_b,
                      "must be another one than body_a");
        const JointLocks& rules = joint.rules;
        require_sound(rules.point <= JointLock::full && rules.turn <= JointLock::full, {"joints", i, "lock"},
                      std::int64_t(std::max(rules.point, rules.turn)), "must be 0 to 2");
        require_sound(rules.point_column <= 2 && rules.turn_column <= 2, {"joints", i, "column"},
                      std::max(rules.point_column, rules.turn_column), "must be 0 to 2");
        require_sound(rules.axis_count <= max_joint_axes, {"joints", i, "axis_count"}, rules.axis_count,
                      "must be 0 to 8");
        require_sound(joint.enabled <= 1, {"joints", i, "enabled"}, joint.enabled, "must be 0 or 1");
        require_sound(joint.solver <= std::uint8_t(JointSolver::direct), {"joints", i, "solver"}, joint.solver,
                      "must be 0 to 2");
        ends_ += std::size_t(joint.body_a != none) + std::size_t(joint.body_b != none);
        const std::int32_t owner = joint_owner(bodies_, joint);
        require_color("joints", i, joint.color, owner != none, is_moved(joint.body_a) && is_moved(joint.body_b));
        if (owner == none) return;
        ++joints_of_island_[std::size_t(bodies_.links[owner].island)];
        for (const std::int32_t b : {joint.body_a, joint.body_b}) {
            if (!is_moved(b)) continue;
            Counted& counted = counted_[std::size_t(b)];
            ++counted.joints;
            take_color("joints", i, joint.color, counted.joint_colors);
            require_sound(bodies_.links[b].island == bodies_.links[owner].island, {"joints", i, "body"}, b,
                          "must be in the same island as the other one");
        }
    }
    bool is_moved(std::int32_t b) const { return b != none && bodies_.is_dynamic(b); }

    // Checks the color of a contact or joint: a valid graph color if it is solved, else no_color.
    static void require_color(const char* list, std::size_t at, std::uint8_t color, bool is_solved, bool both_move) {
        const bool is_of_those =
            color == overflow_color ||
            (both_move ? color < first_fixed_color : color >= first_fixed_color && color < overflow_color);
        require_sound(is_solved ? is_of_those : color == no_color, {list, at, "color"}, color,
                      is_solved ? "must be that of what is solved" : "must be 255: it is not solved");
    }
    static void take_color(const char* list, std::size_t at, std::uint8_t color, std::uint64_t& colors) {
        if (color >= overflow_color) return;
        const std::uint64_t bit = std::uint64_t(1) << color;
        require_sound((colors & bit) == 0, {list, at, "color"}, color, "must not be that of another one of its body");
        colors |= bit;
    }

    void check_joints() {
        counted_.resize(body_count_);
        joints_of_island_.resize(islands_.all.size());
        for (std::size_t i = 0; i < joints_.info.size(); ++i) {
            const bool in_use = joints_.info[i].in_use;
            require_sound(in_use == joints_.slots.is_live(std::uint32_t(i)), {"joints", i, "in_use"}, in_use,
                          "must be as its slot is");
            if (in_use) check_joint(i);
        }
        std::size_t ends = 0;
        for (std::size_t i = 0; i < body_count_; ++i) {
            if (!is_live_body(std::int32_t(i))) continue;
            std::int32_t last = none;
            for (std::int32_t end = bodies_.links[i].first_joint; end != none; ++ends) {
                require_sound(std::uint32_t(end) / 2 < joints_.info.size() && joints_.info[end / 2].in_use,
                              {"bodies", i, "joint"}, end, "must be an end of a joint");
                const JointInfo& joint = joints_.info[end / 2];
                require_sound((end % 2 == 0 ? joint.body_a : joint.body_b) == std::int32_t(i) &&
                                  joint.previous[end % 2] == last,
                              {"joints", std::size_t(end / 2), "previous"}, joint.previous[end % 2],
                              "must be the one before it of its body");
                last = end;
                end = joint.next[end % 2];
            }
            require_sound(bodies_.links[i].last_joint == last, {"bodies", i, "last_joint"}, bodies_.links[i].last_joint,
                          "must be the last of its joints");
        }
        require_count("joints.ends", ends, ends_);
        for (std::size_t i = 0; i < islands_.all.size(); ++i)
            require_sound(!islands_.all[i].in_use || islands_.all[i].joint_count == joints_of_island_[i],
                          {"islands", i, "joint_count"}, islands_.all[i].joint_count, "must be how many joints it has");
    }

    void check_contact(std::size_t id) {
        const ContactInfo& c = contacts_.info[id];
        const SnapshotPlace shape_place{"contacts", id, "shape"}, body_place{"contacts", id, "body"};
        require_sound(c.shape_a < shape_count_, shape_place, c.shape_a, "must be a shape");
        require_sound(c.shape_b < shape_count_, shape_place, c.shape_b, "must be a shape");
        require_sound(c.body_a == shapes_.links[c.shape_a].body, body_place, c.body_a, "must be that of shape_a");
        require_sound(c.body_b == shapes_.links[c.shape_b].body && c.body_b != c.body_a, body_place, c.body_b,
                      "must be that of shape_b, and another one than body_a");
        const bool b_moves = bodies_.is_dynamic(c.body_b);
        const auto is_static = [&](std::int32_t b) { return bodies_.settings[b].type == BodyType::static_; };
        require_sound(bodies_.is_dynamic(c.body_a) ||
                          (c.is_trigger && !b_moves && !(is_static(c.body_a) && is_static(c.body_b))),
                      body_place, c.body_a, "must be dynamic, or one of a trigger's kinematic");
        require_sound(c.b_moves == b_moves, {"contacts", id, "b_moves"}, c.b_moves, "must be as its body is");
        require_sound(c.flipped <= 1 && c.bounces <= 1 && c.is_conveyor <= (b_moves ? 0 : 1),
                      {"contacts", id, "is_conveyor"}, c.is_conveyor, "must be 0 or 1, as its other flags");
        require_sound(c.point_count <= 4, {"contacts", id, "point_count"}, c.point_count, "must be 0 to 4");
        const bool is_solved = c.point_count > 0 && !is_group(c), is_patch = c.kind == PairKind::patch;
        require_color("contacts", id, c.color, is_solved, b_moves);
        const std::size_t materials = is_patch ? surface_materials(shapes_.data[c.shape_b]).size() : 0;
        require_sound(c.surface_material <= materials, {"contacts", id, "surface_material"}, c.surface_material,
                      "must be 0, or of a patch the number of a material of its surface");
        if (!is_patch) {
            require_sound(kind_of(c.shape_a, c.shape_b) == c.kind, {"contacts", id, "kind"}, int(c.kind),
                          "must be that of its shapes");
            const ShapePair pair = pair_of_[id];
            require_sound((c.shape_a == pair.a && c.shape_b == pair.b) || (c.shape_a == pair.b && c.shape_b == pair.a),
                          shape_place, c.shape_a, "must be those of its pair in the broad phase");
            const SeparationBudget& answer = contacts_.separation_budgets[id];
            require_sound(answer.body_a == c.body_a && answer.body_b == c.body_b,
                          {"contacts.separation_budgets", id, "body"}, answer.body_a, "must be those of the contact");
            ++groups_and_pairs_;
        }
        if (!is_solved) return;
        Counted &a = counted_[std::size_t(c.body_a)], &b = counted_[std::size_t(c.body_b)];
        ++a.contacts, ++b.contacts;
        take_color("contacts", id, c.color, a.colors);
        if (!b_moves) return;
        take_color("contacts", id, c.color, b.colors);
        require_sound(bodies_.links[c.body_a].island == bodies_.links[c.body_b].island || !is_live_body(c.body_a) ||
                          !is_live_body(c.body_b),
                      body_place, c.body_b, "must be in the island of body_a");
    }

    void check_patches(std::size_t id) {
        const ContactInfo& group = contacts_.info[id];
        for (std::int32_t p = group.related; p != none; p = contacts_.info[p].next, ++patches_) {
            require_sound(std::uint32_t(p) < contacts_.info.size() && !seen_[std::size_t(p)], {"contacts", id, "patch"},
                          p, "must be a patch of this group alone");
            seen_[std::size_t(p)] = 1;
            const ContactInfo& patch = contacts_.info[p];
            require_sound(patch.in_use && patch.kind == PairKind::patch && patch.related == std::int32_t(id) &&
                              patch.shape_a == group.shape_a && patch.shape_b == group.shape_b,
                          {"contacts", std::size_t(p), "related"}, patch.related, "must be its group");
        }
        const int expected = group.related == none ? 0 : 1;
        require_sound(group.is_trigger || group.point_count <= expected, {"contacts", id, "point_count"},
                      group.point_count, "must be 0 of a group without patches, else 0 or 1");
    }

    void check_contacts() {
        const std::size_t count = contacts_.info.size();
        seen_.assign(count, 0);
        classify_shapes();
        std::size_t in_use = 0, patches = 0;
        for (std::size_t id = 0; id < count; ++id) {
            const ContactInfo& c = contacts_.info[id];
            require_sound(c.in_use <= 1, {"contacts", id, "in_use"}, c.in_use, "must be 0 or 1");
            if (!c.in_use) continue;
            ++in_use;
            check_contact(id);
            if (is_group(c)) check_patches(id);
            patches += c.kind == PairKind::patch;
        }
        require_count("contacts.patches", patches_, patches);
        require_count("contacts.free", contacts_.free.size(), count - in_use);
        for (std::size_t k = 0; k < contacts_.free.size(); ++k) {
            const std::uint32_t id = contacts_.free[k];
            require_sound(id < count && !contacts_.info[id].in_use && !seen_[id], {"contacts.free", k}, id,
                          "must be a contact that is not in use, once");
            seen_[id] = 1;
        }
    }

    // Each contact that is not a patch belongs to exactly one pair. The pairs are recorded first, as they come in no
    // particular order.
    struct ShapePair {
        std::uint32_t a, b;
    };
    static constexpr std::uint32_t no_shape = 0xffffffff;
    void pair(std::uint32_t shape_a, std::uint32_t shape_b, std::uint32_t contact) override {
        require_sound(contact < pair_of_.size() && pair_of_[contact].a == no_shape,
                      {"broad_phase.pairs", pairs_, "contact"}, contact, "must be a contact that no other pair has");
        pair_of_[contact] = {shape_a, shape_b};
        ++pairs_;
    }

    // The kind of a pair follows from the shape types and from whether wide kernels support the shapes, except for a
    // small shape on the curved side of a large one. Cached by shape class.
    PairKind kind_of(std::uint32_t shape_a, std::uint32_t shape_b) {
        if (rests_on_round_side(shapes_.geometry[shape_a], shapes_.geometry[shape_b])) return PairKind::convex_convex;
        const std::uint8_t a = class_of_[shape_a], b = class_of_[shape_b];
        std::optional<PairKind>& known = kinds_[a][b];
        bool swapped = false;
        if (!known) known = pair_kind(shapes_.geometry[shape_a], shapes_.geometry[shape_b], swapped);
        return known.value_or(PairKind::patch); // two surfaces, which have no pair kind
    }
    void classify_shapes() {
        class_of_.resize(shape_count_);
        for (std::size_t i = 0; i < shape_count_; ++i) {
            const Geometry& g = shapes_.geometry[i];
            class_of_[i] = std::uint8_t(2 * int(g.type) + (has_wide_kernels(g) ? 1 : 0));
        }
    }

    // Checks that the broad phase lists each shape according to the state of its body.
    void check_whereabouts() const {
        using Whereabouts = BroadPhase::State;
        for (std::uint32_t i = 0; i < shape_count_; ++i) {
            const Whereabouts where = s_.broad_phase.state_of(i);
            const SnapshotPlace place{"broad_phase.proxies", i, "state"};
            if (!shapes_.slots.is_live(i)) {
                require_sound(where == Whereabouts::none || where == Whereabouts::removed, place, int(where),
                              "must be 0 or 5 of a shape that is no more");
                continue;
            }
            const std::int32_t body = shapes_.links[i].body;
            const bool is_plane = shapes_.geometry[i].type == ShapeType::plane;
            const BodyType type = bodies_.settings[body].type;
            if (!bodies_.is_enabled(body)) {
                require_sound(where == Whereabouts::none, place, int(where), "must be 0 of a body that is disabled");
                continue;
            }
            if (type != BodyType::dynamic) {
                require_sound(where == (is_plane                    ? Whereabouts::plane
                                        : type == BodyType::static_ ? Whereabouts::fixed
                                                                    : Whereabouts::awake),
                              place, int(where), "must be as its body and geometry are");
                continue;
            }
            const std::int32_t key = islands_.all[bodies_.links[body].island].key;
            if (where == Whereabouts::sleeping) {
                const std::uint32_t own = s_.broad_phase.sleeping_key(i);
                require_sound(own < islands_.all.size() && (key == std::int32_t(own) || key_wakes_[own]), place, own,
                              "must sleep under the key of its island, or one that wakes");
            } else {
                require_sound(where == Whereabouts::awake && key == none, place, int(where),
                              "must be awake or sleeping as its island is");
            }
        }
    }

    void check_counts() const {
        for (std::size_t i = 0; i < body_count_; ++i) {
            const BodyLinks& links = bodies_.links[i];
            const Counted& counted = counted_[i];
            if (!is_live_body(std::int32_t(i))) continue;
            require_sound(links.contact_count == counted.contacts, {"bodies", i, "contact_count"}, links.contact_count,
                          "must be how many contacts it has that are solved");
            require_sound(links.joint_count == counted.joints, {"bodies", i, "joint_count"}, links.joint_count,
                          "must be how many joints it has that are solved");
            if (!bodies_.is_dynamic(std::int32_t(i))) continue;
            require_sound(links.colors == counted.colors, {"bodies", i, "colors"}, std::int64_t(links.colors),
                          "must be those of its contacts");
            require_sound(links.joint_colors == counted.joint_colors, {"bodies", i, "joint_colors"},
                          std::int64_t(links.joint_colors), "must be those of its joints");
        }
    }

    State& s_;
    const Bodies& bodies_;
    const Shapes& shapes_;
    const Contacts& contacts_;
    const Islands& islands_;
    const Joints& joints_;
    const std::size_t body_count_, shape_count_;
    std::size_t in_islands_ = 0, ends_ = 0, patches_ = 0, pairs_ = 0, groups_and_pairs_ = 0;
    std::vector<std::uint8_t> key_wakes_; // by island: whether the broad phase has yet to be told that it is awake
    std::vector<std::uint8_t> seen_;      // by contact
    std::vector<ShapePair> pair_of_;      // by contact
    std::vector<std::uint8_t> class_of_;  // by shape
    std::optional<PairKind> kinds_[shape_classes][shape_classes];
    std::vector<std::int32_t> joints_of_island_; // by island
    std::vector<Counted> counted_;               // by body
};

} // namespace

void check_state(State& state) { StateCheck(state).run(); }

} // namespace cairn
