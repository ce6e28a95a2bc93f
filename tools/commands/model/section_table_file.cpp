#include "commands/model/section_table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "cli/option_error.hpp"
#include "core/error.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/input_file.hpp"
#include "core/io/number_table.hpp"
#include "core/units.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxRows = 1000, kMaxLayers = 9, kMaxColumns = 3 + 4 * kMaxLayers;
constexpr double kMaxEnd_m = 10, kMaxSize_m = 1;
constexpr double kMinSize_m = 1e-4;
constexpr const char* kProfileForm =
    "write a position from the knob or from x = 0, and a diameter, or width and thickness, in each line";
constexpr const char* kNamesForm =
    "name further columns in the first line: wall, young, shear, density, and wall_2, young_2 … of inner layers";

// Columns of the kinds from `thickness` to `density` belong to a layer.
enum class ColumnKind { position, diameter, width, thickness, wall, young, shear, density };

struct ColumnName {
  const char* name;
  ColumnKind what;
};
constexpr std::array<ColumnName, 12> kColumns{{{"position", ColumnKind::position},
                                               {"end", ColumnKind::position},
                                               {"x", ColumnKind::position},
                                               {"z", ColumnKind::position},
                                               {"diameter", ColumnKind::diameter},
                                               {"d", ColumnKind::diameter},
                                               {"width", ColumnKind::width},
                                               {"thickness", ColumnKind::thickness},
                                               {"wall", ColumnKind::wall},
                                               {"young", ColumnKind::young},
                                               {"shear", ColumnKind::shear},
                                               {"density", ColumnKind::density}}};

struct ProfileColumn {
  ColumnKind what = ColumnKind::position;
  std::size_t layer = 0;
  std::string unit;  // as stated in the header, in lower case
};

std::optional<ProfileColumn> column_named(const std::string& text) {
  const auto [written, unit] = split_name(text);
  std::string base = lower_case(written);
  std::size_t layer = 0;
  if (base.size() > 2 && base[base.size() - 2] == '_' && base.back() >= '1' && base.back() <= '9') {
    layer = static_cast<std::size_t>(base.back() - '1');
    base.resize(base.size() - 2);
  }
  for (const ColumnName& one : kColumns) {
    const bool of_layer = one.what >= ColumnKind::thickness;
    if (base == one.name && (layer == 0 || of_layer))
      return ProfileColumn{.what = one.what, .layer = layer, .unit = lower_case(unit)};
  }
  return {};
}

struct LengthUnits {
  double position_m = 1, size_m = 1;
};

double metres_of(const std::string& unit, const std::string& units) {
  const auto known = parse_unit(unit);
  if (!known || known->quantity != Quantity::length) {
    throw OptionError::wrong_value("profile_unit", units, "give two units of length POSITION:SIZE, such as cm:mm");
  }
  return known->to_SI;
}

LengthUnits length_units(const std::string& units) {
  const std::size_t colon = units.find(':');
  return {.position_m = metres_of(units.substr(0, colon), units),
          .size_m = metres_of(colon == std::string::npos ? "" : units.substr(colon + 1), units)};
}

// The names of the columns: the last line of names that contains a known one.
std::vector<std::string> names_of(const NumberTable& table, const std::vector<std::string>& unnamed) {
  const auto header = std::find_if(table.headers.rbegin(), table.headers.rend(), [](const auto& names) {
    return std::any_of(names.begin(), names.end(), [](const auto& cell) { return column_named(cell).has_value(); });
  });
  return header == table.headers.rend() ? unnamed : *header;
}

std::vector<ProfileColumn> columns_of(const NumberTable& table, const SectionTableForm& form,
                                      const std::string& where) {
  const std::size_t count = table.rows.front().values.size();
  const std::string& place = table.headers.empty() ? table.rows.front().place : where;
  std::vector<std::string> names = names_of(table, count == 2 ? std::vector<std::string>{} : form.unnamed);
  names.resize(count);
  std::vector<ProfileColumn> columns;
  columns.reserve(count);
  for (const std::string& name : names) {
    const std::size_t i = columns.size();
    auto column = column_named(name);
    if (!column && lower_case(name).starts_with("rad")) {
      throw InputError(fmt::format("column {} holds radii: '{}'", i + 1, one_line(name, 40)), place,
                       "give diameters, under the name diameter");
    }
    // A table of two columns needs no names that percuss knows.
    if (!column && count == 2) column = column_named(i == 0 ? "position" : "diameter");
    if (!column) {
      throw InputError(name.empty() ? fmt::format("column {} has no name", i + 1)
                                    : fmt::format("column {} has the unknown name '{}'", i + 1, one_line(name, 40)),
                       place, kNamesForm);
    }
    for (const ProfileColumn& before : columns) {
      if (before.what == column->what && before.layer == column->layer)
        throw InputError(fmt::format("column {} repeats an earlier one", i + 1), place, kNamesForm);
    }
    columns.push_back(*column);
  }
  return columns;
}

const ProfileColumn* column_for(const std::vector<ProfileColumn>& columns, ColumnKind what, std::size_t layer = 0) {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const auto& one) { return one.what == what && one.layer == layer; });
  return found == columns.end() ? nullptr : &*found;
}

// Whether the unit that the header states for a column is the one in which the column is read.
bool is_expected(const ProfileColumn& column, const LengthUnits& units) {
  const std::string& unit = column.unit;
  if (column.what == ColumnKind::density) return unit == "kg/m3" || unit == "kg/m^3" || unit == "kg/m³";
  if (column.what == ColumnKind::young || column.what == ColumnKind::shear)
    return unit == "pa" || unit == "n/m2" || unit == "n/m^2" || unit == "n/m²";
  const auto stated = parse_unit(unit);
  const double wanted_m = column.what == ColumnKind::position ? units.position_m : units.size_m;
  return stated && stated->quantity == Quantity::length && stated->to_SI == wanted_m;
}

// Refuses columns that give no section, and units in the header that differ from the profile's.
void check_columns(const std::vector<ProfileColumn>& columns, std::size_t layers, const LengthUnits& units,
                   const std::string& place) {
  const auto refuse = [&](const std::string& problem, const char* remedy) {
    return InputError(problem, place, remedy);
  };
  const bool round = column_for(columns, ColumnKind::diameter) != nullptr;
  if (!column_for(columns, ColumnKind::position)) throw refuse("there is no column of positions", kProfileForm);
  if (round == (column_for(columns, ColumnKind::width) != nullptr))
    throw refuse("either a diameter or a width must be given", kProfileForm);
  for (std::size_t layer = 0; layer < layers; ++layer) {
    const bool wall = column_for(columns, ColumnKind::wall, layer) != nullptr;
    const bool thickness = column_for(columns, ColumnKind::thickness, layer) != nullptr;
    if (round ? thickness : wall)
      throw refuse("a round section has walls, a rectangular one thicknesses", kProfileForm);
    if (round ? !wall && layer + 1 < layers : !thickness)
      throw refuse(fmt::format("layer {} has no {}", layer + 1, round ? "wall" : "thickness"), kNamesForm);
  }
  for (const ProfileColumn& one : columns) {
    if (one.unit.empty()) continue;
    if (!is_expected(one, units)) {
      throw InputError(fmt::format("the header states {}, another unit is expected", one.unit), place,
                       "give lengths in the profile's units, moduli in Pa and densities in kg/m³", {"profile_unit"});
    }
  }
}

model::SectionStation station_of(const NumberTableRow& row, const std::vector<ProfileColumn>& columns,
                                 std::size_t layers, const LengthUnits& units) {
  model::SectionStation station{.layers = std::vector<model::SectionLayer>(layers)};
  const auto refuse_size = [&](const std::string& problem) {
    return InputError(problem, row.place, kProfileForm, {"profile_unit"});
  };
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double value = row.values[i], size_m = value * units.size_m;
    model::SectionLayer& layer = station.layers[columns[i].layer];
    const auto checked_size = [&](const char* name) {
      if (!(size_m >= kMinSize_m && size_m <= kMaxSize_m))
        throw refuse_size(fmt::format("{} of {:g} m is not between 0.0001 and 1 m", name, size_m));
      return size_m;
    };
    const auto checked_constant = [&](const char* name) {
      if (!(value > 0))
        throw InputError(fmt::format("{} of {:g} is not above zero", name, value), row.place, kProfileForm);
      return value;
    };
    switch (columns[i].what) {
      case ColumnKind::position:
        station.at_m = value * units.position_m;
        break;
      case ColumnKind::diameter:
        station.width_m = checked_size("a diameter");
        break;
      case ColumnKind::width:
        station.width_m = checked_size("a width");
        break;
      case ColumnKind::thickness:
        layer.thickness_m = checked_size("a thickness");
        break;
      case ColumnKind::wall:
        if (!(size_m > 0 && size_m <= kMaxSize_m))
          throw refuse_size(fmt::format("a wall of {:g} m is not above 0 and at most 1 m", size_m));
        layer.thickness_m = size_m;
        break;
      case ColumnKind::young:
        layer.young_Pa = checked_constant("Young's modulus");
        break;
      case ColumnKind::shear:
        layer.shear_Pa = checked_constant("a shear modulus");
        break;
      case ColumnKind::density:
        layer.density_kgpm3 = checked_constant("a density");
        break;
    }
  }
  return station;
}

}  // namespace

model::SectionTable read_section_table(const std::string& path, const SectionTableForm& form) {
  const LengthUnits units = length_units(form.units);
  const NumberTable table = read_named_number_table(
      path, {.columns = 2, .max_columns = kMaxColumns, .max_rows = kMaxRows, .remedy = kProfileForm});
  const std::vector<ProfileColumn> columns = columns_of(table, form, input_name(path));
  std::size_t layers = 1;
  for (const ProfileColumn& one : columns) layers = std::max(layers, one.layer + 1);
  check_columns(columns, layers, units, table.rows.front().place);
  model::SectionTable out{
      .kind = form.kind, .round = column_for(columns, ColumnKind::diameter) != nullptr, .stations = {}};
  const bool from_zero = form.kind == model::ProfileKind::points;
  for (const NumberTableRow& row : table.rows) {
    out.stations.push_back(station_of(row, columns, layers, units));
    const double at_m = out.stations.back().at_m;
    const bool first = out.stations.size() == 1;
    if (first && at_m == 0 && !from_zero) {
      throw InputError("a slice that ends at position 0", row.place,
                       "write the end of each slice, or state that the rows are points", {"profile_kind"});
    }
    if (first ? !(at_m > 0 || (from_zero && at_m == 0)) : !(at_m > out.stations[out.stations.size() - 2].at_m))
      throw InputError("the positions do not ascend", row.place, kProfileForm);
    if (!(at_m <= kMaxEnd_m)) {
      throw InputError(fmt::format("a position of {:g} m is beyond 10 m", at_m), row.place, kProfileForm,
                       {"profile_unit"});
    }
  }
  if (!(out.length_m() > 0)) throw InputError("a bat or beam of no length", table.rows.front().place, kProfileForm);
  return out;
}

}  // namespace percuss::tools
