#include "acquire/channels/frf_unit.hpp"

#include <string>

#include "core/io/csv_header.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

// Without surrounding blanks and without one matching pair of brackets.
std::string_view bare(std::string_view text) {
  text = trimmed(text);
  const bool round = text.starts_with('(') && text.find(')') == text.size() - 1;
  const bool square = text.starts_with('[') && text.find(']') == text.size() - 1;
  if (text.size() >= 2 && (round || square)) text = trimmed(text.substr(1, text.size() - 2));
  return text;
}

struct Motion {
  FrfKind kind;
  double to_SI;
};

std::optional<Motion> parse_motion(std::string_view text) {
  const std::string_view name = bare(text);
  const auto unit = parse_unit(name);
  if (unit && unit->quantity == Quantity::acceleration) return Motion{FrfKind::accelerance, unit->to_SI};
  if (unit && unit->quantity == Quantity::length) return Motion{FrfKind::receptance, unit->to_SI};
  if (name == "um" || name == "\u00B5m" || name == "\xB5m") return Motion{FrfKind::receptance, 1e-6};
  if (!name.ends_with("/s")) return std::nullopt;
  const auto length = parse_unit(name.substr(0, name.size() - 2));
  if (!length || length->quantity != Quantity::length) return std::nullopt;
  return Motion{FrfKind::mobility, length->to_SI};
}

std::optional<FrfUnit> parse_quotient(std::string_view above, std::string_view below) {
  const auto motion = parse_motion(above);
  const auto force = parse_unit(bare(below));
  if (!motion || !force || force->quantity != Quantity::force) return std::nullopt;
  return FrfUnit{.kind = motion->kind, .response_to_SI = motion->to_SI, .force_to_SI = force->to_SI};
}

}  // namespace

std::optional<FrfUnit> parse_frf_unit(std::string_view text) {
  constexpr std::size_t kMaxUnitLength = 64;  // characters: longer texts are no units
  text = trimmed(text);
  if (text.size() > kMaxUnitLength) return std::nullopt;
  if (text.size() > 2 && text.front() == '[' && text.back() == ']') text = trimmed(text.substr(1, text.size() - 2));
  if (const auto between = text.find(")("); between != std::string_view::npos)
    return parse_quotient(text.substr(0, between + 1), text.substr(between + 1));
  const auto slash = text.rfind('/');
  if (slash == std::string_view::npos) return std::nullopt;
  if (const auto unit = parse_quotient(text.substr(0, slash), text.substr(slash + 1))) return unit;
  // "((m/s^2)/N)": brackets around the whole.
  if (!text.starts_with('(') || !text.ends_with(')')) return std::nullopt;
  text = text.substr(1, text.size() - 2);
  return parse_quotient(text.substr(0, text.rfind('/')), text.substr(std::min(text.size(), text.rfind('/') + 1)));
}

std::optional<FrfKind> parse_frf_kind(std::string_view word) {
  const std::string lower = lower_case(trimmed(word));
  if (lower == "accelerance" || lower == "inertance") return FrfKind::accelerance;
  if (lower == "mobility") return FrfKind::mobility;
  if (lower == "receptance" || lower == "compliance") return FrfKind::receptance;
  return std::nullopt;
}

}  // namespace percuss::acquire
