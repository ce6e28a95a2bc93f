#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire::hdf5 {

/// What the shapes of /force and /accel mean together.
struct Layout {
  std::size_t rows = 0, channels = 0, samples = 0;
  bool force_has_rows = false;  // false: [samples]
  bool accel_has_rows = false, accel_has_channels = false;
};

/// errors  InputError when the shapes are empty, of other rank or contradict each other.
Layout layout_of(const InputDataSet& force, const InputDataSet& accel, const InputHdf5& file);
/// … without a force: two dimensions are [channels, samples].
Layout layout_of(const InputDataSet& accel, const InputHdf5& file);

/// Acceleration channels to be read, counted from 0, in the order wanted; without choice all that no set-up entry
/// ignores. errors  InputError for names of channels that are not there, here or in the set-up, and for roles that the
/// layout does not allow.
std::vector<std::size_t> chosen_channels(const ReadOptions& options, std::size_t channels, const std::string& path);

/// The set-up's entry for the force, or for acceleration channel `index` of `channels`; nullptr without one.
const ChannelSetup* force_setup(const ReadOptions& options);
const ChannelSetup* accel_setup(const ReadOptions& options, std::size_t index, std::size_t channels);

/// "accel 1" for channel 0.
std::string channel_name(std::size_t index);

/// "[5, 2, 1000]"
std::string shape_text(std::span<const std::size_t> shape);

}  // namespace percuss::acquire::hdf5
