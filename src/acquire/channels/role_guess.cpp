#include "acquire/channels/role_guess.hpp"

#include <algorithm>
#include <cmath>

#include "acquire/channels/column_words.hpp"
#include "core/error.hpp"
#include "core/math/statistics.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

// Enough for a hit. Fewer samples of many signals, so that a guess takes less than a second.
constexpr std::size_t kMaxSamples = std::size_t{1} << 18U, kMinSamples = std::size_t{1} << 14U;
constexpr std::size_t kMaxInAll = std::size_t{1} << 21U;
constexpr std::size_t kMaxSignals = 64;  // more than a command line should list

bool is_plain_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
  });
}

// The median of numbers that are not comparable is undefined.
bool are_finite(std::span<const double> samples) {
  return std::all_of(samples.begin(), samples.end(), [](double x) { return std::isfinite(x); });
}

bool is_number(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// The name where a shell takes it as it is and it is the only one, else the number.
std::string option_value(const CsvColumn& signal, const std::vector<CsvColumn>& all) {
  const auto same = [&](const CsvColumn& other) { return lower_case(other.name) == lower_case(signal.name); };
  const bool unique = std::count_if(all.begin(), all.end(), same) == 1;
  if (unique && is_plain_name(signal.name) && !is_number(signal.name)) return signal.name;
  return std::to_string(signal.index + 1);
}

bool measures_response(const CsvColumn& signal) {
  const auto unit = parse_unit(signal.unit);
  return unit && (unit->quantity == Quantity::acceleration || unit->quantity == Quantity::pressure);
}

}  // namespace

double active_share(std::span<const double> samples) {
  if (samples.empty() || !are_finite(samples)) return 1;
  const double rest = median(std::vector<double>(samples.begin(), samples.end()));
  double largest = 0;
  for (const double x : samples) largest = std::max(largest, std::abs(x - rest));
  if (!(largest > 0) || !std::isfinite(largest)) return 1;
  double squares = 0, fourths = 0;
  for (const double x : samples) {
    const double square = std::pow((x - rest) / largest, 2);
    squares += square;
    fourths += square * square;
  }
  return squares * squares / (static_cast<double>(samples.size()) * fourths);  // (1)
}

double hammer_measure(std::span<const double> samples) {
  constexpr double kLeastRatio = 0.05;
  if (samples.empty() || !are_finite(samples)) return 1;
  const double rest = median(std::vector<double>(samples.begin(), samples.end()));
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  const double above = *high - rest, below = rest - *low;
  const double larger = std::max(above, below);
  const double ratio = larger > 0 ? std::min(above, below) / larger : 1;
  return active_share(samples) * std::max(kLeastRatio, ratio);  // (2)
}

bool rises_evenly(std::span<const double> samples) {
  constexpr double kMostDeviation = 0.5;  // of a step
  constexpr std::size_t kFewest = 8;
  if (samples.size() < kFewest) return false;
  const double step = (samples.back() - samples.front()) / static_cast<double>(samples.size() - 1);
  if (!(step > 0) || !std::isfinite(step)) return false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double expected = samples.front() + static_cast<double>(i) * step;
    // Rounded stamps deviate by up to half a step in the coarsest usable column.
    if (!(std::abs(samples[i] - expected) <= kMostDeviation * step)) return false;
  }
  return true;
}

RoleGuess guess_roles(const std::vector<CsvColumn>& signals,
                      const std::function<std::vector<double>(std::size_t index, std::size_t most)>& read,
                      const std::function<std::string(const CsvColumn&)>& name_of) {
  RoleGuess guess{.force = {}, .accel = {}, .rate_known = false};
  std::vector<const CsvColumn*> found;
  constexpr double kNone = 2;  // above every measure
  std::size_t force = 0;
  double least = kNone;
  const std::size_t most = std::clamp(kMaxInAll / std::max<std::size_t>(signals.size(), 1), kMinSamples, kMaxSamples);
  for (const CsvColumn& signal : signals) {
    const std::string base = lower_case(signal.base);
    if (!signal.has_numbers || found.size() == kMaxSignals) continue;
    if (is_one_of(base, kTimeWords)) guess.rate_known = true;
    if (is_one_of(base, kTimeWords) || is_one_of(base, kCountWords) || base == "hit" || base == "run") continue;
    try {
      const std::vector<double> samples = read(signal.index, most);
      if (signal.index == 0 && rises_evenly(samples)) {
        guess.rate_known = true;
        continue;
      }
      const double share = hammer_measure(samples);
      if (share < least && !measures_response(signal)) {
        least = share;
        force = found.size();
      }
      found.push_back(&signal);
    } catch (const InputError&) {
      continue;
    }
  }
  const bool with_force = found.size() > 1 && least < kNone;
  const auto value = [&](const CsvColumn& signal) { return name_of ? name_of(signal) : option_value(signal, signals); };
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i != force || !with_force) guess.accel.push_back(value(*found[i]));
  }
  if (with_force) guess.force = value(*found[force]);
  return guess;
}

}  // namespace percuss::acquire
