#include "acquire/formats/uff/uff_roles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

#include "acquire/channels/column_words.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::acquire {
namespace {

using Functions = std::vector<const UffFunction*>;

std::string lower_name(const UffFunction& function) { return lower_case(uff_dof_name(function.response)); }

// The names that options or set-up give the force, in lower case.
std::vector<std::string> given_force_names(const ReadOptions& options) {
  if (!options.force_channel.empty()) return {lower_case(options.force_channel)};
  std::vector<std::string> names;
  for (const ChannelSetup& entry : options.setup) {
    if (entry.role == "force") names.push_back(lower_case(entry.name));
  }
  return names;
}

bool states_force(const UffFunction& function) { return quantity_of_axis(function.ordinate) == Quantity::force; }

template <class Test>
std::vector<bool> where(const Functions& functions, Test&& test) {
  std::vector<bool> out;
  out.reserve(functions.size());
  for (const UffFunction* function : functions) out.push_back(test(*function));
  return out;
}

bool any(const std::vector<bool>& found) { return std::find(found.begin(), found.end(), true) != found.end(); }

// The function that a number means, counted from 1 in the order of the file; nothing where the text is a name.
const UffFunction* function_numbered(const std::string& text, const Functions& functions) {
  const std::string lower = lower_case(text);
  for (const UffFunction* function : functions) {
    if (lower_name(*function) == lower) return nullptr;
  }
  for (std::size_t i = 0; i < functions.size(); ++i) {
    if (std::to_string(i + 1) == text) return functions[i];
  }
  return nullptr;
}

}  // namespace

std::optional<Quantity> quantity_of_axis(const UffAxis& axis) {
  const auto unit = parse_unit(axis.unit);
  if (unit && (unit->quantity == Quantity::force || unit->quantity == Quantity::acceleration)) return unit->quantity;
  if (axis.quantity == Uff58::excitation_force || axis.quantity == Uff58::reaction_force) return Quantity::force;
  if (axis.quantity == Uff58::acceleration) return Quantity::acceleration;
  const bool unstated = axis.quantity == Uff58::unknown || axis.quantity == Uff58::general;
  return unstated ? quantity_named(axis.label) : std::nullopt;
}

std::vector<bool> force_functions(const Functions& functions, const ReadOptions& options) {
  const std::vector<std::string> names = given_force_names(options);
  std::vector<bool> found = where(functions, [&](const UffFunction& function) {
    return std::find(names.begin(), names.end(), lower_name(function)) != names.end();
  });
  if (!any(found)) found = where(functions, states_force);
  if (any(found)) return found;
  std::string name;  // two names are ambiguous: find_roles then lists the functions
  bool one_name = true;
  found = where(functions, [&](const UffFunction& function) {
    const std::string own = lower_name(function);
    if (quantity_of_axis(function.ordinate) || quantity_named(own) != Quantity::force) return false;
    if (name.empty()) name = own;
    one_name = one_name && own == name;
    return true;
  });
  return one_name ? found : std::vector<bool>(functions.size(), false);
}

ReadOptions with_names(const ReadOptions& options, const Functions& functions) {
  const std::vector<std::string> given = given_force_names(options);
  if (given.size() != 1 || any(where(functions, states_force))) return options;
  const UffFunction* const force = function_numbered(given.front(), functions);
  if (force == nullptr) return options;
  const auto rows =
      static_cast<std::size_t>(std::count_if(functions.begin(), functions.end(), [&](const UffFunction* function) {
        return lower_name(*function) == lower_name(*force);
      }));
  if (rows < 2 || functions.size() % rows != 0 || functions.size() < 2 * rows) return options;
  ReadOptions named = options;
  const auto name = [&](std::string& text) {
    const UffFunction* const function = function_numbered(text, functions);
    if (function != nullptr) text = uff_dof_name(function->response);
  };
  name(named.force_channel);
  for (std::string& channel : named.accel_channels) name(channel);
  for (ChannelSetup& entry : named.setup) name(entry.name);
  return named;
}

void name_by_id_lines(const std::vector<UffFunction*>& functions) {
  constexpr std::size_t kMaxName_bytes = 60;  // a longer line is a description
  std::map<std::pair<int, int>, std::string> line_of_place;
  std::map<std::string, std::pair<int, int>> place_of_line;
  for (const UffFunction* function : functions) {
    if (!function->response.name.empty()) continue;
    const std::string line(trimmed(function->id[0]));
    const std::pair place{function->response.node, function->response.direction};
    if (line.empty() || line == "NONE" || line.size() > kMaxName_bytes) return;
    if (line_of_place.emplace(place, line).first->second != line) return;
    if (place_of_line.emplace(line, place).first->second != place) return;
  }
  for (UffFunction* function : functions) {
    if (function->response.name.empty()) function->response.name = trimmed(function->id[0]);
  }
}

std::string uff_dof_name(const UffDof& dof) {
  if (!dof.name.empty()) return dof.name;
  const int direction = std::abs(dof.direction);
  const std::string sign = dof.direction < 0 ? "-" : "+";
  if (direction < 1 || direction > 6) return fmt::format("node {}", dof.node);
  constexpr std::array axes{"X", "Y", "Z", "RX", "RY", "RZ"};
  return fmt::format("{}{}{}", dof.node, sign, axes.at(static_cast<std::size_t>(direction - 1)));
}

}  // namespace percuss::acquire
