#include "core/io/stated_rate.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/io/csv_text.hpp"
#include "core/io/parse_number.hpp"

namespace percuss {
inline namespace core {
namespace {

// Letters and digits only, lower case: "Sampling Rate(Hz)" → "samplingratehz".
std::string key_of(std::string_view text) {
  std::string key;
  for (const char c : lower_case(text)) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) key += c;
  }
  return key;
}

struct Key {
  std::string_view start;  // of the key
  bool interval;
};

constexpr std::array kKeys = {
    Key{"samplingrate", false},   Key{"samplerate", false},       Key{"samplingfreq", false},
    Key{"samplefreq", false},     Key{"samplespersecond", false}, Key{"abtastrate", false},
    Key{"abtastfrequenz", false}, Key{"scanrate", false},         Key{"samplinginterval", true},
    Key{"sampleinterval", true},  Key{"samplingperiod", true},    Key{"timestep", true},
    Key{"timeinterval", true},    Key{"abtastintervall", true},   Key{"deltat", true},
};

std::optional<bool> is_interval_key(std::string_view text) {
  const std::string key = key_of(text);
  for (const auto& known : kKeys) {
    if (key.substr(0, known.start.size()) == known.start) return known.interval;
  }
  // Short names count only alone or with their unit.
  if (key == "fs" || key == "fshz" || key == "fskhz" || key == "ratehz") return false;
  if (key == "dt" || key == "dts" || key == "dtms" || key == "dtus") return true;
  return std::nullopt;
}

// The factor to Hz or s from the unit in `text`, a key or the text after the number; nothing without a unit.
std::optional<double> unit_factor(std::string_view text, bool interval) {
  const std::string key = key_of(text);
  const auto ends = [&](std::string_view ending) { return key.size() >= ending.size() && key.ends_with(ending); };
  if (interval) {
    if (ends("ms") || ends("msec")) return 1e-3;
    if (ends("us") || ends("usec")) return 1e-6;
    return key == "s" || key == "sec" ? std::optional(1.0) : std::nullopt;
  }
  if (ends("mhz")) return 1e6;
  if (ends("khz") || ends("kss")) return 1e3;
  return ends("hz") ? std::optional(1.0) : std::nullopt;
}

// "50", "50 Hz" and "25.6kHz": the number and the text after it.
std::optional<std::pair<double, std::string_view>> leading_number(std::string_view text, bool decimal_comma) {
  text = trimmed(text);
  std::size_t end = 0;
  while (end < text.size() && std::string_view("0123456789+-.,eE").find(text[end]) != std::string_view::npos) ++end;
  const auto number = parse_number(text.substr(0, end), decimal_comma);
  if (number.problem != NumberProblem::none) return std::nullopt;
  return std::pair{number.value, text.substr(end)};
}

}  // namespace

std::optional<double> stated_rate_Hz(std::string_view line, const CsvDialect& dialect) {
  std::string_view key = line;
  std::vector<std::string_view> values;
  if (const auto mark = line.find_first_of("=:"); mark != std::string_view::npos) {
    key = line.substr(0, mark);
    values = split_cells(line.substr(mark + 1), dialect);
  } else if (dialect.delimiter == ' ') {
    key = line.substr(0, line.find_first_of("0123456789"));
    values = split_cells(line.substr(key.size()), dialect);
  } else if (values = split_cells(line, dialect); !values.empty()) {
    key = values.front();
    values.erase(values.begin());
  }
  const auto interval = is_interval_key(trimmed(key));
  if (!interval) return std::nullopt;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto number = leading_number(values[i], dialect.decimal_comma);
    if (!number || !(number->first > 0)) continue;
    std::optional<double> factor = unit_factor(number->second, *interval);
    if (!factor && i + 1 < values.size()) factor = unit_factor(values[i + 1], *interval);
    if (!factor) factor = unit_factor(key, *interval);
    const double value = number->first * factor.value_or(1);
    return *interval ? 1 / value : value;
  }
  return std::nullopt;
}

}  // namespace core
}  // namespace percuss
