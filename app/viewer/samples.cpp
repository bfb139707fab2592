#include "viewer/samples.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace cairn::viewer {

namespace {

using enum Quantity;
constexpr Quantity energies[] = {kinetic_energy,  potential_energy, lost_to_friction,
                                 lost_in_impacts, external_work,    energy_balance};
constexpr Quantity momenta[] = {momentum_x, momentum_y, momentum_z};
constexpr Quantity angular_momenta[] = {angular_momentum_x, angular_momentum_y, angular_momentum_z};
constexpr Quantity places[] = {body_x, body_y, body_z};
constexpr Quantity velocities[] = {body_velocity_x, body_velocity_y, body_velocity_z, body_speed};
constexpr Quantity turnings[] = {body_turning_x, body_turning_y, body_turning_z};
constexpr Quantity body_energies[] = {body_kinetic_energy};
constexpr Quantity forces[] = {body_contact_force};
constexpr PlotGroup groups[] = {{"energy", energies, false},
                                {"momentum", momenta, false},
                                {"angular momentum about the origin", angular_momenta, false},
                                {"position of the body", places, true},
                                {"velocity of the body", velocities, true},
                                {"angular velocity of the body", turnings, true},
                                {"kinetic energy of the body", body_energies, true},
                                {"contact forces on the body", forces, true}};

// Sum of the magnitudes of the normal forces.
double contact_force(const World& world, BodyId body, double step_length) {
    double impulse = 0.0;
    for (const Contact& contact : world.contacts(body))
        for (int i = 0; i < contact.point_count; ++i) impulse += double(contact.points[i].normal_impulse);
    return impulse / step_length;
}

std::string unit_of(Quantity quantity) {
    const std::string name = name_of(quantity);
    return name.substr(name.rfind(',') + 2);
}

} // namespace

const char* name_of(Quantity quantity) {
    constexpr const char* names[quantity_count] = {"kinetic energy, J",
                                                   "potential energy, J",
                                                   "total energy, J",
                                                   "lost to friction, J",
                                                   "lost in impacts, J",
                                                   "brought in, J",
                                                   "all but what was brought in, J",
                                                   "momentum x, kg m/s",
                                                   "momentum y, kg m/s",
                                                   "momentum z, kg m/s",
                                                   "angular momentum x, kg m2/s",
                                                   "angular momentum y, kg m2/s",
                                                   "angular momentum z, kg m2/s",
                                                   "x, m",
                                                   "y, m",
                                                   "z, m",
                                                   "velocity x, m/s",
                                                   "velocity y, m/s",
                                                   "velocity z, m/s",
                                                   "speed, m/s",
                                                   "angular velocity x, rad/s",
                                                   "angular velocity y, rad/s",
                                                   "angular velocity z, rad/s",
                                                   "kinetic energy of the body, J",
                                                   "sum of normal forces, N"};
    return names[std::size_t(quantity)];
}

Sample measure(const World& world, BodyId id, std::uint64_t step, double step_length, const EnergyFlow& flow) {
    Sample sample;
    sample.step = step;
    sample.body = id;
    sample.time = world.time();
    auto& values = sample.values;
    const auto set = [&values](Quantity first, const auto& vector) {
        for (int i = 0; i < 3; ++i) values[std::size_t(first) + std::size_t(i)] = double(vector[i]);
    };
    values[std::size_t(kinetic_energy)] = world.kinetic_energy();
    values[std::size_t(potential_energy)] = world.potential_energy();
    values[std::size_t(total_energy)] = values[0] + values[1];
    values[std::size_t(lost_to_friction)] = flow.friction;
    values[std::size_t(lost_in_impacts)] = flow.impacts;
    values[std::size_t(external_work)] = flow.external_work;
    values[std::size_t(energy_balance)] =
        values[std::size_t(total_energy)] + flow.friction + flow.impacts - flow.external_work;
    set(momentum_x, world.linear_momentum());
    set(angular_momentum_x, world.angular_momentum());
    if (!id || !world.is_valid(id)) {
        std::fill(values.begin() + int(body_x), values.end(), std::numeric_limits<double>::quiet_NaN());
        return sample;
    }
    const Body body = world.body(id);
    set(body_x, body.center_of_mass());
    set(body_velocity_x, body.linear_velocity());
    values[std::size_t(body_speed)] = double(glm::length(body.linear_velocity()));
    set(body_turning_x, body.angular_velocity());
    values[std::size_t(body_kinetic_energy)] = body.kinetic_energy();
    values[std::size_t(body_contact_force)] = contact_force(world, id, step_length);
    return sample;
}

EnergyFlow flow_of(const Sample& sample) {
    return {sample.values[std::size_t(lost_to_friction)], sample.values[std::size_t(lost_in_impacts)],
            sample.values[std::size_t(external_work)]};
}

void SampleLog::add(const Sample& sample) {
    while (size_ > 0 && last_step() >= sample.step) {
        if (open_.empty()) {
            open_ = *full_.back();
            full_.pop_back();
        }
        open_.pop_back();
        --size_;
    }
    open_.push_back(sample);
    ++size_;
    if (open_.size() < chunk_size) return;
    full_.push_back(std::make_shared<const Chunk>(std::move(open_)));
    open_.clear();
    if (full_.size() <= most_chunks) return;
    size_ -= full_.front()->size();
    full_.erase(full_.begin());
}

void SampleLog::clear() {
    full_.clear();
    open_.clear();
    size_ = 0;
}

const Sample& SampleLog::operator[](std::size_t i) const {
    const std::size_t chunk = i / chunk_size;
    return chunk < full_.size() ? (*full_[chunk])[i % chunk_size] : open_[i - full_.size() * chunk_size];
}

const Sample* SampleLog::at(std::uint64_t step) const {
    std::size_t low = 0, high = size_;
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        (*this)[middle].step < step ? low = middle + 1 : high = middle;
    }
    return low < size_ && (*this)[low].step == step ? &(*this)[low] : nullptr;
}

std::span<const PlotGroup> plot_groups() { return groups; }

Chart sample_chart(const SampleLog& samples, const PlotGroup& group, double seconds, BodyId body,
                   const std::string& name, std::optional<Quantity> against) {
    Chart chart;
    chart.title = group.name + (group.is_of_body && !name.empty() ? " " + name : std::string());
    chart.x_label = against ? name_of(*against) : "time, s";
    chart.y_label = unit_of(group.quantities.front());
    const double from = samples.is_empty() ? 0.0 : samples[samples.size() - 1].time - seconds;
    std::size_t color = 0;
    for (const Quantity quantity : group.quantities) {
        const std::string title = name_of(quantity);
        Curve curve;
        curve.label = title.substr(0, title.rfind(','));
        curve.color = chart_colors[color++ % std::size(chart_colors)];
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Sample& sample = samples[i];
            if (sample.time < from) continue;
            const auto value = [&](Quantity which) {
                return which >= body_x && sample.body != body ? std::numeric_limits<double>::quiet_NaN()
                                                              : sample.values[std::size_t(which)];
            };
            curve.x.push_back(against ? value(*against) : sample.time);
            curve.y.push_back(value(quantity));
        }
        chart.curves.push_back(std::move(curve));
    }
    return chart;
}

} // namespace cairn::viewer
