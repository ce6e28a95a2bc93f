#include "acquire/formats/hdf5/read_frf_hdf5.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "acquire/channels/named_channels.hpp"
#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "acquire/formats/hdf5/hdf5_layout.hpp"
#include "acquire/record/point_number.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::acquire {
namespace {

using hdf5::InputDataSet;
using hdf5::InputHdf5;

constexpr std::size_t kMaxFrfs = 1'000'000;
const char* const kRemedy = "store frf [points, channels, lines] and frequency_hz [lines]";

struct Shape {
  std::size_t points = 1, channels = 1, lines = 0, dimensions = 0;
};

Shape shape_of(const InputDataSet& set, const std::string& where) {
  const auto& shape = set.shape();
  if (shape.empty() || set.elements() == 0) throw InputError("empty", where, kRemedy);
  Shape out{.lines = shape.back(), .dimensions = shape.size()};
  if (shape.size() > 1) out.channels = shape[shape.size() - 2];
  if (shape.size() > 2) out.points = shape[0];
  if (out.points * out.channels > kMaxFrfs) throw InputError("more than a million FRFs", where, "split the file");
  return out;
}

// The index of one FRF in a set with the dimensions of /frf.
std::vector<std::size_t> index_of(const Shape& shape, std::size_t point, std::size_t channel) {
  if (shape.dimensions == 1) return {};
  if (shape.dimensions == 2) return {channel};
  return {point, channel};
}

void require_finite(const std::vector<double>& values, const std::string& where) {
  if (std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); })) return;
  throw InputError("not a finite number", where, "correct or leave out the value");
}

// A real array of the same shape as /frf: standard deviations or coherence.
class Companion {
 public:
  Companion(const InputHdf5& file, const std::string& name, const InputDataSet& frf) : where_(file.where(name)) {
    if (!file.has(name)) return;
    set_.emplace(file, name);
    if (set_->shape() != frf.shape()) {
      throw InputError("shape " + hdf5::shape_text(set_->shape()) + " for FRFs " + hdf5::shape_text(frf.shape()),
                       where_, "store one number per line");
    }
  }
  std::vector<double> read(const Shape& shape, std::size_t point, std::size_t channel) const {
    if (!set_) return {};
    std::vector<double> values(shape.lines);
    set_->read(index_of(shape, point, channel), 0, values);
    require_finite(values, where_);
    return values;
  }

 private:
  std::string where_;
  std::optional<InputDataSet> set_;
};

std::vector<int> points_of(const InputHdf5& file, std::size_t count) {
  std::vector<int> points(count);
  for (std::size_t p = 0; p < count; ++p) points[p] = static_cast<int>(p);
  if (!file.has("point")) return points;
  const InputDataSet set(file, "point");
  const std::string where = file.where("point");
  if (set.shape() != std::vector<std::size_t>{count}) throw InputError("not one number per point", where, kRemedy);
  return point_numbers(set.read_all(), where);
}

void read_sensors(const InputHdf5& file, const InputDataSet& frf, std::size_t channels, FrfRecord& record) {
  const std::string where = file.where("frf");
  const auto angle_deg = hdf5::number_attribute(frf.id(), "angle_deg", where, channels);
  const auto position_m = hdf5::number_attribute(frf.id(), "position_m", where, channels);
  for (std::size_t c = 0; c < channels; ++c) {
    SignalInfo signal{.name = channel_name(c)};
    if (angle_deg && c < angle_deg->size() && std::isfinite((*angle_deg)[c]))
      signal.angle_rad = (*angle_deg)[c] * kDegree_rad;
    if (position_m && c < position_m->size() && std::isfinite((*position_m)[c])) signal.position_m = (*position_m)[c];
    record.accel.push_back(std::move(signal));
  }
}

void read_root(const InputHdf5& file, StoredFrfs& out, std::size_t& averages) {
  if (const auto unit = hdf5::text_attribute(file.id(), "unit", file.path())) out.unit = parse_frf_unit(*unit);
  if (const auto kind = hdf5::text_attribute(file.id(), "kind", file.path())) out.kind = parse_frf_kind(*kind);
  out.record.estimator = one_line(hdf5::text_attribute(file.id(), "estimator", file.path()).value_or(""), 60);
  if (const auto decay = hdf5::number_attribute(file.id(), "decay_per_s", file.path(), 1)) {
    if (!(decay->front() >= 0) || !std::isfinite(decay->front()))
      throw InputError("decay_per_s is not a decay", file.path(), "store 0 or more, in 1/s");
    out.record.decay_per_s = decay->front();
  }
  const auto count = hdf5::number_attribute(file.id(), "averages", file.path(), 1);
  if (count && count->front() >= 0 && count->front() <= kMaxAverages)
    averages = static_cast<std::size_t>(count->front());
}

}  // namespace

std::optional<StoredFrfs> read_frf_hdf5(const std::string& path) {
  const hdf5::Lock lock;
  const InputHdf5 file(path);
  if (!file.has("frf") || file.has("force")) return std::nullopt;
  StoredFrfs out;
  out.record.files.push_back({.path = path, .bytes = file.bytes()});
  out.record.format = "FRF HDF5";
  std::size_t averages = 0;
  read_root(file, out, averages);
  const InputDataSet set(file, "frf", hdf5::Elements::complex);
  const Shape shape = shape_of(set, file.where("frf"));
  if (!file.has("frequency_hz")) throw InputError("no data set /frequency_hz", path, kRemedy);
  const InputDataSet frequencies(file, "frequency_hz");
  if (frequencies.shape() != std::vector<std::size_t>{shape.lines})
    throw InputError("not one frequency per line", file.where("frequency_hz"), kRemedy);
  const auto freq_Hz = frequencies.read_all();
  require_finite(freq_Hz, file.where("frequency_hz"));
  out.set_lines(frequency_lines(freq_Hz, 1, file.where("frequency_hz")));
  read_sensors(file, set, shape.channels, out.record);
  const auto points = points_of(file, shape.points);
  const Companion std(file, "frf_std", set);
  const Companion coherence(file, "coherence", set);
  for (std::size_t p = 0; p < shape.points; ++p) {
    for (std::size_t c = 0; c < shape.channels; ++c) {
      StoredFrf frf{.point = points[p], .channel = c, .value = std::vector<Complex>(shape.lines)};
      set.read(index_of(shape, p, c), 0, frf.value);
      const bool finite = std::all_of(frf.value.begin(), frf.value.end(), [](const Complex& h) {
        return std::isfinite(h.real()) && std::isfinite(h.imag());
      });
      if (!finite) throw InputError("not a finite number", file.where("frf"), "correct or leave out the value");
      frf.std = std.read(shape, p, c);
      frf.coherence = coherence.read(shape, p, c);
      frf.averages = averages;
      out.frfs.push_back(std::move(frf));
    }
  }
  return out;
}

}  // namespace percuss::acquire
