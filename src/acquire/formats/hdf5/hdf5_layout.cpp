#include "acquire/formats/hdf5/hdf5_layout.hpp"

#include "core/error.hpp"

namespace percuss::acquire::hdf5 {
namespace {

constexpr std::size_t kMinSamples = 2;
constexpr std::size_t kTransposedRatio = 16;  // a test has far fewer hits than samples per hit

void check_force_shape(const std::vector<std::size_t>& shape, const std::string& where) {
  if (shape.empty() || shape.size() > 2) {
    throw InputError("shape " + shape_text(shape), where, "store [hits, samples] or [samples]");
  }
  if (shape.size() == 2 && shape[0] == 0) throw InputError("no hits", where, "record at least one");
  if (shape.back() < kMinSamples) {
    throw InputError(shape.back() == 0 ? "no samples" : "one sample per hit", where,
                     "store [hits, samples]; is it transposed?");
  }
  if (shape.size() == 2 && shape[0] > kTransposedRatio * shape[1]) {
    throw InputError("looks transposed: " + shape_text(shape) + " for [hits, samples]", where, "transpose it");
  }
}

void check_accel_shape(const InputDataSet& accel) {
  const auto& a = accel.shape();
  if (a.empty()) throw InputError("one number", accel.where(), "store [hits, channels, samples]");
  if (accel.elements() == 0)
    throw InputError("empty: shape " + shape_text(a), accel.where(), "store [hits, channels, samples]");
}

}  // namespace

std::string shape_text(std::span<const std::size_t> shape) {
  std::string text;
  for (const std::size_t size : shape) text += (text.empty() ? "[" : ", ") + std::to_string(size);
  return text.empty() ? "of one number" : text + "]";
}

Layout layout_of(const InputDataSet& accel) {
  check_accel_shape(accel);
  const auto& a = accel.shape();
  return {.rows = a.size() == 3 ? a[0] : 1,
          .channels = a.size() == 1 ? 1 : a[a.size() - 2],
          .samples = a.back(),
          .accel_has_rows = a.size() == 3,
          .accel_has_channels = a.size() > 1};
}

Layout layout_of(const InputDataSet& force, const InputDataSet& accel, const InputHdf5& file) {
  const auto &f = force.shape(), &a = accel.shape();
  check_force_shape(f, force.where());
  check_accel_shape(accel);
  Layout layout{.rows = f.size() == 2 ? f[0] : 1, .samples = f.back(), .force_has_rows = f.size() == 2};
  // Two dimensions are [hits, samples] if the force has as many hits, else [channels, samples].
  layout.accel_has_rows = a.size() == 3 || (a.size() == 2 && layout.force_has_rows && a[0] == layout.rows);
  layout.accel_has_channels = a.size() == 3 || (a.size() == 2 && !layout.accel_has_rows);
  layout.channels = layout.accel_has_channels ? a[a.size() - 2] : 1;
  const std::size_t accel_rows = layout.accel_has_rows ? a[0] : 1;
  if (accel_rows != layout.rows || a.back() != layout.samples) {
    throw InputError("force " + shape_text(f) + " and accel " + shape_text(a) + " disagree", file.path(),
                     "store force [hits, samples] and accel [hits, channels, samples]");
  }
  return layout;
}

}  // namespace percuss::acquire::hdf5
