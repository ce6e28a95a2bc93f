#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "pipeline/analysis.hpp"
#include "pipeline/hits/hit_noise.hpp"
#include "pipeline/stages/mode_stages.hpp"
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

// The sensors whose ratios gave the modes their types; nothing if no mode has a ratio.
std::optional<identify::SensorPair> tube_sensors(const std::vector<acquire::SignalInfo>& accel,
                                                 const std::vector<identify::ModeClassification>& classifications) {
  const bool typed = std::any_of(classifications.begin(), classifications.end(),
                                 [](const identify::ModeClassification& mode) { return mode.ratio.has_value(); });
  return typed ? sensor_pair(accel) : std::nullopt;
}

// [channels] the two sensors that type the modes, if all respond.
std::vector<bool> needed_for_types(const acquire::Record& record, const identify::ClassifyOptions& options) {
  std::vector<bool> out(record.accel.size());
  const auto sensors = sensor_pair(record.accel);
  if (sensors && options.object != identify::ObjectKind::other) out[sensors->first] = out[sensors->second] = true;
  return out;
}

void append(std::vector<Warning>& out, std::vector<Warning> more) {
  out.insert(out.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

bool has_code(const std::vector<Warning>& warnings, std::string_view code) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& warning) { return warning.code == code; });
}

void remove_code(std::vector<Warning>& warnings, std::string_view code) {
  std::erase_if(warnings, [&](const Warning& warning) { return warning.code == code; });
}

// A window that the recorder applied makes the noise before a hit larger than at the end, and the modes differ by the
// time of the hit. The warnings about these would name wrong causes.
void remove_consequences_of_window(std::vector<Warning>& warnings) {
  if (!has_code(warnings, "already_windowed")) return;
  remove_code(warnings, "not_at_rest");
  remove_code(warnings, "hits_differ");
}

// What other warnings say may be the cause of a misfit.
void name_known_causes(std::vector<Warning>& warnings, bool decay_missing) {
  const auto delayed = [](const Warning& warning) { return warning.code == "skew" && !warning.remedy.empty(); };
  const bool skew = std::any_of(warnings.begin(), warnings.end(), delayed);
  if (!skew && !decay_missing) return;
  const char* const causes = !skew           ? "the missing decay"
                             : decay_missing ? "the missing decay and the delay between the channels"
                                             : "the delay between the channels";
  for (Warning& warning : warnings) {
    if (warning.code != "local_fits" && warning.code != "model_misfit") continue;
    const std::string remedy = std::exchange(warning.remedy, {});  // ends the message, after "; "
    warning.message.resize(warning.message.size() - remedy.size() - 2);
    warning.message += std::string(". First see the other warnings about ") + causes + ", which may cause this";
    warning = with_remedy(std::move(warning), remedy);
  }
}

}  // namespace

// The hits, and what several groups of warnings need to know of them.
struct Analysis::HitEvidence {
  const std::vector<AnalysedHit>& graded;
  std::vector<SilentPoint> silent_points;
  std::vector<Warning> silent_channels;  // silent_response_warnings(); empty if modes were found
  std::vector<Warning> other_units;      // point_force_warnings()
};

std::vector<Tone> Analysis::known_tones() const {
  return read_spectra_.ready() ? responses().tones : std::vector<Tone>{};
}

Analysis::HitEvidence Analysis::hit_evidence() const {
  HitEvidence out{.graded = hits_.ready() ? hits() : force_hits()};
  if (read_spectra_.ready()) out.silent_points = silent_points(out.graded, responses());
  if (given_frfs() == nullptr) out.other_units = point_force_warnings(record(), out.graded, point_names());
  if (modes_.ready() && modes().empty() && read_spectra_.ready())
    out.silent_channels = silent_response_warnings(record(), out.graded, responses());
  return out;
}

std::vector<Warning> Analysis::warnings_of_hits(const HitEvidence& evidence) const {
  const std::vector<AnalysedHit>& graded = evidence.graded;
  const bool force_known = given_frfs() == nullptr;
  std::set<std::size_t> noisy_hits;
  if (force_known && read_spectra_.ready() && hits_.ready())
    noisy_hits = hits_that_differ_by_noise(graded, responses(), transform_options(lines()));
  if (force_known && read_spectra_.ready() && hits_.ready()) noisy_hits.merge(hits_on_node_lines(graded, responses()));
  for (const SilentPoint& one : evidence.silent_points) noisy_hits.insert(one.hits.begin(), one.hits.end());
  std::vector<Warning> out = hit_warnings(record(), graded, point_names(), noisy_hits);
  if (!force_known) return out;
  append(out, refused_hit_warnings(graded, options_.accept_hits, options_.reject_hits));
  append(out, evidence.other_units);
  if (line_choice_.ready())
    append(out, used_hit_warnings(record(), graded, line_choice().lines.samples, point_names()));
  append(out, role_warnings(record(), graded, options_.hits));
  append(out, closed_gap_warnings(closed_gaps(), graded));
  return out;
}

std::vector<Warning> Analysis::warnings_of_channels(const HitEvidence& evidence) const {
  const std::vector<AnalysedHit>& graded = evidence.graded;
  const bool force_known = given_frfs() == nullptr;
  const std::vector<bool> types_need =
      modes_.ready() ? needed_for_types(record(), options_.classes) : std::vector<bool>{};
  std::vector<Warning> out = channel_warnings(record(), graded, types_need);
  append(out, silent_point_warnings(record(), evidence.silent_points, point_names()));
  append(out, evidence.silent_channels);
  if (force_known && read_spectra_.ready() && hits_.ready())
    append(out, record_findings(record(), graded, responses()));
  if (modes_.ready() && force_known && evidence.other_units.empty())
    append(out, point_range_warnings(record(), graded, modes(), point_names()));
  if (modes_.ready() && force_known) append(out, pretrigger_warnings(record(), graded, fitted_frfs()));
  if (read_spectra_.ready() && options_.hits.gate_force) append(out, coupling_warnings(graded, band_Hz().first));
  append(out, rest_warnings(graded, earlier_ringing_.ready() ? earlier_ringing() : std::vector<EarlierRinging>{},
                            known_tones()));
  if (modes_.ready()) {
    SensorDirections sensors{.angles_assumed = options_.classes.angles_assumed};
    if (classifications_.ready()) {
      sensors.tube = tube_sensors(typing_accel(), classifications());
      for (const identify::ModeClassification& one : classifications())
        sensors.hoop.push_back(one.type == identify::ModeType::hoop);
    }
    append(out, channel_mode_warnings(record(), modes(), channel_findings(), force_known, sensors, silent_channels(),
                                      types_need));
  }
  return out;
}

std::vector<Warning> Analysis::warnings_of_modes(const HitEvidence& evidence) const {
  const bool force_known = given_frfs() == nullptr;
  const bool user_chose_modes = options_.modes.modes.has_value() || !options_.modes.start_Hz.empty();
  std::vector<Warning> out = freq_scatter_warnings(
      modes(), force_known ? order_of_points(evidence.graded) : std::map<int, double>{}, force_known);
  append(out, hit_scatter_warnings(modes(), residual_end_Hz_, force_known));
  append(out, mass_loading_warnings(modes()));
  append(out, force_known ? truncation_warnings(modes(), lines(), window_decay_per_s(), decay_cut())
                          : frf_truncation_warnings(modes(), lines(), window_decay_per_s(), before_blow_s_));
  append(out, no_modes_warnings(modes(), band_Hz(), !options_.modes.start_Hz.empty()));
  if (!user_chose_modes) append(out, local_fit_warnings(modes(), force_known));
  append(out, refused_start_warnings(refused_starts_));
  append(out, joined_mode_warnings(joined_modes_));
  if (!user_chose_modes) {
    append(out, unmodelled_peak_warnings(unexplained_peaks(), band_Hz(), known_tones(), lines().df_Hz()));
  }
  append(out, unmodelled_pole_warnings(unmodelled_poles(), band_Hz()));
  if (!options_.band_Hz && !user_chose_modes) append(out, below_band_warnings(margin_modes_below(), band_Hz()));
  append(out, crowd_warnings(modes(), band_Hz()));
  return out;
}

std::vector<Warning> Analysis::warnings() const {
  const HitEvidence evidence = hit_evidence();
  std::vector<Warning> out = options_.known;
  append(out, input_warnings(record()));
  append(out, capture_warnings(record()));
  if (modes_.ready() && given_frfs() != nullptr) append(out, force_noise_warnings(modes()));
  append(out, warnings_of_hits(evidence));
  append(out, warnings_of_channels(evidence));
  if (modes_.ready()) append(out, warnings_of_modes(evidence));
  if (classifications_.ready()) {
    // What the ratios say against the test, they say by sensors that respond.
    acquire::Record typed = record();
    typed.accel = typing_accel();
    if (!sensor_pair(record().accel) || sensor_pair(typed.accel))
      append(out, object_warnings(classifications(), options_.classes));
    std::vector<Warning> of_tube =
        tube_warnings(typed, modes(), classifications(), options_.classes, modes_are_complete());
    // A unit that differs explains the implausible motion.
    if (has_code(of_tube, "units_differ")) remove_code(out, "implausible_motion");
    append(out, std::move(of_tube));
    append(out, split_mode_warnings(modes(), classifications()));
    append(out, three_wave_warnings(modes(), classifications()));
  }
  // Records whose force is known, or whose FRFs show the time of the blow: the fit allows for the missing decay.
  name_known_causes(out, given_frfs() != nullptr && !before_blow_s_ && has_code(out, "truncated_decay"));
  remove_consequences_of_window(out);
  if (has_reversed_phase(record())) remove_consequences_of_reversed_phase(out);
  // Responses that are noise differ from hit to hit.
  const std::size_t silent = evidence.silent_channels.size();
  if (silent > 0 && silent == record().accel.size()) remove_code(out, "hits_disagree");
  return ranked(std::move(out));
}

}  // namespace percuss::pipeline
