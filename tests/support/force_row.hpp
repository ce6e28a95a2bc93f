#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::test {

/// Adds peak · sin²(π (n − onset)/width) to the samples n of x within [onset, onset + width]; onset and width in
/// samples.
void add_haversine(std::vector<double>& x, double onset, double width, double peak);

/// Adds the same pulse, filtered by a recorder's linear-phase anti-alias filter, which rings on both sides.
void add_filtered_haversine(std::vector<double>& x, double onset, double width, double peak);

/// Adds Gaussian noise; equal seeds add equal noise.
void add_noise(std::vector<double>& x, double deviation, std::uint64_t seed);

/// x after a first-order high-pass with this time constant, as in an AC-coupled channel.
std::vector<double> ac_coupled(const std::vector<double>& x, double time_constant_samples);

/// A record in memory of these forces, with one acceleration channel of zeros.
acquire::Record force_record(double fs_Hz, const std::vector<std::vector<double>>& force_N);

}  // namespace percuss::test
