#include "acquire/formats/mat/mat_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include "acquire/formats/mat/mat_description.hpp"
#include "acquire/formats/mat/mat_rate.hpp"

namespace percuss::acquire {
namespace {

// "accel 2": a variable's name and a number.
struct ChannelName {
  std::string variable;
  std::size_t number = 0;  // from 1
};

std::optional<ChannelName> channel_name_in(const std::string& text) {
  const auto blank = text.rfind(' ');
  if (blank == std::string::npos || blank == 0) return std::nullopt;
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + blank + 1, end, number);
  if (error != std::errc() || stop != end || number < 1) return std::nullopt;
  return ChannelName{text.substr(0, blank), number};
}

// The index of the dimension of the channels; nothing for a variable of one channel.
std::optional<std::size_t> channel_dimension(const MatFile& file, const MatVariable& variable) {
  const auto& shape = variable.shape;
  if (shape.size() == 3) return 1;
  if (shape.size() != 2) return std::nullopt;
  const std::size_t time = std::max(shape[0], shape[1]);
  const bool over_time = std::any_of(file.variables.begin(), file.variables.end(), [&](const MatVariable& other) {
    return may_be_signal(other) && is_mat_vector(other) && other.size() == time;
  });
  return over_time && shape[0] != shape[1] ? std::optional<std::size_t>(shape[0] < shape[1] ? 0 : 1) : std::nullopt;
}

MatVariable channel_of(const MatVariable& variable, std::size_t dimension, std::size_t channel) {
  std::size_t inner = 1;  // numbers of one channel that lie together
  for (std::size_t d = 0; d < dimension; ++d) inner *= variable.shape[d];
  const std::size_t step = inner * variable.shape[dimension];
  MatVariable out{.name = fmt::format("{} {}", variable.name, channel + 1), .shape = variable.shape};
  out.shape[dimension] = 1;
  if (out.shape.size() == 3) out.shape.erase(out.shape.begin() + 1);
  const auto take = [&](const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t first = channel * inner; first < from.size(); first += step) {
      const auto begin = from.begin() + static_cast<std::ptrdiff_t>(first);
      to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(inner));
    }
  };
  take(variable.real, out.real);
  take(variable.imaginary, out.imaginary);
  return out;
}

// The names of signals to which the user gives a role of their own.
std::vector<std::string> names_with_roles(const MatFile& file, const ReadOptions& options) {
  std::vector<std::string> names{options.force_channel};
  for (const ChannelSetup& entry : options.setup) {
    if (entry.role != "ignore") names.push_back(entry.name);
  }
  const auto& accel = options.accel_channels;
  const bool variables = std::any_of(accel.begin(), accel.end(),
                                     [&](const std::string& name) { return find_variable(file, name) != nullptr; });
  if (variables) names.insert(names.end(), accel.begin(), accel.end());
  return names;
}

}  // namespace

std::map<std::string, MatChannel> split_channels(MatFile& file, const ReadOptions& options) {
  std::map<std::string, MatChannel> split;
  for (const std::string& text : names_with_roles(file, options)) {
    const auto name = channel_name_in(text);
    if (!name || find_variable(file, text) != nullptr) continue;
    const MatVariable* const found = find_variable(file, name->variable);
    if (found == nullptr || !may_be_signal(*found)) continue;
    const auto dimension = channel_dimension(file, *found);
    if (!dimension || name->number > found->shape[*dimension]) continue;
    const std::size_t place = static_cast<std::size_t>(found - file.variables.data());
    const MatVariable whole = std::move(file.variables[place]);
    file.variables.erase(file.variables.begin() + static_cast<std::ptrdiff_t>(place));
    const std::size_t channels = whole.shape[*dimension];
    for (std::size_t c = 0; c < channels; ++c) {
      MatVariable channel = channel_of(whole, *dimension, c);
      split[channel.name] = {whole.name, c, channels};
      file.variables.insert(file.variables.begin() + static_cast<std::ptrdiff_t>(place + c), std::move(channel));
    }
  }
  return split;
}

}  // namespace percuss::acquire
