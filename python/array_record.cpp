#include "array_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>

#include "acquire/channels/signal_table.hpp"
#include "acquire/record/sample_limits.hpp"
#include "core/error.hpp"

namespace percuss::python {
namespace {

// Calls the function with a null pointer of the number type.
template <class Function>
void with_type(NumberType type, const Function& function) {
  switch (type) {
    case NumberType::float64:
      return function(static_cast<const double*>(nullptr));
    case NumberType::float32:
      return function(static_cast<const float*>(nullptr));
    case NumberType::int8:
      return function(static_cast<const std::int8_t*>(nullptr));
    case NumberType::int16:
      return function(static_cast<const std::int16_t*>(nullptr));
    case NumberType::int32:
      return function(static_cast<const std::int32_t*>(nullptr));
    case NumberType::int64:
      return function(static_cast<const std::int64_t*>(nullptr));
    case NumberType::uint8:
      return function(static_cast<const std::uint8_t*>(nullptr));
    case NumberType::uint16:
      return function(static_cast<const std::uint16_t*>(nullptr));
    case NumberType::uint32:
      return function(static_cast<const std::uint32_t*>(nullptr));
    case NumberType::uint64:
      return function(static_cast<const std::uint64_t*>(nullptr));
  }
}

const std::byte* sample_at(const StridedSamples& signal, std::size_t index) {
  return signal.first + static_cast<std::ptrdiff_t>(index) * signal.step_bytes;
}

template <class Number>
double number_at(const std::byte* at) {
  Number number;
  std::memcpy(&number, at, sizeof number);  // the source may be unaligned
  return static_cast<double>(number);
}

void read_strided(const StridedSamples& signal, std::size_t first, std::span<double> out) {
  with_type(signal.type, [&]<class Number>(const Number*) {
    const std::byte* at = sample_at(signal, first);
    for (double& value : out) {
      value = number_at<Number>(at);
      at += signal.step_bytes;
    }
  });
}

const StridedSamples& strided_samples_of(const ArrayTest& test, std::size_t row, std::size_t signal) {
  const ArrayRow& array_row = test.rows.at(row);
  if (!test.has_force) return array_row.accel.at(signal);
  return signal == 0 ? array_row.force : array_row.accel.at(signal - 1);
}

bool is_contiguous_double(const StridedSamples& signal) {
  return signal.type == NumberType::float64 && signal.step_bytes == sizeof(double) &&
         reinterpret_cast<std::uintptr_t>(signal.first) % alignof(double) == 0;
}

acquire::SignalTable table_of(const std::shared_ptr<const ArrayTest>& test) {
  acquire::SignalTable table{
      .format = "arrays", .fs_Hz = test->fs_Hz, .continuous = test->continuous, .geometry = test->geometry};
  const std::size_t channels = test->rows.empty() ? 0 : test->rows.front().accel.size();
  const std::size_t forces = test->has_force ? 1 : 0;
  for (std::size_t i = 0; i < forces + channels; ++i) {
    const bool is_force = i < forces;
    const std::string name = is_force ? "force" : fmt::format("accel {}", i - forces + 1);
    table.signals.push_back({.name = i < test->names.size() ? test->names[i] : name, .unit = is_force ? "N" : "m/s^2"});
  }
  for (const ArrayRow& row : test->rows) {
    table.rows.push_back(
        {.samples = row.accel.empty() ? row.force.samples : row.accel.front().samples, .point = row.point});
  }
  table.read = [test](std::size_t row, std::size_t signal, std::size_t first, std::span<double> out) {
    read_strided(strided_samples_of(*test, row, signal), first, out);
  };
  return table;
}

// For each signal of each row, whether its samples have been checked.
struct CheckedSignals {
  std::vector<std::atomic<bool>> flags;
  explicit CheckedSignals(std::size_t count) : flags(count) {}
};

// A view of the samples, whose range is checked once. `read` throws the InputError for a sample that is out of range.
template <class Read>
std::span<const double> checked_view(const StridedSamples& signal, std::atomic<bool>& checked, const Read& read) {
  const std::span<const double> all(reinterpret_cast<const double*>(signal.first), signal.samples);
  if (checked.load(std::memory_order_relaxed)) return all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::abs(all[i]) <= acquire::kMaxSample) continue;
    double sample = 0;
    read(i, std::span(&sample, 1));
  }
  checked.store(true, std::memory_order_relaxed);
  return all;
}

void view_forces(acquire::Record& record, const std::shared_ptr<const ArrayTest>& test) {
  const auto checked = std::make_shared<CheckedSignals>(test->rows.size());
  const auto read = record.read_force_N;
  record.read_force_N = {read, [test, read, checked](std::size_t row) {
                           return checked_view(test->rows[row].force, checked->flags[row],
                                               [&](std::size_t at, std::span<double> out) { read(row, at, out); });
                         }};
}

void view_responses(acquire::Record& record, const std::shared_ptr<const ArrayTest>& test) {
  const std::size_t channels = record.accel.size();
  const auto checked = std::make_shared<CheckedSignals>(test->rows.size() * channels);
  const auto read = record.read_accel_mps2;
  record.read_accel_mps2 = {read, [test, read, checked, channels](std::size_t row, std::size_t channel) {
                              return checked_view(
                                  test->rows[row].accel[channel], checked->flags[row * channels + channel],
                                  [&](std::size_t at, std::span<double> out) { read(row, channel, at, out); });
                            }};
}

}  // namespace

std::uint64_t sample_checksum(const ArrayTest& test) {
  constexpr std::size_t kMaxSignals = 64, kNumbers = 512;
  constexpr std::uint64_t kOffset = 14695981039346656037ULL, kPrime = 1099511628211ULL;  // FNV-1a, a number at a time
  const std::size_t signals =
      test.rows.empty() ? 0 : test.rows.front().accel.size() + static_cast<std::size_t>(test.has_force);
  const std::size_t series = test.rows.size() * signals, sampled = std::min(series, kMaxSignals);
  std::uint64_t sum = kOffset;
  for (std::size_t i = 0; i < sampled; ++i) {
    const std::size_t at = i * series / sampled;
    const StridedSamples& signal = strided_samples_of(test, at / signals, at % signals);
    const std::size_t numbers = std::min(signal.samples, kNumbers / sampled);
    with_type(signal.type, [&]<class Number>(const Number*) {
      for (std::size_t n = 0; n < numbers; ++n) {
        const double value = number_at<Number>(sample_at(signal, n * signal.samples / numbers));
        sum = (sum ^ std::bit_cast<std::uint64_t>(value)) * kPrime;
        sum ^= sum >> 32U;
      }
    });
  }
  return sum;
}

acquire::Record record_of_arrays(const std::shared_ptr<const ArrayTest>& test, const acquire::ReadOptions& options) {
  const acquire::SignalTable table = table_of(test);
  // The arrays keep their roles unless the options choose signals.
  const bool chosen = !options.force_channel.empty() || !options.accel_channels.empty() || !options.setup.empty();
  acquire::SignalRoles roles{.force = 0, .has_force = test->has_force, .accel = {}};
  for (std::size_t i = test->has_force ? 1 : 0; i < table.signals.size(); ++i) roles.accel.push_back(i);
  if (!test->has_force && !options.force_optional)
    throw InputError("no force", "arrays", "give force and acceleration: percuss.Record(force, accel, fs=...)");
  if (chosen) roles = acquire::find_roles(table, options);
  acquire::Record record = acquire::record_of_table(table, roles, options);
  bool contiguous = !chosen;
  for (const ArrayRow& row : test->rows) {
    contiguous = contiguous && (!test->has_force || is_contiguous_double(row.force)) &&
                 std::all_of(row.accel.begin(), row.accel.end(), is_contiguous_double);
  }
  contiguous = contiguous &&
               std::all_of(record.accel.begin(), record.accel.end(), [](const auto& one) { return one.to_SI == 1; });
  if (!contiguous) return record;
  if (test->has_force && record.force.to_SI == 1) view_forces(record, test);
  view_responses(record, test);
  return record;
}

}  // namespace percuss::python
