#include "scaling_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "acquire/write_record.hpp"
#include "synth/synthesise.hpp"

namespace percuss::accuracy {
namespace {

constexpr std::size_t kDifferent = 16;

// Turns runs into channels: the same hits, each channel with its own noise.
acquire::Record runs_as_channels(acquire::Record record, std::size_t runs) {
  const std::size_t rows = record.rows.size() / runs, sensors = record.accel.size();
  const auto read = record.read_accel_mps2;
  record.read_accel_mps2 = [=](std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    read(row + channel / sensors * rows, channel % sensors, first, out);
  };
  record.rows.resize(rows);
  const std::vector<acquire::SignalInfo> of_one_run = record.accel;
  for (std::size_t run = 1; run < runs; ++run)
    record.accel.insert(record.accel.end(), of_one_run.begin(), of_one_run.end());
  return record;
}

}  // namespace

std::vector<std::string> one_file(const synth::SynthSpec& spec, const std::string& folder) {
  std::string path = folder + "/test.h5";
  acquire::write_hdf5(path, runs_as_channels(synth::synthesise(spec).record, spec.runs), true);
  return {std::move(path)};
}

std::vector<std::string> many_files(synth::SynthSpec spec, std::size_t count, const std::string& folder) {
  spec.hits = std::min(count, kDifferent);
  const acquire::Record record = synth::synthesise(spec).record;
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < count; ++i) {
    paths.push_back(fmt::format("{}/hit-{:05}.csv", folder, i));
    if (i >= kDifferent) {
      std::filesystem::copy_file(paths[i - kDifferent], paths.back(),
                                 std::filesystem::copy_options::overwrite_existing);
      continue;
    }
    std::size_t row = 0;
    acquire::write_record(paths.back(),
                          acquire::select_rows(record, [&](const acquire::RowInfo&) { return row++ == i; }), true);
  }
  return paths;
}

}  // namespace percuss::accuracy
