#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/math/roots.hpp"
#include "model/bat/bat_collision.hpp"
#include "report/text/numeric_csv.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {

/// Exit speeds over the position of impact, each with its energy balance. `exit`: with all elastic modes of the bat,
/// `half`: with the lower half of them, `rigid`: with none.
struct BatCurve {
  std::vector<double> z_m;
  std::vector<model::BatRebound> flexible;
  NumericColumn exit{.name = "exit_speed_mps", .values = {}}, rigid{.name = "rigid_exit_speed_mps", .values = {}},
      half{.name = "half_modes_exit_speed_mps", .values = {}}, contact{.name = "contact_s", .values = {}},
      contacts{.name = "contacts", .values = {}}, mass{.name = "effective_mass_kg", .values = {}};
  MaximumPoint best, best_rigid;
};

BatCurve bat_curve(const model::BatModes& bat, const model::BatCollision& collision, const std::vector<double>& z_m);

/// "curve" of the document.
nlohmann::ordered_json bat_curve_json(const BatCurve& curve);

/// Of the rigid bat at the struck point; NaN at a support, which does not give way.
double effective_mass_kg(const model::BatModes& bat, double z_m);

/// Appends the shares of the energy: lost in the ball, in all modes, and in each of the lowest modes.
void add_participation(const std::vector<model::BatRebound>& rebounds, std::vector<NumericColumn>& columns);

/// Exit speeds and the shares of the energy, for some of the impacts.
TextTable participation_table(const BatCurve& curve, Eigen::Index modes);

}  // namespace percuss::report
