#include "report/json/analysis_json.hpp"

#include <nlohmann/json.hpp>

#include "core/parallel/parallel.hpp"
#include "pipeline/skipped_work.hpp"
#include "report/json/analysis_options_json.hpp"
#include "report/json/deflection_json.hpp"
#include "report/json/or_null.hpp"
#include "report/json/result_json.hpp"
#include "report/json/warning_json.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

// The deflection document without the members that the analysis has already.
Json deflection_in(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  Json json = Json::parse(deflection_json(analysis, test));
  for (const char* key : {"schema", "version", "inputs", "fs_hz"}) json.erase(key);
  return json;
}

Json inputs_json(const pipeline::Analysis& analysis) {
  Json json = Json::array();
  for (const acquire::InputFile& file : analysis.record().files)
    json.push_back({{"path", file.path}, {"bytes", file.bytes}});
  return json;
}

Json warnings_json(const std::vector<pipeline::Warning>& warnings) {
  Json json = Json::array();
  for (const pipeline::Warning& warning : warnings) json.push_back(warning_json(warning));
  return json;
}

Json skipped_json(const pipeline::Analysis& analysis) {
  Json json = Json::array();
  for (const pipeline::SkippedWork& one : pipeline::skipped_work(analysis)) {
    json.push_back({{"code", one.code}, {"what", one.what}, {"why", one.why}, {"share", or_null(one.share)}});
  }
  return json;
}

Json trace_json(const pipeline::Analysis& analysis) {
  Json json = Json::array();
  for (const auto& stage : analysis.trace().stages())
    json.push_back({{"stage", stage.name}, {"calls", stage.calls}, {"seconds", stage.seconds}});
  return json;
}

void add_modes(JsonDocument& document, const pipeline::Analysis& analysis, const JsonOptions& options) {
  const bool classes = options.sections.contains(ReportSection::classes);
  const std::vector<identify::Mode>& modes = options.modes != nullptr ? options.modes->modes : analysis.modes();
  const double decay = analysis.window_decay_per_s();
  const std::vector<double>& frac = analysis.fit().mode_frac;
  const std::vector<identify::ModeClassification>* classifications = options.classifications;
  if (classes && classifications == nullptr) classifications = &analysis.classifications();
  document.add(
      "modes", modes.size(),
      [&modes, &frac, decay, classifications, classes, shape = options.shape, of = options.modes](std::size_t m) {
        const std::size_t fitted = of != nullptr ? of->of_analysis[m] : m;
        std::string text = mode_json(modes[m], m,
                                     {.window_decay_per_s = decay,
                                      .classification = classes ? &(*classifications)[m] : nullptr,
                                      .frac = fitted < frac.size() ? frac[fitted] : 0});
        return shape ? with_member(std::move(text), "shape", shape(m)) : text;
      });
  analysis.channel_findings();
  analysis.unexplained_peaks();
  document.add("fit", [&] { return fit_json(analysis); });
  document.add("delays", [&] { return delays_json(analysis); });
  document.add("unexplained_peaks", [&] { return unexplained_peaks_json(analysis); });
}

void add_frfs(JsonDocument& document, const pipeline::Analysis& analysis, const JsonOptions& options) {
  const bool frf = options.sections.contains(ReportSection::frf),
             coherence = options.sections.contains(ReportSection::coherence);
  if (frf || coherence) analysis.frfs();
  if (frf) document.add("frf", [&] { return frf_json(analysis); });
  if (coherence) document.add("coherence", [&] { return coherence_json(analysis); });
}

// Several threads make the values when the document is written: the stages must run before.
void add_found(JsonDocument& document, const pipeline::Analysis& analysis, const JsonOptions& options) {
  const bool modes =
      options.sections.contains(ReportSection::modes) || options.sections.contains(ReportSection::classes);
  const bool frfs =
      options.sections.contains(ReportSection::frf) || options.sections.contains(ReportSection::coherence);
  if (modes && frfs) analysis.compute_modes_and_frfs();
  add_frfs(document, analysis, options);
  if (modes) add_modes(document, analysis, options);
  if (options.per_hit) {
    analysis.modes_per_hit();
    document.add("modes_per_hit", [&] { return modes_per_hit_json(analysis); });
  }
  if (options.stabilisation)
    document.add("stabilisation", [&diagram = analysis.stabilisation()] { return stabilisation_json(diagram); });
}

}  // namespace

JsonDocument analysis_document(const pipeline::Analysis& analysis, const JsonOptions& options) {
  const auto wants = [&](ReportSection section) { return options.sections.contains(section); };
  const bool force_only = options.sections == std::set{ReportSection::hits};
  JsonDocument document;
  document.add_written("schema", Json("percuss/analysis/1"));
  document.add_written("version", Json(version()));
  document.add_written("inputs", inputs_json(analysis));
  if (options.bat) document.add_written("bat", bat_json(*options.bat));
  // FRFs do not contain the sampling rate.
  document.add_written("fs_hz", analysis.given_frfs() != nullptr ? Json() : Json(analysis.record().fs_Hz));
  const auto& hits = force_only ? analysis.force_hits() : analysis.hits();
  if (analysis.possible()) {
    const auto [low, high] = analysis.band_Hz();
    document.add_written("band_hz", Json{low, high});
  }
  if (!force_only && wants(ReportSection::modes))
    document.add_written("effort", Json(name_of(analysis.options().modes.effort)));
  if (const Json chosen = options_json(analysis.options()); !chosen.empty()) document.add_written("options", chosen);
  if (wants(ReportSection::hits)) {
    document.add("hits", hits.size(), [&](std::size_t i) { return hit_json(analysis.record(), i, hits[i]); });
  }
  if (analysis.possible()) {
    add_found(document, analysis, options);
  } else if (wants(ReportSection::modes)) {
    document.add_written("modes", Json::array());
  }
  if (options.deflection != nullptr) document.add_written("deflection", deflection_in(analysis, *options.deflection));
  document.add_written("warnings",
                       warnings_json(options.warnings != nullptr ? *options.warnings : analysis.warnings()));
  if (options.explain) document.add_written("skipped", skipped_json(analysis));
  if (options.trace) document.add_written("trace", trace_json(analysis));
  return document;
}

std::string analysis_json(const pipeline::Analysis& analysis, const JsonOptions& options) {
  const ThreadLimit limit(analysis.options().threads);
  return analysis_document(analysis, options).text() + "\n";
}

std::string analysis_json(const std::vector<NumberedAnalysis>& tests, const JsonOptions& options) {
  if (tests.size() == 1) return analysis_json(*tests.front().analysis, options);
  std::vector<JsonDocument> runs;
  for (const NumberedAnalysis& test : tests) {
    runs.push_back(analysis_document(*test.analysis, options));
    runs.back().add_written("run", Json(test.run));
  }
  JsonDocument document;
  document.add_written("schema", Json("percuss/analysis/1"));
  document.add_written("version", Json(version()));
  document.add("runs", runs.size(), [&](std::size_t i) { return runs[i].text(); });
  const ThreadLimit limit(tests.empty() ? 0 : tests.front().analysis->options().threads);
  return document.text() + "\n";
}

}  // namespace percuss::report
