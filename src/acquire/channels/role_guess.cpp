#include "acquire/channels/role_guess.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "acquire/channels/axis_unit.hpp"
#include "acquire/channels/column_words.hpp"
#include "acquire/channels/csv_columns.hpp"
#include "core/error.hpp"
#include "core/math/statistics.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

// A file of many signals gets fewer samples per signal (kMaxInAll in all, at least kMinSamples each), so that a guess
// takes less than a second.
constexpr std::size_t kMinSamples = std::size_t{1} << 14U, kMaxInAll = std::size_t{1} << 21U;

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

// The name if it is unique and needs no quotes in a shell, else the number.
std::string option_value(const CsvColumn& signal, const std::vector<CsvColumn>& all) {
  const auto same = [&](const CsvColumn& other) { return lower_case(other.name) == lower_case(signal.name); };
  const bool unique = std::count_if(all.begin(), all.end(), same) == 1;
  if (unique && is_plain_name(signal.name) && !is_number(signal.name)) return signal.name;
  return std::to_string(signal.index + 1);
}

// The median; of some evenly spaced samples where there are many, which is as good for the rest position.
double rest_of(std::span<const double> samples) {
  const std::size_t step = (samples.size() - 1) / kGuessedSamples + 1;
  std::vector<double> some;
  some.reserve(samples.size() / step + 1);
  for (std::size_t i = 0; i < samples.size(); i += step) some.push_back(samples[i]);
  return median(std::move(some));
}

// (1) of samples around `rest`
double active_share_around(std::span<const double> samples, double rest) {
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

// Whether a column is a helper or the user excludes it.
bool is_no_signal(const CsvColumn& column, const CsvColumns& known, const ReadOptions& options) {
  const std::string base = lower_case(column.base);
  const ChannelSetup* const setup = setup_of(column, options);
  return is_helper(column, known) || is_one_of(base, kTimeWords) || is_one_of(base, kCountWords) ||
         (setup != nullptr && setup->role == "ignore");
}

// Whether a signal measures another quantity than a force or a response, such as a velocity or an angle.
bool measures_another_quantity(const CsvColumn& signal) {
  const auto unit = parse_unit(signal.unit);
  return unit && unit->quantity != Quantity::force && unit->quantity != Quantity::voltage &&
         !is_response(unit->quantity);
}

// Whether a signal is in volts and its set-up states neither its sensitivity nor another unit.
bool is_plain_voltage(const CsvColumn& signal, const ReadOptions& options) {
  const ChannelSetup* const setup = setup_of(signal, options);
  const auto unit = parse_unit(signal.unit);
  return unit && unit->quantity == Quantity::voltage &&
         !(setup != nullptr && (setup->sensitivity_V_per_SI || setup->unit));
}

// Whether nothing states the sensitivity, scale or unit of an acceleration in volts.
bool needs_sensitivity(const CsvColumn& signal, const ReadOptions& options) {
  const bool stated =
      !options.accel_scale.empty() || !options.accel_sensitivity_V_per_mps2.empty() || !options.accel_unit.empty();
  return !stated && is_plain_voltage(signal, options);
}

// Whether nothing states the sensitivity, scale or unit of a force in volts.
bool force_needs_sensitivity(const CsvColumn& force, const ReadOptions& options) {
  const bool stated = !options.force_scale.empty() || options.force_sensitivity_V_per_N || !options.force_unit.empty();
  return !stated && is_plain_voltage(force, options);
}

// The sampling rate that evenly rising numbers state if they are times in s; 0 if that is not plausible.
double rate_of_times_Hz(std::span<const double> times) {
  const double rate_Hz = static_cast<double>(times.size() - 1) / (times.back() - times.front());
  return rate_Hz < kMinTestRate_Hz ? 0 : rate_Hz;
}

// Whether the user or the unit says that the signal is a response.
bool is_stated_response(const CsvColumn& signal, const ReadOptions& options) {
  const ChannelSetup* const setup = setup_of(signal, options);
  const auto names = [&](const std::string& typed) { return is_called(signal, typed); };
  const auto unit = parse_unit(signal.unit);
  return (unit && is_response(unit->quantity)) || (setup != nullptr && setup->role == "acceleration") ||
         std::any_of(options.accel_channels.begin(), options.accel_channels.end(), names);
}

// Whether a signal that is not read may be a force by its unit.
bool may_be_force(const CsvColumn& signal) {
  const auto unit = parse_unit(signal.unit);
  return !unit || unit->quantity == Quantity::force || unit->quantity == Quantity::voltage;
}

bool states_force(const CsvColumn& signal) {
  const auto unit = parse_unit(signal.unit);
  return unit && unit->quantity == Quantity::force;
}

// Several signals with a unit of force are hits side by side, each force followed by its responses. Keeps only the
// first force and the responses up to the next force. If the first two forces are neighbours, keeps all responses after
// them.
void keep_first_hit(std::vector<const CsvColumn*>& signals, const CsvColumn*& force) {
  const auto is_force = [](const CsvColumn* signal) { return states_force(*signal); };
  const auto first = std::find_if(signals.begin(), signals.end(), is_force);
  if (first == signals.end() || std::count_if(first, signals.end(), is_force) < 2) return;
  force = *first;
  const auto next = std::find_if(first + 1, signals.end(), is_force);
  const bool side_by_side = next != first + 1;
  std::vector<const CsvColumn*> kept;
  std::copy_if(first, side_by_side ? next : signals.end(), std::back_inserter(kept),
               [&](const CsvColumn* signal) { return signal == force || !states_force(*signal); });
  signals = std::move(kept);
}

}  // namespace

double active_share(std::span<const double> samples) {
  if (samples.empty() || !are_finite(samples)) return 1;
  return active_share_around(samples, rest_of(samples));
}

double hammer_dissimilarity(std::span<const double> samples) {
  constexpr double kMinSideRatio = 0.05;
  if (samples.empty() || !are_finite(samples)) return 1;
  const double rest = rest_of(samples);
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  const double above = *high - rest, below = rest - *low;
  const double larger = std::max(above, below);
  const double ratio = larger > 0 ? std::min(above, below) / larger : 1;
  return active_share_around(samples, rest) * std::max(kMinSideRatio, ratio);  // (2)
}

bool rises_evenly(std::span<const double> samples) {
  constexpr double kMaxDeviation = 0.5;  // of a step
  if (samples.size() < kMinRisingSamples) return false;
  const double step = (samples.back() - samples.front()) / static_cast<double>(samples.size() - 1);
  if (!(step > 0) || !std::isfinite(step)) return false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double expected = samples.front() + static_cast<double>(i) * step;
    // Rounded stamps deviate by up to half a step in the coarsest usable column.
    if (!(std::abs(samples[i] - expected) <= kMaxDeviation * step)) return false;
  }
  return true;
}

std::optional<Message> unread_hammer_note(
    const std::vector<CsvColumn>& signals, const CsvColumns& known,
    const std::function<std::vector<double>(std::size_t index, std::size_t max_samples)>& read) {
  if (known.has_force) return std::nullopt;
  for (const CsvColumn& signal : signals) {
    const bool is_read = std::any_of(known.accel.begin(), known.accel.end(),
                                     [&](const CsvColumn& column) { return column.index == signal.index; });
    if (is_read || !signal.has_numbers || is_no_signal(signal, known, {})) continue;
    const bool named = quantity_named(signal.base) == Quantity::force;
    try {
      const bool pulses =
          may_be_force(signal) && hammer_dissimilarity(read(signal.index, kGuessedSamples)) < kMaxHammerDissimilarity;
      if (!named && !pulses) continue;
    } catch (const InputError&) {
      if (!named) continue;
    }
    return Message(one_line(signal.name, 40) + " looks like the hammer's force and is not read: name it as the force",
                   {"force_channel"});
  }
  return std::nullopt;
}

RoleGuess guess_roles(const std::vector<CsvColumn>& signals, const CsvColumns& known, const ReadOptions& options,
                      const std::function<std::vector<double>(std::size_t index, std::size_t max_samples)>& read,
                      const std::function<std::string(const CsvColumn&)>& name_of) {
  const auto value = [&](const CsvColumn& signal) { return name_of ? name_of(signal) : option_value(signal, signals); };
  RoleGuess guess{.force = {}, .accel = {}, .rate_known = known.time.has_value()};
  std::vector<const CsvColumn*> found;
  const CsvColumn* force = nullptr;
  std::size_t candidates = 0;  // for the force
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  const std::size_t max_samples =
      std::clamp(kMaxInAll / std::max<std::size_t>(signals.size(), 1), kMinSamples, kGuessedSamples);
  for (const CsvColumn& signal : signals) {
    if (!signal.has_numbers || found.size() == kMaxGuessedSignals) continue;
    if (known.has_force && signal.index == known.force.index) continue;
    if (is_one_of(lower_case(signal.base), kTimeWords)) guess.rate_known = true;
    if (is_no_signal(signal, known, options) || measures_another_quantity(signal)) continue;
    try {
      const std::vector<double> samples = read(signal.index, max_samples);
      if (rises_evenly(samples)) {
        if (signal.index == 0)
          guess.rate_known = true;
        else
          guess.assumed_rate_Hz = rate_of_times_Hz(samples);
        continue;
      }
      if (!is_stated_response(signal, options)) {
        const double measure = hammer_dissimilarity(samples);
        largest = std::max(largest, measure);
        ++candidates;
        if (measure < smallest) {
          smallest = measure;
          force = &signal;
        }
      }
      found.push_back(&signal);
    } catch (const InputError&) {
      continue;
    }
  }
  if (known.has_force) force = &known.force;
  if (!known.has_force) keep_first_hit(found, force);
  // One signal, or signals that are all alike, as two channels of a microphone: none of them is the force.
  const bool alike = candidates > 1 && largest < kMaxDissimilarityRatio * smallest && !(force && states_force(*force));
  if (!known.has_force && (found.size() < 2 || alike)) force = nullptr;
  if (force != nullptr) {
    guess.force = value(*force);
    guess.force_in_volts = force_needs_sensitivity(*force, options);
  }
  for (const CsvColumn* signal : found) {
    if (signal == force) continue;
    guess.accel.push_back(value(*signal));
    guess.in_volts = guess.in_volts || needs_sensitivity(*signal, options);
  }
  if (!options.accel_channels.empty()) guess.accel = options.accel_channels;
  return guess;
}

}  // namespace percuss::acquire
