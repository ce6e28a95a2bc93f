#include "metrics/common_orders.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::metrics {
namespace {

constexpr double kMinOrderConfidence = 0.9;
constexpr double kMuchNearer = 0.5;  // of the distance to the equal order

bool has_order(const ComparedMode& mode) {
  return !mode.family.empty() && mode.family != "unknown" && mode.order > 0 && mode.freq_Hz > 0;
}

bool states_order(const ComparedMode& mode) { return has_order(mode) && mode.confidence >= kMinOrderConfidence; }

// The lowest frequency of each order of one family.
using Frequencies = std::map<int, double>;

std::map<std::string, Frequencies> stated_orders(const ComparedDocument& document) {
  std::map<std::string, Frequencies> out;
  for (const ComparedMode& mode : document.modes) {
    if (!states_order(mode)) continue;
    const auto [at, is_new] = out[mode.family].emplace(mode.order, mode.freq_Hz);
    if (!is_new) at->second = std::min(at->second, mode.freq_Hz);
  }
  return out;
}

// Whether an order of `modes` above `order` has a frequency whose logarithm is within `limit` of ln_freq.
bool higher_order_near(const Frequencies& modes, int order, double ln_freq, double limit) {
  return std::any_of(modes.upper_bound(order), modes.end(),
                     [&](const auto& mode) { return std::abs(std::log(mode.second) - ln_freq) < limit; });
}

int first_doubted(const Frequencies& a, const Frequencies& b) {
  double below = 0;  // ln(f_b/f_a) of the common order below
  for (const auto& [order, a_Hz] : a) {
    const auto other = b.find(order);
    if (other == b.end()) continue;
    const double ln_a = std::log(a_Hz), ln_b = std::log(other->second);
    const double limit = kMuchNearer * std::abs(ln_b - ln_a - below);
    if (higher_order_near(b, order, ln_a + below, limit) || higher_order_near(a, order, ln_b - below, limit))
      return order;
    below = ln_b - ln_a;
  }
  return 0;
}

}  // namespace

CommonOrders::CommonOrders(const ComparedDocument& a, const ComparedDocument& b, double furthest) {
  const auto of_a = stated_orders(a), of_b = stated_orders(b);
  for (const auto& [name, modes] : of_a) {
    const auto others = of_b.find(name);
    if (others == of_b.end()) continue;
    Family& family = families_[name];
    for (const auto& [order, freq_Hz] : modes) {
      const auto other = others->second.find(order);
      if (other == others->second.end()) continue;
      family.orders.push_back(order);
      family.any_near = family.any_near || std::abs(other->second - freq_Hz) <= furthest * freq_Hz;
    }
    family.doubted_from = first_doubted(modes, others->second);
  }
}

bool CommonOrders::within_common(const ComparedMode& x, const ComparedMode& y) const {
  if (!has_order(x) || !has_order(y) || x.family != y.family) return false;
  const auto family = families_.find(x.family);
  return family != families_.end() && family->second.holds(std::min(x.order, y.order));
}

bool CommonOrders::hold(const ComparedMode& x, const ComparedMode& y) const {
  return states_order(x) && states_order(y) && within_common(x, y);
}

bool CommonOrders::tell_apart(const ComparedMode& x, const ComparedMode& y) const {
  return (states_order(x) || states_order(y)) && x.order != y.order && within_common(x, y);
}

std::map<std::string, std::vector<int>> CommonOrders::common() const {
  std::map<std::string, std::vector<int>> out;
  for (const auto& [name, family] : families_) {
    for (const int order : family.orders) {
      if (family.holds(order)) out[name].push_back(order);
    }
  }
  return out;
}

std::vector<DoubtedOrders> CommonOrders::doubted() const {
  std::vector<DoubtedOrders> out;
  for (const auto& [name, family] : families_) {
    if (family.doubted_from > 0) out.push_back({.family = name, .from = family.doubted_from});
  }
  return out;
}

}  // namespace percuss::metrics
