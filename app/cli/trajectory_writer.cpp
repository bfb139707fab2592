#include "cli/trajectory_writer.h"

#include <cairn/error.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <iterator>
#include <system_error>

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
    : path_(path), temporary_(path), bodies_(world.bodies()) {
    temporary_ += ".partial";
    if (std::filesystem::is_directory(path_)) throw Error(ErrorCode::io, path_.string(), {}, "is a folder, not a file");
    file_ = std::fopen(temporary_.c_str(), "wb");
    if (file_ == nullptr) {
        throw Error(ErrorCode::io, path_.string(), {}, std::string("cannot be written: ") + std::strerror(errno));
    }
    for (const BodyId id : bodies_) names_.push_back(quoted(world.body(id).name()));
    write("time,body,name,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n");
}

TrajectoryWriter::~TrajectoryWriter() {
    if (file_ == nullptr) return;
    std::fclose(file_);
    std::error_code code;
    std::filesystem::remove(temporary_, code);
}

void TrajectoryWriter::write(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
        throw Error(ErrorCode::io, path_.string(), {}, std::string("cannot be written: ") + std::strerror(errno));
    }
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
    write(fmt::to_string(lines));
}

void TrajectoryWriter::close() {
    const bool closed = std::fclose(file_) == 0;
    file_ = nullptr;
    std::error_code code;
    if (closed) std::filesystem::rename(temporary_, path_, code);
    if (!closed || code) {
        const std::string reason = closed ? code.message() : std::strerror(errno);
        std::filesystem::remove(temporary_, code);
        throw Error(ErrorCode::io, path_.string(), {}, "cannot be written: " + reason);
    }
}

} // namespace cairn::cli
