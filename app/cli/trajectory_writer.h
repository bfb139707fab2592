// The trajectory of a run, as a table.
#pragma once

#include "cli/table_writer.h"

#include <cairn/world.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::cli {

// The quantities of a table, besides the time (s). With any of the first four, the table has a row for each body and
// moment, with the additional columns `body` (index in the list of bodies, from 0) and `name`; else a row for each
// moment. Quantities of the world or of joints are repeated in every row of a moment.
enum class Quantity {
    position,         // px, py, pz: origin of the body, m
    rotation,         // qx, qy, qz, qw: quaternion
    velocity,         // vx, vy, vz: of the center of mass, m/s
    angular_velocity, // wx, wy, wz: rad/s
    energy,           // kinetic, potential: of the world, J
    momentum,         // mx, my, mz: kg m/s; lx, ly, lz: about the origin, kg m^2/s
    contacts,         // contacts, contact_points, max_penetration (m)
    joints, // for each joint NAME: NAME.position (m or rad; position1, ... if it has several), NAME.force_x, ... (N),
            // NAME.torque_x, ... (N m) as in JointState; NaN once the joint is broken
};

std::vector<std::string_view> quantity_names(); // in the order above
// The quantity of that name.
Quantity quantity_of(std::string_view name);
inline const std::vector<Quantity> default_quantities{Quantity::position, Quantity::rotation, Quantity::velocity,
                                                      Quantity::angular_velocity};

// Writes the table in the format of `TableWriter`. All vectors are in world axes.
class TrajectoryWriter {
  public:
    // Throws Error (io). The bodies must exist as long as the table is written. Columns are in the order of `Quantity`.
    // `world`: in its initial state, also if the table is resumed.
    TrajectoryWriter(const std::filesystem::path& path, const World& world, const std::vector<Quantity>& quantities,
                     const TableStart& start = {});

    void add(const World& world);                    // adds a moment; throws Error (io)
    TableExtent extent() { return table_.extent(); } // after the last moment; throws Error (io)
    void close() { table_.close(); }

  private:
    struct Watched {
        JointId joint;
        int positions = 0;
    };
    // Values that every row of a moment repeats.
    struct Shared {
        double kinetic = 0.0, potential = 0.0;
        glm::dvec3 momentum{}, angular_momentum{};
        Statistics statistics;
        std::vector<JointState> joints;
    };
    static std::vector<Column> columns(const World& world, const std::vector<Quantity>& quantities);
    Shared shared(const World& world) const;
    void add_body(const World& world, std::size_t index);
    void add_shared(const Shared& shared);
    bool shows(Quantity quantity) const;

    std::vector<Quantity> quantities_;
    std::vector<BodyId> bodies_; // empty: one row for each moment
    std::vector<std::string> names_;
    std::vector<Watched> joints_;
    TableWriter table_;
};

} // namespace cairn::cli
