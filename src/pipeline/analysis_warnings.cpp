#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "pipeline/analysis.hpp"
#include "pipeline/hits/hit_noise.hpp"
#include "pipeline/warnings/capture_warnings.hpp"
#include "pipeline/warnings/channel_mode_warnings.hpp"
#include "pipeline/warnings/channel_warnings.hpp"
#include "pipeline/warnings/force_findings.hpp"
#include "pipeline/warnings/hit_scatter_warnings.hpp"
#include "pipeline/warnings/hit_warnings.hpp"
#include "pipeline/warnings/lost_sample_warnings.hpp"
#include "pipeline/warnings/mode_warnings.hpp"
#include "pipeline/warnings/object_warnings.hpp"
#include "pipeline/warnings/point_force_warnings.hpp"
#include "pipeline/warnings/ranking.hpp"
#include "pipeline/warnings/record_findings.hpp"
#include "pipeline/warnings/role_warnings.hpp"
#include "pipeline/warnings/three_wave_warnings.hpp"
#include "pipeline/warnings/truncation_warnings.hpp"
#include "pipeline/warnings/tube_warnings.hpp"
#include "pipeline/warnings/used_hit_warnings.hpp"

namespace percuss::pipeline {

namespace {

// A window that the recorder applied makes the noise before a hit larger than at the end, and the modes differ by the
// time of the hit. The warnings about these would name wrong causes.
void remove_consequences_of_window(std::vector<Warning>& warnings) {
  const bool windowed = std::any_of(warnings.begin(), warnings.end(),
                                    [](const Warning& warning) { return warning.code == "already_windowed"; });
  if (!windowed) return;
  std::erase_if(warnings,
                [](const Warning& warning) { return warning.code == "not_at_rest" || warning.code == "hits_differ"; });
}

// The sensors whose ratios gave the modes their types; nothing if no mode has a ratio.
std::optional<identify::SensorPair> tube_sensors(const acquire::Record& record,
                                                 const std::vector<identify::ModeClassification>& classifications) {
  const bool typed = std::any_of(classifications.begin(), classifications.end(),
                                 [](const identify::ModeClassification& mode) { return mode.ratio.has_value(); });
  if (!typed) return std::nullopt;
  std::vector<std::optional<double>> angles_rad;
  for (const acquire::SignalInfo& accel : record.accel) angles_rad.push_back(accel.angle_rad);
  return identify::pair_of_sensors(angles_rad);
}

}  // namespace

std::vector<Warning> Analysis::warnings() const {
  const std::vector<AnalysedHit>& graded = hits_.ready() ? hits() : force_hits();
  const bool force_known = given_frfs() == nullptr;
  const bool user_chose_modes = options_.modes.modes.has_value() || !options_.modes.start_Hz.empty();
  std::vector<Warning> out;
  const auto add = [&](std::vector<Warning> more) {
    out.insert(out.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  add(options_.known);
  add(input_warnings(record()));
  add(capture_warnings(record()));
  if (modes_.ready() && !force_known) add(force_noise_warnings(modes()));
  const std::vector<SilentPoint> silent_at =
      responses_.ready() ? silent_points(graded, responses()) : std::vector<SilentPoint>{};
  std::set<std::size_t> noisy_hits;
  if (force_known && responses_.ready() && hits_.ready())
    noisy_hits = hits_that_differ_by_noise(graded, responses(), transform_options());
  for (const SilentPoint& one : silent_at) noisy_hits.insert(one.hits.begin(), one.hits.end());
  add(hit_warnings(record(), graded, point_names(), noisy_hits));
  if (force_known) add(refused_hit_warnings(graded, options_.accept_hits, options_.reject_hits));
  const std::vector<Warning> other_units =
      force_known ? point_force_warnings(record(), graded, point_names()) : std::vector<Warning>{};
  add(other_units);
  if (force_known && lines_.ready()) add(used_hit_warnings(record(), graded, lines().samples, point_names()));
  if (force_known) add(role_warnings(record(), graded, options_.hits));
  if (force_known) add(closed_gap_warnings(closed_gaps(), graded));
  add(channel_warnings(record(), graded));
  add(silent_point_warnings(record(), silent_at, point_names()));
  const auto silent = modes_.ready() && modes().empty() && responses_.ready()
                          ? silent_response_warnings(record(), graded, responses())
                          : std::vector<Warning>{};
  add(silent);
  if (force_known && responses_.ready() && hits_.ready()) add(record_findings(record(), graded, responses()));
  if (modes_.ready() && force_known && other_units.empty())
    add(point_range_warnings(record(), graded, modes(), point_names()));
  if (modes_.ready() && force_known) add(pretrigger_warnings(record(), graded, fitted_frfs()));
  if (responses_.ready() && options_.hits.gate_force) add(coupling_warnings(graded, band_Hz().first));
  add(rest_warnings(graded, earlier_ringing_.ready() ? earlier_ringing() : std::vector<EarlierRinging>{}));
  if (modes_.ready()) {
    const SensorDirections sensors{
        .angles_assumed = options_.classes.angles_assumed,
        .tube = classifications_.ready() ? tube_sensors(record(), classifications()) : std::nullopt};
    add(channel_mode_warnings(record(), modes(), channel_findings(), force_known, sensors));
  }
  if (modes_.ready()) {
    add(freq_scatter_warnings(modes(), force_known ? order_of_points(graded) : std::map<int, double>{}));
    add(hit_scatter_warnings(modes(), residual_end_Hz_));
    add(mass_loading_warnings(modes()));
    add(truncation_warnings(modes(), lines(), window_decay_per_s(), force_known, decay_cut()));
    add(no_modes_warnings(modes(), band_Hz(), !options_.modes.start_Hz.empty()));
    if (!user_chose_modes) add(local_fit_warnings(modes()));
    add(refused_start_warnings(refused_starts_));
    if (!user_chose_modes) add(unmodelled_peak_warnings(unexplained_peaks(), band_Hz()));
    add(unmodelled_pole_warnings(unmodelled_poles(), band_Hz()));
    if (!options_.band_Hz && !user_chose_modes) add(below_band_warnings(margin_modes_, band_Hz()));
    add(crowd_warnings(modes(), band_Hz()));
  }
  if (classifications_.ready()) {
    add(object_warnings(classifications(), options_.classes));
    const auto of_tube = tube_warnings(record(), modes(), classifications(), options_.classes, modes_are_complete());
    const auto is = [](const char* code) { return [code](const Warning& warning) { return warning.code == code; }; };
    // A unit that differs explains the implausible motion.
    if (std::any_of(of_tube.begin(), of_tube.end(), is("units_differ"))) std::erase_if(out, is("implausible_motion"));
    add(of_tube);
    add(split_mode_warnings(modes(), classifications()));
    add(three_wave_warnings(modes(), classifications()));
  }
  remove_consequences_of_window(out);
  if (has_reversed_phase(record())) remove_consequences_of_reversed_phase(out);
  // Responses that are noise differ from hit to hit.
  if (!silent.empty() && silent.size() == record().accel.size())
    std::erase_if(out, [](const Warning& warning) { return warning.code == "hits_disagree"; });
  return ranked(std::move(out));
}

}  // namespace percuss::pipeline
