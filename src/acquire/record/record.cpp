#include "acquire/record/record.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <utility>

#include "acquire/record/channel_name.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

// The reader of the rows `from` of another reader: samples in memory are viewed, not copied.
template <class... Place>
SampleReader<std::size_t, Place...> with_rows(const SampleReader<std::size_t, Place...>& all,
                                              const std::vector<std::size_t>& from) {
  using Reader = SampleReader<std::size_t, Place...>;
  typename Reader::View view;
  if (all.view())
    view = [from, seen = all.view()](std::size_t row, Place... place) { return seen(from.at(row), place...); };
  return Reader([from, all](std::size_t row, Place... place, std::size_t first,
                            std::span<double> samples) { all(from.at(row), place..., first, samples); },
                std::move(view));
}

}  // namespace

std::vector<DrivingPlace> driving_at(const std::vector<DrivingPlace>& driving,
                                     const std::vector<std::size_t>& channels) {
  std::vector<DrivingPlace> out;
  for (const DrivingPlace& at : driving) {
    const auto channel = std::find(channels.begin(), channels.end(), at.channel);
    if (channel != channels.end()) out.push_back({at.point, static_cast<std::size_t>(channel - channels.begin())});
  }
  return out;
}

std::set<int> Record::points() const {
  std::set<int> out;
  for (const RowInfo& row : rows) out.insert(row.point);
  return out;
}

int geometry_point(double number, std::size_t points, const char* what, const std::string& where) {
  if (number >= 0 && number < static_cast<double>(points) && number == std::floor(number))
    return static_cast<int>(number);
  throw InputError(std::string("a ") + what + " to a missing point", where,
                   "number points from 0, in the order of the geometry's rows");
}

std::vector<TraceLine> trace_lines_of(const std::vector<double>& numbers, std::size_t points,
                                      const std::string& where) {
  if (numbers.size() % 2 != 0)
    throw InputError("an odd count of point numbers", where, "give two points for every line");
  std::vector<TraceLine> out;
  out.reserve(numbers.size() / 2);
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    out.push_back(
        {geometry_point(numbers[i], points, "line", where), geometry_point(numbers[i + 1], points, "line", where)});
  }
  return out;
}

Record select_rows(const Record& record, const std::function<bool(const RowInfo&)>& keep) {
  Record out = record;
  out.rows.clear();
  out.contiguous.clear();  // it states the place of the first row
  std::vector<std::size_t> from;
  std::vector<int> number(record.rows.size(), -1);  // of the kept rows
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    if (!keep(record.rows[row])) continue;
    number[row] = static_cast<int>(out.rows.size());
    out.rows.push_back(record.rows[row]);
    from.push_back(row);
  }
  for (RecordFault& fault : out.faults) {
    if (fault.row >= 0) fault.row = number.at(static_cast<std::size_t>(fault.row));
  }
  out.read_force_N = with_rows(record.read_force_N, from);
  out.read_accel_mps2 = with_rows(record.read_accel_mps2, from);
  return out;
}

Record record_in_memory(double fs_Hz, std::vector<std::vector<double>> force_N,
                        std::vector<std::vector<std::vector<double>>> accel_mps2) {
  assert(force_N.size() == accel_mps2.size());
  Record record;
  record.format = "memory";
  record.fs_Hz = fs_Hz;
  record.force.name = "force";
  for (const auto& row : force_N) record.rows.push_back({.samples = row.size()});
  for (std::size_t c = 0; !accel_mps2.empty() && c < accel_mps2.front().size(); ++c) {
    record.accel.push_back({.name = channel_name(c), .unit = "m/s^2"});
  }
  const auto copy = [](const std::vector<double>& from, std::size_t first, std::span<double> out) {
    std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  };
  auto force = std::make_shared<const std::vector<std::vector<double>>>(std::move(force_N));
  auto accel = std::make_shared<const std::vector<std::vector<std::vector<double>>>>(std::move(accel_mps2));
  record.read_force_N = {
      [force, copy](std::size_t row, std::size_t first, std::span<double> out) { copy(force->at(row), first, out); },
      [force](std::size_t row) { return std::span<const double>(force->at(row)); }};
  record.read_accel_mps2 = {
      [accel, copy](std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
        copy(accel->at(row).at(channel), first, out);
      },
      [accel](std::size_t row, std::size_t channel) { return std::span<const double>(accel->at(row).at(channel)); }};
  return record;
}

SampleReader<std::size_t> no_force() {
  return [](std::size_t, std::size_t, std::span<double> out) { std::fill(out.begin(), out.end(), 0.0); };
}

}  // namespace percuss::acquire
