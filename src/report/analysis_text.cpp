#include "report/analysis_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "acquire/input_file.hpp"
#include "core/error.hpp"
#include "core/significant.hpp"
#include "core/units.hpp"
#include "report/coherence_summary.hpp"
#include "report/number.hpp"
#include "report/response_summary.hpp"
#include "report/text_table.hpp"

namespace percuss {
namespace {

constexpr std::size_t kMostHits = 40;  // rows of hits shown when all is well; rejected ones always are

std::string heading(const Analysis& analysis, std::size_t hits, std::size_t width) {
  const Record& record = analysis.record();
  std::string name = one_line(input_name(record.source()), 400);
  if (record.files.size() > 1) name += fmt::format(" and {} more", record.files.size() - 1);
  std::string sensors = fmt::format("{} accelerometer{}", record.accel.size(), record.accel.size() == 1 ? "" : "s");
  std::string angles;
  for (const SignalInfo& signal : record.accel) {
    if (signal.angle_rad)
      angles += fmt::format("{}{:.4g}°", angles.empty() ? "" : ", ", *signal.angle_rad * kRadian_deg);
  }
  if (!angles.empty()) sensors += " (" + angles + ")";
  std::string text =
      fmt::format("{} · {} hit{} × {}", short_frequency(record.fs_Hz), hits, hits == 1 ? "" : "s", sensors);
  if (const FrfRecord* given = analysis.given_frfs()) {
    const std::size_t points = given->frfs.size() / record.accel.size();
    text = fmt::format("FRFs ({}) · {} point{} × {}", name_of(given->kind), points, points == 1 ? "" : "s", sensors);
  }
  if (analysis.possible()) {
    const auto [low, high] = analysis.band_Hz();
    text += fmt::format(" · band {:.4g}–{:.4g} Hz", low, high);
  }
  if (text_width(name) + 3 + text_width(text) <= width) return name + "   " + text + '\n';
  return name + "\n  " + wrapped(text, width, 2) + '\n';
}

// What does not reject is said in full once, among the warnings; beside the hit its name and number do.
std::string brief(const Finding& finding) {
  switch (finding.code) {
    case FindingCode::weak:
      return fmt::format("weak ({:.0f} %)", finding.value * 100);
    case FindingCode::truncated_decay:
      return fmt::format("rings on ({:.0f} dB)", finding.value);
    case FindingCode::low_bandwidth:
      return "soft";
    case FindingCode::low_coherence:
      return finding.value > 0 ? fmt::format("agrees {:.0f} % with the others", finding.value * 100)
                               : "does not agree with the others";
    case FindingCode::polarity:
      return "negative";
    default:
      return finding.message;
  }
}

std::string hit_verdict(const AnalysedHit& hit) {
  std::string text = hit.accepted ? "ok" : "rejected";
  if (hit.by_user) text += hit.accepted ? " (kept by --accept-hit)" : " (taken out by --reject-hit)";
  std::string reasons;
  for (const Finding& finding : hit.hit.findings) {
    reasons +=
        (reasons.empty() ? ": " : "; ") + (finding.severity == Severity::reject ? finding.message : brief(finding));
  }
  return text + reasons;
}

std::string hits_text(const Analysis& analysis, const std::vector<AnalysedHit>& hits, std::size_t width) {
  const bool points =
      std::any_of(hits.begin(), hits.end(), [&](const AnalysedHit& h) { return h.point != hits.front().point; });
  const bool files = analysis.record().files.size() > 1;
  std::vector<TextTable::Column> columns{{"hit", TextTable::Align::right}};
  if (points) columns.push_back({"point", TextTable::Align::right});
  if (files) columns.push_back({"file"});
  for (const char* name : {"time", "peak", "pulse", "reaches"}) columns.push_back({name, TextTable::Align::right});
  columns.push_back({"verdict"});
  TextTable table(columns);
  std::size_t shown = 0, left_out = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].accepted && shown >= kMostHits) {
      ++left_out;
      continue;
    }
    ++shown;
    const Hit& hit = hits[i].hit;
    const bool pulse = !hit.gated_N.empty();
    std::vector<std::string> cells{fmt::format("{}", i)};
    if (points) cells.push_back(fmt::format("{}", hits[i].point));
    if (files) {
      const std::string& path = analysis.record().files[analysis.record().rows[hit.row].file].path;
      cells.push_back(one_line(path.substr(path.rfind('/') + 1), 40));
    }
    cells.push_back(pulse ? fmt::format("{:.3f} s", hit.onset_s) : "–");
    cells.push_back(pulse ? fmt::format("{:.3g} N", hit.peak_N) : "–");
    cells.push_back(pulse ? fmt::format("{:.2f} ms", hit.pulse_s * 1e3) : "–");
    cells.push_back(pulse ? short_frequency(std::round(hit.bandwidth_Hz)) : "–");
    cells.push_back(hit_verdict(hits[i]));
    table.add(std::move(cells));
  }
  std::string text = table.text(width);
  if (left_out > 0) text += fmt::format("… and {} more hits in order (all of them with --json)\n", left_out);
  return text;
}

std::string note_of(const Analysis& analysis, std::size_t m) {
  const Verdict& verdict = analysis.verdicts()[m];
  std::string note;
  const auto add = [&](const std::string& text) { note += (note.empty() ? "" : "; ") + text; };
  if (verdict.double_peak) {
    add(verdict.double_peak->first ? fmt::format("double peak, {} Hz apart: this one is quoted",
                                                 significant(verdict.double_peak->separation_Hz, 3))
                                   : "second of the double peak");
  }
  if (verdict.family != Family::unknown && verdict.confidence < 0.95)
    add(fmt::format("{:.0f} % sure", verdict.confidence * 100));
  if (verdict.alternative) add(fmt::format("could be {}", name_of(*verdict.alternative)));
  return note;
}

std::string family_of(const Verdict& verdict) {
  return verdict.order > 0 ? fmt::format("{} {}", name_of(verdict.family), verdict.order) : name_of(verdict.family);
}

std::string decibels(double value_dB) {
  const double rounded_dB = std::round(value_dB * 10) / 10;
  return fmt::format("{:.1f} dB", rounded_dB == 0 ? 0.0 : rounded_dB);  // no -0.0
}

std::string modes_text(const Analysis& analysis, bool classes, std::size_t width) {
  if (analysis.modes().empty()) {
    return analysis.options().modes.start_Hz.empty() ? "no mode stands out of the noise in the band\n"
                                                     : "no mode could be fitted at the frequencies of --start\n";
  }
  const bool named = classes && std::any_of(analysis.verdicts().begin(), analysis.verdicts().end(),
                                            [](const Verdict& v) { return v.ratio.has_value(); });
  std::vector<TextTable::Column> columns{{"mode", TextTable::Align::right}};
  if (named) columns.push_back({"family"});
  columns.push_back({"frequency", TextTable::Align::right});
  columns.push_back({"damping", TextTable::Align::right});
  if (named) columns.push_back({"overlay", TextTable::Align::right});
  columns.push_back({"note"});
  TextTable table(columns);
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    const Mode& mode = analysis.modes()[m];
    std::vector<std::string> cells{fmt::format("{}", m)};
    if (named) cells.push_back(family_of(analysis.verdicts()[m]));
    cells.push_back(with_deviation(mode.pole.freq_Hz, mode.freq_std_Hz) + " Hz");
    cells.push_back(with_deviation(mode.pole.damping_ratio * 100, mode.damping_std * 100) + " %");
    if (named) {
      const auto& overlay_dB = analysis.verdicts()[m].overlay_dB;
      cells.push_back(overlay_dB ? decibels(*overlay_dB) : "–");
    }
    cells.push_back(classes ? note_of(analysis, m) : "");
    table.add(std::move(cells));
  }
  return table.text(width);
}

std::string frf_text(const Analysis& analysis) {
  const auto [least, most] =
      std::minmax_element(analysis.frfs().begin(), analysis.frfs().end(),
                          [](const PointFrf& a, const PointFrf& b) { return a.frf.averages < b.frf.averages; });
  std::string averages = fmt::format("{}", least->frf.averages);
  if (most->frf.averages != least->frf.averages) averages += fmt::format(" to {}", most->frf.averages);
  if (most->frf.averages == 0) averages = "not stated";
  return fmt::format("FRFs: {} lines, {:.4g} Hz apart; averages: {}\n", analysis.lines().count,
                     analysis.lines().df_Hz(), averages);
}

// Of several FRFs the one that agrees least.
std::string coherence_text(const Analysis& analysis) {
  std::optional<CoherenceSummary> worst;
  for (const PointFrf& frf : analysis.frfs()) {
    const auto summary = summary_of_coherence(analysis, frf);
    if (summary && (!worst || summary->mean < worst->mean)) worst = summary;
  }
  if (!worst && analysis.given_frfs() != nullptr) return "coherence: none in the file\n";
  if (!worst) return "coherence: none, as no point has several hits\n";
  return fmt::format("coherence{}: {:.4f} on average, below 0.9 on {:.1f} % of the band's lines\n",
                     analysis.frfs().size() > 1 ? " (of the worst FRF)" : "", worst->mean, worst->below * 100);
}

std::string per_hit_text(const Analysis& analysis, std::size_t width) {
  TextTable table({{"mode", TextTable::Align::right},
                   {"hit", TextTable::Align::right},
                   {"peak", TextTable::Align::right},
                   {"frequency", TextTable::Align::right},
                   {"damping", TextTable::Align::right},
                   {""}});
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    for (const HitMode& found : analysis.modes_per_hit()) {
      if (found.mode != m) continue;
      table.add({fmt::format("{}", m), fmt::format("{}", found.hit),
                 fmt::format("{:.3g} N", analysis.hits()[found.hit].hit.peak_N),
                 with_deviation(found.pole.freq_Hz, found.freq_std_Hz) + " Hz",
                 with_deviation(found.pole.damping_ratio * 100, found.damping_std * 100) + " %", ""});
    }
  }
  return table.text(width);
}

std::string spaced(const std::string& text) { return text.empty() ? text : text + '\n'; }

}  // namespace

std::string analysis_text(const Analysis& analysis, const TextOptions& options) {
  const auto wants = [&](Section section) { return options.sections.contains(section); };
  const bool force_only = options.sections == std::set{Section::hits};
  const auto& hits = force_only ? analysis.force_hits() : analysis.hits();
  std::string text = heading(analysis, hits.size(), options.width) + "\n";
  const bool has_hits = analysis.given_frfs() == nullptr;
  if (wants(Section::hits) && has_hits) text += hits_text(analysis, hits, options.width) + "\n";
  if (wants(Section::hits) && !force_only && has_hits) text += spaced(responses_text(analysis, options.width));
  if (analysis.possible()) {
    if (wants(Section::frf)) text += frf_text(analysis);
    if (wants(Section::coherence)) text += coherence_text(analysis);
    if (wants(Section::frf) || wants(Section::coherence)) text += '\n';
    if (wants(Section::modes) || wants(Section::classes))
      text += modes_text(analysis, wants(Section::classes), options.width) + "\n";
    if (options.per_hit) text += per_hit_text(analysis, options.width) + "\n";
  } else {
    text += "no hit can be used: no FRF, no modes (--accept-hit overrules a rejection)\n\n";
  }
  for (const Warning& warning : options.warnings ? analysis.warnings() : std::vector<Warning>{})
    text += wrapped("! " + one_line(warning.message, 4000), options.width, 2) + "\n";
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

}  // namespace percuss
