// percuss_reading_speed FILE...
// Compares the speed of reading all samples of a record with the speed of reading its bytes (read() in blocks of 128
// KiB, like cat), both from the page cache and in the same run. Each time is the best of several in alternation.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "acquire/open_measurement.hpp"
#include "acquire/record/record.hpp"
#include "read_bytes.hpp"
#include "wall_time.hpp"

namespace percuss {
namespace {

constexpr double kMin_s = 3;  // for each file
constexpr std::size_t kBlock_samples = std::size_t{1} << 15U;

// Reads every signal block by block, like an analysis.
void read_all(const std::string& path) {
  static std::vector<double> block(kBlock_samples);
  const acquire::Record record = acquire::open_record(path);
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    for (std::size_t signal = 0; signal <= record.accel.size(); ++signal) {
      for (std::size_t first = 0; first < record.rows[row].samples; first += block.size()) {
        const auto out = std::span(block).first(std::min(block.size(), record.rows[row].samples - first));
        if (signal == 0) record.read_force_N(row, first, out);
        if (signal > 0) record.read_accel_mps2(row, signal - 1, first, out);
      }
    }
  }
}

void measure(const std::string& path) {
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  double cat_s = 1e9, read_s = 1e9, spent_s = 0;
  for (int turn = 0; turn < 3 || spent_s < kMin_s; ++turn) {
    const double one_s = seconds_of([&] { read_bytes_of(path); }), other_s = seconds_of([&] { read_all(path); });
    cat_s = std::min(cat_s, one_s);
    read_s = std::min(read_s, other_s);
    spent_s += one_s + other_s;
  }
  fmt::print("{:>8.0f} MB/s, {:>5.2f} of cat's {:>6.0f} MB/s: {} ({:.0f} MB)\n", megabytes / read_s, cat_s / read_s,
             megabytes / cat_s, std::filesystem::path(path).filename().string(), megabytes);
}

}  // namespace
}  // namespace percuss

int main(int argc, char** argv) {
  try {
    for (int i = 1; i < argc; ++i) percuss::measure(argv[i]);
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return EXIT_FAILURE;
  }
}
