#include "report/analysis_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "acquire/csv_number.hpp"
#include "core/units.hpp"
#include "identify/ring_split.hpp"
#include "pipeline/skipped.hpp"
#include "report/coherence_summary.hpp"
#include "report/deflection_report.hpp"
#include "report/version.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;

Json finding_json(const Finding& finding) {
  Json json{{"code", name_of(finding.code)}, {"severity", name_of(finding.severity)}, {"value", finding.value}};
  if (finding.delay_s) json["delay_s"] = *finding.delay_s;
  json["message"] = finding.message;
  return json;
}

Json response_json(std::size_t channel, const ResponseGrade& grade) {
  Json json{
      {"channel", channel}, {"left_db", grade.left_dB}, {"truncated", grade.truncated}, {"polarity", grade.polarity}};
  json["delay_s"] = grade.delay_s ? Json(*grade.delay_s) : Json();
  return json;
}

Json hits_json(const Analysis& analysis, const std::vector<AnalysedHit>& hits) {
  Json out = Json::array();
  const bool several = analysis.record().files.size() > 1;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Hit& hit = hits[i].hit;
    Json json{{"index", i}, {"point", hits[i].point}};
    if (several) json["file"] = analysis.record().files[analysis.record().rows[hit.row].file].path;
    if (analysis.record().rows.size() > 1) json["row"] = hit.row;
    json["time_s"] = hit.onset_s;
    json["peak_force_n"] = hit.peak_N;
    json["pulse_s"] = hit.pulse_s;
    json["bandwidth_hz"] = hit.bandwidth_Hz;
    json["accepted"] = hits[i].accepted;
    if (hits[i].by_user) json["by_user"] = true;
    json["findings"] = Json::array();
    for (const Finding& finding : hit.findings) json["findings"].push_back(finding_json(finding));
    if (!hits[i].responses.empty()) {
      json["responses"] = Json::array();
      for (std::size_t c = 0; c < hits[i].responses.size(); ++c)
        json["responses"].push_back(response_json(c, hits[i].responses[c]));
    }
    out.push_back(std::move(json));
  }
  return out;
}

void add_split(Json& json, const DoublePeak& peak) {
  json["separation_std_hz"] = peak.separation_std_Hz;
  json["first_over_second_db"] = peak.first_over_second_dB;
  json["quoted"] = peak.quoted;
  json["split"] = Json();
  if (!peak.planes) return;
  json["split"] = {{"cause", name_of(peak.planes->cause)},
                   {"plane_deg", peak.planes->own.plane_rad * kRadian_deg},
                   {"plane_std_deg", peak.planes->own.std_rad * kRadian_deg},
                   {"between_deg", peak.planes->between_rad * kRadian_deg},
                   {"between_std_deg", peak.planes->between_std_rad * kRadian_deg}};
}

void add_verdict(Json& json, const Verdict& verdict) {
  json["family"] = name_of(verdict.family);
  json["order"] = verdict.order > 0 ? Json(verdict.order) : Json();
  json["confidence"] = verdict.confidence;
  json["alternative"] = verdict.alternative ? Json(name_of(*verdict.alternative)) : Json();
  json["overlay"] =
      verdict.overlay_dB ? Json{{"difference_db", *verdict.overlay_dB}, {"overlaid", verdict.overlaid}} : Json();
  json["ratio"] = verdict.ratio
                      ? Json{{"re", verdict.ratio->real()}, {"im", verdict.ratio->imag()}, {"std", verdict.ratio_std}}
                      : Json();
  json["double_peak"] = Json();
  if (verdict.double_peak) {
    json["double_peak"] = {{"partner", verdict.double_peak->partner},
                           {"separation_hz", verdict.double_peak->separation_Hz},
                           {"first", verdict.double_peak->first}};
    add_split(json["double_peak"], *verdict.double_peak);
  }
}

// What the damping would read from the windowed FRF as it stands: the pole shifted by the window's decay.
double raw_damping(const Pole& pole, double decay_per_s) {
  const double omega = kTwoPi * pole.freq_Hz;
  const double real = pole.damping_ratio * omega + decay_per_s;
  const double imag = omega * std::sqrt(1 - pole.damping_ratio * pole.damping_ratio);
  return real / std::hypot(real, imag);
}

Json modes_json(const Analysis& analysis, const JsonOptions& options) {
  const bool classes = options.sections.contains(Section::classes);
  Json out = Json::array();
  const double decay = analysis.window_decay_per_s();
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    const Mode& mode = analysis.modes()[m];
    Json json{{"index", m},
              {"frequency_hz", mode.pole.freq_Hz},
              {"frequency_std_hz", mode.freq_std_Hz},
              {"damping_ratio", mode.pole.damping_ratio},
              {"damping_ratio_std", mode.damping_std}};
    if (mode.moves_Hz > 0) json["moves_hz"] = mode.moves_Hz;
    if (decay > 0) json["damping_ratio_raw"] = raw_damping(mode.pole, decay);
    if (classes) add_verdict(json, (options.verdicts != nullptr ? *options.verdicts : analysis.verdicts())[m]);
    json["residues"] = Json::array();
    for (const Residue& r : mode.residues) {
      const double std = std::hypot(r.std, r.relative_std * std::abs(r.value));
      Json residue{
          {"point", r.point}, {"channel", r.channel}, {"re", r.value.real()}, {"im", r.value.imag()}, {"std", std}};
      if (r.own_pole) {
        residue["frequency_hz"] = r.own_pole->freq_Hz;
        residue["damping_ratio"] = r.own_pole->damping_ratio;
      }
      json["residues"].push_back(std::move(residue));
    }
    out.push_back(std::move(json));
  }
  return out;
}

Json frf_json(const Analysis& analysis) {
  const auto& frfs = analysis.frfs();
  Json json{{"lines", analysis.lines().count}, {"df_hz", analysis.lines().df_Hz()}, {"averages", Json::array()}};
  for (const PointFrf& frf : frfs)
    json["averages"].push_back({{"point", frf.point}, {"channel", frf.channel}, {"averages", frf.frf.averages}});
  return json;
}

Json coherence_json(const Analysis& analysis) {
  Json out = Json::array();
  const auto summaries = coherence_summaries(analysis);
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const auto& summary = summaries[i];
    out.push_back({{"point", analysis.frfs()[i].point},
                   {"channel", analysis.frfs()[i].channel},
                   {"mean", summary ? Json(summary->mean) : Json()},
                   {"fraction_below_0_9", summary ? Json(summary->below) : Json()}});
  }
  return out;
}

Json per_hit_json(const Analysis& analysis) {
  Json out = Json::array();
  for (const HitMode& m : analysis.modes_per_hit()) {
    out.push_back({{"hit", m.hit},
                   {"mode", m.mode},
                   {"peak_force_n", analysis.hits()[m.hit].hit.peak_N},
                   {"frequency_hz", m.pole.freq_Hz},
                   {"frequency_std_hz", m.freq_std_Hz},
                   {"damping_ratio", m.pole.damping_ratio},
                   {"damping_ratio_std", m.damping_std}});
  }
  return out;
}

Json stabilisation_json(const Stabilisation& diagram) {
  Json json{{"band_hz", {diagram.low_Hz, diagram.high_Hz}}, {"poles", Json::array()}};
  for (const StabilisationPole& pole : diagram.poles) {
    json["poles"].push_back({{"order", pole.order},
                             {"frequency_hz", pole.pole.freq_Hz},
                             {"damping_ratio", pole.pole.damping_ratio},
                             {"flag", name_of(pole.stability)}});
  }
  return json;
}

Json options_json(const Analysis& analysis) {
  const AnalysisOptions& o = analysis.options();
  Json json = Json::object();
  if (!o.accept_hits.empty()) json["accept_hits"] = o.accept_hits;
  if (!o.reject_hits.empty()) json["reject_hits"] = o.reject_hits;
  if (o.estimator != Estimator::h1) json["estimator"] = name_of(o.estimator);
  if (o.modes.modes) json["modes"] = *o.modes.modes;
  if (!o.modes.start_Hz.empty()) json["start_hz"] = o.modes.start_Hz;
  if (o.hits.trigger_N) json["trigger_n"] = *o.hits.trigger_N;
  if (o.hits.pretrigger_s) json["pretrigger_s"] = *o.hits.pretrigger_s;
  if (o.hits.length_s) json["length_s"] = *o.hits.length_s;
  if (o.hits.from_s > 0) json["from_s"] = o.hits.from_s;
  if (o.hits.to_s) json["to_s"] = *o.hits.to_s;
  if (!o.hits.gate_force) json["force_window"] = "off";
  if (o.exponential_end > 0) json["exponential_end"] = o.exponential_end;
  if (o.classes.overlay_dB != ClassifyOptions{}.overlay_dB) json["overlay_db"] = o.classes.overlay_dB;
  return json;
}

Json bat_json(const BatLabel& bat) {
  Json json{{"id", bat.id}, {"properties", Json::object()}};
  for (const auto& [key, text] : bat.properties) {
    const ParsedNumber number = parse_number(text, false);
    json["properties"][key] = number.problem == NumberProblem::none ? Json(number.value) : Json(text);
  }
  return json;
}

// What the document of its own says but for the file.
Json deflection_in(const Analysis& analysis, const ImpactTest& test) {
  Json json = Json::parse(deflection_json(analysis, test));
  for (const char* key : {"schema", "version", "inputs", "fs_hz"}) json.erase(key);
  return json;
}

Json document_of(const Analysis& analysis, const JsonOptions& options) {
  const auto wants = [&](Section section) { return options.sections.contains(section); };
  const bool force_only = options.sections == std::set{Section::hits};
  Json json{{"schema", "percuss/analysis/1"}, {"version", version()}, {"inputs", Json::array()}};
  for (const InputFile& file : analysis.record().files)
    json["inputs"].push_back({{"path", file.path}, {"bytes", file.bytes}});
  if (options.bat) json["bat"] = bat_json(*options.bat);
  json["fs_hz"] = analysis.given_frfs() != nullptr ? Json() : Json(analysis.record().fs_Hz);  // FRFs do not tell it
  const auto& hits = force_only ? analysis.force_hits() : analysis.hits();
  if (analysis.possible()) {
    const auto [low, high] = analysis.band_Hz();
    json["band_hz"] = {low, high};
  }
  if (!force_only && wants(Section::modes)) json["effort"] = name_of(analysis.options().modes.effort);
  if (Json chosen = options_json(analysis); !chosen.empty()) json["options"] = std::move(chosen);
  if (wants(Section::hits)) json["hits"] = hits_json(analysis, hits);
  if (analysis.possible()) {
    if (wants(Section::frf)) json["frf"] = frf_json(analysis);
    if (wants(Section::coherence)) json["coherence"] = coherence_json(analysis);
    if (wants(Section::modes) || wants(Section::classes)) json["modes"] = modes_json(analysis, options);
    if (options.per_hit) json["modes_per_hit"] = per_hit_json(analysis);
    if (options.stabilisation) json["stabilisation"] = stabilisation_json(analysis.stabilisation());
  } else if (wants(Section::modes)) {
    json["modes"] = Json::array();
  }
  if (options.deflection != nullptr) json["deflection"] = deflection_in(analysis, *options.deflection);
  json["warnings"] = Json::array();
  for (const Warning& warning : options.warnings != nullptr ? *options.warnings : analysis.warnings())
    json["warnings"].push_back({{"code", warning.code}, {"message", warning.message}});
  if (options.explain) {
    json["skipped"] = Json::array();
    for (const Skipped& one : skipped_by(analysis)) {
      json["skipped"].push_back(
          {{"code", one.code}, {"what", one.what}, {"why", one.why}, {"share", one.share ? Json(*one.share) : Json()}});
    }
  }
  if (options.trace) {
    json["trace"] = Json::array();
    for (const auto& stage : analysis.trace().stages())
      json["trace"].push_back({{"stage", stage.name}, {"calls", stage.calls}, {"seconds", stage.seconds}});
  }
  return json;
}

std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string analysis_json(const Analysis& analysis, const JsonOptions& options) {
  return text_of(document_of(analysis, options));
}

std::any analysis_document(const Analysis& analysis, const JsonOptions& options) {
  return document_of(analysis, options);
}

std::string analysis_json(const std::vector<NumberedAnalysis>& tests, const JsonOptions& options) {
  if (tests.size() == 1) return analysis_json(*tests.front().analysis, options);
  Json json{{"schema", "percuss/analysis/1"}, {"version", version()}, {"runs", Json::array()}};
  for (const NumberedAnalysis& test : tests) {
    json["runs"].push_back(document_of(*test.analysis, options));
    json["runs"].back()["run"] = test.run;
  }
  return text_of(json);
}

}  // namespace percuss
