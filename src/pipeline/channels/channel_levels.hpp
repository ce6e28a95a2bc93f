#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// Two channels, compared by the residues of the modes that both show clearly.
struct ChannelPair {
  std::size_t first = 0, second = 0;
  std::vector<std::size_t> modes;  // indices of the modes
  double ratio = 0;                // median magnitude of the second's residues over the first's
  double spread = 1;               // largest over smallest of these magnitudes
  double correlation = 0;          // of the residues, each pair normalised: 1 the same motion, −1 the opposite motion
};

/// The first channel with every other one. A channel with fewer than four modes in common is left out.
std::vector<ChannelPair> compare_channels(const std::vector<identify::Mode>& modes, std::size_t channels);

/// The largest velocity that a mode has just after a hit, in m/s: |residue| · |F| at its frequency, the root mean
/// square over the hits. 0 where the force is not known.
double largest_velocity_mps(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes);

}  // namespace percuss::pipeline
