#pragma once
#include <cstddef>
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/hits/residue_ratios.hpp"
#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// The residues of a mode in one hit.
struct ModeInHit {
  std::size_t point = 0;                       // index into the points of the data set
  std::size_t hit = 0;                         // index into the hits
  double power = 0;                            // |F|² at the mode's frequency: the weight of the hit in an average
  double relative_std = 0;                     // relative error that all residues share, from the noise of the force
  std::vector<identify::HitResidue> residues;  // [channels] HitResidue::residue is the index in Mode::residues
};

/// The modes' residues in each hit, at the poles of the test: [modes][hits]. The residues of `modes` carry indices of
/// points, and the modes ascend in frequency.
std::vector<std::vector<ModeInHit>> modes_in_hits(const identify::FrfDataset& set, const identify::HitFrfs& hits,
                                                  const std::vector<identify::Mode>& modes);

}  // namespace percuss::pipeline
