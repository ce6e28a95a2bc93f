#include "report/text/analysis_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/coherence_summary.hpp"
#include "report/text/frf_terminal_plot.hpp"
#include "report/text/number_format.hpp"
#include "report/text/response_summary.hpp"
#include "report/text/text_table.hpp"
#include "report/text/warnings_text.hpp"

namespace percuss::report {
namespace {

std::string heading(const pipeline::Analysis& analysis, std::size_t hits, std::size_t width) {
  const std::string name = source_name(analysis.record());
  const std::string text = test_conditions(analysis, hits);
  if (text_width(name) + 3 + text_width(text) <= width) return name + "   " + text + '\n';
  return name + "\n  " + wrapped(text, width, 2) + '\n';
}

std::string hits_text(const pipeline::Analysis& analysis, const std::vector<pipeline::AnalysedHit>& hits,
                      std::size_t width) {
  const HitsTable table = hits_table(analysis, hits);
  std::string text = table.shown.text(width);
  if (table.left_out > 0)
    text += fmt::format("… and {} more accepted hits (the JSON document lists all)\n", table.left_out);
  return text;
}

std::string modes_text(const pipeline::Analysis& analysis, bool classes, std::size_t width) {
  return analysis.modes().empty() ? no_modes_text(analysis) : modes_table(analysis, classes).text(width);
}

// FRFs with a coherence, from which standard deviations follow once the number of averages is known.
bool averages_would_help(const pipeline::Analysis& analysis) {
  const auto& frfs = analysis.frfs();
  return analysis.given_frfs() != nullptr && std::any_of(frfs.begin(), frfs.end(), [](const auto& one) {
           return one.frf.averages == 0 && one.frf.std.empty() && !one.frf.coherence.empty();
         });
}

std::string frf_text(const pipeline::Analysis& analysis) {
  const auto [least, most] = std::minmax_element(
      analysis.frfs().begin(), analysis.frfs().end(),
      [](const acquire::PointFrf& a, const acquire::PointFrf& b) { return a.frf.averages < b.frf.averages; });
  std::string averages = fmt::format("{}", least->frf.averages);
  if (most->frf.averages != least->frf.averages) averages += fmt::format(" to {}", most->frf.averages);
  if (most->frf.averages == 0) averages = "not stated";
  const acquire::LineRange& lines = analysis.lines();
  return fmt::format("FRFs: {} spectral lines from {:.4g} to {:.4g} Hz, {:.4g} Hz apart; averages: {}\n", lines.count,
                     lines.freq_Hz(0), lines.freq_Hz(lines.count - 1), lines.df_Hz(), averages);
}

// The lowest coherence of several FRFs.
std::string coherence_text(const pipeline::Analysis& analysis) {
  std::optional<CoherenceSummary> worst;
  for (const auto& summary : coherence_summaries(analysis)) {
    if (summary && (!worst || summary->mean < worst->mean)) worst = summary;
  }
  if (!worst && analysis.given_frfs() != nullptr) return "coherence: none in the file\n";
  if (!worst) return "coherence: none, as no point has several hits\n";
  return fmt::format("coherence{}: {:.4f} on average, below 0.9 on {:.1f} % of the band's lines\n",
                     analysis.frfs().size() > 1 ? " (of the worst FRF)" : "", worst->mean, worst->below * 100);
}

std::string per_hit_text(const pipeline::Analysis& analysis, std::size_t width) {
  TextTable table({{"mode", TextTable::Align::right},
                   {"hit", TextTable::Align::right},
                   {"peak", TextTable::Align::right},
                   {"frequency", TextTable::Align::right},
                   {"damping", TextTable::Align::right},
                   {""}});
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    for (const pipeline::HitMode& found : analysis.modes_per_hit()) {
      if (found.mode != m) continue;
      table.add({fmt::format("{}", m + 1), fmt::format("{}", found.hit + 1),
                 force_text(analysis.hits()[found.hit].hit.peak_N),
                 value_with_std(found.pole.freq_Hz, found.freq_std_parts_Hz.total()) + " Hz",
                 value_with_std(found.pole.damping_ratio * 100, found.damping_std_parts.total() * 100) + " %", ""});
    }
  }
  return table.text(width);
}

std::string written(const Message& message, const TextOptions& options) {
  const std::string words = options.write_option != nullptr ? message.written(options.write_option) : message.text;
  return wrapped(words, options.width, 2);
}

Message judged_by_force() {
  return {
      "hits are judged by their force alone: the accelerations were not read and may be clipped; add a section, "
      "such as frf, to judge both",
      {"only"}};
}

Message state_averages() {
  return {
      "the file does not state the number of averages, so its coherence does not count in the ±; state the number of "
      "hits or records that each FRF is averaged over",
      {"averages"}};
}

std::string spaced(const std::string& text) { return text.empty() ? text : text + '\n'; }

}  // namespace

Message no_usable_hit(const std::vector<pipeline::AnalysedHit>& hits) {
  const std::string result = "so there are no FRFs and no modes";
  if (pipeline::can_accept_more(hits))
    return {"no hit can be used, " + result + "; to use a hit despite its findings, accept it", {"accept_hit"}};
  const bool pulses =
      std::any_of(hits.begin(), hits.end(), [](const auto& hit) { return pipeline::can_be_accepted(hit); });
  return {(pulses ? "no hit can be used, " : "no hit has a pulse of the force, ") + result};
}

std::string analysis_text(const pipeline::Analysis& analysis, const TextOptions& options) {
  const auto wants = [&](ReportSection section) { return options.sections.contains(section); };
  const bool force_only = options.sections == std::set{ReportSection::hits};
  const auto& hits = force_only ? analysis.force_hits() : analysis.hits();
  std::string text = heading(analysis, hits.size(), options.width) + "\n";
  const bool has_hits = analysis.given_frfs() == nullptr;
  if (wants(ReportSection::hits) && has_hits) text += hits_text(analysis, hits, options.width) + "\n";
  if (force_only && has_hits && !hits.empty()) text += written(judged_by_force(), options) + "\n\n";
  if (wants(ReportSection::hits) && !force_only && has_hits) text += spaced(responses_text(analysis, options.width));
  if (analysis.possible()) {
    const bool frfs = wants(ReportSection::frf) || wants(ReportSection::coherence);
    const bool modes = wants(ReportSection::modes) || wants(ReportSection::classes);
    if (frfs && modes) analysis.compute_modes_and_frfs();
    if (wants(ReportSection::frf)) text += frf_text(analysis);
    if (wants(ReportSection::coherence)) text += coherence_text(analysis);
    if (frfs && averages_would_help(analysis)) text += written(state_averages(), options) + '\n';
    if (frfs) text += '\n';
    if (options.sketch && (wants(ReportSection::frf) || wants(ReportSection::modes)))
      text += spaced(frf_terminal_plot(analysis, options.width));
    if (modes) text += modes_text(analysis, wants(ReportSection::classes), options.width) + "\n";
    if (options.per_hit) text += per_hit_text(analysis, options.width) + "\n";
  } else {
    text += written(no_usable_hit(hits), options) + "\n\n";
  }
  if (options.warnings) text += warnings_text(analysis.warnings()).text(options.width, options.write_option);
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

}  // namespace percuss::report
