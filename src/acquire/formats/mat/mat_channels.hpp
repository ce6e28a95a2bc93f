#pragma once
#include <cstddef>
#include <map>
#include <string>

#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// A channel that was split off a variable with several channels.
struct MatChannel {
  std::string variable;      // name of the variable that held it
  std::size_t channel = 0;   // counted from 0
  std::size_t channels = 0;  // number of channels of the variable
};

/// Turns a variable of several channels into one variable per channel, "accel 1", "accel 2", …, if such a channel has a
/// role of its own: the options name it as the force, the options name it and a whole variable as accelerations, or the
/// set-up names it.
/// Returns the new variables by their names. Three dimensions are [hits, channels, samples] or [samples, channels,
/// hits]; two are time and channels if another variable is a vector over this time.
std::map<std::string, MatChannel> split_channels(MatFile& file, const ReadOptions& options);

}  // namespace percuss::acquire
