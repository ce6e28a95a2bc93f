#include "acquire/formats/text/frf_text_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "acquire/channels/axis_unit.hpp"
#include "acquire/channels/column_words.hpp"
#include "acquire/record/point_number.hpp"
#include "core/io/parse_number.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

enum class FrfPart { none, real, imaginary, magnitude, phase, std, coherence };

std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words(1);
  for (const char c : lower_case(name)) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (letter) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  return words;
}

FrfPart part_of(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "re" || word.starts_with("real")) return FrfPart::real;
    if (word == "im" || word.starts_with("imag")) return FrfPart::imaginary;
    if (word.starts_with("mag") || word == "abs") return FrfPart::magnitude;
    if (word.starts_with("phase") || word == "arg") return FrfPart::phase;
    if (word.starts_with("coh")) return FrfPart::coherence;
    if (word == "std") return FrfPart::std;
  }
  return FrfPart::none;
}

// The part of an FRF in each column, [columns]. A column of numbers before a phase is its magnitude, whatever its name
// ("Hz, H1, phase"), unless it names another spectrum.
std::vector<FrfPart> parts_of(const CsvHeader& header) {
  std::vector<FrfPart> parts;
  for (const CsvColumn& column : header.columns) {
    const FrfPart part = column.index == 0 || !column.has_numbers ? FrfPart::none : part_of(words_of(column.name));
    const bool after_none = part == FrfPart::phase && parts.size() > 1 && parts.back() == FrfPart::none;
    if (after_none && header.columns[parts.size() - 1].has_numbers &&
        !is_other_spectrum(lower_case(header.columns[parts.size() - 1].name)))
      parts.back() = FrfPart::magnitude;
    parts.push_back(part);
  }
  return parts;
}

// "p12" → 12
template <class Number>
std::optional<Number> numbered(const std::vector<std::string>& words, char letter) {
  for (const std::string& word : words) {
    Number number = 0;
    const char* const end = word.data() + word.size();
    if (word.size() < 2 || word[0] != letter) continue;
    const auto [stop, error] = std::from_chars(word.data() + 1, end, number);
    if (error == std::errc{} && stop == end) return number;
  }
  return std::nullopt;
}

[[noreturn]] void refuse_unpaired(const std::string& file, const std::string& column) {
  throw InputError("column " + column + " has no partner", file,
                   "save frequency, real and imaginary part (or magnitude and phase) of each FRF, in this order");
}

void begin_frf(std::vector<FrfColumns>& out, const CsvColumn& column, bool polar) {
  const std::vector<std::string> words = words_of(column.name);
  out.push_back({.first = column.index, .polar = polar});
  const bool named_dB = std::find(words.begin(), words.end(), "db") != words.end();
  out.back().in_dB = polar && (named_dB || lower_case(column.unit).starts_with("db"));
  out.back().point = numbered<int>(words, 'p');
  out.back().channel = numbered<std::size_t>(words, 'c');
}

// Pairs the columns by their names; empty when no name is a part of an FRF.
std::vector<FrfColumns> find_columns(const CsvHeader& header, const std::string& file) {
  std::vector<FrfColumns> out;
  const std::vector<FrfPart> parts = parts_of(header);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const CsvColumn& column = header.columns[i];
    const FrfPart part = parts[i];
    const bool open = !out.empty() && !out.back().paired;
    if (part == FrfPart::real || part == FrfPart::magnitude) {
      if (open) refuse_unpaired(file, column.name);
      begin_frf(out, column, part == FrfPart::magnitude);
    } else if (part == FrfPart::imaginary || part == FrfPart::phase) {
      if (!open || out.back().polar != (part == FrfPart::phase)) refuse_unpaired(file, column.name);
      out.back().second = column.index;
      out.back().paired = true;
      const auto unit = parse_unit(column.unit);
      if (unit && unit->quantity == Quantity::angle) out.back().phase_to_rad = unit->to_SI;
    } else if (part == FrfPart::std && !out.empty()) {
      out.back().std = column.index;
    } else if (part == FrfPart::coherence && !out.empty()) {
      out.back().coherence = column.index;
    }
  }
  if (!out.empty() && !out.back().paired) refuse_unpaired(file, header.columns.back().name);
  return out;
}

// "freq…" in a first column, or a shorter name beside the parts of an FRF.
bool names_frequencies(const CsvHeader& header) {
  const std::string name = lower_case(header.columns.front().base);
  return lower_case(header.columns.front().name).starts_with("freq") ||
         ((name == "f" || name == "hz") && names_frfs(header));
}

// Columns without names: frequency, real, imaginary, real, imaginary, …
std::vector<FrfColumns> unnamed_columns(const CsvHeader& header, const std::string& file) {
  std::vector<FrfColumns> out;
  for (const CsvColumn& column : header.columns) {
    if (part_of(words_of(column.name)) == FrfPart::phase) refuse_unpaired(file, column.name);
  }
  for (std::size_t i = 1; i + 1 < header.columns.size(); i += 2)
    out.push_back({.first = header.columns[i].index, .second = header.columns[i + 1].index, .paired = true});
  return out;
}

// Numbers points and channels. Unless all names state both numbers, each FRF is a point.
void assign_points_and_channels(std::vector<FrfColumns>& columns, std::vector<Message>& notes,
                                const std::string& file) {
  const bool named =
      std::all_of(columns.begin(), columns.end(), [](const FrfColumns& c) { return c.point && c.channel; });
  if (!named && columns.size() > 1) {
    notes.push_back(
        information(fmt::format("the {} FRFs of the file are taken as points of one channel", columns.size())));
  }
  for (std::size_t i = 0; !named && i < columns.size(); ++i) {
    columns[i].point = static_cast<int>(i);
    columns[i].channel = 0;
  }
  std::size_t channels = 0, points = 0;
  std::vector<std::pair<int, std::size_t>> seen;
  for (const FrfColumns& c : columns) {
    channels = std::max(channels, std::min(*c.channel, columns.size()) + 1);  // a name may state any number
    require_point_number(*c.point, file);
    seen.emplace_back(*c.point, *c.channel);
  }
  std::sort(seen.begin(), seen.end());
  const bool doubled = std::adjacent_find(seen.begin(), seen.end()) != seen.end();
  for (std::size_t i = 0; i < seen.size(); ++i) points += i == 0 || seen[i].first != seen[i - 1].first ? 1U : 0U;
  if (doubled || points * channels != columns.size()) {
    throw InputError("not one FRF of every channel for every point", file,
                     "name the columns p0_c0_re, p0_c0_im, … for point 0 and channel 0");
  }
}

}  // namespace

bool names_frfs(const CsvHeader& header) {
  if (!header.named) return false;
  FrfPart previous = FrfPart::none;
  for (const FrfPart part : parts_of(header)) {
    const bool pair = (previous == FrfPart::real && part == FrfPart::imaginary) ||
                      (previous == FrfPart::magnitude && part == FrfPart::phase);
    if (pair) return true;
    previous = part;
  }
  return false;
}

std::vector<FrfColumns> frf_columns(const CsvHeader& header, const std::string& file, bool forced,
                                    std::vector<Message>& notes) {
  const bool named = names_frequencies(header) || (forced && names_frfs(header));
  std::vector<FrfColumns> columns = named ? find_columns(header, file) : std::vector<FrfColumns>{};
  if (columns.empty() && forced) columns = unnamed_columns(header, file);
  if (!columns.empty()) assign_points_and_channels(columns, notes, file);
  return columns;
}

}  // namespace percuss::acquire
