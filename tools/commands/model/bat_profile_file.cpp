#include "commands/model/bat_profile_file.hpp"

#include <fmt/format.h>

#include "cli/option_error.hpp"
#include "core/error.hpp"
#include "core/io/number_table.hpp"
#include "core/units.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxSlices = 1000;
constexpr double kMaxEnd_m = 10, kMaxDiameter_m = 1;
constexpr double kMinDiameter_m = 1e-4;
constexpr const char* kProfileForm =
    "write the position of a slice's far end, from the knob, and its diameter in each line";

double metres_of(const std::string& unit, const std::string& units) {
  const auto known = parse_unit(unit);
  if (!known || known->quantity != Quantity::length) {
    throw OptionError::wrong_value("profile_unit", units, "give two units of length END:DIAMETER, such as cm:mm");
  }
  return known->to_SI;
}

}  // namespace

model::BatProfile read_bat_profile(const std::string& path, const std::string& units) {
  const std::size_t colon = units.find(':');
  const double end_to_m = metres_of(units.substr(0, colon), units);
  const double diameter_to_m = metres_of(colon == std::string::npos ? "" : units.substr(colon + 1), units);
  model::BatProfile profile;
  double last_m = 0;
  for (const NumberTableRow& row :
       read_number_table(path, {.columns = 2, .max_rows = kMaxSlices, .remedy = kProfileForm})) {
    const double end_m = row.values[0] * end_to_m, diameter_m = row.values[1] * diameter_to_m;
    const auto refuse = [&](const std::string& problem) {
      return InputError(problem, row.place, kProfileForm, {"profile_unit"});
    };
    if (!(end_m > last_m)) throw refuse("the slice ends where the one before does, or earlier");
    if (!(end_m <= kMaxEnd_m)) throw refuse(fmt::format("a slice ends {:g} m from the knob", end_m));
    if (!(diameter_m >= kMinDiameter_m && diameter_m <= kMaxDiameter_m))
      throw refuse(fmt::format("a diameter of {:g} m", diameter_m));
    profile.end_m.push_back(end_m);
    profile.diameter_m.push_back(diameter_m);
    last_m = end_m;
  }
  return profile;
}

}  // namespace percuss::tools
