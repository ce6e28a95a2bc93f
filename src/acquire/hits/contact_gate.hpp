#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "acquire/hits/further_force.hpp"
#include "acquire/hits/hits.hpp"

namespace percuss::acquire {

/// Fills hit.gated_N: the pulse with its tail, and the further contacts within the hit, without spikes; zero between
/// them. `x` are the samples of the hit. The indices in `further` count from `offset` samples before x[0].
void gate_force(Hit& hit, std::span<const double> x, const Gate& pulse, const FurtherForce& further,
                std::size_t offset);

/// A second contact whose peak exceeds this fraction of the main peak rejects the hit. Up to this ratio, it lowers the
/// spectrum of the force by at most the same fraction.
inline constexpr double kMaxSecondContact = 0.05;

/// Adds `double_hit` for the largest of the contacts.
void grade_second_pulse(Hit& hit, const std::vector<SecondPulse>& contacts, double fs_Hz);

/// Adds `no_pulse` where the force still rings 25 to 50 ms after its peak, or has not returned to its rest level by
/// then: the channel is probably a response. The limit for a level of the opposite sign is wider, because an AC-coupled
/// channel undershoots. `x` are the samples of the hit, `peak` the index of its peak.
void grade_lasting_force(Hit& hit, std::span<const double> x, std::size_t peak, double fs_Hz);

}  // namespace percuss::acquire
