#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "identify/identify.hpp"

namespace percuss::pipeline {

/// The parts of a standard deviation of one hit's mode. The misfit of the model is common to all hits and is a part of
/// the mode's standard deviation.
struct HitStdParts {
  double noise = 0;  // of the hit's own fit
  double hits = 0;   // scatter between the hits beyond the noise; 0: not significant
  double total() const;
};

/// A mode fitted to the FRFs of one hit. Its standard deviations are for comparisons between hits.
struct HitMode {
  std::size_t hit = 0;
  std::size_t mode = 0;
  identify::Pole pole;
  HitStdParts freq_std_parts_Hz, damping_std_parts;
};

/// A hit and the number of its point.
struct HitOfPoint {
  std::size_t hit = 0;
  int point = 0;
};

/// Fits the modes of a test to each hit's FRFs. Assigns the modes found to the test's modes, by frequency, damping
/// ratio and the residues at the hit's point. All modes of a hit are assigned together. A mode that the hit does not
/// show has no entry. `dataset_of` gives the FRFs of one hit.
std::vector<HitMode> modes_of_hits(const std::vector<identify::Mode>& modes, const std::vector<HitOfPoint>& hits,
                                   const std::function<identify::FrfDataset(std::size_t hit)>& dataset_of,
                                   identify::Effort effort);

}  // namespace percuss::pipeline
