#include "report/trampoline_report.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "model/trampoline/trampoline_warnings.hpp"
#include "report/json/json_document.hpp"
#include "report/json/warning_json.hpp"
#include "report/text/number_format.hpp"
#include "report/text/version.hpp"
#include "report/trampoline_bats_report.hpp"
#include "report/trampoline_fit_report.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kReference_Hz = 10e3;  // the barrel that the source calls rigid

Json constants_json(const model::Trampoline& m) {
  return {{"m1_kg", m.ball_mass_kg},
          {"k1", m.stiffness},
          {"c1", m.damping},
          {"a", m.stiffness_exponent},
          {"b", m.damping_exponent},
          {"m2_kg", m.barrel_mass_kg},
          {"c2", m.barrel_damping_Nspm},
          {"extra_mass_kg", m.extra_mass_kg},
          {"speed_mps", m.ball_speed_mps}};
}

std::string extras_text(const model::Trampoline& model, const model::HoopPeak& peak, const TrampolineExtras& extras) {
  std::string text;
  if (model.extra_mass_kg > 0) {
    text += fmt::format("with {:g} kg on the barrel a hoop frequency of {:.1f} Hz falls to {:.1f} Hz\n",
                        model.extra_mass_kg, peak.hoop_Hz, model::loaded_hoop_Hz(model, peak.hoop_Hz));
  }
  if (extras.modal_mass_kg)
    text += fmt::format("the shift corresponds to a modal mass of {:.4f} kg\n", *extras.modal_mass_kg);
  return text;
}

// The maximum, with its 68 % range where exponents were fitted.
Json peak_json(const model::HoopPeak& peak, const std::optional<model::FittedExponents>& fitted) {
  Json json{{"hoop_hz", peak.hoop_Hz}, {"cor", peak.cor}, {"at_edge", peak.at_edge}};
  if (!fitted || fitted->fit.contour.empty()) return json;
  const model::SweepRange& range = fitted->range;
  const bool any_edge = peak.at_edge || range.at_edge;
  json["hoop_hz_low"] = range.low.hoop_Hz;
  json["hoop_hz_high"] = range.high.hoop_Hz;
  json["hoop_hz_std"] = any_edge ? Json() : Json((range.high.hoop_Hz - range.low.hoop_Hz) / 2);
  json["cor_low"] = range.peak_cor_low;
  json["cor_high"] = range.peak_cor_high;
  json["range_at_edge"] = range.at_edge;
  return json;
}

std::string peak_text(const std::vector<double>& hoop_Hz, const model::HoopPeak& peak, double wall, double reference,
                      const std::optional<model::FittedExponents>& fitted) {
  const bool has_range = fitted && !fitted->fit.contour.empty();
  const bool has_std = has_range && fitted->fit.determined && !fitted->fit.at_limit && !fitted->range.at_edge;
  const double low_Hz = has_range ? fitted->range.low.hoop_Hz : 0, high_Hz = has_range ? fitted->range.high.hoop_Hz : 0;
  const std::string peak_Hz =
      has_std ? value_with_std(peak.hoop_Hz, (high_Hz - low_Hz) / 2) : fmt::format("{:.1f}", peak.hoop_Hz);
  std::string text =
      peak.at_edge
          ? fmt::format(
                "trampoline: no maximum lies within {:g} to {:g} Hz; the COR is largest, {:.4f}, at the end, {} Hz",
                hoop_Hz.front(), hoop_Hz.back(), peak.cor, peak_Hz)
          : fmt::format("trampoline: the COR is largest, {:.4f}, at a hoop frequency of {} Hz", peak.cor, peak_Hz);
  if (has_range && !has_std)
    text += fmt::format(" ({:.0f} to {:.0f} Hz with the exponents that fit about as well)", low_Hz, high_Hz);
  return text + fmt::format(". It is {:.3f} times the rigid wall's {:.5f} and {:.3f} times the {:.4f} at 10 kHz\n",
                            peak.cor / wall, wall, peak.cor / reference, reference);
}

void add_warnings(const std::vector<warnings::Warning>& warnings, Json& json, ReportText& text) {
  json["warnings"] = Json::array();
  for (const warnings::Warning& warning : warnings) {
    json["warnings"].push_back(warning_json(warning));
    text.warn({warning.message, warning.options});
  }
}

// A row per rebound.
std::vector<NumericColumn> curve_columns(const model::Trampoline& model, const std::vector<double>& hoop_Hz,
                                         const std::vector<model::Rebound>& sweep, double wall, double reference) {
  NumericColumn cor{.name = "cor"}, over_wall{.name = "cor_over_wall"}, over_10kHz{.name = "cor_over_10khz"},
      loaded{.name = "loaded_hoop_hz"}, contact{.name = "contact_s"}, contacts{.name = "contacts"};
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    cor.values.push_back(sweep[i].cor);
    over_wall.values.push_back(sweep[i].cor / wall);
    over_10kHz.values.push_back(sweep[i].cor / reference);
    loaded.values.push_back(model::loaded_hoop_Hz(model, hoop_Hz[i]));
    contact.values.push_back(sweep[i].contact_s);
    contacts.values.push_back(static_cast<double>(sweep[i].contacts));
  }
  return {{"hoop_hz", hoop_Hz}, cor, loaded, contact, contacts, over_wall, over_10kHz};
}

// An object per rebound.
Json curve_json(const model::Trampoline& model, const std::vector<double>& hoop_Hz,
                const std::vector<model::Rebound>& sweep, const std::optional<model::FittedExponents>& fitted) {
  Json out = Json::array();
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    out.push_back({{"hoop_hz", hoop_Hz[i]},
                   {"cor", sweep[i].cor},
                   {"loaded_hoop_hz", model::loaded_hoop_Hz(model, hoop_Hz[i])},
                   {"contact_s", sweep[i].contact_s},
                   {"contacts", sweep[i].contacts}});
    if (!fitted) continue;
    out.back()["cor_low"] = fitted->range.cor_low[i];
    out.back()["cor_high"] = fitted->range.cor_high[i];
  }
  return out;
}

// The coefficients of restitution of the barrel, of the rigid wall and of measured bats.
struct ModelChart {
  std::vector<double> hoop_Hz, cor;
  double wall = 0;
  std::optional<ChartCurve> bats;
};

// ccor  not used without `fitted`
std::vector<LineChart> charts_of(ModelChart chart, const std::optional<model::FittedExponents>& fitted,
                                 CcorCurve ccor) {
  const std::vector<double>& hoop_Hz = chart.hoop_Hz;
  std::vector<LineChart> out = {
      {.title = "Ball and hollow barrel",
       .x = {.label = "hoop frequency, Hz"},
       .y = {.label = "coefficient of restitution"},
       .curves = {{"barrel", hoop_Hz, chart.cor},
                  {"rigid wall", {hoop_Hz.front(), hoop_Hz.back()}, {chart.wall, chart.wall}}}}};
  if (chart.bats) out[0].curves.push_back(std::move(*chart.bats));
  if (fitted) {
    out[0].bands = {{.x = hoop_Hz, .low = fitted->range.cor_low, .high = fitted->range.cor_high}};
    out.push_back(ccor_chart(*fitted, std::move(ccor)));
  }
  return out;
}

}  // namespace

CommandReport trampoline_report(const model::Trampoline& model, const std::vector<double>& hoop_Hz,
                                const TrampolineExtras& extras) {
  const std::vector<model::Rebound> sweep = model::hoop_sweep(model, hoop_Hz);
  const model::HoopPeak peak = model::optimal_hoop_frequency(model, hoop_Hz, sweep);
  const double wall = model::rigid_wall_rebound(model).cor, reference = model::rebound(model, kReference_Hz).cor;
  std::optional<model::FittedExponents> fitted = extras.fitted;
  if (fitted) {
    fitted->range = model::sweep_range(model, fitted->fit, hoop_Hz, sweep);
    fitted->family = model::exponent_family(model, fitted->measured, fitted->fit, hoop_Hz);
  }
  Json json{{"schema", "percuss/model-trampoline/1"},
            {"version", version()},
            {"constants", constants_json(model)},
            {"wall_cor", wall},
            {"cor_10khz", reference},
            {"peak", peak_json(peak, fitted)},
            {"curve", curve_json(model, hoop_Hz, sweep, fitted)}};
  if (extras.modal_mass_kg) json["modal_mass_kg"] = *extras.modal_mass_kg;
  CcorCurve ccor;
  if (fitted) {
    ccor = ccor_curve(model, *fitted);
    json["fit"] = trampoline_fit_json(*fitted, ccor);
  }
  CommandReport report;
  report.columns = curve_columns(model, hoop_Hz, sweep, wall, reference);
  ModelChart chart{.hoop_Hz = hoop_Hz, .cor = report.columns[1].values, .wall = wall};
  if (fitted) {  // before the ratios
    report.columns.insert(report.columns.end() - 2, {"cor_low", fitted->range.cor_low});
    report.columns.insert(report.columns.end() - 2, {"cor_high", fitted->range.cor_high});
  }
  report.text = peak_text(hoop_Hz, peak, wall, reference, fitted) + extras_text(model, peak, extras);
  if (fitted) report.text += trampoline_fit_text(*fitted);
  if (!extras.bats.empty()) {
    const BatsBesideModel beside = bats_beside_model(model, extras.bats);
    json["bats"] = trampoline_bats_json(beside);
    report.text += trampoline_bats_text(beside);
    chart.bats = trampoline_bats_curve(beside);
    std::vector<double> bats_Hz;
    for (const MeasuredBat& bat : beside.bats) bats_Hz.push_back(bat.hoop_Hz);
    report.formulas = extras.formulas;
    add_bats_rows(curve_columns(model, bats_Hz, beside.rebounds, wall, reference), beside, report);
  }
  add_warnings(model::trampoline_warnings(model, peak, fitted), json, report.text);
  report.json = indented_text(json) + "\n";
  report.charts = charts_of(std::move(chart), fitted, std::move(ccor));
  return report;
}

}  // namespace percuss::report
