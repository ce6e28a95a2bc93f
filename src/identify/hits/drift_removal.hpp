#pragma once
#include <optional>
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// The drift that the modes have in common, as a temperature causes it: the relative change of every frequency per hit.
/// Nothing if fewer than three modes drift, or if less than three quarters of the drifting modes drift alike (within a
/// fifth).
std::optional<DriftTrend> common_drift(const std::vector<Mode>& modes);

/// The FRFs and single hits as they would be if no frequency changed from hit to hit. `hits` refers to `spectra`.
struct SteadyTest {
  FrfDataset set;
  HitFrfs hits;
  std::vector<std::vector<Complex>> spectra;  // [channels of hits.set][lines] of the responses
};

/// Takes a drift out of a test: each hit's FRFs change by the difference between the modes with the mean poles and with
/// the poles of that hit. The frequencies are then those of the middle of the test.
/// change_per_hit  relative, of all frequencies. theory (4.32)
SteadyTest without_drift(const FrfDataset& set, const HitFrfs& hits, const std::vector<Mode>& modes,
                         double change_per_hit);

/// Gives each mode the drift, and a standard deviation of at least the spread of its frequency over `hits` hits. The
/// scatter between hits is taken from the nearest mode of `before`, within a half-power bandwidth.
void describe_common_drift(const DriftTrend& drift, std::size_t hits, const std::vector<Mode>& before,
                           std::vector<Mode>& modes);

}  // namespace percuss::identify
