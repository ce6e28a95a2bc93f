#include "identify/identify.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "identify/misfit/misfit.hpp"
#include "identify/misfit/unresolved_partners.hpp"
#include "identify/multi_output.hpp"
#include "identify/select/finished_modes.hpp"
#include "identify/select/joint_refinement.hpp"
#include "identify/select/joint_search.hpp"
#include "identify/select/satellite_modes.hpp"
#include "identify/select/sequential_fit.hpp"
#include "identify/started_modes.hpp"

namespace percuss::identify {
namespace {

std::vector<Mode> fit_all_channels(const FrfDataset& set, const IdentifyOptions& options) {
  const SequentialFitOptions sequential = sequential_fit_options(options.effort);
  std::vector<FittedMode> found = without_unresolved_partners(set, fit_sequentially(set, sequential), sequential);
  std::vector<Eigen::VectorXcd> residual;
  if (options.effort == Effort::best && !found.empty()) residual = refine_jointly(set, found);
  if (options.effort != Effort::quick && residual.empty()) residual = refine_without_satellites(set, found);
  if (options.effort != Effort::quick) search_jointly(set, residual, found);
  return finished_modes(set, std::move(found));
}

std::vector<Mode> search(const FrfDataset& set, const IdentifyOptions& options) {
  std::optional<std::vector<Mode>> modes;
  if (set.channels.size() > kMaxPrincipalFrfs) modes = identify_multi_output(set, options);
  if (!modes) modes = fit_all_channels(set, options);
  if (options.modes) keep_clearest(*modes, *options.modes);
  return with_misfit(set, *std::move(modes));
}

StartedModes search_with_starts(const FrfDataset& set, const IdentifyOptions& options) {
  return with_started_modes(set, search(set, {.effort = options.effort}), options.start_Hz, options.effort);
}

}  // namespace

std::vector<Mode> identify_modes(const FrfDataset& set, const IdentifyOptions& options) {
  if (options.start_Hz.empty()) return search(set, options);
  std::vector<Mode> modes = modes_at_starts(set.lines, search_with_starts(set, options).modes, options.start_Hz);
  if (options.modes) keep_clearest(modes, *options.modes);
  return modes;
}

std::vector<Mode> modes_from_frequencies(const FrfDataset& set, const std::vector<double>& freq_Hz, Effort effort) {
  std::vector<FittedMode> found = fit_starts(set, freq_Hz, effort).modes;
  if (effort == Effort::best && !found.empty()) refine_jointly(set, found);
  return with_misfit(set, finished_modes(set, std::move(found)));
}

std::vector<Mode> modes_from_poles(const FrfDataset& set, const std::vector<Pole>& poles, Effort effort) {
  SequentialFitOptions sequential = sequential_fit_options(effort);
  sequential.start = poles;
  std::vector<FittedMode> found = fit_sequentially(set, sequential);
  if (effort == Effort::best && !found.empty()) refine_jointly(set, found);
  return finished_modes(set, std::move(found));
}

std::vector<RefusedStart> refused_starts(const FrfDataset& set, const IdentifyOptions& options) {
  return search_with_starts(set, options).refused;
}

void keep_clearest(std::vector<Mode>& modes, std::size_t count) {
  if (modes.size() <= count) return;
  const auto relative = [](const Mode& mode) { return mode.damping_std / mode.pole.damping_ratio; };
  std::stable_sort(modes.begin(), modes.end(), [&](const Mode& a, const Mode& b) { return relative(a) < relative(b); });
  modes.resize(count);
  std::sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
}

}  // namespace percuss::identify
