#pragma once
#include <cstddef>
#include <vector>

#include "metrics/deflection/deflection.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// The results that the warnings of an impact test are made from.
struct DeflectionResults {
  std::size_t without_pulse = 0, impacts = 0;  // hits left out because they show no impact; all hits
  bool rest_recorded = false;                  // every row begins long enough before its impact
  bool free_body = false;                      // as stated by the user
  bool has_force = false;                      // recorded
  bool mass_known = false;                     // the effective mass, as stated by the user
  // Corner of the force channel's AC coupling, where the force shows it and no corner is undone; else 0.
  double coupling_Hz = 0;
  std::vector<std::size_t> moving{};  // hits before which the structure moves
  // Impacts with a clipped acceleration: left out, or used because the user accepts them.
  struct ClippedImpact {
    std::size_t hit = 0, samples = 0;  // at the limit
  };
  std::vector<ClippedImpact> clipped_left_out{}, clipped_used{};
  struct OfHit {
    std::size_t hit = 0;
    const metrics::Deflection* deflection = nullptr;
    double onset_s = 0;  // of the impact, from the first sample of the deflection
    double fs_Hz = 0;
  };
  std::vector<OfHit> deflections{};
};

/// no_pulse, response_clipped, ac_coupling, no_rest, not_at_rest, earlier_ringing, not_told, larger_later, modes_alone,
/// not_free, drift.
std::vector<Warning> deflection_warnings(const DeflectionResults& test);

}  // namespace percuss::pipeline
