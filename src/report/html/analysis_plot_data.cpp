#include "report/html/analysis_plot_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json/json_document.hpp"
#include "report/json/quantised_curve.hpp"
#include "report/svg/analysis_curves.hpp"
#include "report/svg/barrel_cross_section.hpp"
#include "report/text/analysis_tables.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

// Quantisation steps, below the resolution of the plots.
constexpr double kMagnitudeStep_dB = 0.01, kPhaseStep_deg = 0.1, kCoherenceStep = 1e-4;

// A test of many points shows fewer curves here, because the plot "fit" has every FRF and the page a limited size.
constexpr std::size_t kManyFrfs = 12, kFrfsOfMany = 3, kManyHits = 32, kHitsOfMany = 6, kFrfsShown = 8, kHitsShown = 12;

Json curve_plot_json(const FrfCurve& curve) {
  Json json{{"name", curve.name},
            {"db", quantised_json(curve.level_dB, kMagnitudeStep_dB)},
            {"phase_deg", quantised_json(curve.phase_deg, kPhaseStep_deg)}};
  if (!curve.coherence.empty()) json["coherence"] = quantised_json(curve.coherence, kCoherenceStep);
  if (!curve.above_dB.empty()) json["sigma_db"] = quantised_json(curve.above_dB, kMagnitudeStep_dB);
  if (!curve.fit_dB.empty()) json["fit_db"] = quantised_json(curve.fit_dB, kMagnitudeStep_dB);
  return json;
}

Json frf_plot_json(const pipeline::Analysis& analysis) {
  Json json{{"first_hz", analysis.lines().freq_Hz(0)},
            {"df_hz", analysis.lines().df_Hz()},
            {"of", analysis.frfs().size()},
            {"curves", Json::array()}};
  for (const FrfCurve& curve : frf_curves(analysis, analysis.frfs().size() > kManyFrfs ? kFrfsOfMany : kFrfsShown))
    json["curves"].push_back(curve_plot_json(curve));
  return json;
}

Json modes_plot_json(const pipeline::Analysis& analysis, const std::vector<identify::Mode>& modes,
                     const std::vector<identify::ModeClassification>& classifications) {
  Json out = Json::array();
  for (std::size_t m = 0; m < classifications.size(); ++m) {
    const identify::Mode& mode = modes[m];
    const identify::ModeClassification& classification = classifications[m];
    Json json{{"hz", mode.pole.freq_Hz},
              {"zeta", mode.pole.damping_ratio},
              {"name", mode_name(classification, m)},
              {"family", name_of(classification.type)},
              {"sensors", Json::array()}};
    for (const BarrelSensor& sensor : barrel_sensors(analysis, mode)) {
      json["sensors"].push_back(
          {{"angle_rad", sensor.angle_rad}, {"re", sensor.residue.real()}, {"im", sensor.residue.imag()}});
    }
    out.push_back(std::move(json));
  }
  return out;
}

Json samples_json(const HitSamples& samples, double min_step) {
  return {{"first", samples.first}, {"step", samples.step}, {"values", quantised_json(samples.value, min_step)}};
}

Json hits_plot_json(const pipeline::Analysis& analysis) {
  Json out = Json::array();
  for (const HitCurves& hit : hit_curves(analysis, analysis.hits().size() > kManyHits ? kHitsOfMany : kHitsShown)) {
    out.push_back({{"name", fmt::format("hit {}", hit.index + 1)},
                   {"accepted", hit.accepted},
                   {"bandwidth_hz", hit.bandwidth_Hz},
                   {"force_n", samples_json(hit.force_N, 0)},
                   {"response_mps2", hit.response_mps2.value.empty() ? Json() : samples_json(hit.response_mps2, 0)},
                   {"noise_db", std::isfinite(hit.noise_dB) ? Json(hit.noise_dB) : Json()},
                   {"spectrum_db", samples_json(hit.spectrum_dB, kMagnitudeStep_dB)},
                   {"decay_db", hit.decay_dB.value.empty() ? Json() : samples_json(hit.decay_dB, kMagnitudeStep_dB)}});
  }
  return out;
}

Json stabilisation_plot_json(const identify::Stabilisation& diagram, const std::vector<identify::Pole>& unmodelled) {
  std::vector<double> freq_Hz;
  std::string stability;
  Json orders = Json::array();
  for (const identify::StabilisationPole& pole : diagram.poles) {
    freq_Hz.push_back(pole.pole.freq_Hz);
    orders.push_back(pole.order);
    stability += name_of(pole.stability)[0];
  }
  Json json{{"hz", quantised_json(freq_Hz, 0)}, {"order", std::move(orders)}, {"stability", stability}};
  for (const identify::Pole& pole : unmodelled) json["unmodelled_hz"].push_back(pole.freq_Hz);
  return json;
}

}  // namespace

std::string analysis_plot_data(const pipeline::Analysis& analysis,
                               const std::vector<identify::ModeClassification>& classifications,
                               const PlotSelection& wanted, const std::vector<identify::Mode>* modes) {
  Json json = Json::object();
  if (wanted.hits && analysis.given_frfs() == nullptr) {
    json["hits"] = hits_plot_json(analysis);
    json["of_hits"] = analysis.hits().size();
  }
  if (!analysis.possible()) return ascii_text(json);
  const auto [low_Hz, high_Hz] = analysis.band_Hz();
  json["band_hz"] = {low_Hz, high_Hz};
  if (wanted.frfs) json["frf"] = frf_plot_json(analysis);
  json["modes"] = classifications.empty()  // a page without modes does not compute them
                      ? Json::array()
                      : modes_plot_json(analysis, modes != nullptr ? *modes : analysis.modes(), classifications);
  if (wanted.stabilisation)
    json["stabilisation"] = stabilisation_plot_json(analysis.stabilisation(), analysis.unmodelled_poles());
  return ascii_text(json);
}

}  // namespace percuss::report
