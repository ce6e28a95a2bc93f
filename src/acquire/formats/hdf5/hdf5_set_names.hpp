#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire::hdf5 {

/// The largest number of names that a message lists.
inline constexpr std::size_t kNamesShown = 12;

/// "force, accel", or "nothing".
std::string list_of_names(const std::vector<std::string>& names);

/// The data set of this name.
/// errors  InputError with the names that the file has.
InputDataSet open_required(const InputHdf5& file, const std::string& name);

/// The data sets of a record, as paths without the first slash.
struct SetNames {
  std::string force = "force", accel = "accel";
};

/// Takes the names of data sets out of the options, which then name only signals of these sets.
/// errors  InputError: several data sets named for the accelerations.
SetNames take_set_names(const InputHdf5& file, ReadOptions& options);

/// Whether the options or the set-up name a channel of the accelerations as the force.
bool gives_force_to_channel(const ReadOptions& options);

}  // namespace percuss::acquire::hdf5
