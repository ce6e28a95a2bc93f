#include "commands/model/measured_ccor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "cli/option_error.hpp"
#include "commands/model/colon_numbers.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/number_table.hpp"

namespace percuss::tools {
namespace {

constexpr const char* kCcorForm =
    "give SPEED:COR:STD with the speed in m/s or with its unit, such as 26.8:0.519:0.004,80mph:0.507:0.004, or a file";
constexpr std::uint64_t kMaxFile_bytes = std::uint64_t{1} << 20U;
constexpr std::size_t kMaxPoints = 10'000;

model::MeasuredCor checked(const std::vector<double>& values, const std::string& place) {
  const model::MeasuredCor m{.speed_mps = values[0], .cor = values[1], .cor_std = values[2]};
  if (!(m.speed_mps > 0 && m.cor > 0 && m.cor <= 1 && m.cor_std > 0))
    throw InputError("not a speed, a COR up to 1 and a standard deviation above 0", place, kCcorForm);
  return m;
}

// The numbers of "26.8:0.519:0.004" or "60mph:0.519:0.004", the speed in m/s; none for another text.
std::optional<std::vector<double>> triple_of(std::string_view text) {
  auto values = numbers_between_colons(text, "M/S");
  if (values && values->size() != 3) values.reset();
  return values;
}

bool names_a_file(const std::string& word) {
  if (word.find(':') == std::string::npos) return true;
  std::error_code ignored;
  return !triple_of(word) && std::filesystem::exists(word, ignored);
}

// Triples as on the command line, separated by commas, blanks and line ends. Skips lines that begin with #, and a first
// line without digits (column names).
std::vector<model::MeasuredCor> triples_in(std::string_view text, const std::string& where) {
  std::vector<model::MeasuredCor> out;
  bool first = true;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos || line[begin] == '#') continue;
    const bool names = first && line.find_first_of("0123456789") == std::string_view::npos;
    first = false;
    if (names) continue;
    const std::string place = fmt::format("{}: line {}", where, number);
    for (std::size_t from = begin; from < line.size();) {
      const std::size_t to = std::min(line.find_first_of(", \t\r", from), line.size());
      const std::string_view word = line.substr(from, to - from);
      from = to + 1;
      if (word.empty()) continue;
      const auto values = triple_of(word);
      if (!values) throw InputError("'" + one_line(word, 40) + "' is not SPEED:COR:STD", place, kCcorForm);
      if (out.size() == kMaxPoints) throw InputError("more than 10000 points", place, "give fewer");
      out.push_back(checked(*values, place));
    }
  }
  if (out.empty()) throw InputError("no points", where, kCcorForm);
  return out;
}

std::vector<model::MeasuredCor> points_in_file(const std::string& path) {
  const FileBytes bytes = read_input(path, kMaxFile_bytes);
  if (bytes.view().find(':') != std::string_view::npos) return triples_in(bytes.view(), input_name(path));
  std::vector<model::MeasuredCor> out;
  for (const NumberTableRow& row :
       parse_number_table(bytes.view(), input_name(path),
                          {.columns = 3, .remedy = "write speed in m/s, COR and standard deviation in each line"}))
    out.push_back(checked(row.values, row.place));
  return out;
}

}  // namespace

std::vector<model::MeasuredCor> measured_ccor(const std::vector<std::string>& words) {
  if (words.size() == 1 && names_a_file(words[0])) return points_in_file(words[0]);
  std::vector<model::MeasuredCor> out;
  for (const std::string& word : words) {
    const auto values = triple_of(word);
    if (!values) throw OptionError::wrong_value("fit_ccor", word, kCcorForm);
    try {
      out.push_back(checked(*values, word));
    } catch (const InputError&) {
      throw OptionError::wrong_value("fit_ccor", word, kCcorForm);
    }
  }
  return out;
}

}  // namespace percuss::tools
