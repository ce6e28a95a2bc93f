#pragma once
#include <string>
#include <vector>

#include "acquire/formats/mat/mat_file.hpp"

namespace percuss::acquire {

/// The place of a signal in a variable: sample i of a row is number offset + row · row_stride + i · sample_stride.
struct MatSignal {
  std::size_t offset = 0, row_stride = 0, sample_stride = 1;
};

struct MatLayout {
  std::size_t rows = 1, samples = 0;
  bool time_last = false;  // true: [hits, samples]; false: [samples, hits]
  bool of_force = true;    // false: of the first response, where no force was recorded
  MatSignal signal;
};

/// The layout of a force: a vector, or a matrix whose longer side is time.
/// errors  InputError: another shape, or a square.
MatLayout force_layout(const MatVariable& variable, const std::string& file);

/// The layout of a response where no force was recorded: its rows and samples, and whether time is last. Its longest
/// side is time. Three dimensions are [hits, channels, samples] or [samples, channels, hits]. Two are time and the
/// channels of one row; or time and the hits, if the shorter side equals `hits` (the size of a variable with a number
/// per hit).
/// errors  InputError: another shape, or no longest side.
MatLayout response_layout(const MatVariable& variable, std::size_t hits, const std::string& file);

/// The channels of an acceleration sampled with a force (or first response) of layout `force`.
/// errors  InputError: the sizes disagree.
std::vector<MatSignal> accel_layout(const MatVariable& variable, const MatLayout& force, const std::string& file);

}  // namespace percuss::acquire
