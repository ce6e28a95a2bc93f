#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "acquire/hits/further_force.hpp"
#include "acquire/hits/hits.hpp"

namespace percuss::acquire {

/// Copies the pulse with its tail, and the contacts within the hit except spikes, into the hit's gate. The gate is zero
/// between them. `x` are the samples of the hit; `further` was found in samples that begin `offset` earlier.
void gate_force(Hit& hit, std::span<const double> x, const Gate& pulse, const FurtherForce& further,
                std::size_t offset);

/// Ratio of the second contact to the main one. The second contact lowers the spectrum by at most this fraction.
inline constexpr double kMaxSecondContact = 0.05;

/// Adds `double_hit` for the largest of the contacts.
void grade_second_pulse(Hit& hit, const std::vector<SecondPulse>& contacts, double fs_Hz);

/// Adds `no_pulse` where the force still rings 25 to 50 ms after its peak or has not returned to its rest: a response
/// in the place of the force. The limit against the pulse is wider, for the undershoot of an AC-coupled channel. `x`
/// are the samples of the hit, `peak` the index of its peak.
void grade_lasting_force(Hit& hit, std::span<const double> x, std::size_t peak, double fs_Hz);

}  // namespace percuss::acquire
