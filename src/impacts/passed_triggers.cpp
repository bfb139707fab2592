#include "impacts/passed_triggers.h"

#include "impacts/meeting_points.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace cairn {

using math::DVec3;

namespace {

// The path of a body through the step, in consecutive pieces.
class PiecewisePath {
  public:
    PiecewisePath(const Movers& movers, std::span<const PathPiece> pieces, std::int32_t body)
        : mover_(movers.of_body(body)), rest_(movers.path_of(body)) {
        const auto [first, last] =
            std::equal_range(pieces.begin(), pieces.end(), PathPiece{mover_, {}, 0},
                             [](const PathPiece& a, const PathPiece& b) { return a.mover < b.mover; });
        if (mover_ != none) pieces_ = {first, last};
    }
    std::span<const PathPiece> pieces() const { return pieces_; }
    // The pose at a time, on the first piece that extends to the time `up_to`.
    RigidPath::Pose at(double time, double up_to) const {
        if (mover_ == none) return rest_.at(time);
        for (const PathPiece& piece : pieces_)
            if (up_to <= piece.until) return piece.path.at(time);
        return pieces_.back().path.at(pieces_.back().until); // the body has stopped
    }
    // The path between two times as a path of its own, parametrized from 0 to 1, or reversed. No piece ends between the
    // two times.
    RigidPath between(double from, double to, DVec3 origin, bool backwards) const {
        RigidPath::Pose first = at(from, to), last = at(to, to);
        if (backwards) std::swap(first, last);
        return RigidPath::between(first.x - origin, first.q, last.x - origin, last.q);
    }

  private:
    std::int32_t mover_;
    RigidPath rest_;
    std::span<const PathPiece> pieces_;
};

struct TriggerPassage {
    std::uint32_t trigger, other;
    bool inside;
    double time; // 0 to 1
};

class PassedTriggers {
  public:
    PassedTriggers(const Bodies& bodies, const Shapes& shapes, const Movers& movers, SweepScratch& scratch,
                   NarrowBatch& narrow, float dt)
        : bodies_(bodies), shapes_(shapes), movers_(movers), scratch_(scratch), narrow_(narrow), dt_(dt) {}

    void report(StepEvents& events) {
        std::vector<NearTrigger>& near = scratch_.near_triggers;
        const auto shapes_of = [](const NearTrigger& t) { return std::tie(t.trigger, t.other); };
        std::sort(near.begin(), near.end(),
                  [&](const NearTrigger& a, const NearTrigger& b) { return shapes_of(a) < shapes_of(b); });
        near.erase(
            std::unique(near.begin(), near.end(),
                        [&](const NearTrigger& a, const NearTrigger& b) { return shapes_of(a) == shapes_of(b); }),
            near.end());
        complete_pieces();
        for (const NearTrigger& t : near) list_passages(t);
        std::stable_sort(passages_.begin(), passages_.end(),
                         [](const TriggerPassage& a, const TriggerPassage& b) { return a.time < b.time; });
        for (const TriggerPassage& p : passages_)
            events.triggers.next.push_back({shapes_.slots.id(p.trigger), shapes_.slots.id(p.other),
                                            bodies_.id(body_of(p.trigger)), bodies_.id(body_of(p.other)), p.inside,
                                            dt_ * float(p.time)});
    }

  private:
    std::int32_t body_of(std::uint32_t shape) const { return shapes_.links[shape].body; }

    // Appends the last piece of each mover that is needed, and groups the pieces by mover.
    void complete_pieces() {
        std::vector<std::int32_t>& asked = scratch_.asked;
        asked.clear();
        for (const NearTrigger& t : scratch_.near_triggers)
            for (const std::uint32_t shape : {t.trigger, t.other})
                if (const std::int32_t i = movers_.of_body(body_of(shape)); i != none) asked.push_back(i);
        std::sort(asked.begin(), asked.end());
        asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
        for (const std::int32_t i : asked)
            scratch_.pieces.push_back({i, movers_[i].path, std::min(movers_[i].until, movers_[i].path.until)});
        std::stable_sort(scratch_.pieces.begin(), scratch_.pieces.end(),
                         [](const PathPiece& a, const PathPiece& b) { return a.mover < b.mover; });
    }

    SweptShape swept(std::uint32_t shape, const RigidPath& path) const {
        const Geometry& g = shapes_.geometry[shape];
        return {g, shapes_.data[shape], math::to_double(g.position - bodies_.mass[body_of(shape)].center), path};
    }
    // The first time at which the two overlap between two times, or the last one, which is the first on the reversed
    // path; `never`: they do not overlap.
    double time_of_overlap(const NearTrigger& t, const PiecewisePath& own, const PiecewisePath& other, double from,
                           double to, bool last) const {
        const DVec3 origin = own.between(from, to, {}, last).start;
        const RigidPath path = own.between(from, to, origin, last), of_other = other.between(from, to, origin, last);
        const bool is_first = !is_surface(shapes_.geometry[t.trigger].type); // the first argument must not be a surface
        const SweptShape trigger = swept(t.trigger, path), body = swept(t.other, of_other);
        const Nearness found = is_first ? nearness_of(trigger, body, 0, {}) : nearness_of(body, trigger, 0, {});
        if (found.distance > 0) return never;
        return from + (last ? 1 - found.time : found.time) * (to - from);
    }
    // Whether the two overlap by the test of the narrow phase.
    bool is_inside(const NearTrigger& t, const RigidPath::Pose& at, const RigidPath::Pose& other) const {
        std::vector<ImpactPoint>& points = scratch_.points;
        points.clear();
        find_meeting_points(bodies_, shapes_, t.trigger, {at.x, at.q, {}, {}}, t.other, {other.x, other.q, {}, {}},
                            other.x - at.x, narrow_, points);
        return std::any_of(points.begin(), points.end(), [](const ImpactPoint& p) { return p.depth >= 0; });
    }
    // Lists each entry and exit; none if the two overlap at the start or end of the step, as the narrow phase reports
    // that.
    void list_passages(const NearTrigger& t) {
        const PiecewisePath own(movers_, scratch_.pieces, body_of(t.trigger)),
            other(movers_, scratch_.pieces, body_of(t.other));
        if (is_inside(t, own.at(0, 0), other.at(0, 0)) || is_inside(t, own.at(1, 1), other.at(1, 1))) return;
        std::vector<double> times{0, 1};
        for (const PiecewisePath* w : {&own, &other})
            for (const PathPiece& piece : w->pieces()) times.push_back(std::min(piece.until, 1.0));
        std::sort(times.begin(), times.end());
        times.erase(std::unique(times.begin(), times.end()), times.end());
        bool inside = false; // at the end of the previous piece
        for (std::size_t i = 1; i < times.size(); ++i) {
            const double begin = times[i - 1], end = times[i];
            double time = begin;
            if (!inside) {
                time = time_of_overlap(t, own, other, begin, end, false);
                if (time > 1) continue;
                passages_.push_back({t.trigger, t.other, true, time});
            }
            inside = is_inside(t, own.at(end, end), other.at(end, end));
            if (inside) continue;
            const double left = time_of_overlap(t, own, other, begin, end, true);
            passages_.push_back({t.trigger, t.other, false, left > 1 ? time : std::max(time, left)});
        }
    }

    const Bodies& bodies_;
    const Shapes& shapes_;
    const Movers& movers_;
    SweepScratch& scratch_;
    NarrowBatch& narrow_; // working memory of the pair test
    const float dt_;
    std::vector<TriggerPassage> passages_;
};

} // namespace

void report_passed_triggers(const Bodies& bodies, const Shapes& shapes, const Movers& movers, SweepScratch& scratch,
                            NarrowBatch& narrow, StepEvents& events, float dt) {
    if (!scratch.near_triggers.empty()) PassedTriggers(bodies, shapes, movers, scratch, narrow, dt).report(events);
    scratch.near_triggers.clear(), scratch.pieces.clear();
}

} // namespace cairn
