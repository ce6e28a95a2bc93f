#include "core/io/natural_order.hpp"

#include <algorithm>
#include <numeric>

#include "core/io/parse_number.hpp"

namespace percuss {
inline namespace core {
namespace {

// The name with "#" for each number.
std::string without_numbers(const std::string& name) {
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_digit(name[i])) {
      out += name[i];
    } else if (i == 0 || !is_digit(name[i - 1])) {
      out += '#';
    }
  }
  return out;
}

// Whether the names, below the folder that they share, hold a decimal number.
bool have_decimal_numbers(const std::vector<std::string>& alike) {
  const std::string& name = alike.front();
  const std::string& other = alike.back();
  const auto apart = std::mismatch(name.begin(), name.end(), other.begin(), other.end()).first;
  const std::size_t folder = std::string(name.begin(), apart).rfind('/');
  const std::string below = without_numbers(folder == std::string::npos ? name : name.substr(folder + 1));
  return below.find("#.#") != std::string::npos || below.find("#,#") != std::string::npos;
}

// Some locales ignore punctuation: "p10.csv" before "p1.csv".
std::string letters_and_digits(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (letter || is_digit(c) || static_cast<unsigned char>(c) >= 0x80) out += c;
  }
  return out;
}

bool in_a_shells_order(const std::vector<std::string>& names) {
  const auto before = [](const std::string& a, const std::string& b) {
    return letters_and_digits(a) < letters_and_digits(b);
  };
  return std::is_sorted(names.begin(), names.end()) || std::is_sorted(names.begin(), names.end(), before);
}

}  // namespace

bool comes_first_naturally(const std::string& a, const std::string& b) {
  const auto number = [&](const std::string& text, std::size_t& at) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789", at), text.size());
    const std::size_t first = std::min(text.find_first_not_of('0', at), end);
    at = end;
    return text.substr(first, end - first);
  };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      const std::string x = number(a, i), y = number(b, j);
      if (x != y) return x.size() != y.size() ? x.size() < y.size() : x < y;
    } else if (a[i] != b[j]) {
      return a[i] < b[j];
    } else {
      ++i;
      ++j;
    }
  }
  return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

std::vector<std::size_t> intended_order(const std::vector<std::string>& names) {
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t first = 0; first < names.size();) {
    const std::string common = without_numbers(names[first]);
    std::size_t end = first + 1;
    while (end < names.size() && without_numbers(names[end]) == common) ++end;
    const auto at = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    const std::vector<std::string> alike(names.begin() + at(first), names.begin() + at(end));
    if (!have_decimal_numbers(alike) && in_a_shells_order(alike)) {
      std::sort(order.begin() + at(first), order.begin() + at(end),
                [&](std::size_t a, std::size_t b) { return comes_first_naturally(names[a], names[b]); });
    }
    first = end;
  }
  return order;
}

NameParts texts_and_numbers(std::string_view name) {
  NameParts parts{""};
  for (const char c : name) {
    const bool in_number = parts.size() % 2 == 0;
    if (is_digit(c) != in_number) parts.emplace_back();
    parts.back() += c;
  }
  return parts;
}

std::optional<std::set<std::size_t>> differing_numbers(const std::vector<NameParts>& names) {
  std::set<std::size_t> differing;
  for (const NameParts& name : names) {
    const NameParts& first = names.front();
    if (name.size() != first.size()) return std::nullopt;
    for (std::size_t i = 0; i < name.size(); ++i) {
      if (name[i] == first[i]) continue;
      if (i % 2 == 0) return std::nullopt;
      differing.insert(i);
    }
  }
  return differing;
}

}  // namespace core
}  // namespace percuss
