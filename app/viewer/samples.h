/// \file samples.h
/// Samples of energies, momenta and quantities of one body, step by step, for plots.
#pragma once

#include "viewer/chart.h"
#include "viewer/energy_balance.h"

#include <cairn/world.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cairn::viewer {

/// The sampled quantities, in the order of `Sample::values`.
enum class Quantity {
    kinetic_energy,
    potential_energy,
    total_energy,
    lost_to_friction, // since sampling began
    lost_in_impacts,
    external_work,
    energy_balance,
    momentum_x,
    momentum_y,
    momentum_z,
    angular_momentum_x,
    angular_momentum_y,
    angular_momentum_z,
    body_x, // from here on: of the sampled body
    body_y,
    body_z,
    body_velocity_x,
    body_velocity_y,
    body_velocity_z,
    body_speed,
    body_turning_x,
    body_turning_y,
    body_turning_z,
    body_kinetic_energy,
    body_contact_force,
};
inline constexpr int quantity_count = 25;
const char* name_of(Quantity quantity); ///< With its unit.

struct Sample {
    std::uint64_t step = 0;
    BodyId body;                                 ///< The sampled body.
    double time = 0.0;                           ///< s
    std::array<double, quantity_count> values{}; ///< Quantities of a body are NaN if there is none.
};

/// `body`: null for none. `flow`: accumulated since sampling began.
Sample measure(const World& world, BodyId body, std::uint64_t step, double step_length, const EnergyFlow& flow = {});
/// The energy flow of a sample.
EnergyFlow flow_of(const Sample& sample);

/// Samples by step. A copy is cheap: full chunks are shared and immutable.
class SampleLog {
  public:
    /// Adds a sample; it replaces those of the same and later steps.
    void add(const Sample& sample);
    void clear();
    bool is_empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    const Sample& operator[](std::size_t i) const;
    /// Null if that step was not sampled.
    const Sample* at(std::uint64_t step) const;
    std::uint64_t last_step() const { return (*this)[size_ - 1].step; }

  private:
    static constexpr std::size_t chunk_size = 256, most_chunks = 256;
    using Chunk = std::vector<Sample>;
    std::vector<std::shared_ptr<const Chunk>> full_;
    Chunk open_;
    std::size_t size_ = 0;
};

/// Quantities that are plotted together.
struct PlotGroup {
    const char* name;
    std::span<const Quantity> quantities;
    bool is_of_body;
};
std::span<const PlotGroup> plot_groups();

/// The last `seconds` of the samples as a chart; all samples for infinity. `body`, `name`: the body whose quantities
/// are shown. `against`: the quantity on the x axis instead of time.
Chart sample_chart(const SampleLog& samples, const PlotGroup& group, double seconds, BodyId body,
                   const std::string& name, std::optional<Quantity> against = std::nullopt);

} // namespace cairn::viewer
