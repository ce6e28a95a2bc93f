#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "metrics/study/study.hpp"

namespace percuss::metrics {
namespace {

QuantitySummary summary_of(StudyQuantity quantity, const std::vector<double>& values) {
  QuantitySummary out{.quantity = quantity, .states = values.size()};
  const auto count = static_cast<double>(values.size());
  for (const double v : values) out.mean += v;
  out.mean /= count;
  for (const double v : values) out.std += (v - out.mean) * (v - out.mean);
  out.std = values.size() > 1 ? std::sqrt(out.std / (count - 1)) : 0;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  out.low = *low;
  out.high = *high;
  return out;
}

StudyGroup group_of(const std::vector<const StudyBat*>& members, StudyGroup group) {
  std::set<std::string> bats;
  for (const StudyBat* bat : members) bats.insert(bat->bat.empty() ? "id " + bat->id : "bat " + bat->bat);
  group.states = members.size();
  group.bats = bats.size();
  for (std::size_t q = 0; q < kStudyQuantities; ++q) {
    const auto quantity = static_cast<StudyQuantity>(q);
    std::vector<double> values;
    for (const StudyBat* bat : members) {
      if (bat->value(quantity)) values.push_back(*bat->value(quantity));
    }
    if (!values.empty()) group.quantities.push_back(summary_of(quantity, values));
  }
  return group;
}

}  // namespace

std::vector<StudyGroup> study_groups_of(const std::vector<StudyBat>& bats) {
  std::vector<StudyGroup> out;
  for (const BarrelMaterial material : {BarrelMaterial::wood, BarrelMaterial::aluminum, BarrelMaterial::composite}) {
    std::vector<const StudyBat*> all;
    std::set<std::pair<std::string, bool>> kinds;  // program, broken in
    for (const StudyBat& bat : bats) {
      if (bat.material != material) continue;
      all.push_back(&bat);
      kinds.insert({program_of(bat), bat.broken_in});
    }
    if (all.empty()) continue;
    out.push_back(group_of(all, {.material = material, .kind = "all", .program = "all"}));
    if (kinds.size() < 2) continue;
    for (const auto& [program, broken_in] : kinds) {
      std::vector<const StudyBat*> members;
      for (const StudyBat* bat : all) {
        if (program_of(*bat) == program && bat->broken_in == broken_in) members.push_back(bat);
      }
      out.push_back(
          group_of(members, {.material = material, .kind = broken_in ? "broken in" : "new", .program = program}));
    }
  }
  return out;
}

}  // namespace percuss::metrics
