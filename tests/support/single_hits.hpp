#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "identify/fit/joint_fit.hpp"
#include "identify/hits/hit_frfs.hpp"

namespace percuss::test {

/// The hits of a test of one channel, with equal forces, and their average at each point. Lines from 200 to 450 Hz.
struct SingleHits {
  identify::FrfDataset set;
  identify::HitFrfs frfs;
  std::vector<std::vector<Complex>> spectra;

  /// `add` adds the modes of a hit. noise  standard deviation of each hit's FRF
  SingleHits(std::size_t points, std::size_t hits_per_point, double noise,
             const std::function<void(identify::FrfDataset& one, std::size_t point, std::size_t hit)>& add);

  /// Modes with the poles and residues of a fit of `set`.
  std::vector<identify::Mode> modes(const identify::JointFit& fit) const;
  /// Modes with these poles.
  std::vector<identify::Mode> modes(const std::vector<identify::Pole>& poles) const;
};

}  // namespace percuss::test
