#include "pipeline/stages/hit_scatter.hpp"

#include <utility>

#include "identify/hits/hit_scatter.hpp"
#include "pipeline/stages/single_hits.hpp"

namespace percuss::pipeline {
namespace {

using identify::Mode;

// The frequencies of the modes without those that only imitate the scatter of another mode; none where all are genuine.
using Genuine = std::function<std::vector<double>(const std::vector<Mode>&)>;

// A fit of the modes that are left may lose some of them: many weak modes from a search that fits all modes together
// may describe a misfit, and take a clear mode's place. Then the modes found one by one count.
std::vector<Mode> identify_again(const identify::FrfDataset& set, identify::Effort effort,
                                 const std::vector<double>& left_Hz, const Genuine& genuine) {
  std::vector<Mode> modes = identify::identify_modes(set, {.effort = effort, .start_Hz = left_Hz});
  if (modes.size() == left_Hz.size()) return modes;
  std::vector<Mode> single = identify::identify_modes(set, {.effort = effort, .search_jointly = false});
  const std::vector<double> single_Hz = genuine(single);
  if (!single_Hz.empty()) single = identify::identify_modes(set, {.effort = effort, .start_Hz = single_Hz});
  return single.size() >= modes.size() ? single : modes;
}

}  // namespace

void add_scatter_between_hits(const identify::FrfDataset& set, const TestSpectra& spectra,
                              const std::function<const identify::HitFrfs&()>& hits,
                              const identify::IdentifyOptions& options, const std::function<void()>& search,
                              std::vector<Mode>& modes) {
  const std::vector<std::size_t> used = comparable_hits(spectra);
  if (used.size() < 2) return;
  const identify::HitFrfs& each = hits();
  std::vector<double> peak_N;
  peak_N.reserve(used.size());
  for (const std::size_t h : used) peak_N.push_back(spectra.hits[h].hit.peak_N);
  identify::WindowedHitPoles linear = identify::windowed_hit_poles(set, each, modes);
  if (options.start_Hz.empty() && !options.modes) {
    const auto left_Hz = identify::without_imitated_modes(set, each, linear, peak_N, modes);
    if (!left_Hz.empty()) {
      modes = identify_again(set, options.effort, left_Hz, [&](const std::vector<Mode>& found) {
        return identify::without_imitated_modes(set, each, identify::windowed_hit_poles(set, each, found), peak_N,
                                                found);
      });
      search();
      linear = identify::windowed_hit_poles(set, each, modes);
    }
  }
  identify::add_hit_scatter(set, each, linear, peak_N, modes);
}

}  // namespace percuss::pipeline
