#include <algorithm>
#include <charconv>
#include <vector>

#include "mutators.hpp"

namespace percuss::fuzz {
namespace {

constexpr std::string_view kDelimiter = "    -1";

// Lines with their ends; the samples of a binary data set count as lines too.
std::vector<std::string> lines_of(const std::string& bytes) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size() - 1) + 1;
    lines.push_back(bytes.substr(at, end - at));
    at = end;
  }
  return lines;
}

// The first lines of the data sets: pairs of delimiters enclose them.
std::vector<std::size_t> data_sets(const std::vector<std::string>& lines) {
  std::vector<std::size_t> starts;
  bool inside = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool delimiter = lines[i].size() >= kDelimiter.size() &&
                           std::string_view(lines[i])
                               .substr(lines[i].find_last_of('-') == std::string::npos ? 0 : lines[i].find_last_of('-'))
                               .starts_with("-1") &&
                           lines[i].find(kDelimiter) != std::string::npos;
    if (!delimiter) continue;
    if (!inside) starts.push_back(i);
    inside = !inside;
  }
  return starts;
}

// Right-aligned, as Fortran writes it.
void put_field(std::string& line, std::size_t at, std::size_t width, const std::string& text) {
  if (line.size() < at + width + 1) return;
  const std::string cut = text.substr(0, width);
  line.replace(at, width, std::string(width - cut.size(), ' ') + cut);
}

void change_field(std::string& line, Random& random) {
  static constexpr std::size_t kWidths[] = {5, 6, 10, 12, 13, 20, 25};
  static constexpr const char* kReals[] = {
      "1.00000E+00", "0.00000E+00", "-1.0000E+00", "1.0000E-300", "1.0000E+400", "NaN", "*****", "1.0D+03", ""};
  const std::size_t width = one_of(kWidths, random), fields = line.size() / width;
  if (fields == 0) return;
  const std::uint64_t number = unusual_number(random);
  const std::string text =
      random() % 3 == 0 ? one_of(kReals, random) : std::to_string(static_cast<std::int32_t>(number));
  put_field(line, width * below(random, fields), width, text);
}

void change_kind(std::string& line, Random& random) {
  static constexpr const char* kKinds[] = {"15", "58", "58b", "82", "151", "164", "2411", "2412", "2414", "55", "1858"};
  const std::string kind = one_of(kKinds, random);
  if (line.size() > 6) line.replace(0, 6, std::string(6 - kind.size(), ' ') + kind);
}

// Sets the length in the header of each binary data set.
void fix_lengths(std::string& bytes) {
  constexpr std::size_t kLengthColumn = 31, kLengthWidth = 12, kTextLines = 11;
  for (std::size_t at = bytes.find("\n    58b"); at != std::string::npos; at = bytes.find("\n    58b", at + 1)) {
    std::size_t first = at + 1;
    for (std::size_t line = 0; line <= kTextLines && first != 0; ++line) first = bytes.find('\n', first) + 1;
    const std::size_t end = first == 0 ? std::string::npos : bytes.find(kDelimiter, first);
    if (end == std::string::npos || bytes.find('\n', at + 1) < at + 1 + kLengthColumn + kLengthWidth) continue;
    const std::string length = std::to_string(end - first);
    bytes.replace(at + 1 + kLengthColumn, kLengthWidth, std::string(kLengthWidth - length.size(), ' ') + length);
  }
}

}  // namespace

void mutate_uff(std::string& bytes, Random& random) {
  std::vector<std::string> lines = lines_of(bytes);
  const std::vector<std::size_t> sets = data_sets(lines);
  if (sets.empty()) return;
  const std::size_t which = below(random, sets.size()), first = sets[which];
  const std::size_t end = which + 1 < sets.size() ? sets[which + 1] : lines.size();
  const auto iterator = [&](std::size_t i) { return lines.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t line = first + below(random, std::min<std::size_t>(end - first, 16));
  const std::vector<std::string> set(iterator(first), iterator(end));
  const auto action = random() % 10;
  if (action == 0) {
    lines.insert(iterator(sets[below(random, sets.size())]), set.begin(), set.end());
  } else if (action == 1 && sets.size() > 1) {
    lines.erase(iterator(first), iterator(end));
  } else if (action == 2) {
    const std::string twin = lines[line];
    lines.insert(iterator(line), twin);
  } else if (action == 3) {
    lines.erase(iterator(line));
  } else if (action == 4 && first + 1 < end) {
    change_kind(lines[first + 1], random);
  } else if (action == 5) {
    lines[line].resize(below(random, lines[line].size() + 1));
    lines[line] += '\n';
  } else {
    for (std::size_t changes = 1 + random() % 2; changes > 0; --changes) change_field(lines[line], random);
  }
  bytes.clear();
  for (const std::string& text : lines) bytes += text;
  if (random() % 8 != 0) fix_lengths(bytes);
}

}  // namespace percuss::fuzz
