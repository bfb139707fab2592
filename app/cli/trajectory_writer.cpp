#include "cli/trajectory_writer.h"

#include <fmt/format.h>

#include <iterator>

namespace cairn::cli {

namespace {

// RFC 4180: in quotes, with quotes inside doubled.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

} // namespace

TrajectoryWriter::TrajectoryWriter(const std::filesystem::path& path, const World& world)
    : file_(path), bodies_(world.bodies()) {
    for (const BodyId id : bodies_) names_.push_back(quoted(world.body(id).name()));
    file_.write("time,body,name,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n");
}

void TrajectoryWriter::add(const World& world) {
    fmt::memory_buffer lines;
    const double time = world.time();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Body body = world.body(bodies_[i]);
        const Position p = body.position();
        const Quat q = body.rotation();
        const Vec3 v = body.linear_velocity(), w = body.angular_velocity();
        fmt::format_to(std::back_inserter(lines), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", time, i,
                       names_[i], p.x, p.y, p.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z);
    }
    file_.write({lines.data(), lines.size()});
}

void TrajectoryWriter::close() { file_.close(); }

} // namespace cairn::cli
