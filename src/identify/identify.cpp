#include "identify/identify.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "identify/misfit/misfit.hpp"
#include "identify/misfit/unresolved_partners.hpp"
#include "identify/multi_output.hpp"
#include "identify/select/common_residues.hpp"
#include "identify/select/joint_refinement.hpp"
#include "identify/select/joint_search.hpp"
#include "identify/select/local_force_noise.hpp"
#include "identify/select/satellite_modes.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {
namespace {

// Adds the noise of the force. Where the modes' residues do not add up to the FRFs, fits them all together.
std::vector<Mode> finished(const FrfDataset& set, std::vector<FittedMode> found) {
  add_force_noise(set, found);
  fit_common_residues(set, found);
  std::vector<Mode> modes;
  modes.reserve(found.size());
  for (FittedMode& mode : found) modes.push_back(std::move(mode.mode));
  return modes;
}

std::vector<Mode> fit_all_channels(const FrfDataset& set, const IdentifyOptions& options) {
  const SequentialFitOptions sequential = sequential_fit_options(options.effort);
  std::vector<FittedMode> found = without_unresolved_partners(set, fit_sequentially(set, sequential), sequential);
  std::vector<Eigen::VectorXcd> residual;
  if (options.effort == Effort::best && !found.empty()) residual = refine_jointly(set, found);
  if (options.effort != Effort::quick && residual.empty()) residual = refine_without_satellites(set, found);
  if (options.effort != Effort::quick) search_jointly(set, residual, found);
  return finished(set, std::move(found));
}

std::vector<Mode> fit_at_starts(const FrfDataset& set, const IdentifyOptions& options) {
  std::vector<FittedMode> found = fit_starts(set, options.start_Hz, options.effort).modes;
  if (options.effort == Effort::best && !found.empty()) refine_jointly(set, found);
  return finished(set, std::move(found));
}

}  // namespace

std::vector<Mode> identify_modes(const FrfDataset& set, const IdentifyOptions& options) {
  std::optional<std::vector<Mode>> modes;
  if (!options.start_Hz.empty()) {
    modes = fit_at_starts(set, options);
  } else if (set.channels.size() > kMaxPrincipalFrfs) {
    modes = identify_multi_output(set, options);
  }
  if (!modes) modes = fit_all_channels(set, options);
  if (options.modes) keep_clearest(*modes, *options.modes);
  for (Mode& mode : *modes) {
    mode.freq_std_parts_Hz.noise = mode.freq_std_Hz;
    mode.damping_std_parts.noise = mode.damping_std;
  }
  add_misfit(set, *modes);
  return *std::move(modes);
}

std::vector<Mode> modes_from_poles(const FrfDataset& set, const std::vector<Pole>& poles, Effort effort) {
  SequentialFitOptions sequential = sequential_fit_options(effort);
  sequential.start = poles;
  std::vector<FittedMode> found = fit_sequentially(set, sequential);
  if (effort == Effort::best && !found.empty()) refine_jointly(set, found);
  return finished(set, std::move(found));
}

std::vector<RefusedStart> refused_starts(const FrfDataset& set, const IdentifyOptions& options) {
  return fit_starts(set, options.start_Hz, options.effort).refused;
}

void keep_clearest(std::vector<Mode>& modes, std::size_t count) {
  if (modes.size() <= count) return;
  const auto relative = [](const Mode& mode) { return mode.damping_std / mode.pole.damping_ratio; };
  std::stable_sort(modes.begin(), modes.end(), [&](const Mode& a, const Mode& b) { return relative(a) < relative(b); });
  modes.resize(count);
  std::sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
}

}  // namespace percuss::identify
