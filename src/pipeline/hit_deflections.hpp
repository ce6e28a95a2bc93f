#pragma once
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "metrics/deflection/deflection.hpp"
#include "pipeline/impact_test.hpp"

namespace percuss::pipeline {

/// The impacts of a test, and which of them have a deflection.
struct TestImpacts {
  std::vector<AnalysedHit> all;
  std::vector<std::size_t> used;  // indices into `all`
  // [all] samples in which an acceleration is clipped; zeros for the modal method, which does not integrate them
  std::vector<std::size_t> clipped_samples;
  std::vector<bool> moving;    // [used] whether the structure moves before the impact (moves_before())
  bool rest_recorded = false;  // before each used impact (rest_recorded())
};

/// The modes by which a channel responds to an impact at a point: {point, channel}.
using PlaceModes = std::map<std::pair<int, std::size_t>, std::vector<metrics::ModalContribution>>;

/// The modes for each point and channel of the used impacts. Empty lists where the method does not need modes: then no
/// mode is identified. The automatic method needs them where no rest is recorded or the structure moves.
/// errors  InputError: the modal method, and no mode is known at the point of an impact.
PlaceModes modes_for_deflections(const Analysis& analysis, const TestImpacts& impacts,
                                 const metrics::DeflectionOptions& options);

/// The deflections, used impact by used impact, channel by channel, without positions. They are computed from the
/// record of Analysis::closed_gaps().
std::vector<DeflectedHit> hit_deflections(const Analysis& analysis, const TestImpacts& impacts, const PlaceModes& modes,
                                          const ImpactTestOptions& options);

}  // namespace percuss::pipeline
