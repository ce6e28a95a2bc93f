#include "report/html/analysis_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "identify/start/cmif.hpp"
#include "report/html/analysis_plot_data.hpp"
#include "report/html/fit_plot_data.hpp"
#include "report/html/html_page.hpp"
#include "report/html/method_section.hpp"
#include "report/json/json_document.hpp"
#include "report/svg/deflection_chart.hpp"
#include "report/text/analysis_summary.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/deflection_text.hpp"
#include "report/text/html_escape.hpp"

namespace percuss::report {

std::string frf_section(const std::string& summary) {
  return page_section(
      "frf", "Frequency responses",
      page_hint("Drag to zoom in on a frequency range in all three plots; double-click to see the whole band.") +
          page_plot("magnitude", "Magnitude of the frequency responses in decibels over frequency. " + summary) +
          page_plot("phase", "Phase of the frequency responses over frequency.") +
          page_plot("coherence", "Coherence over frequency, 0 to 1."));
}

std::string fit_section(const pipeline::Analysis& analysis, const PageWarnings& warnings) {
  const std::size_t others = analysis.fitted_modes().size() - analysis.modes().size();
  return page_section("fit", "Fit of the modes",
                      page_paragraph(fmt::format(
                          "Measured FRFs against the FRFs synthesised from the modes{}. Triangles: peaks that no "
                          "mode explains, with their level below the largest peak.",
                          others > 0 ? fmt::format(" and the {} fitted ones that are not listed", others) : "")) +
                          page_panel("fit", "Measured and synthesised frequency response of one point and channel.") +
                          warnings.beside(PagePart::fit));
}

std::string indicator_section(const pipeline::Analysis& analysis) {
  const bool several = analysis.record().accel.size() > 1 && analysis.points().size() > 1;
  return page_section(
      "indicator", "Mode indicators",
      page_paragraph(std::string("Singular values of the FRFs (CMIF)") +
                     (several ? ": if the second peaks with the first, two modes share a frequency." : ".") +
                     " Below, the mode indicator function (MIF): it falls towards 0 "
                     "where a mode dominates.") +
          page_plot("indicator", "Singular values of the FRFs in decibels over frequency.") +
          page_plot("mif", "Mode indicator function over frequency, 0 to 1."));
}

std::string stabilisation_section(const PageWarnings& warnings) {
  return page_section("stabilisation", "Stabilisation",
                      page_plot("stabilisation", "Poles of every model order over frequency.") +
                          warnings.beside(PagePart::stabilisation));
}

std::string hits_section(const pipeline::Analysis& analysis, const PageWarnings& warnings) {
  constexpr std::size_t kMaxListed = 20;  // longer tables are folded
  const HitsTable table = hits_table(analysis, analysis.hits());
  const std::string more =
      table.left_out > 0 ? page_paragraph(fmt::format("… and {} more accepted hits.", table.left_out)) : "";
  const bool excluded = std::any_of(analysis.hits().begin(), analysis.hits().end(),
                                    [](const pipeline::AnalysedHit& hit) { return !hit.accepted; });
  const std::string key =
      excluded ? page_paragraph("Values struck through belong to rejected hits and are in no result.") : "";
  std::string shown = table.shown.html() + key + more;
  if (analysis.hits().size() > kMaxListed) {
    shown =
        fmt::format("<details>\n<summary>Table of {} hits</summary>\n{}</details>\n", analysis.hits().size(), shown);
  }
  return page_section(
      "hits", "Hits",
      shown + page_plot("force", "Force of the first hits over time.") + warnings.beside(PagePart::force) +
          page_plot("response", "Response of the first accelerometer to the pulses over time.") +
          warnings.beside(PagePart::response) +
          page_plot("spectrum", "Spectrum of the force in decibels over frequency.") +
          warnings.beside(PagePart::spectrum) + page_plot("decay", "Decay of the responses in decibels over time.") +
          warnings.beside(PagePart::decay));
}

std::set<PagePart> parts_of_hits() {
  return {PagePart::force, PagePart::response, PagePart::spectrum, PagePart::decay};
}

std::string quoted_modes_key(const std::vector<identify::ModeClassification>& classifications) {
  if (std::all_of(classifications.begin(), classifications.end(), is_quoted)) return "";
  return page_paragraph(
      "A split mode has two peaks, of which one is quoted. Values struck through belong to the other.");
}

namespace {

std::string frf_sentence(const pipeline::Analysis& analysis) {
  const acquire::LineRange& lines = analysis.lines();
  return fmt::format("{} frequency responses of {} spectral lines from {:.4g} to {:.4g} Hz, {:.4g} Hz apart.",
                     analysis.frfs().size(), lines.count, lines.freq_Hz(0), lines.freq_Hz(lines.count - 1),
                     lines.df_Hz());
}

std::string hits_sentence(const pipeline::Analysis& analysis) {
  const auto& hits = analysis.hits();
  const auto used =
      std::count_if(hits.begin(), hits.end(), [](const pipeline::AnalysedHit& hit) { return hit.accepted; });
  return fmt::format("{} of {} hits can be used.", used, hits.size());
}

std::string deflection_section(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  return page_section("deflection", "Deflection",
                      deflection_tables(analysis, test).html() + page_chart(deflection_chart(analysis, test)));
}

std::string fit_data(const pipeline::Analysis& analysis) {
  const Eigen::MatrixXd values = identify::cmif(analysis.fitted_frfs(), analysis.band_lines());
  return ascii_text(nlohmann::ordered_json{{"fit", fit_plot_json(analysis, nullptr)},
                                           {"indicator", indicator_plot_json(analysis, values)}});
}

std::string comparison_section(const CommandReport& comparison) {
  std::string charts;
  for (const LineChart& chart : comparison.charts) charts += page_chart(chart);
  return page_section("comparison", "Comparison with other documents", comparison.text.html() + charts);
}

}  // namespace

std::string analysis_page(const pipeline::Analysis& analysis, const PageOptions& options,
                          const Provenance& provenance) {
  const auto wants = [&](ReportSection section) { return options.sections.contains(section); };
  const bool possible = analysis.possible(), modes = wants(ReportSection::modes) || wants(ReportSection::classes);
  const bool with_hits = wants(ReportSection::hits) && analysis.given_frfs() == nullptr;
  const bool frfs = possible && (wants(ReportSection::frf) || wants(ReportSection::coherence));
  const std::vector<identify::ModeClassification> classifications =
      possible && modes ? analysis.classifications() : std::vector<identify::ModeClassification>();
  const std::string summary = modes || !possible ? summary_sentence(analysis, classifications)
                              : frfs             ? frf_sentence(analysis)
                                                 : hits_sentence(analysis);
  const bool fitted = possible && modes;
  std::set<PagePart> parts = with_hits ? parts_of_hits() : std::set<PagePart>();
  if (fitted) parts.insert({PagePart::fit, PagePart::stabilisation});
  const PageWarnings warnings(analysis.warnings(), with_hits ? analysis.hits() : std::vector<pipeline::AnalysedHit>(),
                              parts);
  std::string found = "<p class=\"verdict\">" + html_escape(summary) + "</p>\n" + warnings.caution();
  if (!classifications.empty()) found += modes_table(analysis, wants(ReportSection::classes)).html();
  if (wants(ReportSection::classes)) found += quoted_modes_key(classifications);
  const std::string title = title_of(analysis.record().files);
  std::string body = page_header(title, test_conditions(analysis, with_hits ? analysis.hits().size() : 0),
                                 with_file_facts(provenance.title_block, analysis)) +
                     "<main>\n";
  body += page_section(modes ? "modes" : "result", modes ? "Modes" : "Result", found);
  body += warnings.section();
  if (options.comparison != nullptr) body += comparison_section(*options.comparison);
  if (frfs) body += frf_section(summary);
  if (fitted) body += fit_section(analysis, warnings);
  if (with_hits) body += hits_section(analysis, warnings);
  if (options.deflection != nullptr) body += deflection_section(analysis, *options.deflection);
  if (fitted) {
    body += page_section("movement", "Cross-section of the barrel",
                         page_plot("movement", "Cross-section of the barrel in each mode."));
    body += indicator_section(analysis) + stabilisation_section(warnings);
  }
  body += method_section(analysis, {.modes = modes, .deflection = options.deflection});
  body += page_section("provenance", "Provenance", page_provenance(analysis.record().files, provenance)) + "</main>\n";
  const PlotSelection wanted{.hits = with_hits, .frfs = frfs, .stabilisation = modes};
  return HtmlPage{.title = page_title(title, provenance.title_block),
                  .body = body,
                  .block = provenance.title_block,
                  .data = "[" + analysis_plot_data(analysis, classifications, wanted) +
                          (fitted ? "," + fit_data(analysis) : "") + "]"}
      .text();
}

}  // namespace percuss::report
