#include <array>
#include <sstream>
#include <vector>

#include "mutators.hpp"

namespace percuss::fuzz {
namespace {

using Words = std::vector<std::string>;

// The kinds of words in a line of a recipe.
enum class Kind { name, object, type, sizes, values, text, option };

struct LineForm {
  const char* first;  // word
  std::vector<Kind> rest;
};

struct Grammar {
  std::vector<LineForm> lines;
  Words names;
};

const Grammar& hdf5_grammar() {
  static const Grammar grammar{
      .lines = {{"set", {Kind::name, Kind::type, Kind::sizes, Kind::option}},
                {"number", {Kind::object, Kind::name, Kind::values}},
                {"text", {Kind::object, Kind::name, Kind::text}},
                {"group", {Kind::name}},
                {"soft", {Kind::name, Kind::object}},
                {"external", {Kind::name, Kind::text}}},
      .names = {"force",      "accel",      "fs",        "point",        "run",         "geometry",     "points",
                "frf",        "frf_std",    "coherence", "frequency_hz", "kind",        "unit",         "unit_str",
                "angle_deg",  "position_m", "name",      "names",        "sensitivity", "pretrigger_s", "dt",
                "continuous", "hit",        "direction", "channel"}};
  return grammar;
}

const Grammar& mat_grammar() {
  static const Grammar grammar{
      .lines = {{"real", {Kind::name, Kind::sizes, Kind::option}},
                {"complex", {Kind::name, Kind::sizes, Kind::option}},
                {"number", {Kind::name, Kind::values}},
                {"text", {Kind::name, Kind::text}}},
      .names = {"force",        "accel",      "fs",         "dt",         "df",         "t",        "time",
                "frequency_hz", "frf",        "H",          "coherence",  "point",      "run",      "geometry",
                "unit",         "force_unit", "accel_unit", "angle_deg",  "position_m", "hammer_N", "acc_g",
                "continuous",   "kind",       "frf_std",    "data.other", "data.force"}};
  return grammar;
}

std::string number_word(Random& random) {
  static constexpr const char* kOdd[] = {"nan", "inf", "-1", "0", "1e308", "0.5", "1e-300", "-0", "4294967296", "1e12"};
  return random() % 4 == 0 ? one_of(kOdd, random) : std::to_string(below(random, 50));
}

std::string list_word(Random& random, bool sizes) {
  std::string list;
  for (std::size_t n = 1 + random() % 4; n > 0; --n) {
    if (!list.empty()) list += ',';
    list += sizes && random() % 6 == 0 ? std::to_string(unusual_number(random)) : number_word(random);
  }
  return list;
}

std::string word_of(Kind kind, const Grammar& grammar, Random& random) {
  static constexpr const char* kTypes[] = {"f4", "f8", ">f8", "i1", "i2", "i4", ">i8", "u2", "complex", "text"};
  static constexpr const char* kTexts[] = {"g",          "N",   "lbf", "m/s^2", "mobility", "accelerance",
                                           "receptance", "g/N", "V",   "/",     "é",        "other.h5"};
  static constexpr const char* kOptions[] = {"chunk", "gzip", "nan", "claimed"};
  const std::string& name = grammar.names[below(random, grammar.names.size())];
  switch (kind) {
    case Kind::name:
      return random() % 8 == 0 ? "g/" + name : name;
    case Kind::object:
      return random() % 3 == 0 ? "/" : name;
    case Kind::type:
      return one_of(kTypes, random);
    case Kind::sizes:
      return list_word(random, true);
    case Kind::values:
      return list_word(random, false);
    case Kind::text:
      return one_of(kTexts, random);
    default:
      return one_of(kOptions, random);
  }
}

Words new_line(const Grammar& grammar, Random& random) {
  const LineForm& form = grammar.lines[below(random, grammar.lines.size())];
  Words words{form.first};
  for (const Kind kind : form.rest) {
    if (kind != Kind::option || random() % 3 == 0) words.push_back(word_of(kind, grammar, random));
  }
  return words;
}

// Replaces a word by another of its kind. In a list, it may replace or remove the last number instead.
void change_word(Words& line, const Grammar& grammar, Random& random) {
  for (const LineForm& form : grammar.lines) {
    if (line.empty() || line.front() != form.first) continue;
    const std::size_t at = below(random, form.rest.size());
    if (at + 1 >= line.size()) line.resize(at + 2, "1");
    std::string& word = line[at + 1];
    const Kind kind = form.rest[at];
    const std::size_t comma = word.rfind(',');
    if ((kind == Kind::sizes || kind == Kind::values) && comma != std::string::npos && random() % 2 == 0) {
      word = word.substr(0, comma) + (random() % 3 == 0 ? "" : "," + number_word(random));
    } else {
      word = word_of(kind, grammar, random);
    }
    return;
  }
  line = new_line(grammar, random);
}

void mutate_recipe(std::string& recipe, const Grammar& grammar, Random& random) {
  std::vector<Words> lines;
  std::istringstream in(recipe);
  for (std::string text; std::getline(in, text);) {
    std::istringstream words(text);
    lines.emplace_back();
    for (std::string word; words >> word;) lines.back().push_back(word);
  }
  const std::size_t at = below(random, lines.size());
  const auto position = lines.begin() + static_cast<std::ptrdiff_t>(at);
  const auto action = lines.empty() ? 0U : random() % 8;
  if (action == 0) {
    lines.insert(position, new_line(grammar, random));
  } else if (action == 1) {
    lines.erase(position);
  } else if (action == 2) {
    const Words twin = *position;
    lines.insert(position, twin);
    change_word(lines[at], grammar, random);
  } else if (action == 3) {
    std::swap(*position, lines[below(random, lines.size())]);
  } else {
    change_word(*position, grammar, random);
  }
  recipe.clear();
  for (const Words& words : lines) {
    for (const std::string& word : words) recipe += (&word == words.data() ? "" : " ") + word;
    recipe += '\n';
  }
}

}  // namespace

std::uint64_t unusual_number(Random& random) {
  static constexpr std::uint64_t kNumbers[] = {
      0,   1,     2,     3,     4,          7,          8,          16,          127,         128,         255,
      256, 32767, 65535, 65536, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x100000000, 1ULL << 40U, 1ULL << 62U, ~0ULL};
  const std::uint64_t number = one_of(kNumbers, random);
  return random() % 4 == 0 ? number + random() % 3 - 1 : number;
}

void mutate_hdf5_recipe(std::string& recipe, Random& random) { mutate_recipe(recipe, hdf5_grammar(), random); }

void mutate_mat_recipe(std::string& recipe, Random& random) { mutate_recipe(recipe, mat_grammar(), random); }

}  // namespace percuss::fuzz
