#include "acquire/record/record_losses.hpp"

#include <algorithm>

#include "acquire/record/channel_name.hpp"

namespace percuss::acquire {

void add_lost_lines(const std::vector<TraceLine>& lines, std::size_t kept, std::vector<std::string>& losses) {
  if (kept >= lines.size()) return;
  losses.emplace_back(kept == 0 ? "the lines between points" : "lines to points without coordinates");
}

void add_lost_places(const Record& record, std::vector<std::string>& losses) {
  const auto any = [&](auto place) {
    return std::any_of(record.accel.begin(), record.accel.end(), [&](const auto& s) { return (s.*place).has_value(); });
  };
  if (any(&SignalInfo::angle_rad)) losses.emplace_back("the sensors' angles");
  if (any(&SignalInfo::position_m)) losses.emplace_back("the sensors' positions");
}

void add_lost_quantities(const Record& record, std::vector<std::string>& losses) {
  const auto differs = [&](const SignalInfo& signal) { return signal.measures != record.accel.front().measures; };
  if (std::any_of(record.accel.begin(), record.accel.end(), differs))
    losses.emplace_back("which responses are accelerations and which are pressures");
}

void add_lost_names(const Record& record, std::vector<std::string>& losses) {
  for (std::size_t c = 0; c < record.accel.size(); ++c) {
    if (record.accel[c].name == channel_name(c)) continue;
    losses.emplace_back("the channels' names");
    return;
  }
}

}  // namespace percuss::acquire
