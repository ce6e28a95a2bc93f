#include "core/units.hpp"

#include <array>
#include <cctype>
#include <utility>

#include "core/error.hpp"

namespace percuss {
inline namespace core {
namespace {

struct Name {
  std::string_view text;
  Unit unit;
};

constexpr double kFoot_m = 12 * kInch_m;

// Names after normalised(): no spaces or outer brackets, squares as "2", micro as "u", accelerations as length/s2.
constexpr std::array kNames = {
    Name{"N", {Quantity::force, 1}},
    Name{"mN", {Quantity::force, 1e-3}},
    Name{"kN", {Quantity::force, 1e3}},
    Name{"Newton", {Quantity::force, 1}},
    Name{"newton", {Quantity::force, 1}},
    Name{"Newtons", {Quantity::force, 1}},
    Name{"newtons", {Quantity::force, 1}},
    Name{"lbf", {Quantity::force, kPoundForce_N}},
    Name{"lb-f", {Quantity::force, kPoundForce_N}},
    Name{"lbF", {Quantity::force, kPoundForce_N}},
    Name{"kgf", {Quantity::force, kStandardGravity_mps2}},
    Name{"m/s2", {Quantity::acceleration, 1}},
    Name{"mm/s2", {Quantity::acceleration, 1e-3}},
    Name{"cm/s2", {Quantity::acceleration, 1e-2}},
    Name{"in/s2", {Quantity::acceleration, kInch_m}},
    Name{"ft/s2", {Quantity::acceleration, kFoot_m}},
    Name{"g", {Quantity::acceleration, kStandardGravity_mps2}},
    Name{"G", {Quantity::acceleration, kStandardGravity_mps2}},
    Name{"g's", {Quantity::acceleration, kStandardGravity_mps2}},
    Name{"G's", {Quantity::acceleration, kStandardGravity_mps2}},
    Name{"Gs", {Quantity::acceleration, kStandardGravity_mps2}},
    Name{"gn", {Quantity::acceleration, kStandardGravity_mps2}},
    Name{"mg", {Quantity::acceleration, 1e-3 * kStandardGravity_mps2}},
    Name{"V", {Quantity::voltage, 1}},
    Name{"v", {Quantity::voltage, 1}},
    Name{"Volt", {Quantity::voltage, 1}},
    Name{"volt", {Quantity::voltage, 1}},
    Name{"Volts", {Quantity::voltage, 1}},
    Name{"volts", {Quantity::voltage, 1}},
    Name{"mV", {Quantity::voltage, 1e-3}},
    Name{"uV", {Quantity::voltage, 1e-6}},
    Name{"s", {Quantity::time, 1}},
    Name{"S", {Quantity::time, 1}},
    Name{"sec", {Quantity::time, 1}},
    Name{"Sec", {Quantity::time, 1}},
    Name{"seconds", {Quantity::time, 1}},
    Name{"ms", {Quantity::time, 1e-3}},
    Name{"msec", {Quantity::time, 1e-3}},
    Name{"us", {Quantity::time, 1e-6}},
    Name{"min", {Quantity::time, 60}},
    Name{"deg", {Quantity::angle, kDegree_rad}},
    Name{"degree", {Quantity::angle, kDegree_rad}},
    Name{"degrees", {Quantity::angle, kDegree_rad}},
    Name{"rad", {Quantity::angle, 1}},
    Name{"m", {Quantity::length, 1}},
    Name{"mm", {Quantity::length, 1e-3}},
    Name{"cm", {Quantity::length, 1e-2}},
    Name{"in", {Quantity::length, kInch_m}},
    Name{"inch", {Quantity::length, kInch_m}},
    Name{"ft", {Quantity::length, kFoot_m}},
    Name{"kg", {Quantity::mass, 1}},
    Name{"lb", {Quantity::mass, kPound_kg}},
    Name{"lbs", {Quantity::mass, kPound_kg}},
    Name{"pounds", {Quantity::mass, kPound_kg}},
    Name{"Pounds", {Quantity::mass, kPound_kg}},
    Name{"oz", {Quantity::mass, kOunce_kg}},
    Name{"Pa", {Quantity::pressure, 1}},
    Name{"kPa", {Quantity::pressure, 1e3}},
    Name{"mPa", {Quantity::pressure, 1e-3}},
    Name{"uPa", {Quantity::pressure, 1e-6}},
    Name{"m/s", {Quantity::velocity, 1}},
    Name{"m_s", {Quantity::velocity, 1}},
    Name{"mm/s", {Quantity::velocity, 1e-3}},
    Name{"mm_s", {Quantity::velocity, 1e-3}},
    Name{"cm/s", {Quantity::velocity, 1e-2}},
    Name{"cm_s", {Quantity::velocity, 1e-2}},
    Name{"in/s", {Quantity::velocity, kInch_m}},
    Name{"ft/s", {Quantity::velocity, kFoot_m}},
};

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

void remove_outer_brackets(std::string& text) {
  while (text.size() >= 2 &&
         ((text.front() == '(' && text.back() == ')') || (text.front() == '[' && text.back() == ']'))) {
    text = text.substr(1, text.size() - 2);
  }
}

// The spelling of a name that kNames uses.
std::string normalised(std::string_view name) {
  // UTF-8 comes before Latin-1, whose single bytes occur inside UTF-8 sequences.
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 21> kSame = {{
      {"\xC2\xB2", "2"},     {"\xC2\xB5", "u"},     {"\xCE\xBC", "u"},   {"\xC2\xB7", "*"}, {"\xE2\x8B\x85", "*"},
      {"\xE2\x81\xBB", "-"}, {"\xE2\x88\x92", "-"}, {"\xC2\xB0", "deg"}, {"\xB2", "2"},     {"\xB5", "u"},
      {"\xB7", "*"},         {"\xB0", "deg"},       {"**", "^"},         {"^", ""},         {"s*s", "s2"},
      {"(s2)", "s2"},        {"/s/s", "/s2"},       {"*s-2", "/s2"},     {"_s2", "/s2"},    {"ps2", "/s2"},
      {"/sec2", "/s2"},
  }};
  std::string text;
  for (const char c : name) {
    if (std::isspace(static_cast<unsigned char>(c)) == 0) text += c;
  }
  remove_outer_brackets(text);
  for (const auto& [from, to] : kSame) replace_all(text, from, to);
  return text;
}

std::string quantity_name(Quantity quantity) {
  switch (quantity) {
    case Quantity::force:
      return "a force";
    case Quantity::acceleration:
      return "an acceleration";
    case Quantity::voltage:
      return "a voltage";
    case Quantity::time:
      return "a time";
    case Quantity::angle:
      return "an angle";
    case Quantity::length:
      return "a length";
    case Quantity::mass:
      return "a mass";
    case Quantity::pressure:
      return "a pressure";
    case Quantity::velocity:
      return "a velocity";
  }
  return "nothing";
}

std::string examples(Quantity quantity) {
  switch (quantity) {
    case Quantity::force:
      return "N, kN, lbf or kgf";
    case Quantity::acceleration:
      return "m/s^2, mm/s^2, cm/s^2, in/s^2, ft/s^2, g or mg";
    case Quantity::voltage:
      return "V or mV";
    case Quantity::time:
      return "s, ms or us";
    case Quantity::angle:
      return "deg or rad";
    case Quantity::length:
      return "m, mm, cm, in or ft";
    case Quantity::mass:
      return "kg, lb or oz";
    case Quantity::pressure:
      return "Pa or kPa";
    case Quantity::velocity:
      return "m/s or mm/s";
  }
  return "SI";
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view name) {
  constexpr std::size_t kMaxLength = 24;  // bytes of the longest name worth normalising
  if (name.empty() || name.size() > kMaxLength) return std::nullopt;
  const std::string text = normalised(name);
  for (const auto& known : kNames) {
    if (known.text == text) return known.unit;
  }
  return std::nullopt;
}

Unit require_unit(std::string_view name, Quantity wanted, std::string_view where) {
  return require_unit(name, wanted, where, {});
}

Unit require_unit(std::string_view name, Quantity wanted, std::string_view where,
                  const std::vector<OptionId>& options) {
  const auto unit = parse_unit(name);
  const std::string remedy = "use " + examples(wanted);
  if (!unit) throw InputError("unknown unit \"" + one_line(name, 40) + "\"", where, remedy, options);
  if (unit->quantity == Quantity::velocity && wanted == Quantity::acceleration) {
    throw InputError("\"" + one_line(name, 40) + "\" measures a velocity, not an acceleration", where,
                     "differentiate the velocities, or give FRFs of them as mobility");
  }
  // A hammer or a load cell in pounds measures pounds of force.
  if (unit->quantity == Quantity::mass && wanted == Quantity::force && unit->to_SI == kPound_kg)
    return {Quantity::force, kPoundForce_N};
  if (unit->quantity != wanted) {
    throw InputError(
        "\"" + one_line(name, 40) + "\" measures " + quantity_name(unit->quantity) + ", not " + quantity_name(wanted),
        where, remedy, options);
  }
  return *unit;
}

std::string si_name(Quantity quantity) {
  switch (quantity) {
    case Quantity::force:
      return "N";
    case Quantity::acceleration:
      return "m/s^2";
    case Quantity::voltage:
      return "V";
    case Quantity::time:
      return "s";
    case Quantity::angle:
      return "rad";
    case Quantity::length:
      return "m";
    case Quantity::mass:
      return "kg";
    case Quantity::pressure:
      return "Pa";
    case Quantity::velocity:
      return "m/s";
  }
  return {};
}

}  // namespace core
}  // namespace percuss
