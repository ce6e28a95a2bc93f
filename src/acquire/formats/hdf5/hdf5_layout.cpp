#include "acquire/formats/hdf5/hdf5_layout.hpp"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>

#include "core/error.hpp"

namespace percuss::acquire::hdf5 {
namespace {

constexpr std::size_t kFewestSamples = 2;
constexpr std::size_t kTransposedRatio = 16;  // a test has far fewer hits than samples per hit

void check_force_shape(const std::vector<std::size_t>& shape, const std::string& where) {
  if (shape.empty() || shape.size() > 2) {
    throw InputError("shape " + shape_text(shape), where, "store [hits, samples] or [samples]");
  }
  if (shape.size() == 2 && shape[0] == 0) throw InputError("no hits", where, "record at least one");
  if (shape.back() < kFewestSamples) {
    throw InputError(shape.back() == 0 ? "no samples" : "one sample per hit", where,
                     "store [hits, samples]; is it transposed?");
  }
  if (shape.size() == 2 && shape[0] > kTransposedRatio * shape[1]) {
    throw InputError("looks transposed: " + shape_text(shape) + " for [hits, samples]", where, "transpose it");
  }
}

bool is_force_name(const std::string& name) { return name == "force" || name == "/force"; }

/// The channel, counted from 0, that a name or 1-based number stands for.
std::optional<std::size_t> channel_named(std::string name, std::size_t channels) {
  if (name.starts_with('/')) name.erase(0, 1);
  if (name.starts_with("accel")) {
    name.erase(0, 5);
    if (name.empty() && channels == 1) return 0;
    if (name.starts_with(' ')) name.erase(0, 1);
  }
  std::size_t number = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data(), end, number);
  if (error != std::errc() || stop != end || number < 1 || number > channels) return std::nullopt;
  return number - 1;
}

std::string names_of(std::size_t channels) {
  return channels == 1 ? "the only one is " + channel_name(0)
                       : "there are " + channel_name(0) + " to " + channel_name(channels - 1);
}

void check_setup(const ChannelSetup& entry, std::size_t channels, const std::string& path) {
  const std::string where = path + ": channel set-up " + entry.name;
  const bool force = is_force_name(entry.name);
  if (!force && !channel_named(entry.name, channels)) {
    throw InputError("no such channel", where, "name force or an acceleration: " + names_of(channels));
  }
  const std::string own = force ? "force" : "acceleration";
  const bool fits = entry.role.empty() || entry.role == own || (!force && entry.role == "ignore");
  if (!fits) throw InputError("role " + entry.role + " for the " + own, where, "give the role " + own);
}

}  // namespace

std::string channel_name(std::size_t index) { return "accel " + std::to_string(index + 1); }

std::string shape_text(std::span<const std::size_t> shape) {
  std::string text;
  for (const std::size_t size : shape) text += (text.empty() ? "[" : ", ") + std::to_string(size);
  return text.empty() ? "of one number" : text + "]";
}

void check_accel_shape(const InputDataSet& accel, const InputHdf5& file) {
  const auto& a = accel.shape();
  if (a.empty()) throw InputError("one number", file.where("accel"), "store [hits, channels, samples]");
  if (accel.elements() == 0)
    throw InputError("empty: shape " + shape_text(a), file.where("accel"), "store [hits, channels, samples]");
}

Layout layout_of(const InputDataSet& accel, const InputHdf5& file) {
  check_accel_shape(accel, file);
  const auto& a = accel.shape();
  if (a.size() > 3) throw InputError("shape " + shape_text(a), file.where("accel"), "store [hits, channels, samples]");
  return {.rows = a.size() == 3 ? a[0] : 1,
          .channels = a.size() == 1 ? 1 : a[a.size() - 2],
          .samples = a.back(),
          .accel_has_rows = a.size() == 3,
          .accel_has_channels = a.size() > 1};
}

Layout layout_of(const InputDataSet& force, const InputDataSet& accel, const InputHdf5& file) {
  const auto &f = force.shape(), &a = accel.shape();
  check_force_shape(f, file.where("force"));
  check_accel_shape(accel, file);
  Layout layout{.rows = f.size() == 2 ? f[0] : 1, .samples = f.back(), .force_has_rows = f.size() == 2};
  // Two dimensions are [hits, samples] where the force has hits, else [channels, samples].
  layout.accel_has_rows = a.size() == 3 || (a.size() == 2 && layout.force_has_rows && a[0] == layout.rows);
  layout.accel_has_channels = a.size() == 3 || (a.size() == 2 && !layout.accel_has_rows);
  layout.channels = layout.accel_has_channels ? a[a.size() - 2] : 1;
  const std::size_t accel_rows = layout.accel_has_rows ? a[0] : 1;
  if (accel_rows != layout.rows || a.back() != layout.samples) {
    throw InputError("force " + shape_text(f) + " and accel " + shape_text(a) + " disagree", file.path(),
                     "store force [hits, samples] and accel [hits, channels, samples]");
  }
  return layout;
}

std::vector<std::size_t> chosen_channels(const ReadOptions& options, std::size_t channels, const std::string& path) {
  for (const ChannelSetup& entry : options.setup) check_setup(entry, channels, path);
  if (!options.force_channel.empty() && !is_force_name(options.force_channel)) {
    throw InputError("no force channel " + options.force_channel, path, "the only one is force");
  }
  std::vector<std::size_t> chosen;
  for (const std::string& name : options.accel_channels) {
    const auto index = channel_named(name, channels);
    if (!index) throw InputError("no acceleration channel " + name, path + ": /accel", names_of(channels));
    if (std::find(chosen.begin(), chosen.end(), *index) != chosen.end()) {
      throw InputError("acceleration channel " + name + " asked for twice", path + ": /accel", "name it once");
    }
    chosen.push_back(*index);
  }
  if (!chosen.empty()) return chosen;
  for (std::size_t index = 0; index < channels; ++index) {
    const ChannelSetup* const entry = accel_setup(options, index, channels);
    if (entry == nullptr || entry->role != "ignore") chosen.push_back(index);
  }
  if (chosen.empty()) throw InputError("every acceleration is ignored", path + ": channel set-up", "keep one");
  return chosen;
}

const ChannelSetup* force_setup(const ReadOptions& options) {
  for (const ChannelSetup& entry : options.setup) {
    if (is_force_name(entry.name)) return &entry;
  }
  return nullptr;
}

const ChannelSetup* accel_setup(const ReadOptions& options, std::size_t index, std::size_t channels) {
  for (const ChannelSetup& entry : options.setup) {
    if (channel_named(entry.name, channels) == index) return &entry;
  }
  return nullptr;
}

}  // namespace percuss::acquire::hdf5
