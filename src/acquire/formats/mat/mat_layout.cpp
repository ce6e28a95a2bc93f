#include "acquire/formats/mat/mat_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/io/counted_words.hpp"

namespace percuss::acquire {
namespace {

struct Axis {
  std::size_t size, stride;
};

// Dimensions of more than one element, the fastest first.
std::vector<Axis> axes_of(const MatVariable& variable) {
  std::vector<Axis> axes;
  std::size_t stride = 1;
  for (const std::size_t size : variable.shape) {
    if (size > 1) axes.push_back({size, stride});
    stride *= size;
  }
  return axes;
}

[[noreturn]] void refuse_shape(const MatVariable& variable, const std::string& file, const std::string& why) {
  throw InputError(fmt::format("{} is {}: {}", one_line(variable.name, 63), shape_name(variable.shape), why), file,
                   "store force [hits, samples] and accel [hits, channels, samples]");
}

}  // namespace

MatLayout force_layout(const MatVariable& variable, const std::string& file) {
  const auto axes = axes_of(variable);
  if (axes.empty() || axes.size() > 2) refuse_shape(variable, file, "a force has one or two dimensions");
  if (axes.size() == 1) {
    const bool last = variable.shape.back() > 1;
    return {.rows = 1, .samples = axes[0].size, .time_last = last, .signal = {0, 0, axes[0].stride}};
  }
  if (axes[0].size == axes[1].size) refuse_shape(variable, file, "as many hits as samples, so that time is unclear");
  const bool last = axes[1].size > axes[0].size;
  const Axis time = axes[last ? 1 : 0], rows = axes[last ? 0 : 1];
  return {.rows = rows.size, .samples = time.size, .time_last = last, .signal = {0, rows.stride, time.stride}};
}

MatLayout response_layout(const MatVariable& variable, std::size_t hits, const std::string& file) {
  const auto axes = axes_of(variable);
  if (axes.empty() || variable.shape.size() > 3) refuse_shape(variable, file, "a response has up to three dimensions");
  const auto longest =
      std::max_element(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.size < b.size; });
  const auto as_long = [&](const Axis& axis) { return axis.size == longest->size; };
  if (std::count_if(axes.begin(), axes.end(), as_long) > 1)
    refuse_shape(variable, file, "two sides are equally long, so that time is unclear");
  MatLayout out{
      .samples = longest->size, .time_last = variable.shape.back() == longest->size, .of_force = false, .signal = {}};
  if (variable.shape.size() == 3) {
    if (!out.time_last && variable.shape.front() != longest->size)
      refuse_shape(variable, file, "time is neither the first dimension nor the last");
    out.rows = out.time_last ? variable.shape.front() : variable.shape.back();
  } else if (axes.size() == 2 && axes[out.time_last ? 0 : 1].size == hits) {
    out.rows = hits;
  }
  return out;
}

std::vector<MatSignal> accel_layout(const MatVariable& variable, const MatLayout& force, const std::string& file) {
  std::vector<Axis> axes = axes_of(variable);
  const auto is_time = [&](const Axis& axis) { return axis.size == force.samples; };
  const auto disagree = [&] {
    refuse_shape(variable, file,
                 fmt::format("{} has {} hit{} of {} sample{}", force.of_force ? "the force" : "the first response",
                             force.rows, plural(force.rows), force.samples, plural(force.samples)));
  };
  // Where two dimensions are equally long, time is the same dimension as in the force.
  auto time = force.time_last ? std::find_if(axes.rbegin(), axes.rend(), is_time).base()
                              : std::find_if(axes.begin(), axes.end(), is_time);
  if (force.time_last && time != axes.begin()) --time;
  if (axes.empty() || time == axes.end() || !is_time(*time) || axes.size() > 3) disagree();
  const Axis samples = *time;
  const bool last = time + 1 == axes.end() && axes.size() > 1;
  axes.erase(time);
  Axis rows{1, 0}, channels{1, 0};
  if (axes.size() == 1) {
    (force.rows > 1 ? rows : channels) = axes[0];
  } else if (axes.size() == 2) {
    rows = axes[last ? 0 : 1];
    channels = axes[last ? 1 : 0];
    if (rows.size != force.rows) std::swap(rows, channels);
  }
  if (rows.size != force.rows) disagree();
  constexpr std::size_t kMaxMatChannels = 100'000;
  if (channels.size > kMaxMatChannels) disagree();
  std::vector<MatSignal> out(channels.size);
  for (std::size_t c = 0; c < out.size(); ++c) out[c] = {c * channels.stride, rows.stride, samples.stride};
  return out;
}

}  // namespace percuss::acquire
