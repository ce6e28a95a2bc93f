#include "identify/identify.hpp"

#include "identify/multi_output.hpp"
#include "identify/select/joint_refinement.hpp"
#include "identify/select/local_force_noise.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss {

std::vector<Mode> identify_modes(const FrfSet& set, const IdentifyOptions& options) {
  if (options.start_Hz.empty() && set.outputs.size() > kFewOutputs) {
    if (auto modes = identify_many(set, options)) return *std::move(modes);
  }
  PeakFitOptions peaks = peak_fit_of(options.effort);
  peaks.modes = options.modes;
  peaks.start_Hz = options.start_Hz;
  auto found = fit_peaks(set, peaks);
  if (options.effort == Effort::best && !found.empty()) refine(set, found);
  add_force_noise(set, found);
  std::vector<Mode> modes;
  modes.reserve(found.size());
  for (PeakMode& mode : found) modes.push_back(std::move(mode.mode));
  return modes;
}

}  // namespace percuss
