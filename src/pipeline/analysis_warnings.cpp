#include <algorithm>
#include <iterator>
#include <set>

#include "pipeline/analysis.hpp"
#include "pipeline/warnings/capture_warnings.hpp"
#include "pipeline/warnings/channel_mode_warnings.hpp"
#include "pipeline/warnings/channel_warnings.hpp"
#include "pipeline/warnings/force_findings.hpp"
#include "pipeline/warnings/hit_scatter_warnings.hpp"
#include "pipeline/warnings/hit_warnings.hpp"
#include "pipeline/warnings/mode_warnings.hpp"
#include "pipeline/warnings/object_warnings.hpp"
#include "pipeline/warnings/point_force_warnings.hpp"
#include "pipeline/warnings/ranking.hpp"
#include "pipeline/warnings/record_findings.hpp"
#include "pipeline/warnings/role_warnings.hpp"
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
  std::set<std::size_t> silent_hits;
  for (const SilentPoint& one : silent_at) silent_hits.insert(one.hits.begin(), one.hits.end());
  add(hit_warnings(record(), graded, silent_hits));
  if (force_known) add(point_force_warnings(record(), graded));
  if (force_known && lines_.ready()) add(used_hit_warnings(record(), graded, lines().samples));
  if (force_known) add(role_warnings(record(), graded));
  add(channel_warnings(record(), graded));
  add(silent_point_warnings(record(), silent_at));
  const auto silent = modes_.ready() && modes().empty() && responses_.ready()
                          ? silent_response_warnings(record(), graded, responses())
                          : std::vector<Warning>{};
  add(silent);
  if (force_known && responses_.ready() && hits_.ready()) add(record_findings(record(), graded, responses()));
  if (modes_.ready() && force_known) add(pretrigger_warnings(record(), graded, fitted_frfs()));
  if (responses_.ready() && options_.hits.gate_force) add(coupling_warnings(graded, band_Hz().first));
  add(rest_warnings(graded, earlier_ringing_.ready() ? earlier_ringing() : std::vector<EarlierRinging>{}));
  if (modes_.ready()) add(channel_mode_warnings(record(), modes(), channel_findings(), force_known));
  if (modes_.ready()) {
    add(freq_scatter_warnings(modes()));
    add(hit_scatter_warnings(modes(), residual_end_Hz_));
    add(mass_loading_warnings(modes()));
    add(truncation_warnings(modes(), lines(), window_decay_per_s(), force_known));
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
    add(tube_warnings(record(), modes(), classifications(), options_.classes, modes_are_complete()));
    add(split_mode_warnings(modes(), classifications()));
  }
  remove_consequences_of_window(out);
  // Responses that are noise differ from hit to hit.
  if (!silent.empty() && silent.size() == record().accel.size())
    std::erase_if(out, [](const Warning& warning) { return warning.code == "hits_disagree"; });
  return ranked(std::move(out));
}

}  // namespace percuss::pipeline
