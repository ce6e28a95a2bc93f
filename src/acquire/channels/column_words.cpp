#include "acquire/channels/column_words.hpp"

#include <algorithm>

#include "core/io/csv_header.hpp"

namespace percuss::acquire {

bool is_one_of(const std::string& name, Words words) {
  return std::find(words.begin(), words.end(), name) != words.end();
}

bool has_one_of(const std::string& name, Words words) {
  return std::any_of(words.begin(), words.end(), [&](auto word) { return name.find(word) != std::string::npos; });
}

std::optional<Quantity> quantity_named(std::string_view name) {
  const std::string lower = lower_case(name);
  if (has_one_of(lower, kAccelWords)) return Quantity::acceleration;
  return has_one_of(lower, kForceWords) ? std::optional(Quantity::force) : std::nullopt;
}

bool is_other_spectrum(const std::string& name) {
  constexpr std::array<std::string_view, 7> kWords{"spec", "psd", "csd", "coh", "auto", "cross", "corr"};
  return has_one_of(name, kWords);
}

}  // namespace percuss::acquire
