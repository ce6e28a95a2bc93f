// Findings about the channels and the quality of the fit, from the modes, and the corrections that follow.
#include <algorithm>
#include <utility>
#include <vector>

#include "core/parallel/parallel.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kPeakWidths = 3;  // half-power bandwidths on either side of a mode, or spectral lines if wider

// The modes whose peaks lie outside the band. The band shows half the peak of a mode closer to its end.
std::vector<identify::Mode> clear_of_band(std::vector<identify::Mode> modes, std::pair<double, double> band_Hz,
                                          double df_Hz) {
  std::erase_if(modes, [&](const identify::Mode& mode) {
    const double reach_Hz = kPeakWidths * std::max(mode.pole.half_power_Hz(), df_Hz);
    return mode.pole.freq_Hz + reach_Hz >= band_Hz.first && mode.pole.freq_Hz - reach_Hz <= band_Hz.second;
  });
  return modes;
}

}  // namespace

const std::vector<ChannelDelay>& Analysis::corrected_delays() const {
  return within_budget(budget_, corrected_delays_, [&] {
    if (!options_.delays.automatic) return stated_delays(options_.delays.delay_s, record());
    // The modes that show the delays are found without a correction first. Clear peaks suffice; with a large delay, the
    // search for other modes would follow its misfit for minutes.
    AnalysisOptions uncorrected = options_;
    uncorrected.delays = {};
    uncorrected.modes.effort = identify::Effort::quick;
    const Analysis first(record(), std::move(uncorrected));
    std::vector<ChannelDelay> delays;
    if (!first.possible()) return delays;
    trace_.run("delays", [&] {
      delays = first.channel_findings().delays;
      std::erase_if(delays, [](const ChannelDelay& delay) { return !delay.established(); });
      return 0;
    });
    return delays;
  });
}

const ClosedGaps& Analysis::closed_gaps() const {
  return within_budget(budget_, closed_gaps_, [&] { return close_gaps(record(), force_hits()); });
}

const acquire::Record& Analysis::aligned_record() const {
  return within_budget(budget_, aligned_record_, [&] {
    const std::vector<ChannelDelay>& delays = corrected_delays();
    acquire::Record whole = closed_gaps().record;
    return delays.empty() ? whole : align_record(std::move(whole), delays);
  });
}

const std::vector<Eigen::VectorXcd>& Analysis::modal_sums() const {
  return within_budget(budget_, modal_sums_, [&] {
    const std::vector<identify::Mode> found = fitted_modes();
    const ThreadLimit limit(options_.threads);
    return identify::modal_sums(fitted_frfs(), found);
  });
}

const std::vector<identify::SynthesisedFrf>& Analysis::synthesis() const {
  return within_budget(budget_, synthesis_, [&] {
    const identify::FrfDataset& set = fitted_frfs();
    const ThreadLimit limit(options_.threads);
    const std::vector<Eigen::VectorXcd>& sums = modal_sums();
    return trace_.run("synthesis", [&] { return identify::frfs_from_sums(set, sums, band_lines()); });
  });
}

const FitQuality& Analysis::fit() const {
  return within_budget(budget_, fit_, [&] { return fit_quality(fitted_frfs(), modes(), synthesis(), band_lines()); });
}

const std::vector<identify::UnmodelledPeak>& Analysis::unexplained_peaks() const {
  return within_budget(budget_, unexplained_peaks_, [&] {
    const ThreadLimit limit(options_.threads);
    const std::vector<identify::Mode> found = fitted_modes();  // sets margin_modes_
    const std::vector<identify::Mode> beyond = clear_of_band(margin_modes_, band_Hz(), lines().df_Hz());
    return trace_.run("peaks", [&] { return unexplained_peaks_of(fitted_frfs(), found, beyond); });
  });
}

const std::vector<identify::Pole>& Analysis::unmodelled_poles() const {
  return within_budget(budget_, unmodelled_poles_, [&]() -> std::vector<identify::Pole> {
    if (options_.modes.modes || !options_.modes.start_Hz.empty()) return {};
    const ThreadLimit limit(options_.threads);
    const std::vector<identify::Mode>& found = modes();
    std::vector<identify::Pole> poles =
        searched_poles_ ? *searched_poles_ : identify::unmodelled_poles(fitted_frfs(), found, modal_sums());
    const auto band = band_Hz();
    std::erase_if(poles,
                  [&](const identify::Pole& pole) { return pole.freq_Hz < band.first || pole.freq_Hz > band.second; });
    return poles;
  });
}

const ChannelFindings& Analysis::channel_findings() const {
  return within_budget(budget_, channel_findings_, [&]() -> ChannelFindings {
    const std::vector<identify::Mode>& found = modes();
    const identify::FrfDataset& set = fitted_frfs();
    const std::size_t channels = record().accel.size();
    const ThreadLimit limit(options_.threads);
    return trace_.run("channels", [&]() -> ChannelFindings {
      return {.delays = channel_delays(set, with_point_indices(found, frf_points()), hits(), channels),
              .corrected_delays = corrected_delays(),
              .clocks = channel_clocks(set, found, channels),
              .pairs = compare_channels(found, channels),
              .largest_velocity_mps = largest_velocity_mps(set, found)};
    });
  });
}

}  // namespace percuss::pipeline
