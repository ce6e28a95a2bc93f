#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::test {

/// Adds peak · sin²(π (n − onset)/width) to the samples n of x within [onset, onset + width]; onset and width in
/// samples.
void add_haversine(std::vector<double>& x, double onset, double width, double peak);

/// Adds the pulse as a recorder's linear-phase anti-alias filter passes it: with ringing on both sides.
void add_filtered_haversine(std::vector<double>& x, double onset, double width, double peak);

/// Adds Gaussian noise; equal seeds add equal noise.
void add_noise(std::vector<double>& x, double deviation, std::uint64_t seed);

/// x through a first-order high-pass of this time constant, as an AC-coupled channel shows it.
std::vector<double> ac_coupled(const std::vector<double>& x, double time_constant_samples);

/// A record in memory of these forces, with one acceleration channel that reads zero.
acquire::Record force_record(double fs_Hz, const std::vector<std::vector<double>>& force_N);

}  // namespace percuss::test
