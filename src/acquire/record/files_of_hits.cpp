#include "acquire/record/files_of_hits.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/io/natural_order.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMaxHitDigits = 6;  // longer numbers are dates and times

struct NameOfHit {
  std::string stem;
  int number = 0;
};

// The index at which `word` starts if `text` ends with it, in any letter case. Nothing if a letter stands before the
// word, or if the word is the whole text.
std::optional<std::size_t> start_of_word(std::string_view text, std::string_view word) {
  if (text.size() <= word.size()) return std::nullopt;
  const std::size_t at = text.size() - word.size();
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (lower(text[at + i]) != word[i]) return std::nullopt;
  }
  const char before = lower(text[at - 1]);
  return before >= 'a' && before <= 'z' ? std::nullopt : std::optional(at);
}

std::string_view without_separators(std::string_view text) {
  constexpr std::string_view kSeparators = "_- (";
  while (!text.empty() && kSeparators.find(text.back()) != std::string_view::npos) text.remove_suffix(1);
  return text;
}

// A name without extension, split at the number at its end.
struct NumberedName {
  std::string_view text;  // what precedes the number
  int number = 0;
};

std::optional<NumberedName> numbered_name(std::string_view name) {
  std::string_view text = name;
  if (text.ends_with(')')) text.remove_suffix(1);
  const std::string_view all = text;
  while (!text.empty() && is_digit(text.back())) text.remove_suffix(1);
  const std::string_view digits = all.substr(text.size());
  if (digits.empty() || digits.size() > kMaxHitDigits) return std::nullopt;
  return NumberedName{.text = text, .number = std::stoi(std::string(digits))};
}

std::optional<NameOfHit> name_of_hit(const std::string& path) {
  const std::filesystem::path file(path);
  const std::string name = file.stem().string();
  const auto numbered = numbered_name(name);
  if (!numbered) return std::nullopt;
  std::string_view stem = without_separators(numbered->text);
  bool separated = stem.size() < numbered->text.size();
  for (const std::string_view word : {"hit", "h"}) {
    const auto at = start_of_word(stem, word);
    if (!at) continue;
    stem = without_separators(stem.substr(0, *at));
    separated = true;
    break;
  }
  if (!separated || stem.empty()) return std::nullopt;
  return NameOfHit{.stem = (file.parent_path() / std::string(stem)).string(), .number = numbered->number};
}

// The files of one word and one name before it.
struct CalledHits {
  FilesOfHits group;
  std::set<int> numbers;
  bool repeated = false;  // a number occurs twice
};

// The index at which a word for a hit starts, at the end of the text; nothing if it ends in none.
std::optional<std::size_t> start_of_hit_word(std::string_view text) {
  for (const std::string_view word : {"hit", "impact", "blow", "strike", "tap"}) {
    // The blank before the text lets the word be the whole text.
    const auto at = start_of_word(" " + std::string(text), word);
    if (at) return *at - 1;
  }
  return std::nullopt;
}

// The path through the number of the point, without the part that numbers the hit.
std::string stem_of_point(const NameParts& name, std::size_t point, std::size_t hit) {
  const auto joined = [&](std::size_t from, std::size_t end) {
    std::string text;
    for (std::size_t i = from; i < end; ++i) text += name[i];
    return text;
  };
  if (point < hit) return joined(0, point + 1);
  const std::string own = joined(hit + 1, point + 1);
  const std::size_t begin = std::min(own.find_first_not_of("_- ()/."), own.size());
  return (std::filesystem::path(joined(0, hit)).parent_path() / own.substr(begin)).string();
}

// The files of one number of the point each; empty if the numbers form no such grid.
std::vector<FilesOfHits> grouped_by(const std::vector<NameParts>& names, std::size_t point, std::size_t hit) {
  std::vector<FilesOfHits> groups;
  std::vector<std::set<int>> hits;  // [groups]
  std::map<int, std::size_t> group_of;
  std::set<int> all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i][point].size() > kMaxHitDigits || names[i][hit].size() > kMaxHitDigits) return {};
    const int number = std::stoi(names[i][hit]);
    const auto [at, is_new] = group_of.emplace(std::stoi(names[i][point]), groups.size());
    if (is_new) {
      groups.push_back({.stem = stem_of_point(names[i], point, hit), .files = {}});
      hits.emplace_back();
    }
    groups[at->second].files.push_back(i);
    if (!hits[at->second].insert(number).second) return {};
    all.insert(number);
  }
  const auto complete = static_cast<std::size_t>(std::count(hits.begin(), hits.end(), all));
  return all.size() > 1 && complete > 1 && 2 * complete >= groups.size() ? groups : std::vector<FilesOfHits>{};
}

}  // namespace

std::vector<FilesOfHits> files_of_hits(const std::vector<std::string>& paths) {
  std::vector<FilesOfHits> groups;
  std::vector<std::set<int>> numbers;  // [groups]
  std::map<std::string, std::size_t> group_of;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto name = name_of_hit(paths[i]);
    if (!name) return {};
    const auto [at, is_new] = group_of.emplace(name->stem, groups.size());
    if (is_new) {
      groups.push_back({.stem = name->stem, .files = {}});
      numbers.emplace_back();
    }
    groups[at->second].files.push_back(i);
    if (!numbers[at->second].insert(name->number).second) return {};
  }
  std::map<std::set<int>, std::size_t> alike;
  for (const std::set<int>& one : numbers) {
    if (one.size() > 1 && ++alike[one] > 1) return groups;
  }
  return {};
}

std::vector<std::vector<FilesOfHits>> groupings_by_two_numbers(const std::vector<std::string>& paths) {
  if (paths.size() < 4) return {};
  std::vector<NameParts> names;
  names.reserve(paths.size());
  for (const std::string& path : paths)
    names.push_back(texts_and_numbers(std::filesystem::path(path).replace_extension().string()));
  const auto differing = differing_numbers(names);
  if (!differing || differing->size() != 2) return {};
  const std::size_t first = *differing->begin(), second = *differing->rbegin();
  std::vector<std::vector<FilesOfHits>> groupings;
  for (const auto& [point, hit] : {std::pair(first, second), std::pair(second, first)}) {
    std::vector<FilesOfHits> groups = grouped_by(names, point, hit);
    if (!groups.empty()) groupings.push_back(std::move(groups));
  }
  return groupings;
}

std::vector<FilesOfHits> files_called_hits(const std::vector<std::string>& paths) {
  std::vector<CalledHits> called;
  std::map<std::string, std::size_t> group_of;  // by folder, name and word
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const std::filesystem::path file(paths[i]);
    const std::string name = file.stem().string();
    const auto numbered = numbered_name(name);
    if (!numbered) continue;
    const std::string_view text = without_separators(numbered->text);
    const auto at = start_of_hit_word(text);
    if (!at) continue;
    const auto [found, is_new] = group_of.emplace((file.parent_path() / text).string(), called.size());
    if (is_new) {
      const auto stem = file.parent_path() / std::string(without_separators(text.substr(0, *at)));
      called.push_back({.group = {.stem = stem.string(), .files = {}}, .numbers = {}});
    }
    CalledHits& one = called[found->second];
    one.group.files.push_back(i);
    if (!one.numbers.insert(numbered->number).second) one.repeated = true;
  }
  std::vector<FilesOfHits> groups;
  for (CalledHits& one : called) {
    if (one.group.files.size() > 1 && !one.repeated) groups.push_back(std::move(one.group));
  }
  return groups;
}

}  // namespace percuss::acquire
