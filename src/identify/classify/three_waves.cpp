#include "identify/classify/three_waves.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace percuss::identify {
namespace {

constexpr double kFirstThreeWaves = 2;    // lowest frequency of n = 3 over the lowest of n = 2 …
constexpr double kLastThreeWaves = 6;     // … and the end of their range
constexpr double kKnownConfidence = 0.9;  // of a mode that counts as known
constexpr double kOrderStd = 0.03;        // standard deviation of ln f for an order that follows the known ones
constexpr double kMissing = 0.15;         // prior that a bending order is not among the modes
constexpr std::size_t kMaxMissing = 2;    // orders in a row
constexpr std::size_t kMinKnown = 3;      // known orders, for a forecast
constexpr double kEvenSteps = 0.2;        // largest relative difference of the last two steps
constexpr double kMinRival = 0.03;        // probability of three waves that is stated
constexpr double kSureOrder = 0.9;        // probability of an order that is stated without a note
constexpr std::size_t kMaxOrders = 10;    // whose assignments are all compared
constexpr double kNegligible = 1e-6;      // density of an assignment that is left out

// The modes of one bending order.
struct Order {
  std::vector<std::size_t> modes;
  int number = 0;
  double freq_Hz = 0;             // mean
  double three_over_bending = 1;  // of the mode whose ratio is furthest from 1
};

std::vector<Order> bending_orders(const std::vector<Mode>& modes, const std::vector<ModeClassification>& types,
                                  const std::vector<double>& three_over_bending) {
  std::vector<Order> orders;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (types[m].type != ModeType::bending || types[m].possible_three_waves) continue;
    if (orders.empty() || orders.back().number != types[m].order)
      orders.push_back({.modes = {}, .number = types[m].order});
    Order& order = orders.back();
    order.modes.push_back(m);
    order.freq_Hz += (modes[m].pole.freq_Hz - order.freq_Hz) / static_cast<double>(order.modes.size());
    if (std::abs(std::log(three_over_bending[m])) > std::abs(std::log(order.three_over_bending)))
      order.three_over_bending = three_over_bending[m];
  }
  return orders;
}

// The bending orders known so far: √f of the last one, and the step to the next.
struct Sequence {
  double last = 0, step = 0;
  bool known = false;

  // The density of ln f for a bending mode `missing` + 1 orders after the last one, times the prior of the gap.
  double density(double freq_Hz, std::size_t missing) const {
    const double orders = static_cast<double>(missing) + 1, forecast = last + orders * step;
    const double std = kOrderStd * orders, z = (std::log(freq_Hz) - 2 * std::log(forecast)) / std;
    return std::pow(kMissing, static_cast<double>(missing)) * std::exp(-z * z / 2) /
           (std * std::sqrt(2 * std::numbers::pi));
  }
};

Sequence sequence_of(const std::vector<double>& known_Hz) {
  if (known_Hz.size() < kMinKnown) return {};
  const auto root = [&](std::size_t from_end) { return std::sqrt(known_Hz[known_Hz.size() - 1 - from_end]); };
  const double step = root(0) - root(1), before = root(1) - root(2);
  return {.last = root(0), .step = step, .known = std::abs(step / before - 1) < kEvenSteps};
}

// Sums over all assignments of the orders to bending and to three waves. Orders after the first kMaxOrders are not
// assigned: both are equally probable.
class Assignments {
 public:
  Assignments(const std::vector<Order>& orders, const Sequence& known, double end_Hz)
      : orders_(orders),
        compared_(std::min(orders.size(), kMaxOrders)),
        end_Hz_(end_Hz),
        by_offset_(orders.size()),
        chosen_(compared_) {
    assign(0, known, 0, 1);
  }

  // The probability that an order is bending.
  double bending(std::size_t order) const {
    double sum = 0;
    for (const auto& [offset, weight] : by_offset_[order]) sum += weight;
    return order < compared_ ? sum / total_ : 0.5;
  }
  // The probability, if the order is bending, that its true number is Order::number plus `offset`.
  double probability_of_offset(std::size_t order, int offset) const {
    double sum = 0;
    for (const auto& [one, weight] : by_offset_[order]) sum += weight;
    const auto found = by_offset_[order].find(offset);
    return found == by_offset_[order].end() ? 0 : found->second / sum;
  }

 private:
  // `offset`: the number of missing bending orders minus the number of three-wave orders, so far.
  void assign(std::size_t next, const Sequence& known, int offset, double weight) {
    if (next == compared_) {
      finish(known, weight);
      return;
    }
    const double uniform = 1 / std::log(kLastThreeWaves / kFirstThreeWaves);
    const Order& order = orders_[next];
    chosen_[next] = std::nullopt;
    assign(next + 1, known, offset - 1, weight * uniform * order.three_over_bending);
    if (!known.known) {
      chosen_[next] = offset;
      assign(next + 1, known, offset, weight * uniform);
      return;
    }
    for (std::size_t missing = 0; missing <= kMaxMissing; ++missing) {
      const double density = known.density(order.freq_Hz, missing), root = std::sqrt(order.freq_Hz);
      if (density < kNegligible) continue;
      chosen_[next] = offset + static_cast<int>(missing);
      assign(next + 1, {.last = root, .step = missing == 0 ? root - known.last : known.step, .known = true},
             *chosen_[next], weight * density);
    }
  }

  void finish(const Sequence& known, double weight) {
    // Orders that the sequence forecasts below the highest mode are missing.
    for (std::size_t missing = 1; known.known && missing <= kMaxMissing; ++missing) {
      const double forecast = known.last + static_cast<double>(missing) * known.step;
      if (forecast * forecast < end_Hz_ * (1 - kOrderStd)) weight *= kMissing;
    }
    total_ += weight;
    for (std::size_t i = 0; i < compared_; ++i) {
      if (chosen_[i]) by_offset_[i][*chosen_[i]] += weight;
    }
  }

  const std::vector<Order>& orders_;
  std::size_t compared_;
  double end_Hz_, total_ = 0;
  std::vector<std::map<int, double>> by_offset_;  // weights of the assignments in which the order is bending
  std::vector<std::optional<int>> chosen_;        // the offset of a bending order
};

std::optional<double> lowest_sure_hoop_Hz(const std::vector<Mode>& modes, const std::vector<ModeClassification>& types,
                                          const LowerTubeModes& lower) {
  if (lower.lowest_hoop_Hz) return lower.lowest_hoop_Hz;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (types[m].type == ModeType::hoop && types[m].confidence >= kKnownConfidence) return modes[m].pole.freq_Hz;
  }
  return std::nullopt;
}

// Whether all modes of the order keep the type bending.
bool stays_bending(const Order& order, const std::vector<ModeClassification>& types, double bending) {
  return std::all_of(order.modes.begin(), order.modes.end(),
                     [&](std::size_t m) { return types[m].confidence * bending >= kMinTypeProbability; });
}

void make_unknown(ModeClassification& type) {
  type.type = ModeType::unknown;
  type.alternative = ModeType::bending;
  type.confidence = 1 - type.confidence;
  type.order = 0;
  if (type.split_mode) type.split_mode->planes.reset();
}

}  // namespace

void allow_three_waves(const std::vector<Mode>& modes, std::vector<ModeClassification>& classifications,
                       const std::vector<double>& three_over_bending, const LowerTubeModes& lower) {
  const auto hoop_Hz = lowest_sure_hoop_Hz(modes, classifications, lower);
  if (!hoop_Hz) return;
  std::vector<Order> above;
  std::vector<double> known_Hz = lower.bending_Hz;
  for (Order& order : bending_orders(modes, classifications, three_over_bending)) {
    if (modes[order.modes.front()].pole.freq_Hz > kFirstThreeWaves * *hoop_Hz) {
      above.push_back(std::move(order));
    } else {
      known_Hz.push_back(order.freq_Hz);
    }
  }
  if (above.empty()) return;
  const Assignments assignments(above, sequence_of(known_Hz), modes.back().pole.freq_Hz);
  std::vector<double> left_out_Hz;  // orders that do not count any more
  for (std::size_t i = 0; i < above.size(); ++i) {
    const double bending = assignments.bending(i);
    const bool stays = stays_bending(above[i], classifications, bending);
    for (const std::size_t m : above[i].modes) {
      ModeClassification& type = classifications[m];
      type.confidence *= bending;
      type.possible_three_waves = 1 - bending > kMinRival;
      type.order_uncertain =
          stays && assignments.probability_of_offset(i, -static_cast<int>(left_out_Hz.size())) < kSureOrder;
      if (!stays) {
        make_unknown(type);
      } else if (type.confidence < kKnownConfidence && !type.alternative) {
        type.alternative = ModeType::unknown;
      }
    }
    if (!stays) left_out_Hz.push_back(above[i].freq_Hz);
  }
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (classifications[m].type != ModeType::bending) continue;
    classifications[m].order -= static_cast<int>(std::count_if(
        left_out_Hz.begin(), left_out_Hz.end(), [&](double f_Hz) { return f_Hz < modes[m].pole.freq_Hz; }));
  }
}

}  // namespace percuss::identify
