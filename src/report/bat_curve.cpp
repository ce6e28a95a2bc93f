#include "report/bat_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

namespace percuss::report {
namespace {

constexpr Eigen::Index kModesShown = 8;  // whose shares of the energy are listed
constexpr Eigen::Index kModesInTable = 4;
constexpr std::size_t kRowsInTable = 13;

}  // namespace

double effective_mass_kg(const model::BatModes& bat, double z_m) {
  const double accelerance_per_kg = bat.rigid_accelerance_per_kg(z_m);
  return accelerance_per_kg > 0 ? 1 / accelerance_per_kg : std::numeric_limits<double>::quiet_NaN();
}

BatCurve bat_curve(const model::BatModes& bat, const model::BatCollision& collision, const std::vector<double>& z_m) {
  const auto modes = static_cast<std::size_t>(bat.freq_Hz.size());
  BatCurve curve{.z_m = z_m, .flexible = model::bat_sweep(bat, modes, collision, z_m), .best = {}, .best_rigid = {}};
  for (const model::BatRebound& half : model::bat_sweep(bat, modes / 2, collision, z_m))
    curve.half.values.push_back(half.exit_speed_mps);
  for (std::size_t i = 0; i < z_m.size(); ++i) {
    const model::BatRebound& r = curve.flexible[i];
    curve.exit.values.push_back(r.exit_speed_mps);
    curve.rigid.values.push_back(model::rigid_exit_speed_mps(bat, collision, z_m[i]));
    curve.contact.values.push_back(r.contact_s);
    curve.contacts.values.push_back(static_cast<double>(r.contacts));
    curve.mass.values.push_back(effective_mass_kg(bat, z_m[i]));
  }
  curve.best = bracketed_maximum([&](double z) { return model::bat_rebound(bat, modes, collision, z).exit_speed_mps; },
                                 z_m, curve.exit.values);
  curve.best_rigid = bracketed_maximum([&](double z) { return model::rigid_exit_speed_mps(bat, collision, z); }, z_m,
                                       curve.rigid.values);
  return curve;
}

nlohmann::ordered_json bat_curve_json(const BatCurve& curve) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < curve.z_m.size(); ++i) {
    const model::BatRebound& r = curve.flexible[i];
    const Eigen::VectorXd share = r.mode_share.head(std::min(kModesShown, r.mode_share.size()));
    json.push_back({{"z_m", curve.z_m[i]},
                    {curve.exit.name, r.exit_speed_mps},
                    {curve.rigid.name, curve.rigid.values[i]},
                    {curve.half.name, curve.half.values[i]},
                    {curve.contact.name, r.contact_s},
                    {curve.contacts.name, r.contacts},
                    {"ball_share", r.ball_share},
                    {"vibration_share", r.mode_share.sum()},
                    {curve.mass.name, std::isfinite(curve.mass.values[i]) ? nlohmann::ordered_json(curve.mass.values[i])
                                                                          : nlohmann::ordered_json()},
                    {"mode_share", std::vector<double>(share.begin(), share.end())}});
  }
  return json;
}

void add_participation(const std::vector<model::BatRebound>& rebounds, std::vector<NumericColumn>& columns) {
  if (rebounds.empty()) return;
  NumericColumn ball{.name = "ball_share", .values = {}}, vibration{.name = "vibration_share", .values = {}};
  for (const model::BatRebound& r : rebounds) {
    ball.values.push_back(r.ball_share);
    vibration.values.push_back(r.mode_share.sum());
  }
  columns.push_back(std::move(ball));
  columns.push_back(std::move(vibration));
  for (Eigen::Index m = 0; m < std::min(kModesShown, rebounds.front().mode_share.size()); ++m) {
    NumericColumn column{.name = fmt::format("mode_share_{}", m + 1), .values = {}};
    for (const model::BatRebound& r : rebounds) column.values.push_back(r.mode_share[m]);
    columns.push_back(std::move(column));
  }
}

TextTable participation_table(const BatCurve& curve, Eigen::Index modes) {
  const Eigen::Index shown = std::min(modes, kModesInTable);
  std::vector<TextTable::Column> heads{{"impact, mm", TextTable::Align::right},
                                       {"exit speed", TextTable::Align::right},
                                       {"rigid bat", TextTable::Align::right},
                                       {"lost in ball", TextTable::Align::right}};
  for (Eigen::Index m = 0; m < shown; ++m) heads.push_back({fmt::format("bending {}", m + 1), TextTable::Align::right});
  heads.push_back({"other modes", TextTable::Align::right});
  TextTable table(std::move(heads));
  const auto percent = [](double share) { return fmt::format("{:.2f} %", 100 * share); };
  const std::size_t every = std::max<std::size_t>(1, (curve.z_m.size() + kRowsInTable - 2) / (kRowsInTable - 1));
  for (std::size_t i = 0; i < curve.z_m.size(); i += every) {
    const model::BatRebound& r = curve.flexible[i];
    std::vector<std::string> cells{fmt::format("{:.1f}", 1000 * curve.z_m[i]),
                                   fmt::format("{:.2f} m/s", r.exit_speed_mps),
                                   fmt::format("{:.2f} m/s", curve.rigid.values[i]), percent(r.ball_share)};
    for (Eigen::Index m = 0; m < shown; ++m) cells.push_back(percent(r.mode_share[m]));
    cells.push_back(percent(r.mode_share.tail(r.mode_share.size() - shown).sum()));
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace percuss::report
