#include "report/json/result_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/units.hpp"
#include "identify/classify/asymmetry_split.hpp"
#include "identify/shapes/mode_shapes.hpp"
#include "report/json/json_document.hpp"
#include "report/json/mode_std_json.hpp"
#include "report/json/or_null.hpp"
#include "report/text/coherence_summary.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

Json finding_json(const acquire::Finding& finding) {
  Json json{{"code", name_of(finding.code)}, {"severity", name_of(finding.severity)}, {"value", finding.value}};
  if (finding.delay_s) json["delay_s"] = *finding.delay_s;
  json["message"] = finding.message;
  return json;
}

Json response_grade_json(std::size_t channel, const acquire::ResponseGrade& grade) {
  Json json{{"channel", channel},
            {"left_db", grade.end_level_dB},
            {"truncated", grade.truncated},
            {"polarity", grade.polarity}};
  json["delay_s"] = or_null(grade.delay_s);
  return json;
}

void add_split(Json& json, const identify::SplitMode& peak) {
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

void add_classification(Json& json, const identify::ModeClassification& classification) {
  json["family"] = name_of(classification.type);
  json["order"] = classification.order > 0 ? Json(classification.order) : Json();
  json["confidence"] = classification.confidence;
  json["alternative"] = classification.alternative ? Json(name_of(*classification.alternative)) : Json();
  if (classification.possible_three_waves) json["three_waves"] = true;
  if (classification.order_uncertain) json["order_uncertain"] = true;
  json["overlay"] = classification.overlay_dB
                        ? Json{{"difference_db", *classification.overlay_dB}, {"overlaid", classification.overlaid}}
                        : Json();
  json["ratio"] = classification.ratio ? Json{{"re", classification.ratio->real()},
                                              {"im", classification.ratio->imag()},
                                              {"std", classification.ratio_std}}
                                       : Json();
  json["double_peak"] = Json();
  if (classification.split_mode) {
    json["double_peak"] = {{"partner", classification.split_mode->partner},
                           {"separation_hz", classification.split_mode->separation_Hz},
                           {"first", classification.split_mode->first}};
    add_split(json["double_peak"], *classification.split_mode);
  }
}

// The damping ratio of the windowed FRF: the pole shifted by the window's decay.
double raw_damping(const identify::Pole& pole, double decay_per_s) {
  const double omega = kTwoPi * pole.freq_Hz;
  const double real = pole.damping_ratio * omega + decay_per_s;
  const double imag = omega * std::sqrt(1 - pole.damping_ratio * pole.damping_ratio);
  return real / std::hypot(real, imag);
}

Json residue_json(const identify::Residue& r) {
  Json json{{"point", r.point},
            {"channel", r.channel},
            {"re", r.value.real()},
            {"im", r.value.imag()},
            {"std", identify::total_std(r)}};
  if (!r.own_pole) return json;
  json["frequency_hz"] = r.own_pole->freq_Hz;
  json["damping_ratio"] = r.own_pole->damping_ratio;
  return json;
}

Json hit_parts_json(const pipeline::HitStdParts& parts) { return {{"noise", parts.noise}, {"hits", parts.hits}}; }

}  // namespace

std::string hit_json(const acquire::Record& record, std::size_t i, const pipeline::AnalysedHit& analysed) {
  const acquire::Hit& hit = analysed.hit;
  Json json{{"index", i}, {"point", analysed.point}};
  if (record.files.size() > 1) json["file"] = record.files[record.rows[hit.row].file].path;
  if (record.rows.size() > 1) json["row"] = hit.row;
  json["time_s"] = hit.onset_s;
  json["peak_force_n"] = hit.peak_N;
  json["pulse_s"] = hit.pulse_s;
  json["bandwidth_hz"] = hit.bandwidth_Hz;
  json["accepted"] = analysed.accepted;
  if (analysed.by_user) json["by_user"] = true;
  json["findings"] = Json::array();
  for (const acquire::Finding& finding : hit.findings) json["findings"].push_back(finding_json(finding));
  if (!analysed.responses.empty()) {
    json["responses"] = Json::array();
    for (std::size_t c = 0; c < analysed.responses.size(); ++c)
      json["responses"].push_back(response_grade_json(c, analysed.responses[c]));
  }
  return indented_text(json);
}

std::string mode_json(const identify::Mode& mode, std::size_t m, const ModeJson& of) {
  Json json{{"index", m},
            {"frequency_hz", mode.pole.freq_Hz},
            {"frequency_std_hz", mode.freq_std_Hz},
            {"damping_ratio", mode.pole.damping_ratio},
            {"damping_ratio_std", mode.damping_std}};
  add_std_parts(json, mode);
  if (mode.freq_scatter_Hz > 0) json["moves_hz"] = mode.freq_scatter_Hz;
  if (of.window_decay_per_s > 0) json["damping_ratio_raw"] = raw_damping(mode.pole, of.window_decay_per_s);
  if (of.classification != nullptr) add_classification(json, *of.classification);
  if (of.frac) json["frac"] = *of.frac;
  if (mode.joint_misfit > 0) {
    json["effort_used"] = name_of(identify::Effort::standard);
    json["joint_misfit"] = std::isfinite(mode.joint_misfit) ? Json(mode.joint_misfit) : Json();
  }
  json["residues"] = Json::array();
  for (const identify::Residue& r : mode.residues) json["residues"].push_back(residue_json(r));
  return indented_text(json);
}

std::string frf_json(const pipeline::Analysis& analysis) {
  const auto& frfs = analysis.frfs();
  Json json{{"lines", analysis.lines().count}, {"df_hz", analysis.lines().df_Hz()}, {"averages", Json::array()}};
  for (const acquire::PointFrf& frf : frfs)
    json["averages"].push_back({{"point", frf.point}, {"channel", frf.channel}, {"averages", frf.frf.averages}});
  return indented_text(json);
}

std::string coherence_json(const pipeline::Analysis& analysis) {
  Json out = Json::array();
  const auto summaries = coherence_summaries(analysis);
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const auto& summary = summaries[i];
    out.push_back({{"point", analysis.frfs()[i].point},
                   {"channel", analysis.frfs()[i].channel},
                   {"mean", summary ? Json(summary->mean) : Json()},
                   {"fraction_below_0_9", summary ? Json(summary->below) : Json()}});
  }
  return indented_text(out);
}

std::string fit_json(const pipeline::Analysis& analysis) {
  const auto complex = [](Complex z) { return Json{{"re", z.real()}, {"im", z.imag()}}; };
  const std::vector<int> points = analysis.frf_points();
  Json out = Json::array();
  for (const pipeline::FrfFit& frf : analysis.fit().frfs) {
    out.push_back({{"point", points[frf.point]},
                   {"channel", frf.channel},
                   {"frac", frf.frac},
                   {"lower", complex(frf.lower)},
                   {"upper", complex(frf.upper)},
                   {"upper_4", complex(frf.upper4)},
                   {"upper_6", complex(frf.upper6)}});
  }
  return indented_text(out);
}

std::string unexplained_peaks_json(const pipeline::Analysis& analysis) {
  const auto [low_Hz, high_Hz] = analysis.band_Hz();
  Json out = Json::array();
  for (const identify::UnmodelledPeak& peak : analysis.unexplained_peaks()) {
    out.push_back({{"frequency_hz", peak.freq_Hz},
                   {"level_db", peak.level_dB},
                   {"in_band", peak.freq_Hz >= low_Hz && peak.freq_Hz <= high_Hz}});
  }
  return indented_text(out);
}

std::string delays_json(const pipeline::Analysis& analysis) {
  Json out = Json::array();
  const auto add = [&](const std::vector<pipeline::ChannelDelay>& delays, bool corrected) {
    for (const pipeline::ChannelDelay& delay : delays) {
      if (!corrected && !delay.established()) continue;
      out.push_back({{"channel", delay.channel},
                     {"delay_s", delay.delay_s},
                     {"std_s", delay.std_s},
                     {"modes", delay.modes},
                     {"corrected", corrected}});
    }
  };
  add(analysis.channel_findings().corrected_delays, true);
  add(analysis.channel_findings().delays, false);
  return indented_text(out);
}

std::string modes_per_hit_json(const pipeline::Analysis& analysis) {
  Json out = Json::array();
  for (const pipeline::HitMode& m : analysis.modes_per_hit()) {
    out.push_back({{"hit", m.hit},
                   {"mode", m.mode},
                   {"peak_force_n", analysis.hits()[m.hit].hit.peak_N},
                   {"frequency_hz", m.pole.freq_Hz},
                   {"frequency_std_hz", m.freq_std_parts_Hz.total()},
                   {"damping_ratio", m.pole.damping_ratio},
                   {"damping_ratio_std", m.damping_std_parts.total()},
                   {"frequency_std_parts_hz", hit_parts_json(m.freq_std_parts_Hz)},
                   {"damping_ratio_std_parts", hit_parts_json(m.damping_std_parts)}});
  }
  return indented_text(out);
}

std::string stabilisation_json(const identify::Stabilisation& diagram) {
  Json json{{"band_hz", {diagram.low_Hz, diagram.high_Hz}}, {"poles", Json::array()}};
  for (const identify::StabilisationPole& pole : diagram.poles) {
    json["poles"].push_back({{"order", pole.order},
                             {"frequency_hz", pole.pole.freq_Hz},
                             {"damping_ratio", pole.pole.damping_ratio},
                             {"flag", name_of(pole.stability)}});
  }
  return indented_text(json);
}

}  // namespace percuss::report
