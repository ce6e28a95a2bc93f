#include "acquire/formats/text/read_frf_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "acquire/channels/axis_unit.hpp"
#include "acquire/formats/text/csv_layout.hpp"
#include "acquire/formats/text/csv_table.hpp"
#include "acquire/formats/text/frf_text_columns.hpp"
#include "acquire/record/channel_name.hpp"
#include "core/error.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

// The estimator in percuss's own statement, "Hv, exp(+jwt)": elsewhere, H1 may be the name of an FRF.
std::string stated_estimator(const std::string& previous, const std::string& word) {
  if (word != "exp(+jwt)") return "";
  return previous == "h1" ? "H1" : previous == "h2" ? "H2" : previous == "hv" ? "Hv" : "";
}

bool closes_more_than_it_opens(const std::string& word, char open, char close) {
  return word.ends_with(close) &&
         std::count(word.begin(), word.end(), close) > std::count(word.begin(), word.end(), open);
}

// Removes "dB" and unmatched closing brackets: "g/N)", the last word of "(dB re 1 g/N)", and "(dBg/N)" give "g/N";
// "(m/s)/N)" gives "(m/s)/N".
std::string without_dB(std::string word) {
  if (closes_more_than_it_opens(word, '(', ')')) word.pop_back();
  if (closes_more_than_it_opens(word, '[', ']')) word.pop_back();
  const std::size_t at = lower_case(word).find("db");
  if (at > 1) return word;
  if (at == 1 && word.size() > 3) word.pop_back();  // the closing bracket
  return word.substr(at + 2);
}

// The stated averages of each FRF: one number for all, or one for each. Other counts of numbers state nothing.
void set_averages(const std::vector<double>& averages, StoredFrfs& out) {
  if (averages.size() != 1 && averages.size() != out.frfs.size()) return;
  for (std::size_t i = 0; i < out.frfs.size(); ++i)
    out.frfs[i].averages = static_cast<std::size_t>(averages[averages.size() == 1 ? 0 : i]);
}

// Reads unit, kind, estimator, window and the sensors' angles from the cells before the data. Returns the numbers of
// averages.
std::vector<double> read_statements(std::string_view header, StoredFrfs& out) {
  std::string previous;
  bool by_percuss = false;
  std::vector<double> averages;
  std::vector<double> angle_deg;
  while (!header.empty()) {
    const auto end = std::min(header.find_first_of("\t\r\n,;# "), header.size());
    const std::string word = without_dB(to_utf8(trimmed(header.substr(0, end))));
    header.remove_prefix(std::min(end + 1, header.size()));
    if (word.empty()) continue;
    if (!out.unit) out.unit = parse_frf_unit(word);
    if (!out.kind) out.kind = parse_frf_kind(word);
    if (out.record.estimator.empty()) out.record.estimator = stated_estimator(previous, word);
    const ParsedNumber number = parse_number(word, false);
    const bool is_number = number.problem == NumberProblem::none;
    if (is_number && previous == "decay_per_s" && number.value >= 0) out.record.decay_per_s = number.value;
    by_percuss = by_percuss || word == "exp(+jwt)";
    if (is_number && by_percuss && previous == "averages") {
      averages.push_back(number.value >= 0 && number.value <= kMaxAverages ? number.value : 0);
    } else if (is_number && previous == "angle_deg") {
      angle_deg.push_back(number.value);
    } else {
      previous = lower_case(word);
    }
  }
  for (std::size_t c = 0; c < std::min(angle_deg.size(), out.record.accel.size()); ++c)
    out.record.accel[c].angle_rad = angle_deg[c] * kDegree_rad;
  return averages;
}

std::vector<double> read_column(const CsvTable& table, std::size_t index) {
  std::vector<double> numbers(table.lines());
  table.read(index, 0, numbers);
  return numbers;
}

// A column of numbers; empty when the column is absent or has only empty cells.
std::vector<double> read_optional(const CsvTable& table, std::optional<std::size_t> index) {
  if (!index) return {};
  bool any = false;
  table.for_each_cell(*index, [&](std::size_t, std::string_view cell) { any = any || !trimmed(cell).empty(); });
  return any ? read_column(table, *index) : std::vector<double>{};
}

// At a resonance, the phase changes by 180° or π.
bool look_like_radians(const std::vector<double>& phase) {
  constexpr double kRounded = 1e-3;
  const auto [least, most] = std::minmax_element(phase.begin(), phase.end());
  return least != phase.end() && std::max(-*least, *most) <= std::numbers::pi * (1 + kRounded) &&
         *most - *least > std::numbers::pi / 2;
}

// True for a level in dB with a phase in degrees. From line to line, a level in neper and a phase in radians change
// alike, as real and imaginary part do; in dB and degrees, the squared changes of the phase are 43 times as large.
bool look_like_level_and_phase(const std::vector<double>& first, const std::vector<double>& second) {
  constexpr double kHalfTurn_deg = 180.001, kMinPhase_deg = 80, kClearlyMore = 10;
  double largest = 0, of_first = 0, of_second = 0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    largest = std::max(largest, std::abs(second[k]));
    if (k == 0) continue;
    of_first += std::pow(first[k] - first[k - 1], 2);
    of_second += std::pow(std::remainder(second[k] - second[k - 1], 360), 2);
  }
  return largest > kMinPhase_deg && largest <= kHalfTurn_deg && of_second > kClearlyMore * of_first;
}

// Columns without names count as real and imaginary parts. A real part that is never negative may be a magnitude.
void refuse_possible_polar(const CsvTable& table, const std::vector<double>& first, const std::vector<double>& second,
                           const FrfColumns& columns) {
  if (table.header().named) return;
  const bool positive = std::none_of(first.begin(), first.end(), [](double x) { return x < 0; });
  if (!positive && !look_like_level_and_phase(first, second)) return;
  const std::size_t at = columns.first + 1;
  throw InputError(
      positive ? fmt::format("column {} has no name and is never negative: it may be a real part or a magnitude", at)
               : fmt::format("columns {} and {} have no names and may be a level in dB and a phase in degrees", at,
                             columns.second + 1),
      input_name(table.path()), "add a first line with names, such as Hz,re,im or Hz,magnitude,phase or Hz,dB,phase");
}

std::vector<Complex> read_value(const CsvTable& table, const FrfColumns& columns, std::vector<Message>& notes) {
  const auto first = read_column(table, columns.first);
  const auto second = read_column(table, columns.second);
  std::vector<Complex> value(first.size());
  if (!columns.polar) refuse_possible_polar(table, first, second, columns);
  double to_rad = columns.phase_to_rad.value_or(kDegree_rad);
  if (columns.polar && !columns.phase_to_rad) {
    const bool radians = look_like_radians(second);
    if (radians) to_rad = 1;
    const Message note = radians ? "the unit of the phase is not stated; no value is beyond ±π: taken as radians"
                                 : "the unit of the phase is not stated: taken as degrees";
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }
  for (std::size_t k = 0; k < value.size(); ++k) {
    if (!columns.polar) {
      value[k] = {first[k], second[k]};
    } else {
      value[k] = std::polar(1.0, second[k] * to_rad) * (columns.in_dB ? std::pow(10.0, first[k] / 20) : first[k]);
    }
  }
  return value;
}

}  // namespace

std::optional<StoredFrfs> read_frf_text(const FileBytes& bytes, bool forced) {
  const std::string file = input_name(bytes.path);
  CsvLayout layout = layout_of_text(bytes, CsvContent::frf);
  if (layout.header.columns.front().index != 0) return std::nullopt;
  StoredFrfs out;
  const std::vector<FrfColumns> columns = frf_columns(layout.header, file, forced, out.record.notes);
  if (columns.empty()) return std::nullopt;
  out.record.files.push_back({.path = bytes.path, .bytes = bytes.size});
  out.record.format = "FRF text";
  std::size_t channels = 0;
  for (const FrfColumns& c : columns) channels = std::max(channels, *c.channel + 1);
  for (std::size_t c = 0; c < channels; ++c) out.record.accel.push_back({.name = channel_name(c)});
  const std::vector<double> averages = read_statements(bytes.view().substr(0, layout.header.data_start), out);
  const double to_Hz = require_Hz_per_unit(layout.header.columns.front().unit, file + ": header");
  const CsvTable table(bytes, std::move(layout));
  out.set_lines(frequency_lines(read_column(table, 0), to_Hz, file));
  for (const FrfColumns& c : columns) {
    out.frfs.push_back({.point = *c.point,
                        .channel = *c.channel,
                        .value = read_value(table, c, out.record.notes),
                        .std = read_optional(table, c.std),
                        .coherence = read_optional(table, c.coherence)});
  }
  set_averages(averages, out);
  return out;
}

}  // namespace percuss::acquire
