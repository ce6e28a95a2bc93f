#include "report/compare_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/io/counted_words.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxNamed = 8;
constexpr double kSameFrequency = 0.01;  // relative: equal modes of tests of one structure agree far better

// "-0.25 %", "+98 ppm": with a sign, but for a value that rounds to zero.
std::string signed_difference(double percent) {
  const double magnitude_ppm = 1e4 * std::abs(percent);
  if (std::abs(percent) >= kMinPercentShown) return fmt::format("{:+.2f} %", percent);
  constexpr double kZero_ppm = 0.005;
  if (magnitude_ppm < kZero_ppm) return "0.00 ppm";
  const int digits = magnitude_ppm < 1 ? 2 : magnitude_ppm < 10 ? 1 : 0;
  return fmt::format("{:+.{}f} ppm", 1e4 * percent, digits);
}

// The standard deviation of the difference of two frequencies in percent, where both have one.
std::optional<double> frequency_std_percent(const Comparison& c, const metrics::ModePair& pair) {
  const bool both = c.a.modes[pair.a].freq_std_Hz > 0 && c.b.modes[pair.b].freq_std_Hz > 0;
  const bool known = both && pair.difference_std_percent && *pair.difference_std_percent > 0;
  return known ? pair.difference_std_percent : std::nullopt;
}

// Likewise of two damping ratios.
std::optional<double> damping_std_percent(const Comparison& c, const metrics::ModePair& pair) {
  const bool both = c.a.modes[pair.a].damping_std > 0 && c.b.modes[pair.b].damping_std > 0;
  const bool known = both && pair.damping_difference_std_percent && *pair.damping_difference_std_percent > 0;
  return known ? pair.damping_difference_std_percent : std::nullopt;
}

// "-0.25 %, 154 σ": the difference, and how many of its standard deviations it is, where it has one.
std::string difference_text(double percent, const std::optional<double>& std_percent) {
  constexpr double kLargest = 1000;
  const std::string text = signed_difference(percent);
  if (!std_percent) return text;
  const double deviations = std::abs(percent) / *std_percent;
  if (deviations >= kLargest) return text + fmt::format(", over {:.0f} σ", kLargest);
  return text + (deviations < 10 ? fmt::format(", {:.1f} σ", deviations) : fmt::format(", {:.0f} σ", deviations));
}

// A part at another temperature differs by many σ from itself.
void say_what_deviations_lack(ReportText& text, const std::vector<Comparison>& comparisons) {
  const bool stated = std::any_of(comparisons.begin(), comparisons.end(), [](const Comparison& c) {
    return std::any_of(c.modes.pairs.begin(), c.modes.pairs.end(), [&](const metrics::ModePair& pair) {
      return frequency_std_percent(c, pair) || (pair.damping_difference_percent && damping_std_percent(c, pair));
    });
  });
  if (!stated) return;
  text.say(
      "σ holds the noise and the scatter of the hits of each test, but neither temperature nor support nor mounting "
      "of a sensor: to learn how far equal parts differ, test one part twice, remounted");
}

std::string frequency_text(const metrics::ComparedMode& mode) {
  return value_with_std(mode.freq_Hz, mode.freq_std_Hz) + " Hz";
}

std::string damping_text(const metrics::ComparedMode& mode) {
  return mode.damping_ratio ? value_with_std(100 * *mode.damping_ratio, 100 * mode.damping_std) + " %" : "–";
}

// Whether a mode of the document has a type. Modes of a plate or a beam have none.
bool names_families(const metrics::ComparedDocument& document) {
  return std::any_of(document.modes.begin(), document.modes.end(), [](const metrics::ComparedMode& mode) {
    return !mode.family.empty() && mode.family != "unknown";
  });
}

// The first cells of a mode's row.
std::vector<std::string> mode_cells(const metrics::ComparedDocument& document, std::size_t m) {
  std::vector<std::string> cells{std::to_string(first_mode_number(document) + m)};
  if (names_families(document)) cells.push_back(compared_mode_name(document, m));
  return cells;
}

// ", bending 4" for a partner whose stated order or type is another.
std::string other_name(const Comparison& c, const metrics::ModePair& pair) {
  const std::string name = compared_mode_name(c.b, pair.b);
  return c.b.modes[pair.b].order > 0 && name != compared_mode_name(c.a, pair.a) ? ", " + name : "";
}

TextTable modes_table(const std::vector<metrics::ComparedDocument>& documents) {
  std::vector<TextTable::Column> heads{{"mode", TextTable::Align::right}};
  if (names_families(documents.front())) heads.push_back({"family"});
  for (const metrics::ComparedDocument& document : documents)
    heads.push_back({one_line(document.name, 40), TextTable::Align::right});
  heads.push_back({""});
  TextTable table(std::move(heads));
  table.split_after(names_families(documents.front()) ? 3 : 2);
  return table;
}

// The dampings of the paired modes, where two documents state them.
std::optional<TextTable> dampings_table(const std::vector<metrics::ComparedDocument>& documents,
                                        const std::vector<Comparison>& comparisons) {
  TextTable table = modes_table(documents);
  bool any = false;
  for (std::size_t m = 0; m < documents.front().modes.size(); ++m) {
    const metrics::ComparedMode& mode = documents.front().modes[m];
    std::vector<std::string> cells = mode_cells(documents.front(), m);
    cells.push_back(damping_text(mode));
    bool paired = false;
    for (const Comparison& c : comparisons) {
      const metrics::ModePair* pair = pair_at(c, m);
      const bool differs = pair && pair->damping_difference_percent;
      paired = paired || differs;
      cells.push_back(
          !pair     ? "–"
          : differs ? fmt::format("{} ({})", damping_text(c.b.modes[pair->b]),
                                  difference_text(*pair->damping_difference_percent, damping_std_percent(c, *pair)))
                    : damping_text(c.b.modes[pair->b]));
    }
    cells.emplace_back("");
    if (paired) table.add(std::move(cells));
    any = any || paired;
  }
  return any ? std::optional(std::move(table)) : std::nullopt;
}

// A sentence about one comparison, or about several of which the same holds: `before`, the documents, `after`.
struct Note {
  std::string before, of, after;  // `of` precedes the names of the documents; empty: no names
  bool operator==(const Note&) const = default;
};

// How the points of the shapes were matched.
void add_place_notes(std::vector<Note>& notes, const Comparison& c) {
  const metrics::CommonPlaces& places = c.places;
  if (std::min(places.points_a, places.points_b) < 2) return;
  if (places.coordinates_differ) {
    notes.push_back(
        {"the coordinates of the points", " of ", " do not agree: another origin, unit or direction of the axes?"});
  }
  const std::string numbers = places.by == metrics::PlacesMatchedBy::sequence
                                  ? "their sequence, since one document counts from 0 and the other from 1"
                                  : fmt::format("their {}", name_of(places.by));
  const std::size_t common = places.of_b.size();
  const std::string of = common == places.points_a && common == places.points_b
                             ? ""
                             : fmt::format(", of {} and {}", places.points_a, places.points_b);
  notes.push_back({"points", " of ", fmt::format(" are matched by {}: {} in both{}", numbers, common, of)});
}

// Says where modes without a partner agree in frequency, but not in shape.
std::optional<std::string> other_shapes_text(const Comparison& c) {
  std::size_t alike = 0;
  for (const std::size_t a : c.modes.unpaired_a) {
    const double freq_Hz = c.a.modes[a].freq_Hz;
    alike += std::any_of(c.modes.unpaired_b.begin(), c.modes.unpaired_b.end(), [&](std::size_t b) {
      return std::abs(c.b.modes[b].freq_Hz - freq_Hz) < kSameFrequency * freq_Hz &&
             metrics::mac_between(c.a.modes[a], c.b.modes[b]).has_value();
    });
  }
  if (alike == 0) return std::nullopt;
  return fmt::format("{} without a partner {} in frequency within {:.0f} % with a mode of {}, but not in shape{}",
                     alike == 1 ? "1 mode" : fmt::format("{} modes", alike), alike == 1 ? "agrees" : "agree",
                     100 * kSameFrequency, one_line(c.b.name, 200),
                     c.places.by == metrics::PlacesMatchedBy::coordinates
                         ? ""
                         : ": do equal point numbers mean equal places in both?");
}

// "modes are paired with the modes of b.json by …", or "2 of 7 modes are …"; nothing where none is.
void add_paired_note(std::vector<Note>& notes, const Comparison& c, metrics::PairedBy by, const std::string& how) {
  const auto& pairs = c.modes.pairs;
  const auto count = static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [&](const metrics::ModePair& pair) { return pair.by == by; }));
  if (count == 0) return;
  const std::string which = count == pairs.size()
                                ? "modes are"
                                : fmt::format("{} of {} modes {}", count, pairs.size(), count == 1 ? "is" : "are");
  notes.push_back({which + " paired", " with the modes of ", " by " + how});
}

// That modes are paired by order or by frequency, and which of them may be exchanged.
void add_pairing_notes(std::vector<Note>& notes, const Comparison& c) {
  const std::string few = fmt::format("(fewer than {} common points)", metrics::kMinPlaces);
  add_paired_note(notes, c, metrics::PairedBy::order, "family and order " + few);
  for (const metrics::DoubtedOrders& doubted : c.modes.doubted_orders) {
    notes.push_back({"the frequencies", " of ",
                     fmt::format(" contradict the orders of {} modes from {} on, as where one test lacks a mode: these "
                                 "orders are not used",
                                 one_line(doubted.family, 40), doubted.from)});
  }
  add_paired_note(notes, c, metrics::PairedBy::frequency, "frequency " + few + ": modes that crossed are exchanged");
  std::vector<std::string> exchangeable;
  const std::size_t number = first_mode_number(c.a);
  for (const metrics::ModePair& pair : c.modes.pairs) {
    for (const std::size_t other : pair.exchangeable_a) {
      if (other > pair.a) exchangeable.push_back(fmt::format("{} and {}", number + pair.a, number + other));
    }
  }
  if (exchangeable.empty()) return;
  notes.push_back(
      {fmt::format("modes {} may be exchanged",
                   limited_list(exchangeable.size(), kMaxNamed, [&](std::size_t i) { return exchangeable[i]; })),
       " in ", ": they lie no further apart than they moved"});
}

std::vector<Note> notes_of(const Comparison& c) {
  std::vector<Note> notes;
  add_place_notes(notes, c);
  add_pairing_notes(notes, c);
  return notes;
}

// Says the notes about comparisons[i] that no earlier comparison has, with the names of all documents of which they
// hold.
void say_notes(ReportText& text, const std::vector<Comparison>& comparisons,
               const std::vector<std::vector<Note>>& notes, std::size_t i) {
  const auto holds = [&](std::size_t k, const Note& note) {
    return std::find(notes[k].begin(), notes[k].end(), note) != notes[k].end();
  };
  for (const Note& note : notes[i]) {
    std::vector<std::string> names;
    bool earlier = false;
    for (std::size_t k = 0; k < notes.size(); ++k) {
      if (!holds(k, note)) continue;
      earlier = earlier || k < i;
      names.push_back(one_line(comparisons[k].b.name, 200));
    }
    if (earlier) continue;
    const std::string list = names.size() > 1 && names.size() == notes.size()
                                 ? "all others"
                                 : limited_list(names.size(), kMaxNamed, [&](std::size_t n) { return names[n]; });
    text.say(note.before + (notes.size() > 1 ? note.of + list : "") + note.after);
  }
}

// Says which modes without a partner have shapes that agree.
void say_distant_pairs(ReportText& text, const Comparison& c) {
  if (c.distant.empty()) return;
  const std::string pairs = limited_list(c.distant.size(), kMaxNamed, [&](std::size_t i) {
    const metrics::DistantPair& pair = c.distant[i];
    return fmt::format("{} and {} Hz (MAC {:.2f}, {:.0f} % apart, paired with {:.0f} %)",
                       hertz_text(c.a.modes[pair.a].freq_Hz), hertz_text(c.b.modes[pair.b].freq_Hz), pair.mac.value,
                       100 * std::abs(pair.difference), 100 * pair.furthest);
  });
  text.say({fmt::format("modes of equal shapes are too far apart to pair: {}; allow a larger difference", pairs),
            {"furthest"}});
}

}  // namespace

std::size_t first_mode_number(const metrics::ComparedDocument& document) {
  return document.schema == "percuss/model-beam/1" ? 0 : 1;
}

std::string compared_mode_name(const metrics::ComparedDocument& document, std::size_t m) {
  constexpr std::size_t kLetters = 26;
  const metrics::ComparedMode& mode = document.modes[m];
  const std::string family = one_line(mode.family, 40);
  if (mode.order <= 0) return family;
  std::string name = fmt::format("{} {}", family, mode.order);
  const auto same = metrics::modes_of_order(document, mode.family, mode.order);
  const auto rank = static_cast<std::size_t>(std::find(same.begin(), same.end(), m) - same.begin());
  if (same.size() > 1 && rank < std::min(same.size(), kLetters)) name += static_cast<char>('a' + rank);
  return name;
}

const metrics::ModePair* pair_at(const Comparison& c, std::size_t mode) {
  for (const metrics::ModePair& pair : c.modes.pairs) {
    if (pair.a == mode) return &pair;
  }
  return nullptr;
}

ReportText compare_modes_text(const std::vector<metrics::ComparedDocument>& documents,
                              const std::vector<Comparison>& comparisons) {
  TextTable table = modes_table(documents);
  for (std::size_t m = 0; m < documents.front().modes.size(); ++m) {
    const metrics::ComparedMode& mode = documents.front().modes[m];
    if (!(mode.freq_Hz > 0)) continue;
    std::vector<std::string> cells = mode_cells(documents.front(), m);
    cells.push_back(frequency_text(mode));
    for (const Comparison& c : comparisons) {
      const metrics::ModePair* pair = pair_at(c, m);
      std::string cell = pair ? fmt::format("{}{} ({}", frequency_text(c.b.modes[pair->b]), other_name(c, *pair),
                                            difference_text(pair->difference_percent, frequency_std_percent(c, *pair)))
                              : "–";
      if (pair) cell += pair->mac ? fmt::format(", MAC {:.3f})", pair->mac->value) : ")";
      cells.push_back(std::move(cell));
    }
    cells.emplace_back("");
    table.add(std::move(cells));
  }
  ReportText text;
  text += table;
  std::vector<std::vector<Note>> notes;
  std::transform(comparisons.begin(), comparisons.end(), std::back_inserter(notes), notes_of);
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    say_notes(text, comparisons, notes, i);
    if (c.modes.unpaired_b.empty()) continue;
    if (const auto hint = other_shapes_text(c)) text.say(*hint);
    say_distant_pairs(text, c);
    const auto& unpaired = c.modes.unpaired_b;
    text.say(fmt::format(
        "only in {}: {}", one_line(c.b.name, 200), limited_list(unpaired.size(), kMaxNamed, [&](std::size_t u) {
          const metrics::ComparedMode& mode = c.b.modes[unpaired[u]];
          const std::string freq = fmt::format("{:.6g} Hz", mode.freq_Hz);
          return mode.order > 0 ? fmt::format("{} ({})", freq, compared_mode_name(c.b, unpaired[u])) : freq;
        })));
  }
  if (auto dampings = dampings_table(documents, comparisons)) {
    text += "\ndamping\n";
    text += *dampings;
  }
  say_what_deviations_lack(text, comparisons);
  return text;
}

ReportText compare_deflections_text(const Comparison& c) {
  const bool inverted = c.a.model && !c.b.model;
  TextTable table({{"position", TextTable::Align::right},
                   {one_line(c.a.name, 40), TextTable::Align::right},
                   {one_line(c.b.name, 40), TextTable::Align::right},
                   {inverted ? "first/second" : "second/first", TextTable::Align::right},
                   {""}});
  for (const metrics::DeflectionPair& pair : c.deflections) {
    const std::string place = pair.position_m ? fmt::format("{:.1f} mm", 1000 * *pair.position_m)
                              : pair.point    ? fmt::format("point {}", *pair.point)
                                              : "";
    table.add({place, fmt::format("{:.4g} mm", 1000 * pair.a_m), fmt::format("{:.4g} mm", 1000 * pair.b_m),
               value_with_std(pair.ratio, pair.ratio_std), ""});
  }
  ReportText text(std::string("largest deflection\n"));
  text += table;
  return text;
}

}  // namespace percuss::report
