// Spectra of the hits, without the ringing of earlier blows.
#include <algorithm>
#include <cmath>

#include "core/parallel/parallel.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::pipeline {
namespace {

// The first poles are fitted to responses that still contain the ringing of earlier blows. Strong ringing biases these
// poles, and then also the ringing that is extrapolated with them. Both are computed again until the poles stand still.
constexpr int kRingingPasses = 8;
constexpr double kStrongRinging = 3e-3;  // of the largest response
constexpr double kStill = 0.2;           // standard deviations of a pole

bool stand_still(const std::vector<identify::Mode>& before, const std::vector<identify::Mode>& now) {
  return std::equal(before.begin(), before.end(), now.begin(), now.end(),
                    [](const identify::Mode& a, const identify::Mode& b) {
                      return std::abs(a.pole.freq_Hz - b.pole.freq_Hz) < kStill * b.freq_std_Hz &&
                             std::abs(a.pole.damping_ratio - b.pole.damping_ratio) < kStill * b.damping_std;
                    });
}

bool rings_strongly(const std::vector<EarlierRinging>& ringing) {
  return std::any_of(ringing.begin(), ringing.end(),
                     [](const EarlierRinging& one) { return one.share > kStrongRinging; });
}

}  // namespace

TestSpectra Analysis::measured_spectra() const {
  return {.lines = lines(),
          .hits = hits(),
          .force = force_spectra(),
          .responses = responses(),
          .window_decay_per_s = window_decay_per_s()};
}

const std::vector<EarlierRinging>& Analysis::earlier_ringing() const {
  return within_budget(budget_, earlier_ringing_, [&] {
    if (given_frfs() != nullptr || !may_ring_at_hits(hits())) return std::vector<EarlierRinging>{};
    const TestSpectra from = measured_spectra();
    const ThreadLimit limit(options_.threads);
    FirstModes first{.frfs = source_->dataset(from, accepted_hits(from.hits), nullptr), .modes = {}};
    first.modes = trace_.run("modes", [&] { return identify::identify_modes(first.frfs, all_modes()); });
    std::vector<EarlierRinging> ringing = trace_.run(
        "earlier ringing", [&] { return find_earlier_ringing(aligned_record(), first.frfs, from, first.modes); });
    std::vector<identify::Mode> known = first.modes;
    if (ringing.empty()) first_modes_ = std::move(first);
    for (int pass = 1; pass < kRingingPasses && rings_strongly(ringing); ++pass) {
      const HitResponses settled = without_ringing(responses(), ringing, hits(), transform_options(lines()));
      const TestSpectra quiet{.lines = from.lines,
                              .hits = from.hits,
                              .force = from.force,
                              .responses = settled,
                              .window_decay_per_s = from.window_decay_per_s};
      const identify::FrfDataset set = source_->dataset(quiet, accepted_hits(quiet.hits), nullptr);
      auto modes = trace_.run("modes", [&] { return identify::identify_modes(set, all_modes()); });
      ringing = trace_.run("earlier ringing", [&] { return find_earlier_ringing(aligned_record(), set, from, modes); });
      if (stand_still(known, modes)) break;
      known = std::move(modes);
    }
    return ringing;
  });
}

TestSpectra Analysis::spectra() const {
  if (earlier_ringing().empty()) return measured_spectra();
  const HitResponses& settled = within_budget(budget_, settled_responses_, [&] {
    return without_ringing(responses(), earlier_ringing(), hits(), transform_options(lines()));
  });
  return {.lines = lines(),
          .hits = hits(),
          .force = force_spectra(),
          .responses = settled,
          .window_decay_per_s = window_decay_per_s()};
}

}  // namespace percuss::pipeline
