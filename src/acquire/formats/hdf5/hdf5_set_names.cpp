#include "acquire/formats/hdf5/hdf5_set_names.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::acquire::hdf5 {
namespace {

constexpr std::size_t kNameBytesShown = 40;

std::string without_slash(const std::string& name) { return name.starts_with('/') ? name.substr(1) : name; }

// "accel", "accel 2", "2": channels of the accelerations, whose names are numbers.
bool is_channel_name(std::string name) {
  if (name.starts_with("accel")) name.erase(0, 5);
  if (name.starts_with(' ')) name.erase(0, 1);
  return std::all_of(name.begin(), name.end(), is_digit);
}

}  // namespace

std::string list_of_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + one_line(name, kNameBytesShown);
  return text.empty() ? "nothing" : text;
}

InputDataSet open_required(const InputHdf5& file, const std::string& name) {
  if (file.has(name)) return {file, name};
  throw InputError(
      "no data set /" + one_line(name, kNameBytesShown) + " among: " + list_of_names(file.data_paths(kNamesShown)),
      file.path(), "store force [hits, samples] and accel [hits, channels, samples], or name the data sets",
      {"force_channel", "accel_channel"});
}

SetNames take_set_names(const InputHdf5& file, ReadOptions& options) {
  SetNames names;
  const std::string force = without_slash(options.force_channel);
  const bool channel = force.starts_with("accel") && is_channel_name(force) && !file.has(force);
  if (!channel && !force.empty()) {
    names.force = force;
    options.force_channel = "force";
  }
  const auto& accel = options.accel_channels;
  const auto is_signal = [&](const std::string& name) {
    return is_channel_name(without_slash(name)) || (without_slash(name) == "force" && names.force == "force");
  };
  if (std::all_of(accel.begin(), accel.end(), is_signal)) return names;
  if (accel.size() > 1) {
    throw InputError("several data sets named for the accelerations", file.path(),
                     "name one that holds [hits, channels, samples]", {"accel_channel"});
  }
  names.accel = without_slash(accel.front());
  options.accel_channels.clear();
  return names;
}

bool gives_force_to_channel(const ReadOptions& options) {
  const bool by_option = !options.force_channel.empty() && options.force_channel != "force";
  return by_option || std::any_of(options.setup.begin(), options.setup.end(), [](const ChannelSetup& entry) {
           return entry.role == "force" && is_channel_name(without_slash(entry.name));
         });
}

}  // namespace percuss::acquire::hdf5
