#pragma once
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/model/mode.hpp"

namespace percuss::test {

/// A mode with one residue. `half_power_Hz` is its half-power bandwidth.
identify::Mode mode_at(double freq_Hz, double half_power_Hz, Complex residue);

/// Hits of one point whose average has a strong mode at 431 Hz, alike in all hits, and a weak one whose phase advances
/// by `turns` full turns from hit to hit. Each hit is a force of one sample, 1 N, and its FRF has a little noise. The
/// lines are 1 Hz apart, from 10 to 990 Hz.
class HitsWithPhases {
 public:
  HitsWithPhases(const identify::Mode& weak, std::size_t hits, double turns);
  HitsWithPhases(const HitsWithPhases&) = delete;
  HitsWithPhases& operator=(const HitsWithPhases&) = delete;

  identify::FrfDataset set;          // the average
  identify::HitFrfs frfs;            // refers to spectra_
  identify::Mode strong, weak_mean;  // of the average

 private:
  std::vector<std::vector<Complex>> spectra_;
};

}  // namespace percuss::test
