#include "report/json/response_json.hpp"

#include <nlohmann/json.hpp>

#include "core/units.hpp"
#include "report/json/analysis_options_json.hpp"
#include "report/json/bat_label.hpp"
#include "report/json/json_document.hpp"
#include "report/json/result_json.hpp"
#include "report/json/warning_json.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

Json hit_of(const pipeline::ResponseTest& test, std::size_t h) {
  const pipeline::ResponseHit& hit = test.hits[h];
  Json json{{"index", h}, {"point", hit.point}};
  if (test.record.files.size() > 1) json["file"] = test.record.files[test.record.rows[hit.impact.row].file].path;
  if (test.record.rows.size() > 1) json["row"] = hit.impact.row;
  json["time_s"] = hit.impact.whole_pulse ? Json(hit.onset_s) : Json();
  json["accepted"] = hit.accepted;
  if (hit.by_user) json["by_user"] = true;
  json["findings"] = Json::array();
  if (!hit.reason.empty())
    json["findings"].push_back({{"code", "short_hit"},
                                {"severity", "reject"},
                                {"value", static_cast<double>(hit.impact.end - hit.impact.first) / test.record.fs_Hz},
                                {"message", hit.reason}});
  return json;
}

Json mode_of(const pipeline::ResponseTest& test, std::size_t m, bool classes) {
  const identify::DecayMode& found = test.found.modes[m];
  const ModeJson of{.classification = classes && m < test.classifications.size() ? &test.classifications[m] : nullptr};
  Json json = Json::parse(mode_json(found.mode, m, of));
  json["hit_amplitudes"] = Json::array();
  for (const identify::HitAmplitude& hit : found.hits)
    json["hit_amplitudes"].push_back({{"re", hit.value.real()}, {"im", hit.value.imag()}, {"std", hit.std}});
  return json;
}

Json document_of(const pipeline::ResponseTest& test, const std::optional<BatLabel>& bat,
                 const std::set<ReportSection>& sections) {
  const bool classes = sections.contains(ReportSection::classes);
  const bool modes = classes || sections.contains(ReportSection::modes);
  Json json{{"schema", "percuss/analysis/1"}, {"version", version()}, {"inputs", Json::array()}};
  for (const acquire::InputFile& file : test.record.files)
    json["inputs"].push_back({{"path", file.path}, {"bytes", file.bytes}});
  if (bat) json["bat"] = bat_json(*bat);
  json["input"] = "response";
  json["excitation"] = "unknown";
  json["fs_hz"] = test.record.fs_Hz;
  if (test.fitted && test.possible()) json["band_hz"] = {test.band_Hz.first, test.band_Hz.second};
  if (const Json chosen = options_json(test.options); !chosen.empty()) json["options"] = chosen;
  if (sections.contains(ReportSection::hits)) {
    json["hits"] = Json::array();
    for (std::size_t h = 0; h < test.hits.size(); ++h) json["hits"].push_back(hit_of(test, h));
  }
  if (modes && test.possible()) {
    json["decay"] = {{"start_s", test.start_s},
                     {"end_s", static_cast<double>(test.samples) / test.record.fs_Hz},
                     {"reference_channel", test.found.reference},
                     {"unit", si_name(test.record.accel[test.found.reference].measures)}};
  }
  if (modes) json["modes"] = Json::array();
  for (std::size_t m = 0; modes && m < test.found.modes.size(); ++m) json["modes"].push_back(mode_of(test, m, classes));
  json["warnings"] = Json::array();
  for (const pipeline::Warning& warning : test.warnings) json["warnings"].push_back(warning_json(warning));
  return json;
}

}  // namespace

std::string responses_json(const std::vector<pipeline::ResponseTest>& tests, const std::optional<BatLabel>& bat,
                           const std::set<ReportSection>& sections) {
  if (tests.size() == 1) return indented_text(document_of(tests.front(), bat, sections)) + "\n";
  Json json{{"schema", "percuss/analysis/1"}, {"version", version()}, {"runs", Json::array()}};
  for (std::size_t t = 0; t < tests.size(); ++t) {
    json["runs"].push_back(document_of(tests[t], bat, sections));
    json["runs"].back()["run"] = t;
  }
  return indented_text(json) + "\n";
}

}  // namespace percuss::report
