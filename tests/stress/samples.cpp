#include "samples.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/units.hpp"

namespace percuss::stress {
namespace {

template <class Change>
void change_force(Samples& samples, Change change) {
  for (auto& row : samples.force_N) {
    for (double& x : row) x = change(x);
  }
}

template <class Change>
void change_accel(Samples& samples, Change change) {
  for (auto& row : samples.accel_mps2) {
    for (auto& channel : row) {
      for (double& x : channel) x = change(x);
    }
  }
}

double largest_accel(const Samples& samples) {
  double largest = 0;
  for (const auto& row : samples.accel_mps2) {
    for (const auto& channel : row) {
      for (const double x : channel) largest = std::max(largest, std::abs(x));
    }
  }
  return largest;
}

}  // namespace

Samples samples_of(const acquire::Record& record) {
  Samples samples{.fs_Hz = record.fs_Hz};
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const std::size_t count = record.rows[row].samples;
    std::vector<double> x(count);
    record.read_force_N(row, 0, x);
    samples.force_N.push_back(x);
    samples.accel_mps2.emplace_back();
    for (std::size_t c = 0; c < record.accel.size(); ++c) {
      record.read_accel_mps2(row, c, 0, x);
      samples.accel_mps2.back().push_back(x);
    }
  }
  return samples;
}

acquire::Record record_of(Samples samples, const acquire::Record& like) {
  acquire::Record record =
      acquire::record_in_memory(samples.fs_Hz, std::move(samples.force_N), std::move(samples.accel_mps2));
  if (record.accel.size() == like.accel.size()) record.accel = like.accel;
  for (std::size_t row = 0; row < std::min(record.rows.size(), like.rows.size()); ++row)
    record.rows[row].point = like.rows[row].point;
  record.continuous = like.continuous;
  return record;
}

void scale(Samples& samples, double force, double accel) {
  change_force(samples, [force](double x) { return x * force; });
  change_accel(samples, [accel](double x) { return x * accel; });
}

void cut(Samples& samples, std::size_t count) {
  for (auto& row : samples.force_N) row.resize(std::min(row.size(), count));
  for (auto& row : samples.accel_mps2) {
    for (auto& channel : row) channel.resize(std::min(channel.size(), count));
  }
}

void round_to_float(Samples& samples) {
  const auto rounded = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  change_force(samples, rounded);
  change_accel(samples, rounded);
}

void swap_force_and_first_accel(Samples& samples) {
  for (std::size_t row = 0; row < samples.force_N.size(); ++row)
    std::swap(samples.force_N[row], samples.accel_mps2[row].front());
}

void add_hum(Samples& samples, double mains_Hz, double fraction) {
  const double amplitude = fraction * largest_accel(samples);
  for (std::size_t row = 0; row < samples.accel_mps2.size(); ++row) {
    const double phase = 2.4 * static_cast<double>(row);  // about the golden angle: no two rows have equal phases
    for (auto& channel : samples.accel_mps2[row]) {
      for (std::size_t n = 0; n < channel.size(); ++n) {
        const double turn = kTwoPi * mains_Hz * static_cast<double>(n) / samples.fs_Hz + phase;
        channel[n] += amplitude * (std::sin(turn) + std::sin(3 * turn) + std::sin(5 * turn));
      }
    }
  }
}

}  // namespace percuss::stress
