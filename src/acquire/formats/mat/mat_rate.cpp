#include "acquire/formats/mat/mat_rate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "acquire/channels/axis_unit.hpp"
#include "acquire/channels/signal_table.hpp"
#include "acquire/formats/mat/mat_description.hpp"
#include "acquire/record/sampling_rate.hpp"
#include "core/error.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/time_stamps.hpp"

namespace percuss::acquire {
namespace {

constexpr double kSingleEpsilon = static_cast<double>(std::numeric_limits<float>::epsilon());
constexpr double kRateTolerance = 1e-6;  // relative: single precision

bool is_time_vector(const MatVariable& variable) {
  const std::string name = bare_name(field_name(variable.name));
  const bool named = name == "t" || name == "time" || name == "ts" || name == "times" || name == "timedomain" ||
                     name == "timevector" || name == "tvec" || name == "timestamp";
  return named && !variable.is_text && !variable.is_complex() && is_mat_vector(variable);
}

// The value of a scalar, or of a field of a struct array if all its values are equal.
std::optional<double> single_number(const MatVariable& variable) {
  if (variable.size() == 0 || variable.is_text || variable.is_complex()) return std::nullopt;
  const double first = variable.real.front();
  const bool alike = std::all_of(variable.real.begin(), variable.real.end(), [&](double x) { return x == first; });
  return alike ? std::optional(first) : std::nullopt;
}

// `named`: the options name this variable.
double rate_of_times_Hz(const MatFile& file, const MatVariable& variable, bool named) {
  const std::string where = file.path + ": " + variable.name;
  const std::optional<double> to_s = s_per_unit(unit_in(file, variable.name));
  std::vector<double> times_s = variable.real;
  if (to_s) {
    for (double& t : times_s) t *= *to_s;
  }
  double largest = 0;
  for (const double t_s : times_s) largest = std::max(largest, std::abs(t_s));
  // Times may have been stored in single precision.
  const double resolution_s = 2 * largest * kSingleEpsilon;
  StampProblem problem;
  const std::vector<TimeStamps> rows{{.time_s = times_s, .resolution_s = resolution_s}};
  const auto rate = rate_of_time_stamps(rows, problem);
  if (rate) {
    if (!to_s && !named) {
      require_plausible_times(rate->fs_Hz, one_line(variable.name, 40), file.path,
                              "state the sampling rate, or store the unit beside the times");
    }
    return rate->fs_Hz;
  }
  throw InputError(problem.text, fmt::format("{}, number {}", where, problem.at + 1), "state the sampling rate",
                   {"fs"});
}

}  // namespace

std::string bare_name(std::string_view name) {
  std::string out = lower_case(name);
  std::erase(out, '_');
  return out;
}

std::string_view field_name(std::string_view name) { return name.substr(name.rfind('.') + 1); }

bool is_mat_vector(const MatVariable& variable) {
  const auto beyond_one = std::count_if(variable.shape.begin(), variable.shape.end(), [](auto n) { return n > 1; });
  return beyond_one == 1 && variable.size() > 1;
}

std::optional<double> mat_number(const MatFile& file, std::initializer_list<std::string_view> names) {
  for (const std::string_view wanted : names) {
    for (const MatVariable& variable : file.variables) {
      const std::string lower = lower_case(field_name(variable.name)), name = bare_name(lower);
      // A long name may have a prefix, such as force_samplerate. Short ones ("fs", "dt") also end other words.
      const bool ending = lower.size() > wanted.size() && name.ends_with(wanted) && wanted.size() > 4;
      if (name != wanted && !ending) continue;
      const std::optional<double> number = single_number(variable);
      if (number && (variable.size() == 1 || variable.name.find('.') != std::string::npos)) return number;
    }
  }
  return std::nullopt;
}

std::string mat_text(const MatFile& file, std::string_view name) {
  for (const MatVariable& variable : file.variables) {
    if (variable.is_text && lower_case(field_name(variable.name)) == name) return variable.text;
  }
  return {};
}

std::optional<double> mat_rate_Hz(const MatFile& file, const ReadOptions& options) {
  if (options.fs_Hz) return checked_rate_Hz(*options.fs_Hz, "the rate stated");
  if (!options.fs_variable.empty()) {
    const MatVariable* const named = find_variable(file, options.fs_variable);
    const std::string where = file.path + ": " + options.fs_variable;
    if (named == nullptr) throw InputError("no such variable", where, "name another, or state the rate in Hz", {"fs"});
    if (named->is_text || named->is_complex() || named->size() == 0)
      throw InputError("not a number", where, "name another, or state the rate in Hz", {"fs"});
    const std::optional<double> number = single_number(*named);
    return checked_rate_Hz(number ? *number : rate_of_times_Hz(file, *named, true), where);
  }
  std::optional<double> found_Hz = mat_number(file, {"fs", "fshz", "samplerate", "samplingrate", "samplefrequency",
                                                     "samplingfrequency", "samplefreq", "samplingfreq", "srate"});
  const auto dt_s = mat_number(file, {"dt", "dts", "deltat", "sampletime", "samplinginterval", "sampleinterval"});
  if (!found_Hz && dt_s && *dt_s > 0) found_Hz = 1 / *dt_s;
  if (found_Hz) checked_rate_Hz(*found_Hz, file.path);
  if (found_Hz && dt_s && !(std::abs(*found_Hz * *dt_s - 1) <= kRateTolerance)) {
    throw InputError(fmt::format("a rate of {} Hz, and {} s between samples", *found_Hz, *dt_s), file.path,
                     "state the right one", {"fs"});
  }
  if (found_Hz) return found_Hz;
  for (const MatVariable& variable : file.variables) {
    if (is_time_vector(variable)) return checked_rate_Hz(rate_of_times_Hz(file, variable, false), file.path);
  }
  return std::nullopt;
}

}  // namespace percuss::acquire
