#include "report/trampoline_report.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "report/text/number_format.hpp"
#include "report/text/version.hpp"

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

Json fit_json(const FittedExponents& fitted) {
  const model::ExponentFit& fit = fitted.fit;
  Json json{{"a", fit.stiffness_exponent},
            {"a_std", fit.stiffness_exponent_std},
            {"b", fit.damping_exponent},
            {"b_std", fit.damping_exponent_std},
            {"b_std_given_a", fit.damping_exponent_std_given_a},
            {"correlation", fit.correlation},
            {"chi2", fit.chi2},
            {"beyond_std", fit.beyond_std},
            {"points", Json::array()}};
  for (std::size_t i = 0; i < fitted.measured.size(); ++i) {
    const model::MeasuredCor& m = fitted.measured[i];
    json["points"].push_back(
        {{"speed_mps", m.speed_mps}, {"cor", m.cor}, {"cor_std", m.cor_std}, {"model_cor", fit.model_cor[i]}});
  }
  return json;
}

std::string fit_text(const FittedExponents& fitted) {
  const model::ExponentFit& fit = fitted.fit;
  return fmt::format(
      "fit to measured CCOR: a = {}, b = {}, correlation {:.6f}; for a known a, b has ± {:.2g}; chi2 {:.2f} of {} "
      "points, {} with residuals above their ±\n",
      value_with_std(fit.stiffness_exponent, fit.stiffness_exponent_std),
      value_with_std(fit.damping_exponent, fit.damping_exponent_std), fit.correlation, fit.damping_exponent_std_given_a,
      fit.chi2, fitted.measured.size(), fit.beyond_std);
}

std::string extras_text(const model::Trampoline& model, const model::HoopPeak& peak, const TrampolineExtras& extras) {
  std::string text;
  if (model.extra_mass_kg > 0) {
    text += fmt::format("with {:g} kg on the barrel a hoop frequency of {:.1f} Hz falls to {:.1f} Hz\n",
                        model.extra_mass_kg, peak.hoop_Hz, model::loaded_hoop_Hz(model, peak.hoop_Hz));
  }
  if (extras.modal_mass_kg)
    text += fmt::format("the shift corresponds to a modal mass of {:.4f} kg\n", *extras.modal_mass_kg);
  if (extras.fitted) text += fit_text(*extras.fitted);
  return text;
}

}  // namespace

CommandReport trampoline_report(const model::Trampoline& model, const std::vector<double>& hoop_Hz,
                                const TrampolineExtras& extras) {
  const std::vector<model::Rebound> sweep = model::hoop_sweep(model, hoop_Hz);
  const model::HoopPeak peak = model::optimal_hoop_frequency(model, hoop_Hz, sweep);
  const double wall = model::rigid_wall_rebound(model).cor, reference = model::rebound(model, kReference_Hz).cor;
  NumericColumn cor{.name = "cor"}, loaded{.name = "loaded_hoop_hz"}, contact{.name = "contact_s"},
      contacts{.name = "contacts"};
  Json json{{"schema", "percuss/model-trampoline/1"},
            {"version", version()},
            {"constants", constants_json(model)},
            {"wall_cor", wall},
            {"cor_10khz", reference},
            {"peak", {{"hoop_hz", peak.hoop_Hz}, {"cor", peak.cor}}},
            {"curve", Json::array()}};
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    cor.values.push_back(sweep[i].cor);
    loaded.values.push_back(model::loaded_hoop_Hz(model, hoop_Hz[i]));
    contact.values.push_back(sweep[i].contact_s);
    contacts.values.push_back(static_cast<double>(sweep[i].contacts));
    json["curve"].push_back({{"hoop_hz", hoop_Hz[i]},
                             {cor.name, sweep[i].cor},
                             {loaded.name, loaded.values.back()},
                             {contact.name, sweep[i].contact_s},
                             {contacts.name, sweep[i].contacts}});
  }
  if (extras.modal_mass_kg) json["modal_mass_kg"] = *extras.modal_mass_kg;
  if (extras.fitted) json["fit"] = fit_json(*extras.fitted);
  CommandReport report;
  report.json = json.dump(2) + "\n";
  report.text = fmt::format(
                    "trampoline: the COR is largest, {:.4f}, at a hoop frequency of {:.1f} Hz. It is {:.3f} of the "
                    "rigid wall's {:.5f} and {:.3f} of the {:.4f} at 10 kHz\n",
                    peak.cor, peak.hoop_Hz, peak.cor / wall, wall, peak.cor / reference, reference) +
                extras_text(model, peak, extras);
  report.charts = {
      {.title = "Ball and hollow barrel",
       .x = {.label = "hoop frequency, Hz"},
       .y = {.label = "coefficient of restitution"},
       .curves = {{"barrel", hoop_Hz, cor.values}, {"rigid wall", {hoop_Hz.front(), hoop_Hz.back()}, {wall, wall}}}}};
  report.columns = {{"hoop_hz", hoop_Hz}, cor, loaded, contact, contacts};
  return report;
}

}  // namespace percuss::report
