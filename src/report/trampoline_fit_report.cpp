#include "report/trampoline_fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kCcorPoints = 41;

Json family_json(const model::FittedExponents& fitted) {
  const char* const varied = fitted.fit.held.damping && !fitted.fit.held.stiffness ? "a" : "b";
  Json out = Json::array();
  for (const model::FamilyPair& pair : fitted.family) {
    const auto& within = pair.within_std;
    out.push_back({{"a", pair.exponents[0]},
                   {"b", pair.exponents[1]},
                   {"chi2", pair.chi2},
                   {"varied", varied},
                   {"within_low", within ? Json(within->at(0)) : Json()},
                   {"within_high", within ? Json(within->at(1)) : Json()},
                   {"hoop_hz", pair.optimum.hoop_Hz},
                   {"cor", pair.optimum.cor},
                   {"at_edge", pair.optimum.at_edge}});
  }
  return out;
}

std::string exponent_text(double value, double std, bool held) {
  return held ? fmt::format("{:g} (held)", value) : value_with_std(value, std);
}

}  // namespace

CcorCurve ccor_curve(const model::Trampoline& model, const model::FittedExponents& fitted) {
  const model::CcorMisfit misfit(model, fitted.measured);
  const double low = 0.9 * fitted.slowest_mps(), high = 1.1 * fitted.fastest_mps();
  CcorCurve out;
  for (int i = 0; i < kCcorPoints; ++i) {
    const double speed = low + (high - low) * i / (kCcorPoints - 1);
    const double cor = misfit.cor(fitted.fit.exponents(), speed);
    out.speed_mps.push_back(speed);
    out.cor.push_back(cor);
    out.low.push_back(cor);
    out.high.push_back(cor);
    for (const model::Exponents& e : fitted.fit.contour) {
      const double other = misfit.cor(e, speed);
      out.low.back() = std::min(out.low.back(), other);
      out.high.back() = std::max(out.high.back(), other);
    }
  }
  return out;
}

Json trampoline_fit_json(const model::FittedExponents& fitted, const CcorCurve& curve) {
  const model::ExponentFit& fit = fitted.fit;
  const auto std_or_null = [](double std, bool held) { return held ? Json() : Json(std); };
  Json held = Json::array();
  if (fit.held.stiffness) held.push_back("a");
  if (fit.held.damping) held.push_back("b");
  Json json{{"a", fit.stiffness_exponent},
            {"a_std", std_or_null(fit.stiffness_exponent_std, fit.held.stiffness)},
            {"b", fit.damping_exponent},
            {"b_std", std_or_null(fit.damping_exponent_std, fit.held.damping)},
            {"b_std_given_a", std_or_null(fit.damping_exponent_std_given_a, fit.held.damping)},
            {"correlation", fit.correlation},
            {"chi2", fit.chi2},
            {"chi2_p", fit.chi2_p},
            {"beyond_std", fit.beyond_std},
            {"held", std::move(held)},
            {"a_low", fit.a_interval.low},
            {"a_high", fit.a_interval.high},
            {"b_low", fit.b_interval.low},
            {"b_high", fit.b_interval.high},
            {"determined", fit.determined && !fit.at_limit},
            {"at_limit", fit.at_limit},
            {"points", Json::array()},
            {"family", family_json(fitted)},
            {"ccor", Json::array()}};
  for (std::size_t i = 0; i < fitted.measured.size(); ++i) {
    const model::MeasuredCor& m = fitted.measured[i];
    json["points"].push_back(
        {{"speed_mps", m.speed_mps}, {"cor", m.cor}, {"cor_std", m.cor_std}, {"model_cor", fit.model_cor[i]}});
  }
  for (std::size_t i = 0; i < curve.cor.size(); ++i) {
    json["ccor"].push_back({{"speed_mps", curve.speed_mps[i]},
                            {"cor", curve.cor[i]},
                            {"cor_low", curve.low[i]},
                            {"cor_high", curve.high[i]}});
  }
  return json;
}

ReportText trampoline_fit_text(const model::FittedExponents& fitted) {
  const model::ExponentFit& fit = fitted.fit;
  std::string line = fmt::format("fit to measured CCOR: a = {}, b = {}",
                                 exponent_text(fit.stiffness_exponent, fit.stiffness_exponent_std, fit.held.stiffness),
                                 exponent_text(fit.damping_exponent, fit.damping_exponent_std, fit.held.damping));
  if (fit.free() == 2) {
    line += fmt::format(", correlation {:.6f}; for a known a, b has ± {:.2g}", fit.correlation,
                        fit.damping_exponent_std_given_a);
  }
  line += fmt::format("; chi2 {:.2f} of {} points, {} with residuals above their ±\n", fit.chi2, fitted.measured.size(),
                      fit.beyond_std);
  ReportText out = line;
  if (fit.free() == 0) return out;
  const bool a_varies = fit.held.damping;
  TextTable table({{"a", TextTable::Align::right},
                   {"b", TextTable::Align::right},
                   {a_varies ? "a with each CCOR within its ±" : "b with each CCOR within its ±"},
                   {"chi2", TextTable::Align::right},
                   {"COR largest at", TextTable::Align::right},
                   {"COR", TextTable::Align::right}});
  for (const model::FamilyPair& pair : fitted.family) {
    table.add(
        {fmt::format("{:.4f}", pair.exponents[0]), fmt::format("{:.4f}", pair.exponents[1]),
         pair.within_std ? fmt::format("{:.4f} to {:.4f}", pair.within_std->at(0), pair.within_std->at(1)) : "none",
         fmt::format("{:.2f}", pair.chi2),
         fmt::format("{:.1f} Hz{}", pair.optimum.hoop_Hz, pair.optimum.at_edge ? " (end)" : ""),
         fmt::format("{:.4f}", pair.optimum.cor)});
  }
  out += table;
  return out;
}

LineChart ccor_chart(const model::FittedExponents& fitted, CcorCurve curve) {
  LineChart chart{.title = "CCOR over the speed",
                  .x = {.label = "speed of the ball, m/s"},
                  .y = {.label = "coefficient of restitution"}};
  chart.bands = {{.x = curve.speed_mps, .low = std::move(curve.low), .high = std::move(curve.high)}};
  chart.curves.push_back({.name = "model", .x = std::move(curve.speed_mps), .y = std::move(curve.cor)});
  ChartCurve points{.name = "measured, ± std", .line = false, .style = 1};
  for (const model::MeasuredCor& m : fitted.measured) {
    points.x.push_back(m.speed_mps);
    points.y.push_back(m.cor);
  }
  chart.curves.push_back(std::move(points));
  for (const model::MeasuredCor& m : fitted.measured) {
    chart.curves.push_back(
        {.name = "", .x = {m.speed_mps, m.speed_mps}, .y = {m.cor - m.cor_std, m.cor + m.cor_std}, .style = 1});
  }
  return chart;
}

}  // namespace percuss::report
