#include "percuss/record.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "acquire/channels/channel_setup.hpp"
#include "acquire/open_measurement.hpp"
#include "acquire/record/point_number.hpp"
#include "acquire/record/sample_limits.hpp"
#include "api/handles.hpp"
#include "core/error.hpp"
#include "pipeline/run_analyses.hpp"

namespace percuss {
namespace api {

Record make_record(acquire::Record record) {
  return Record(std::make_shared<const RecordData>(RecordData{std::move(record)}));
}

Channel channel_of(const acquire::SignalInfo& signal) {
  return {.name = signal.name, .unit = signal.unit, .angle_rad = signal.angle_rad, .position_m = signal.position_m};
}

acquire::ReadOptions read_options(const ReadOptions& options) {
  acquire::ReadOptions out;
  out.fs_Hz = options.fs_Hz;
  out.fs_variable = options.fs_variable;
  out.df_Hz = options.df_Hz;
  out.force_channel = options.force_channel;
  out.accel_channels = options.accel_channel;
  out.force_unit = options.force_unit;
  out.accel_unit = options.unit;
  out.force_scale = options.force_scale;
  out.accel_scale = options.accel_scale;
  out.force_sensitivity_V_per_N = options.force_sensitivity_VpN;
  out.accel_sensitivity_V_per_mps2 = options.accel_sensitivity_Vpmps2;
  out.pressure_sensitivity_V_per_Pa = options.pressure_sensitivity_VpPa;
  out.angle_rad = options.angle_rad;
  out.position_m = options.position_m;
  if (!options.setup.empty()) out.setup = acquire::read_channel_setup(options.setup);
  out.force_optional = options.force_optional;
  out.sandboxed = !options.trust_input;
  return out;
}

acquire::Record record_of_one_run(const Record& record) {
  const acquire::Record& its = record.data().record;
  const bool several = std::any_of(its.rows.begin(), its.rows.end(),
                                   [&](const acquire::RowInfo& row) { return row.run != its.rows.front().run; });
  if (several) throw InputError("several runs", its.source(), "take each of Record::runs() by itself");
  return its;
}

namespace {

acquire::FileGrouping grouping(FileGrouping files) {
  if (files == FileGrouping::points) return acquire::FileGrouping::points;
  return files == FileGrouping::hits ? acquire::FileGrouping::hits : acquire::FileGrouping::automatic;
}

constexpr const char* kArrays = "arrays";

void require_samples(const std::vector<double>& samples, std::size_t count) {
  if (samples.size() != count)
    throw InputError("signals of one row differ in length", kArrays, "give equally many samples");
  for (const double sample : samples) {
    if (!(std::abs(sample) <= acquire::kMaxSample))
      throw InputError("a sample is too large or not a finite number", kArrays, "leave the row out");
  }
}

void require_shapes(const RecordArrays& arrays) {
  const std::size_t rows = arrays.accel_mps2.size();
  if (rows == 0 || arrays.accel_mps2.front().empty())
    throw InputError("no acceleration", kArrays, "give accel_mps2 as [rows][channels][samples]");
  if (!(std::isfinite(arrays.fs_Hz) && arrays.fs_Hz > 0))
    throw InputError("no sampling rate", kArrays, "give fs_Hz above 0", {"fs"});
  if (!arrays.force_N.empty() && arrays.force_N.size() != rows)
    throw InputError("force and acceleration differ in rows", kArrays, "give one force per row");
  if (!arrays.point.empty() && arrays.point.size() != rows)
    throw InputError("points and rows differ in number", kArrays, "give one point per row");
  for (const int point : arrays.point) acquire::require_point_number(point, kArrays);
  const std::size_t channels = arrays.accel_mps2.front().size();
  for (const std::vector<double>* places : {&arrays.angle_rad, &arrays.position_m}) {
    if (!places->empty() && places->size() != channels) {
      throw InputError("angle_rad or position_m does not have one value per channel", kArrays,
                       "give one value per channel, or none");
    }
  }
  for (std::size_t row = 0; row < rows; ++row) {
    if (arrays.accel_mps2[row].size() != channels)
      throw InputError("rows differ in channels", kArrays, "give the same channels in every row");
    const std::size_t samples = arrays.accel_mps2[row].front().size();
    if (samples < 2) throw InputError("a row has fewer than two samples", kArrays, "leave the row out");
    for (const auto& channel : arrays.accel_mps2[row]) require_samples(channel, samples);
    if (!arrays.force_N.empty()) require_samples(arrays.force_N[row], samples);
  }
}

void require_place(const acquire::Record& record, std::size_t row, std::size_t channel, std::size_t first = 0,
                   std::size_t count = 0) {
  if (row >= record.rows.size()) throw InputError("there is no such row", record.source(), "rows count from 0");
  if (channel >= std::max<std::size_t>(record.accel.size(), 1))
    throw InputError("there is no such channel", record.source(), "channels count from 0");
  const std::size_t samples = record.rows[row].samples;
  if (first > samples || count > samples - first)
    throw InputError("there is no such sample", record.source(), "samples count from 0 within each row");
}

}  // namespace
}  // namespace api

RecordDescription Record::description() const {
  const acquire::Record& record = data_->record;
  RecordDescription out{.paths = {},
                        .format = record.format,
                        .fs_Hz = record.fs_Hz,
                        .has_force = record.has_force,
                        .force = api::channel_of(record.force),
                        .accel = {},
                        .rows = {},
                        .continuous = record.continuous,
                        .notes = record.notes};
  for (const acquire::InputFile& file : record.files) out.paths.push_back(file.path);
  for (const acquire::SignalInfo& signal : record.accel) out.accel.push_back(api::channel_of(signal));
  for (const acquire::RowInfo& row : record.rows) {
    out.rows.push_back({.samples = row.samples,
                        .path = record.files.empty() ? "" : record.files.at(row.file).path,
                        .point = row.point,
                        .run = row.run});
  }
  return out;
}

double Record::fs_Hz() const { return data_->record.fs_Hz; }
std::size_t Record::rows() const { return data_->record.rows.size(); }
std::size_t Record::channels() const { return data_->record.accel.size(); }

void Record::read_force_N(std::size_t row, std::size_t first, std::size_t count, double* out) const {
  api::require_place(data_->record, row, 0, first, count);
  data_->record.read_force_N(row, first, std::span(out, count));
}

void Record::read_accel_mps2(std::size_t row, std::size_t channel, std::size_t first, std::size_t count,
                             double* out) const {
  api::require_place(data_->record, row, channel, first, count);
  data_->record.read_accel_mps2(row, channel, first, std::span(out, count));
}

std::vector<double> Record::force_N(std::size_t row) const {
  api::require_place(data_->record, row, 0);
  std::vector<double> out(data_->record.rows[row].samples);
  read_force_N(row, 0, out.size(), out.data());
  return out;
}

std::vector<double> Record::accel_mps2(std::size_t row, std::size_t channel) const {
  api::require_place(data_->record, row, channel);
  std::vector<double> out(data_->record.rows[row].samples);
  read_accel_mps2(row, channel, 0, out.size(), out.data());
  return out;
}

std::vector<Record> Record::runs() const {
  std::vector<Record> out;
  for (auto& [run, part] : pipeline::split_runs(data_->record)) out.push_back(api::make_record(std::move(part)));
  return out;
}

Record open_record(const std::string& path, const ReadOptions& options) {
  return api::make_record(acquire::open_record(path, api::read_options(options)));
}

Record open_record(const std::vector<std::string>& paths, const ReadOptions& options) {
  if (paths.empty()) throw InputError("no file", "paths", "name at least one");
  const acquire::ReadOptions common = api::read_options(options);
  if (common.force_scale.size() > 1 && common.force_scale.size() != paths.size()) {
    throw InputError("the scales and the files differ in number", "force_scale", "give one for all or one per file",
                     {"force_scale"});
  }
  std::vector<acquire::Record> records;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    acquire::ReadOptions of_file = common;
    if (common.force_scale.size() > 1) of_file.force_scale = {common.force_scale[i]};
    records.push_back(acquire::open_record(paths[i], of_file));
  }
  return api::make_record(acquire::join_records(std::move(records), api::grouping(options.files)));
}

Record record_from_arrays(RecordArrays arrays) {
  api::require_shapes(arrays);
  const bool has_force = !arrays.force_N.empty();
  if (!has_force) {
    for (const auto& row : arrays.accel_mps2) arrays.force_N.emplace_back(row.front().size());
  }
  acquire::Record record =
      acquire::record_in_memory(arrays.fs_Hz, std::move(arrays.force_N), std::move(arrays.accel_mps2));
  record.format = api::kArrays;
  record.force.unit = "N";
  record.has_force = has_force;
  record.continuous = arrays.continuous;
  for (std::size_t row = 0; row < arrays.point.size(); ++row) record.rows[row].point = arrays.point[row];
  for (std::size_t c = 0; c < arrays.angle_rad.size(); ++c) record.accel[c].angle_rad = arrays.angle_rad[c];
  for (std::size_t c = 0; c < arrays.position_m.size(); ++c) record.accel[c].position_m = arrays.position_m[c];
  return api::make_record(std::move(record));
}

}  // namespace percuss
