#include "report/text/analysis_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/significant_digits.hpp"
#include "core/units.hpp"
#include "pipeline/warnings/channel_warnings.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxHits = 40;  // rows, after which only rejected hits are shown

// Findings that do not reject a hit are abbreviated here: the warnings state them in full.
std::string brief(const acquire::Finding& finding) {
  switch (finding.code) {
    case acquire::FindingCode::weak:
      return fmt::format("weak ({:.0f} %)", finding.value * 100);
    case acquire::FindingCode::truncated_decay:
      return fmt::format("still rings at the end ({:.0f} dB)", finding.value);
    case acquire::FindingCode::low_bandwidth:
      return "low bandwidth";
    case acquire::FindingCode::low_coherence:
      return finding.value > 0 ? fmt::format("{:.0f} % coherent with the others", finding.value * 100)
                               : "not coherent with the others";
    case acquire::FindingCode::polarity:
      return "negative force";
    default:
      return finding.message;
  }
}

std::string hit_verdict(const pipeline::AnalysedHit& hit) {
  std::string text = hit.accepted ? "ok" : "rejected";
  if (hit.by_user) text += hit.accepted ? " (accepted by the user)" : " (by the user)";
  std::string reasons;
  for (const acquire::Finding& finding : hit.hit.findings) {
    reasons += (reasons.empty() ? ": " : "; ") +
               (finding.severity == acquire::Severity::reject ? finding.message : brief(finding));
  }
  return text + reasons;
}

}  // namespace

HitsTable hits_table(const pipeline::Analysis& analysis, const std::vector<pipeline::AnalysedHit>& hits) {
  const bool points = std::any_of(hits.begin(), hits.end(),
                                  [&](const pipeline::AnalysedHit& h) { return h.point != hits.front().point; });
  const bool files = analysis.record().files.size() > 1;
  std::vector<TextTable::Column> columns{{"hit", TextTable::Align::right}};
  if (points) columns.push_back({"point", TextTable::Align::right});
  if (files) columns.push_back({"file"});
  for (const char* name : {"time", "peak", "pulse", "bandwidth"}) columns.push_back({name, TextTable::Align::right});
  columns.push_back({"verdict"});
  TextTable table(columns);
  std::size_t shown = 0, left_out = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].accepted && shown >= kMaxHits) {
      ++left_out;
      continue;
    }
    ++shown;
    const acquire::Hit& hit = hits[i].hit;
    const bool pulse = !hit.gated_N.empty();
    std::vector<std::string> cells{fmt::format("{}", i + 1)};
    if (points) cells.push_back(fmt::format("{}", analysis.point_names().number(hits[i].point)));
    if (files) {
      const std::string& path = analysis.record().files[analysis.record().rows[hit.row].file].path;
      cells.push_back(one_line(path.substr(path.rfind('/') + 1), 40));
    }
    cells.push_back(pulse ? fmt::format("{:.3f} s", hit.onset_s) : "–");
    cells.push_back(pulse ? force_text(hit.peak_N) : "–");
    cells.push_back(pulse ? fmt::format("{:.2f} ms", hit.pulse_s * 1e3) : "–");
    cells.push_back(pulse ? rounded_frequency_text(std::round(hit.bandwidth_Hz)) : "–");
    cells.push_back(hit_verdict(hits[i]));
    table.add(std::move(cells), hits[i].accepted);
  }
  return {std::move(table), left_out};
}

std::string source_of_std(const identify::Mode& mode) {
  const auto exceeds = [&](double identify::StdParts::*part) {
    return mode.freq_std_parts_Hz.*part > mode.freq_std_parts_Hz.noise ||
           mode.damping_std_parts.*part > mode.damping_std_parts.noise;
  };
  const bool hits = exceeds(&identify::StdParts::hits), misfit = exceeds(&identify::StdParts::misfit);
  if (!hits && !misfit) return "";
  return std::string("± from ") + (hits ? "the scatter of the hits" : "") + (hits && misfit ? " and " : "") +
         (misfit ? "the misfit" : "");
}

namespace {

// The note of a mode that shares its order with another mode, without being a split mode; empty for others.
std::string shared_order_note(const pipeline::Analysis& analysis, std::size_t m) {
  const auto& all = analysis.classifications();
  if (all[m].split_mode || all[m].order == 0) return "";
  for (std::size_t other = 0; other < all.size(); ++other) {
    if (other == m || all[other].type != all[m].type || all[other].order != all[m].order) continue;
    const double apart_Hz = std::abs(analysis.modes()[m].pole.freq_Hz - analysis.modes()[other].pole.freq_Hz);
    return fmt::format("same order as mode {}, {} Hz apart: too far for a split mode", other + 1,
                       significant(apart_Hz, 3));
  }
  return "";
}

std::string note_of(const pipeline::Analysis& analysis, std::size_t m) {
  const identify::ModeClassification& classification = analysis.classifications()[m];
  std::string note;
  const auto add = [&](const std::string& text) { note += (note.empty() ? "" : "; ") + text; };
  if (const std::string shared = shared_order_note(analysis, m); !shared.empty()) add(shared);
  if (const auto& split = classification.split_mode) {
    add(split->first ? fmt::format("split mode, {} Hz apart", significant(split->separation_Hz, 3))
                     : "second peak of the split mode");
    if (split->quoted) note += ": its frequency stands for the mode";
  }
  if (const std::string other = other_types(classification); !other.empty()) add(other);
  if (classification.order_uncertain) add("order uncertain: see the modes below it that may have three waves");
  const std::string source = source_of_std(analysis.modes()[m]);
  if (!source.empty()) add(source);
  return note;
}

std::string decibels(double value_dB) {
  const double rounded_dB = std::round(value_dB * 10) / 10;
  return fmt::format("{:.1f} dB", rounded_dB == 0 ? 0.0 : rounded_dB);  // no -0.0
}

}  // namespace

TextTable modes_table(const pipeline::Analysis& analysis, bool classes) {
  const bool named = classes && std::any_of(analysis.classifications().begin(), analysis.classifications().end(),
                                            [](const identify::ModeClassification& v) { return v.ratio.has_value(); });
  std::vector<TextTable::Column> columns{{"mode", TextTable::Align::right}};
  if (named) columns.insert(columns.end(), {{"family"}, {"confidence", TextTable::Align::right}});
  columns.push_back({"frequency", TextTable::Align::right});
  columns.push_back({"damping", TextTable::Align::right});
  if (named) columns.push_back({"overlay", TextTable::Align::right});
  columns.push_back({"note"});
  TextTable table(columns);
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    const identify::Mode& mode = analysis.modes()[m];
    std::vector<std::string> cells{fmt::format("{}", m + 1)};
    if (named) {
      cells.push_back(mode_type_of(analysis.classifications()[m]));
      cells.push_back(confidence_text(analysis.classifications()[m]));
    }
    cells.push_back(value_with_std(mode.pole.freq_Hz, mode.freq_std_Hz) + " Hz");
    cells.push_back(value_with_std(mode.pole.damping_ratio * 100, mode.damping_std * 100) + " %");
    if (named) {
      const auto& overlay_dB = analysis.classifications()[m].overlay_dB;
      cells.push_back(overlay_dB ? decibels(*overlay_dB) : "–");
    }
    cells.push_back(classes ? note_of(analysis, m) : "");
    table.add(std::move(cells), !classes || is_quoted(analysis.classifications()[m]));
  }
  return table;
}

const char* no_modes_text(const pipeline::Analysis& analysis) {
  if (pipeline::has_reversed_phase(analysis.record())) return "no mode fits: the phase of the FRFs is reversed\n";
  return analysis.options().modes.start_Hz.empty() ? "no mode rises above the noise in the band\n"
                                                   : "no mode could be fitted at the starting frequencies\n";
}

bool is_quoted(const identify::ModeClassification& classification) {
  return !classification.split_mode || classification.split_mode->quoted;
}

std::string other_types(const identify::ModeClassification& classification) {
  std::string types;
  if (classification.alternative && *classification.alternative != identify::ModeType::unknown)
    types = name_of(*classification.alternative);
  if (classification.possible_three_waves) types += std::string(types.empty() ? "" : " or ") + "three waves (n = 3)";
  if (classification.alternative && types.empty()) types = name_of(*classification.alternative);
  return types.empty() ? "" : "could be " + types;
}

std::string mode_type_of(const identify::ModeClassification& classification) {
  return classification.order > 0 ? fmt::format("{} {}", name_of(classification.type), classification.order)
                                  : name_of(classification.type);
}

std::string confidence_text(const identify::ModeClassification& classification) {
  if (classification.type == identify::ModeType::unknown) return "–";
  const double percent = 100 * classification.confidence;
  if (percent >= 99.95) return "> 99.9 %";
  return percent >= 99 ? fmt::format("{:.1f} %", percent) : fmt::format("{:.0f} %", std::floor(percent));
}

std::string test_conditions(const pipeline::Analysis& analysis, std::size_t hits) {
  const acquire::Record& record = analysis.record();
  std::string sensors = fmt::format("{} accelerometer{}", record.accel.size(), record.accel.size() == 1 ? "" : "s");
  std::string angles;
  for (const acquire::SignalInfo& signal : record.accel) {
    if (signal.angle_rad)
      angles += fmt::format("{}{:.4g}°", angles.empty() ? "" : ", ", *signal.angle_rad * kRadian_deg);
  }
  if (!angles.empty()) sensors += " (" + angles + (analysis.options().classes.angles_assumed ? ", assumed)" : ")");
  std::string text =
      fmt::format("{} · {} hit{} × {}", rounded_frequency_text(record.fs_Hz), hits, hits == 1 ? "" : "s", sensors);
  if (const acquire::FrfRecord* given = analysis.given_frfs()) {
    const std::size_t points = given->frfs.size() / record.accel.size();
    text = fmt::format("FRFs ({}) · {} point{} × {}", name_of(given->kind), points, points == 1 ? "" : "s", sensors);
  }
  if (analysis.possible()) {
    const auto [low, high] = analysis.band_Hz();
    text += fmt::format(" · band {}–{} Hz", hertz_text(low), hertz_text(high));
  }
  return text;
}

std::string mode_name(const identify::ModeClassification& classification, std::size_t index) {
  return classification.order > 0 ? mode_type_of(classification) : fmt::format("mode {}", index + 1);
}

std::string source_name(const acquire::Record& record) {
  const std::string name = one_line(input_name(record.source()), 400);
  return record.files.size() > 1 ? fmt::format("{} and {} more", name, record.files.size() - 1) : name;
}

}  // namespace percuss::report
