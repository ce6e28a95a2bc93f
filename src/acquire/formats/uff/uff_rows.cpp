#include "acquire/formats/uff/uff_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr double kSameStep = 1e-4;  // relative: the text columns round a step

using Functions = std::vector<const UffFunction*>;

// Rows that begin with a force, or end with a force if `forward` is not set. Empty when their lengths differ.
std::vector<UffRow> rows_in_order(Functions functions, std::vector<bool> is_force, bool forward) {
  if (!forward) {
    std::reverse(functions.begin(), functions.end());
    std::reverse(is_force.begin(), is_force.end());
  }
  std::vector<UffRow> rows;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    if (is_force[i]) rows.emplace_back();
    if (rows.empty()) return {};
    rows.back().push_back(functions[i]);
  }
  for (UffRow& row : rows) {
    if (row.size() != rows.front().size() || row.size() < 2) return {};
    if (!forward) std::reverse(row.begin() + 1, row.end());
  }
  if (!forward) std::reverse(rows.begin(), rows.end());
  return rows;
}

// One row per force. Among the responses with the same degree of freedom and quantity, the k-th belongs to the k-th
// row. Empty when the rows would differ in length.
std::vector<UffRow> rows_by_dof(const Functions& functions, const std::vector<bool>& is_force) {
  std::vector<UffRow> rows;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    if (is_force[i]) rows.push_back({functions[i]});
  }
  std::map<std::tuple<UffDof, int>, std::size_t> seen;
  std::size_t responses = 0;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    if (is_force[i]) continue;
    const std::size_t row = rows.size() == 1 ? 0 : seen[{functions[i]->response, functions[i]->ordinate.quantity}]++;
    if (row >= rows.size()) return {};
    rows[row].push_back(functions[i]);
    ++responses;
  }
  const bool even = responses > 0 && responses % rows.size() == 0;
  const auto fits = [&](const UffRow& row) { return row.size() == rows.front().size(); };
  return even && std::all_of(rows.begin(), rows.end(), fits) ? rows : std::vector<UffRow>{};
}

// The mean step of uneven times, and how far the rounding of the first and last time may change it.
struct MeanStep {
  double step_s, rounding_s;
};

MeanStep mean_step(const UffFunction& f) {
  if (f.count < 2) return {0, 0};
  constexpr double kTimeRounding = 1e-5;  // relative: times have five decimals in a text (E13.5)
  const double first_s = f.x(0), last_s = f.x(f.count - 1), steps = static_cast<double>(f.count - 1);
  return {(last_s - first_s) / steps, kTimeRounding * (std::abs(first_s) + std::abs(last_s)) / steps};
}

bool has_same_step(const UffFunction& a, const UffFunction& b) {
  if (a.even != b.even) return false;
  if (a.even) return a.dx == b.dx || std::abs(a.dx / b.dx - 1) <= kSameStep;
  const MeanStep one = mean_step(a), other = mean_step(b);
  return !(std::abs(one.step_s - other.step_s) >
           kSameStep * std::abs(other.step_s) + one.rounding_s + other.rounding_s);
}

void require_one_sampling(const std::vector<UffRow>& rows, const std::string& file) {
  const UffFunction& first = *rows.front().front();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const UffFunction* function : rows[r]) {
      const bool same_length = function->count == rows[r].front()->count;
      if (same_length && has_same_step(*function, first)) continue;
      throw InputError(
          fmt::format("the functions of hit {} differ in {}", r + 1, same_length ? "their sampling rate" : "length"),
          file, "export records that were sampled together");
    }
  }
}

}  // namespace

std::vector<UffRow> uff_rows(const std::vector<const UffFunction*>& functions, const std::vector<bool>& is_force,
                             const std::string& file) {
  std::vector<UffRow> rows;
  if (std::find(is_force.begin(), is_force.end(), true) == is_force.end()) rows.push_back(functions);
  if (rows.empty()) rows = rows_in_order(functions, is_force, true);
  if (rows.empty()) rows = rows_in_order(functions, is_force, false);
  if (rows.empty()) rows = rows_by_dof(functions, is_force);
  if (rows.empty()) {
    const auto forces = std::count(is_force.begin(), is_force.end(), true);
    throw InputError(fmt::format("{} forces and {} responses do not make rows of one force and its responses", forces,
                                 static_cast<std::ptrdiff_t>(functions.size()) - forces),
                     file, "export each hit's force followed by its responses");
  }
  require_one_sampling(rows, file);
  return rows;
}

}  // namespace percuss::acquire
