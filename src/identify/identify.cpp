#include "identify/identify.hpp"

#include "identify/misfit/misfit.hpp"
#include "identify/multi_output.hpp"
#include "identify/select/joint_refinement.hpp"
#include "identify/select/local_force_noise.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

namespace {

std::vector<Mode> fitted_to_noise(const FrfDataset& set, const IdentifyOptions& options) {
  if (options.start_Hz.empty() && set.channels.size() > kMaxPrincipalFrfs) {
    if (auto modes = identify_multi_output(set, options)) return *std::move(modes);
  }
  SequentialFitOptions sequential = sequential_fit_options(options.effort);
  sequential.modes = options.modes;
  sequential.start_Hz = options.start_Hz;
  auto found = fit_sequentially(set, sequential);
  if (options.effort == Effort::best && !found.empty()) refine_jointly(set, found);
  add_force_noise(set, found);
  std::vector<Mode> modes;
  modes.reserve(found.size());
  for (FittedMode& mode : found) modes.push_back(std::move(mode.mode));
  return modes;
}

}  // namespace

std::vector<Mode> identify_modes(const FrfDataset& set, const IdentifyOptions& options) {
  std::vector<Mode> modes = fitted_to_noise(set, options);
  for (Mode& mode : modes) {
    mode.freq_std_parts_Hz.noise = mode.freq_std_Hz;
    mode.damping_std_parts.noise = mode.damping_std;
  }
  add_misfit(set, modes);
  return modes;
}

}  // namespace percuss::identify
