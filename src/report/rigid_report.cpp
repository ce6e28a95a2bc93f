#include "report/rigid_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/json/json_document.hpp"
#include "report/text/version.hpp"

namespace percuss::report {

CommandReport rigid_report(const model::RigidCollision& collision, const std::vector<double>& z_m) {
  const model::BestImpact best = model::best_impact(collision, z_m.front(), z_m.back());
  NumericColumn exit{.name = "exit_speed_mps"}, swing{.name = "swing_speed_mps"}, mass{.name = "effective_mass_kg"};
  nlohmann::ordered_json json{{"schema", "percuss/model-rigid/1"},
                              {"version", version()},
                              {"best", {{"z_m", best.z_m}, {"exit_speed_mps", best.exit_speed_mps}}},
                              {"curve", nlohmann::ordered_json::array()}};
  for (const double z : z_m) {
    exit.values.push_back(model::exit_speed_mps(collision, z));
    swing.values.push_back(swing_speed_mps(collision, z));
    mass.values.push_back(model::effective_mass_kg(collision, z));
    json["curve"].push_back({{"z_m", z},
                             {exit.name, exit.values.back()},
                             {swing.name, swing.values.back()},
                             {mass.name, mass.values.back()}});
  }
  const double near_m = 0.05;
  const auto loss = [&](double z) { return best.exit_speed_mps - model::exit_speed_mps(collision, z); };
  CommandReport report;
  report.json = indented_text(json) + "\n";
  report.text = fmt::format(
      "rigid bat: the ball leaves fastest, with {:.2f} m/s, {:.1f} mm from the centre of mass (positive towards the "
      "barrel)\n5 cm closer to the handle the ball is {:.2f} m/s slower, 5 cm closer to the tip {:.2f} m/s\n",
      best.exit_speed_mps, 1000 * best.z_m, loss(best.z_m - near_m), loss(best.z_m + near_m));
  report.charts = {{.title = "Rigid bat",
                    .x = {.label = "impact from the centre of mass, m"},
                    .y = {.label = "speed, m/s"},
                    .curves = {{"ball after impact", z_m, exit.values}, {"bat before impact", z_m, swing.values}}},
                   {.title = "Effective mass of the bat",
                    .x = {.label = "impact from the centre of mass, m"},
                    .y = {.label = "effective mass, kg"},
                    .curves = {{"effective mass", z_m, mass.values}}}};
  report.columns = {{"z_m", z_m}, exit, swing, mass};
  return report;
}

}  // namespace percuss::report
