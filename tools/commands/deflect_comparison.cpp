#include "commands/deflect_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/option_error.hpp"
#include "cli/option_units.hpp"
#include "cli/output.hpp"
#include "core/io/parse_number.hpp"
#include "model/beam/beam.hpp"
#include "model/impact/impact.hpp"
#include "report/beam_report.hpp"
#include "report/compare_report.hpp"
#include "report/json/read_document.hpp"

namespace percuss::tools {
namespace {

constexpr const char* kKeys = "give KEY=VALUE with ei, rho_a, torsion, length, support, ball_mass, speed or hertz";
constexpr std::size_t kBeamModes = 10;
constexpr double kMaxValue = 1e12;

struct ModelBeam {
  model::Impact impact;
  bool speed_known = false;
};

double positive(const std::string& entry, const std::string& text) {
  const ParsedNumber number = parse_number(text, false);
  if (number.problem == NumberProblem::none && number.value > 0 && number.value < kMaxValue) return number.value;
  throw OptionError::wrong_value("beam", entry, kKeys, "its value is no number above 0 and below 1e12");
}

ModelBeam beam_of(const std::vector<std::string>& entries) {
  ModelBeam out;
  struct Number {
    double* value;
    const char* unit;  // as a placeholder of an option
  };
  const std::map<std::string, Number> numbers{{"ei", {&out.impact.beam.stiffness_Nm2, ""}},
                                              {"rho_a", {&out.impact.beam.mass_per_length_kgpm, ""}},
                                              {"torsion", {&out.impact.beam.torsion_Nmprad, ""}},
                                              {"length", {&out.impact.beam.length_m, "M"}},
                                              {"ball_mass", {&out.impact.ball_mass_kg, "KG"}},
                                              {"speed", {&out.impact.speed_mps, "M/S"}},
                                              {"hertz", {&out.impact.hertz_Npm15, ""}}};
  for (const std::string& entry : entries) {
    const std::size_t equals = entry.find('=');
    const std::string key = entry.substr(0, equals), text = equals == std::string::npos ? "" : entry.substr(equals + 1);
    if (key == "support") {
      const auto support = report::support_named(text);
      if (!support) throw OptionError::wrong_value("beam", entry, "give torsion, pinned, clamped or free");
      out.impact.beam.support = *support;
      continue;
    }
    const auto number = numbers.find(key);
    if (number == numbers.end()) throw OptionError::wrong_value("beam", entry, kKeys, "it is not a known name");
    *number->second.value = positive(entry, in_option_unit(text, number->second.unit));
    out.speed_known = out.speed_known || key == "speed";
  }
  return out;
}

metrics::ComparedDocument document_of(ModelBeam beam, const pipeline::ImpactTest& test) {
  metrics::ComparedDocument out{
      .name = "model beam", .schema = "percuss/model-beam/1", .model = true, .modes = {}, .deflections = {}};
  for (const model::BeamMode& mode : model::beam_modes(beam.impact.beam, kBeamModes))
    out.modes.push_back({.freq_Hz = mode.freq_Hz(), .family = "bending", .shape = {}});
  double mean = 0;
  for (const pipeline::ImpactSpeed& one : test.speeds) mean += one.speed_mps / static_cast<double>(test.speeds.size());
  if (!beam.speed_known && test.speeds.empty()) return out;
  if (!beam.speed_known) beam.impact.speed_mps = mean;
  for (const pipeline::PointDeflection& point : test.points) {
    const bool on_beam = point.position_m && *point.position_m >= 0 && *point.position_m <= beam.impact.beam.length_m;
    const bool known = std::any_of(out.deflections.begin(), out.deflections.end(),
                                   [&](const auto& one) { return one.position_m == point.position_m; });
    if (!on_beam || known) continue;
    beam.impact.at_m = *point.position_m;
    out.deflections.push_back({.point = {},
                               .position_m = point.position_m,
                               .peak_m = std::abs(model::simulate_impact(beam.impact).peak_deflection_m)});
  }
  return out;
}

metrics::ComparedDocument document_of(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test,
                                      const ImpactModes& found) {
  metrics::ComparedDocument out{
      .name = analysis.record().source(), .schema = "percuss/deflection/1", .modes = {}, .deflections = {}};
  for (const identify::Mode& mode : found.modes)
    out.modes.push_back({.freq_Hz = mode.pole.freq_Hz, .freq_std_Hz = mode.freq_std_Hz, .family = "", .shape = {}});
  for (const pipeline::PointDeflection& point : test.points) {
    if (point.channel != 0 || std::isnan(point.peak_m)) continue;
    out.deflections.push_back(
        {.point = point.point, .position_m = point.position_m, .peak_m = std::abs(point.peak_m), .std_m = point.std_m});
  }
  return out;
}

}  // namespace

ImpactModes modes_of_impacts(const pipeline::Analysis& analysis) {
  ImpactModes out;
  if (analysis.record().has_force) {
    if (analysis.possible()) out.modes = analysis.modes();
    return out;
  }
  out.responses = pipeline::analyse_responses(analysis.record(), analysis.options());
  for (const identify::DecayMode& one : out.responses->found.modes) out.modes.push_back(one.mode);
  return out;
}

report::CommandReport impact_comparison(const ComparisonFlags& flags, const Host* host,
                                        const pipeline::Analysis& analysis, const pipeline::ImpactTest& test,
                                        const ImpactModes& modes) {
  std::vector<metrics::ComparedDocument> documents{document_of(analysis, test, modes)};
  for (const std::string& path : flags.compared) {
    for (metrics::ComparedDocument& one : report::read_documents(path)) {
      one.name = with_display_names(host, one.name);
      documents.push_back(std::move(one));
    }
  }
  if (!flags.beam.empty()) documents.push_back(document_of(beam_of(flags.beam), test));
  return report::compare_report(documents);
}

}  // namespace percuss::tools
