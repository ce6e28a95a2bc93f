#include "report/shell_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/math/significance.hpp"
#include "report/json/json_document.hpp"
#include "report/text/birge_text.hpp"
#include "report/text/number_format.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

// The degrees of freedom: measured frequencies less fitted values.
std::size_t spare_frequencies(const FittedShell& fitted) {
  const std::size_t values = (fitted.fit.young_std_Pa > 0 ? 1U : 0U) + (fitted.fit.wall_std_m > 0 ? 1U : 0U);
  return fitted.measured.size() - values;
}

Json fitted_json(const FittedShell& fitted) {
  const model::ShellFit& fit = fitted.fit;
  Json json{{"young_pa", fit.shell.young_Pa},
            {"young_std_pa", fit.young_std_Pa},
            {"wall_m", fit.shell.wall_m},
            {"wall_std_m", fit.wall_std_m},
            {"correlation", fit.correlation},
            {"chi2", fit.chi2},
            {"birge_ratio", birge_ratio(fit.chi2, static_cast<double>(spare_frequencies(fitted)))},
            {"points", Json::array()}};
  for (std::size_t i = 0; i < fitted.measured.size(); ++i) {
    const model::MeasuredHoop& hoop = fitted.measured[i];
    json["points"].push_back({{"n", hoop.n},
                              {"m", hoop.m},
                              {"frequency_hz", hoop.freq_Hz},
                              {"frequency_std_hz", hoop.freq_std_Hz},
                              {"model_hz", fit.model_Hz[i]}});
  }
  return json;
}

std::string fitted_text(const FittedShell& fitted) {
  const model::ShellFit& fit = fitted.fit;
  return fmt::format("fit: E = {} GPa, wall {} mm, correlation {:.4f}, chi2 {:.2f} of {} frequencies\n",
                     value_with_std(fit.shell.young_Pa / 1e9, fit.young_std_Pa / 1e9),
                     value_with_std(1000 * fit.shell.wall_m, 1000 * fit.wall_std_m), fit.correlation, fit.chi2,
                     fitted.measured.size()) +
         birge_text(fit.chi2, spare_frequencies(fitted));
}

}  // namespace

CommandReport shell_report(const model::TubeShell& shell, std::size_t n, std::size_t modes,
                           const std::optional<FittedShell>& fitted) {
  NumericColumn half_waves{.name = "m", .values = {}}, flugge{.name = "flugge_hz", .values = {}};
  for (std::size_t m = 1; m <= modes; ++m) {
    half_waves.values.push_back(static_cast<double>(m));
    flugge.values.push_back(model::flugge_Hz(shell, n, m));
  }
  Json json{{"schema", "percuss/model-shell/1"},
            {"version", version()},
            {"n", n},
            {"ring_hz", model::ring_Hz(shell, n)},
            {"rayleigh_hz", model::rayleigh_Hz(shell, n)},
            {"love_hz", model::love_Hz(shell, n)},
            {"flugge_hz", flugge.values},
            {"mass_kg", model::tube_mass_kg(shell)}};
  if (fitted) json["fit"] = fitted_json(*fitted);
  CommandReport report;
  report.json = indented_text(json) + "\n";
  report.text = fmt::format("hoop modes with {} waves around: ring {:.1f} Hz, Rayleigh {:.1f} Hz, Love {:.1f} Hz\n", n,
                            model::ring_Hz(shell, n), model::rayleigh_Hz(shell, n), model::love_Hz(shell, n));
  for (std::size_t m = 1; m <= modes; ++m)
    report.text += fmt::format("Flügge, {} half-wave{} along: {:.1f} Hz\n", m, m == 1 ? "" : "s", flugge.values[m - 1]);
  report.text +=
      fmt::format("the tube weighs {:.4f} kg, an estimate of a barrel's effective mass m2 in the trampoline model\n",
                  model::tube_mass_kg(shell));
  if (fitted) report.text += fitted_text(*fitted);
  report.charts = {{.title = fmt::format("Hoop modes of a tube, {} waves around", n),
                    .x = {.label = "half-waves along"},
                    .y = {.label = "frequency, Hz"},
                    .curves = {{"Flügge", half_waves.values, flugge.values, true}}}};
  report.columns = {half_waves, flugge};
  return report;
}

}  // namespace percuss::report
