#include "acquire/channels/unit_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "acquire/record/note_codes.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kListedNames = 2;

// "a and b", "a, b and 3 more", of two names or more.
std::string listed(const std::vector<std::string>& names) {
  const std::string last =
      names.size() > kListedNames + 1 ? fmt::format("{} more", names.size() - kListedNames) : names.back();
  const std::size_t first = std::min(names.size() - 1, kListedNames);
  return fmt::format("{} and {}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(first), ", "),
                     last);
}

Message assumed_unit(const std::vector<std::string>& names, const char* unit, const char* option) {
  const std::string subject = names.size() == 1 ? fmt::format("the unit of {} is", names.front())
                                                : fmt::format("the units of {} are", listed(names));
  return {fmt::format("{} not stated; taken as {}", subject, unit), {option}};
}

}  // namespace

void note_assumed_units(Record& record) {
  if (record.has_force && record.force.unit_assumed)
    record.notes.push_back(assumed_unit({one_line(record.force.name, 40)}, "N", "force_unit"));
  for (const char* const unit : {"m/s^2", "Pa"}) {
    std::vector<std::string> names;
    for (const SignalInfo& signal : record.accel) {
      if (signal.unit_assumed && signal.unit == unit) names.push_back(one_line(signal.name, 40));
    }
    if (!names.empty()) record.notes.push_back(with_code(assumed_unit(names, unit, "unit"), kResponseUnitAssumed));
  }
}

Message full_scale_note() {
  Message note("stored numbers are fractions of full scale: give N and m/s^2 at full scale",
               {"force_scale", "accel_scale"});
  return with_code(std::move(note), kFullScaleAssumed);
}

bool is_about_assumed_units(const Message& note) {
  return note.code == kResponseUnitAssumed || note.code == kFullScaleAssumed;
}

}  // namespace percuss::acquire
