#include "metrics/compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

#include "metrics/common_orders.hpp"

namespace percuss::metrics {
namespace {

constexpr double kSamePlace_m = 1e-6;
constexpr double kAgreeingMac = 0.9;   // of the shapes of a distant pair
constexpr double kFurthestFactor = 2;  // between the frequencies of a distant pair
// The limit that would pair the two modes is rounded up to a multiple of 1/kFurthestSteps.
constexpr double kFurthestSteps = 10;

// Whether the modes may be of one kind. Only classified modes state whether they are the second peak of a split mode.
bool kinds_agree(const ComparedMode& a, const ComparedMode& b) {
  const auto any = [](const std::string& family) { return family.empty() || family == "unknown"; };
  return any(a.family) || any(b.family) || (a.family == b.family && a.second == b.second);
}

bool frequencies_match(const ComparedMode& a, const ComparedMode& b, double furthest) {
  return kinds_agree(a, b) && a.freq_Hz > 0 && b.freq_Hz > 0 && std::abs(b.freq_Hz - a.freq_Hz) <= furthest * a.freq_Hz;
}

double difference_percent(double a, double b) { return 100 * (b / a - 1); }

std::optional<double> difference_std_percent(double a, double a_std, double b, double b_std) {
  if (!(a_std > 0 || b_std > 0)) return std::nullopt;
  return 100 * b / a * std::hypot(a_std / a, b_std / b);
}

ModePair pair_of(const ComparedDocument& a, const ComparedDocument& b, std::size_t i, std::size_t k) {
  const ComparedMode &x = a.modes[i], &y = b.modes[k];
  ModePair pair{.a = i,
                .b = k,
                .difference_percent = difference_percent(x.freq_Hz, y.freq_Hz),
                .difference_std_percent = difference_std_percent(x.freq_Hz, x.freq_std_Hz, y.freq_Hz, y.freq_std_Hz)};
  if (x.damping_ratio.value_or(0) > 0 && y.damping_ratio.value_or(0) > 0) {
    pair.damping_difference_percent = difference_percent(*x.damping_ratio, *y.damping_ratio);
    pair.damping_difference_std_percent =
        difference_std_percent(*x.damping_ratio, x.damping_std, *y.damping_ratio, y.damping_std);
  }
  pair.mac = mac_between(x, y);
  return pair;
}

std::vector<std::size_t> all_modes_of(const ComparedDocument& document) {
  std::vector<std::size_t> modes(document.modes.size());
  std::iota(modes.begin(), modes.end(), std::size_t{0});
  return modes;
}

// Pairs of the modes `of_a` and `of_b`, with the best MAC first.
std::vector<ModePair> by_shape(const ComparedDocument& a, const ComparedDocument& b,
                               const std::vector<std::size_t>& of_a, const std::vector<std::size_t>& of_b,
                               const PairOptions& options) {
  std::vector<ModePair> all, chosen;
  for (const std::size_t i : of_a) {
    for (const std::size_t k : of_b) {
      if (!frequencies_match(a.modes[i], b.modes[k], options.furthest)) continue;
      ModePair pair = pair_of(a, b, i, k);
      pair.by = PairedBy::shape;
      if (pair.mac && pair.mac->value >= options.min_mac) all.push_back(pair);
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const ModePair& x, const ModePair& y) { return x.mac->value > y.mac->value; });
  for (ModePair& pair : all) {
    const bool taken = std::any_of(chosen.begin(), chosen.end(),
                                   [&](const ModePair& other) { return other.a == pair.a || other.b == pair.b; });
    if (!taken) chosen.push_back(pair);
  }
  return chosen;
}

std::vector<std::size_t> ascending(const ComparedDocument& document, std::vector<std::size_t> modes) {
  std::stable_sort(modes.begin(), modes.end(),
                   [&](std::size_t x, std::size_t y) { return document.modes[x].freq_Hz < document.modes[y].freq_Hz; });
  return modes;
}

bool is_paired(const std::vector<ModePair>& pairs, std::size_t ModePair::*side, std::size_t mode) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const ModePair& pair) { return pair.*side == mode; });
}

// The modes that are not in `pairs`, ascending by frequency.
std::vector<std::size_t> unpaired_ascending(const ComparedDocument& document, const std::vector<ModePair>& pairs,
                                            std::size_t ModePair::*side) {
  std::vector<std::size_t> modes;
  for (std::size_t m = 0; m < document.modes.size(); ++m) {
    if (!is_paired(pairs, side, m)) modes.push_back(m);
  }
  return ascending(document, std::move(modes));
}

// Pairs of the modes `rows` of a and `columns` of b, both ascending by frequency, for which may_pair(x, y) holds.
// Dynamic programming: best[i][k] has the most pairs among the first i and k modes, then the smallest sum of
// |ln(f_b/f_a)|.
template <class MayPair>
std::vector<ModePair> by_frequency(const ComparedDocument& a, const ComparedDocument& b,
                                   const std::vector<std::size_t>& rows, const std::vector<std::size_t>& columns,
                                   const MayPair& may_pair) {
  struct Best {
    std::size_t pairs = 0;
    double apart = 0;
    bool better(const Best& other) const {
      return pairs > other.pairs || (pairs == other.pairs && apart < other.apart);
    }
  };
  std::vector<std::vector<Best>> best(rows.size() + 1, std::vector<Best>(columns.size() + 1));
  const auto together = [&](std::size_t i, std::size_t k) -> std::optional<Best> {
    const ComparedMode &x = a.modes[rows[i]], &y = b.modes[columns[k]];
    if (!may_pair(x, y)) return std::nullopt;
    const Best& before = best[i][k];
    return Best{.pairs = before.pairs + 1, .apart = before.apart + std::abs(std::log(y.freq_Hz / x.freq_Hz))};
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Best& here = best[i + 1][k + 1];
      here = best[i][k + 1].better(best[i + 1][k]) ? best[i][k + 1] : best[i + 1][k];
      if (const auto pair = together(i, k); pair && pair->better(here)) here = *pair;
    }
  }
  std::vector<ModePair> pairs;  // from the highest frequencies down
  for (std::size_t i = rows.size(), k = columns.size(); i > 0 && k > 0;) {
    const Best& here = best[i][k];
    const auto same = [&](const Best& other) { return other.pairs == here.pairs && other.apart == here.apart; };
    if (same(best[i - 1][k])) {
      --i;
    } else if (same(best[i][k - 1])) {
      --k;
    } else {
      pairs.push_back(pair_of(a, b, rows[--i], columns[--k]));
    }
  }
  return pairs;
}

// The modes of one order: the second peaks of split modes, or all others.
std::vector<std::size_t> peaks_of(const ComparedDocument& document, const std::vector<std::size_t>& modes,
                                  bool second) {
  std::vector<std::size_t> out;
  std::copy_if(modes.begin(), modes.end(), std::back_inserter(out),
               [&](std::size_t m) { return document.modes[m].second == second; });
  return out;
}

// Pairs of one family and order, without the modes in `chosen`.
std::vector<ModePair> by_order(const ComparedDocument& a, const ComparedDocument& b, const CommonOrders& orders,
                               const std::vector<ModePair>& chosen, const PairOptions& options) {
  std::vector<ModePair> pairs;
  const auto near = [&](const ComparedMode& x, const ComparedMode& y) {
    return orders.hold(x, y) && std::abs(y.freq_Hz - x.freq_Hz) <= options.furthest_of_orders * x.freq_Hz &&
           !mac_between(x, y);
  };
  const auto add = [&](ModePair pair) {
    if (is_paired(chosen, &ModePair::a, pair.a) || is_paired(chosen, &ModePair::b, pair.b)) return;
    pair.by = PairedBy::order;
    pairs.push_back(std::move(pair));
  };
  for (const auto& [family, common] : orders.common()) {
    for (const int order : common) {
      const auto of_a = modes_of_order(a, family, order), of_b = modes_of_order(b, family, order);
      const auto from_below = [&](const std::vector<std::size_t>& x, const std::vector<std::size_t>& y) {
        for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
          if (near(a.modes[x[i]], b.modes[y[i]])) add(pair_of(a, b, x[i], y[i]));
        }
      };
      if (of_a.size() == of_b.size()) {
        from_below(of_a, of_b);
        continue;
      }
      // The first peak of a split mode stands for it, even if the second is lower.
      std::vector<std::size_t> rest_a, rest_b;
      for (const bool second : {false, true}) {
        const auto x = peaks_of(a, of_a, second), y = peaks_of(b, of_b, second);
        from_below(x, y);
        const auto paired = static_cast<std::ptrdiff_t>(std::min(x.size(), y.size()));
        rest_a.insert(rest_a.end(), x.begin() + paired, x.end());
        rest_b.insert(rest_b.end(), y.begin() + paired, y.end());
      }
      from_below(rest_a, rest_b);
    }
  }
  return pairs;
}

// Pairs, by frequency, of modes that are not in `chosen`, whose shapes cannot be compared, and whose orders do not
// decide.
std::vector<ModePair> remaining_pairs(const ComparedDocument& a, const ComparedDocument& b, const CommonOrders& orders,
                                      const std::vector<ModePair>& chosen, const PairOptions& options) {
  return by_frequency(a, b, unpaired_ascending(a, chosen, &ModePair::a), unpaired_ascending(b, chosen, &ModePair::b),
                      [&](const ComparedMode& x, const ComparedMode& y) {
                        return frequencies_match(x, y, options.furthest) && !orders.hold(x, y) &&
                               !orders.tell_apart(x, y) && !mac_between(x, y);
                      });
}

// Whether two pairs are exchangeable: see pair_modes().
bool may_be_exchanged(const ComparedDocument& a, const ComparedDocument& b, const CommonOrders& orders,
                      const ModePair& first, const ModePair& second, double furthest) {
  const auto crosswise = [&](const ModePair& one, const ModePair& other) {
    const ComparedMode &x = a.modes[one.a], &y = b.modes[other.b];
    return frequencies_match(x, y, furthest) && !orders.tell_apart(x, y) && !mac_between(x, y);
  };
  if (first.mac || second.mac || !crosswise(first, second) || !crosswise(second, first)) return false;
  const auto apart_Hz = [](const ComparedMode& x, const ComparedMode& y) { return std::abs(x.freq_Hz - y.freq_Hz); };
  const double shift_Hz =
      std::max(apart_Hz(a.modes[first.a], b.modes[first.b]), apart_Hz(a.modes[second.a], b.modes[second.b]));
  return std::min(apart_Hz(a.modes[first.a], a.modes[second.a]), apart_Hz(b.modes[first.b], b.modes[second.b])) <=
         shift_Hz;
}

// The deflection of a document at a position, interpolated between neighbours where possible.
std::optional<ComparedDeflection> at_position(const ComparedDocument& document, double position_m) {
  const ComparedDeflection *below = nullptr, *above = nullptr;
  for (const ComparedDeflection& d : document.deflections) {
    if (!d.position_m) continue;
    if (*d.position_m <= position_m + kSamePlace_m && (!below || *d.position_m > *below->position_m)) below = &d;
    if (*d.position_m >= position_m - kSamePlace_m && (!above || *d.position_m < *above->position_m)) above = &d;
  }
  if (!below || !above) return std::nullopt;
  const double step_m = *above->position_m - *below->position_m;
  if (step_m < kSamePlace_m) return *below;
  if (!document.model) return std::nullopt;  // a test has no value between its points
  const double part = (position_m - *below->position_m) / step_m;
  return ComparedDeflection{.position_m = position_m, .peak_m = (1 - part) * below->peak_m + part * above->peak_m};
}

std::optional<ComparedDeflection> at_point(const ComparedDocument& document, int point) {
  for (const ComparedDeflection& d : document.deflections) {
    if (d.point == point) return d;
  }
  return std::nullopt;
}

}  // namespace

const char* name_of(PairedBy by) {
  switch (by) {
    case PairedBy::shape:
      return "shape";
    case PairedBy::order:
      return "order";
    case PairedBy::frequency:
      return "frequency";
  }
  return "";
}

std::optional<identify::Mac> mac_between(const ComparedMode& a, const ComparedMode& b) {
  identify::ShapeValues first, second;
  for (const auto& [place, component] : a.shape) {
    const auto other = b.shape.find(place);
    if (other == b.shape.end()) continue;
    first.value.push_back(component.value);
    first.std.push_back(component.std);
    second.value.push_back(other->second.value);
    second.std.push_back(other->second.std);
  }
  if (first.value.size() < kMinPlaces) return std::nullopt;
  return mac(first, second);
}

std::vector<std::size_t> modes_of_order(const ComparedDocument& document, const std::string& family, int order) {
  std::vector<std::size_t> modes;
  for (std::size_t m = 0; m < document.modes.size(); ++m) {
    const ComparedMode& mode = document.modes[m];
    if (mode.family == family && mode.order == order && mode.freq_Hz > 0) modes.push_back(m);
  }
  return ascending(document, std::move(modes));
}

PairedModes pair_modes(const ComparedDocument& a, const ComparedDocument& b, const PairOptions& options) {
  const CommonOrders orders(a, b, options.furthest_of_orders);
  PairedModes out{.pairs = by_shape(a, b, all_modes_of(a), all_modes_of(b), options),
                  .doubted_orders = orders.doubted()};
  const auto add = [&](const std::vector<ModePair>& pairs) {
    out.pairs.insert(out.pairs.end(), pairs.begin(), pairs.end());
  };
  add(by_order(a, b, orders, out.pairs, options));
  add(remaining_pairs(a, b, orders, out.pairs, options));
  std::sort(out.pairs.begin(), out.pairs.end(), [](const ModePair& x, const ModePair& y) { return x.a < y.a; });
  for (ModePair& pair : out.pairs) {
    for (const ModePair& other : out.pairs) {
      if (other.a != pair.a && may_be_exchanged(a, b, orders, pair, other, options.furthest))
        pair.exchangeable_a.push_back(other.a);
    }
  }
  const auto rest = [&](const ComparedDocument& document, std::size_t ModePair::*side) {
    std::vector<std::size_t> left;
    for (std::size_t m = 0; m < document.modes.size(); ++m) {
      if (!is_paired(out.pairs, side, m) && document.modes[m].freq_Hz > 0) left.push_back(m);
    }
    return left;
  };
  out.unpaired_a = rest(a, &ModePair::a);
  out.unpaired_b = rest(b, &ModePair::b);
  return out;
}

std::vector<DistantPair> distant_pairs(const ComparedDocument& a, const ComparedDocument& b, const PairedModes& paired,
                                       const PairOptions& options) {
  std::vector<DistantPair> out;
  PairOptions wider = options;
  wider.min_mac = std::max(kAgreeingMac, options.min_mac);
  wider.furthest = kFurthestFactor - 1;
  for (const ModePair& pair : by_shape(a, b, paired.unpaired_a, paired.unpaired_b, wider)) {
    const double x_Hz = a.modes[pair.a].freq_Hz, y_Hz = b.modes[pair.b].freq_Hz;
    const double difference = y_Hz / x_Hz - 1;
    if (std::abs(difference) <= options.furthest || x_Hz > kFurthestFactor * y_Hz) continue;
    PairOptions enough = options;
    enough.furthest = std::ceil(kFurthestSteps * std::abs(difference)) / kFurthestSteps;
    const auto then = by_shape(a, b, all_modes_of(a), all_modes_of(b), enough);
    const bool pairs =
        std::any_of(then.begin(), then.end(), [&](const ModePair& one) { return one.a == pair.a && one.b == pair.b; });
    if (!pairs) continue;  // one of them then has a partner of a better MAC
    out.push_back({.a = pair.a, .b = pair.b, .mac = *pair.mac, .difference = difference, .furthest = enough.furthest});
  }
  std::sort(out.begin(), out.end(), [](const DistantPair& x, const DistantPair& y) { return x.a < y.a; });
  return out;
}

std::vector<DeflectionPair> pair_deflections(const ComparedDocument& a, const ComparedDocument& b) {
  // A test leads, because a model can be interpolated at each place of the test.
  const bool swapped = a.model && !b.model;
  const ComparedDocument &lead = swapped ? b : a, &other = swapped ? a : b;
  std::vector<DeflectionPair> pairs;
  for (const ComparedDeflection& d : lead.deflections) {
    const auto match = d.position_m ? at_position(other, *d.position_m)
                       : d.point    ? at_point(other, *d.point)
                                    : std::nullopt;
    if (!match || !(d.peak_m > 0) || !(match->peak_m > 0)) continue;
    // Other over lead is model/test if one document is a model, otherwise b/a.
    const double ratio = match->peak_m / d.peak_m;
    pairs.push_back({.point = d.point,
                     .position_m = d.position_m,
                     .a_m = swapped ? match->peak_m : d.peak_m,
                     .b_m = swapped ? d.peak_m : match->peak_m,
                     .ratio = ratio,
                     .ratio_std = ratio * std::hypot(d.std_m / d.peak_m, match->std_m / match->peak_m)});
  }
  return pairs;
}

}  // namespace percuss::metrics
