#include "commands/record/record_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "acquire/geometry/geometry.hpp"
#include "acquire/hits/time_selection.hpp"
#include "cli/analysis_flags.hpp"
#include "cli/option_error.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::tools {
namespace {

constexpr int kMaxPoint = 99'999;
constexpr double kLowestRate_Hz = 100;

// The rows of a record's geometry: row i is point i, NaN for points that the file does not list.
std::vector<std::vector<double>> geometry_rows(const acquire::Geometry& geometry, const std::string& path) {
  const bool coordinates = std::all_of(geometry.points.begin(), geometry.points.end(),
                                       [](const acquire::GeometryPoint& point) { return point.xyz_m.has_value(); });
  int last = 0;
  for (const acquire::GeometryPoint& point : geometry.points) last = std::max(last, point.point);
  if (last > kMaxPoint) throw InputError("a point's number is too large", path, "number points from 0");
  std::vector<std::vector<double>> rows(
      static_cast<std::size_t>(last) + 1,
      std::vector<double>(coordinates ? 3 : 2, std::numeric_limits<double>::quiet_NaN()));
  for (const acquire::GeometryPoint& point : geometry.points) {
    std::vector<double>& row = rows[static_cast<std::size_t>(point.point)];
    if (coordinates) {
      row.assign(point.xyz_m->begin(), point.xyz_m->end());
    } else {
      row = {point.position_m, point.angle_rad * kRadian_deg};
    }
  }
  return rows;
}

std::vector<pipeline::PrecisionGoal> goals_of(const RecordFlags& flags) {
  if (flags.until.empty() && !flags.is_given("until")) return {};
  try {
    return pipeline::parse_goals(flags.until);
  } catch (const InputError& error) {
    throw OptionError({"until"}, "is not understood: " + error.problem(), error.remedy());
  }
}

}  // namespace

pipeline::GuideOptions guide_options(const RecordFlags& flags) {
  pipeline::GuideOptions options;
  options.plan.hits = flags.hits;
  if (!flags.geometry.empty()) {
    const acquire::Geometry geometry = acquire::read_geometry(flags.geometry);
    options.plan.points.clear();
    for (const acquire::GeometryPoint& point : geometry.points) options.plan.points.push_back(point.point);
    options.geometry = geometry_rows(geometry, flags.geometry);
    for (const auto& line : geometry.lines) options.trace_lines.push_back({line[0], line[1]});
    options.trace_faces = geometry.faces;
  }
  options.date = flags.date;
  if (!flags.band.empty()) options.analysis.band_Hz = parse_band(flags.band, "band");
  options.analysis.classes.object = object_kind_of(flags.object);
  options.until = goals_of(flags);
  options.trigger_N = flags.trigger_N;
  options.pretrigger_s = flags.pretrigger_s;
  options.length_s = flags.length_s;
  options.sensor_moves = flags.roving == "sensor";
  const auto folder = std::filesystem::path(flags.output).parent_path();
  options.folder = folder.empty() ? "." : folder.string();
  return options;
}

void check_recording(const acquire::Record& description, const RecordFlags& flags) {
  const double fs_Hz = description.fs_Hz;
  if (fs_Hz < kLowestRate_Hz) {
    throw InputError(fmt::format("{:.6g} Hz is too low a sampling rate: a pulse has too few samples", fs_Hz),
                     flags.device,
                     flags.device.starts_with("file:") ? "analyse the file: percuss analyze or percuss info"
                                                       : fmt::format("choose {:.6g} Hz or more", kLowestRate_Hz),
                     {"fs"});
  }
  if (!flags.band.empty()) {
    const auto band_Hz = parse_band(flags.band, "band");
    if (band_Hz.second >= fs_Hz / 2) {
      throw InputError(
          fmt::format("the band ends at {:.6g} Hz, half the sampling rate is {:.6g} Hz", band_Hz.second, fs_Hz / 2),
          flags.device, "choose a lower end, or a higher rate", {"band", "fs"});
    }
  }
  const std::size_t pretrigger = acquire::pretrigger_samples(description, {.pretrigger_s = flags.pretrigger_s});
  if (pretrigger == 0)
    throw InputError("no samples before the blow", flags.device, "keep some ms before its peak", {"pretrigger"});
  const std::size_t length = acquire::selected_length(description, {.length_s = flags.length_s}).value_or(0);
  if (length > 0 && length < 2 * pretrigger) {
    throw InputError(fmt::format("the samples of a blow last {:.4g} s, of which {:.4g} s come before its peak",
                                 static_cast<double>(length) / fs_Hz, static_cast<double>(pretrigger) / fs_Hz),
                     flags.device, "state a longer length or a shorter pre-trigger", {"length", "pretrigger"});
  }
}

}  // namespace percuss::tools
