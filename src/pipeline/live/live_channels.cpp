#include "pipeline/live/live_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/channels/named_channels.hpp"
#include "acquire/channels/signal_table.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {
namespace {

using acquire::StreamFormat;

acquire::SignalTable table_of(const StreamFormat& format) {
  acquire::SignalTable table{.format = "stream", .fs_Hz = format.fs_Hz};
  const bool named = format.names.size() == format.channels;
  for (std::size_t c = 0; c < format.channels; ++c) {
    table.signals.push_back({.name = named ? format.names[c] : "channel " + std::to_string(format.number_of(c)),
                             .unit = c < format.units.size() ? format.units[c] : ""});
  }
  table.rows.push_back({.samples = 2});
  table.read = [](std::size_t /*row*/, std::size_t /*signal*/, std::size_t /*first*/, std::span<double> out) {
    std::fill(out.begin(), out.end(), 0);
  };
  return table;
}

// The set-up for the recorded channels: each number of the device becomes the channel's place in the stream.
std::vector<acquire::ChannelSetup> recorded_entries(std::vector<acquire::ChannelSetup> setup,
                                                    const StreamFormat& format) {
  if (format.numbers.empty()) return setup;
  std::vector<acquire::ChannelSetup> out;
  for (acquire::ChannelSetup& entry : setup) {
    const bool number = !entry.name.empty() && entry.name.find_first_not_of("0123456789") == std::string::npos;
    const auto at = std::find_if(format.numbers.begin(), format.numbers.end(),
                                 [&](std::size_t other) { return std::to_string(other) == entry.name; });
    if (number && at == format.numbers.end()) continue;
    if (number) entry.name = std::to_string(at - format.numbers.begin() + 1);
    out.push_back(std::move(entry));
  }
  return out;
}

bool names_channel(const acquire::ChannelSetup& entry, const acquire::SignalTable& table, std::size_t channel) {
  return entry.name == std::to_string(channel + 1) || entry.name == table.signals[channel].name;
}

bool is_force(const acquire::ChannelSetup& entry) {
  if (!entry.role.empty()) return entry.role == "force";
  const auto unit = parse_unit(entry.unit.value_or(""));
  return (unit && unit->quantity == Quantity::force) ||
         (entry.sensitivity_V_per_SI && entry.sensitivity_to == Quantity::force);
}

// The set-up with all roles, for channels whose names and units say nothing: an entry without a role is a response. The
// hammer is the entry that is a force, else the first channel. Where no entry is a response, all other channels are.
std::vector<acquire::ChannelSetup> with_roles(std::vector<acquire::ChannelSetup> setup,
                                              const acquire::SignalTable& table) {
  const auto entry_of = [&](std::size_t channel) {
    return std::find_if(setup.begin(), setup.end(),
                        [&](const auto& entry) { return names_channel(entry, table, channel); });
  };
  if (std::none_of(setup.begin(), setup.end(), is_force)) {
    if (entry_of(0) == setup.end()) setup.push_back({.name = "1"});
    if (entry_of(0)->role.empty()) entry_of(0)->role = "force";
  }
  bool responses = false;
  for (acquire::ChannelSetup& entry : setup) {
    if (entry.role.empty()) entry.role = is_force(entry) ? "force" : "acceleration";
    responses = responses || entry.role == "acceleration";
  }
  for (std::size_t c = 0; c < table.signals.size() && !responses; ++c) {
    if (entry_of(c) == setup.end()) setup.push_back({.name = std::to_string(c + 1), .role = "acceleration"});
  }
  return setup;
}

acquire::SignalRoles roles_of(const acquire::SignalTable& table, const acquire::ReadOptions& options,
                              const std::string& device) {
  if (table.signals.size() < 2) {
    throw InputError("a hammer test needs the force and at least one response", device,
                     "choose a device with two channels or more", {"channels"});
  }
  const bool stated = !options.force_channel.empty() || !options.accel_channels.empty() || !options.setup.empty();
  try {
    return acquire::find_roles(table, options);
  } catch (const acquire::AmbiguousColumns&) {
  } catch (const InputError&) {
    if (stated) throw;
  }
  if (!options.setup.empty()) {
    acquire::ReadOptions completed = options;
    completed.setup = with_roles(options.setup, table);
    try {
      return acquire::find_roles(table, completed);
    } catch (const acquire::AmbiguousColumns&) {  // its guess would need samples
      throw InputError("the set-up leaves open which channels are the hammer and the responses", device,
                       "give each of its entries the name or number of a channel and a role", {"setup"});
    }
  }
  // A device without names: the hammer is plugged into the first channel, unless that measures a response.
  acquire::SignalRoles roles;
  const auto unit = parse_unit(table.signals.front().unit);
  roles.has_force = !unit || !is_response(unit->quantity);
  for (std::size_t c = 1; c < table.signals.size(); ++c) roles.accel.push_back(c);
  return roles;
}

// As a reader of the written file finds the signal: in SI units, the angle converted to degrees and back.
acquire::SignalInfo as_stored(const acquire::SignalInfo& signal, const std::string& name, const std::string& unit) {
  acquire::SignalInfo out{.name = name, .unit = unit, .position_m = signal.position_m, .measures = signal.measures};
  if (signal.angle_rad) out.angle_rad = *signal.angle_rad * kRadian_deg * kDegree_rad;
  return out;
}

}  // namespace

std::string name_of_channel(const LiveChannels& channels, std::size_t accel) {
  const std::string number = fmt::format("channel {}", channels.accel_numbers[accel]);
  const std::string& name = channels.accel_names[accel];
  const std::string in_file = acquire::channel_name(accel);
  if (name == number || name.starts_with("accel")) return fmt::format("{} ({})", number, in_file);
  return fmt::format("{} ({}, {})", number, one_line(name, kMaxNameBytes), in_file);
}

LiveChannels live_channels(const StreamFormat& format, const acquire::ReadOptions& stated,
                           std::vector<Message> device_notes) {
  acquire::ReadOptions options = stated;
  options.setup = recorded_entries(std::move(options.setup), format);
  acquire::SignalTable table = table_of(format);
  const acquire::SignalRoles roles = roles_of(table, options, format.device);
  LiveChannels out{.force = roles.force, .accel = roles.accel};
  if (!roles.has_force)
    throw InputError("no channel is a force", format.device, "name the hammer's channel in the set-up", {"setup"});
  out.force_number = format.number_of(roles.force);
  for (const std::size_t c : roles.accel) {
    out.accel_names.push_back(table.signals[c].name);
    out.accel_numbers.push_back(format.number_of(c));
  }
  const acquire::Record described = acquire::record_of_table(std::move(table), roles, options);
  out.force_to_N = described.force.to_SI;
  out.notes = std::move(device_notes);
  out.notes.insert(out.notes.end(), described.notes.begin(), described.notes.end());
  out.description.format = "HDF5";
  out.description.fs_Hz = format.fs_Hz;
  out.description.force = {.name = "force", .unit = "N", .measures = Quantity::force};
  for (std::size_t c = 0; c < described.accel.size(); ++c) {
    out.accel_to_mps2.push_back(described.accel[c].to_SI);
    out.description.accel.push_back(as_stored(described.accel[c], acquire::channel_name(c), "m/s^2"));
  }
  return out;
}

}  // namespace percuss::pipeline
