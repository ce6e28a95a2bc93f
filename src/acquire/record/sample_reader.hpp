#pragma once
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace percuss::acquire {

/// Reads ranges of one signal's samples. Samples in memory can be viewed without a copy. `Place` is the row, or the row
/// and the channel.
template <class... Place>
class SampleReader {
 public:
  using Read = std::function<void(Place... place, std::size_t first, std::span<double> out)>;
  using View = std::function<std::span<const double>(Place... place)>;

  SampleReader() = default;
  template <class Callable>
  requires(!std::same_as<Callable, SampleReader>) SampleReader(Callable read) : read_(std::move(read)) {}
  /// `view` returns the whole row, valid during the reader's lifetime.
  SampleReader(Read read, View view) : read_(std::move(read)), view_(std::move(view)) {}

  /// Fills `out` with the samples first … first + out.size() − 1.
  void operator()(Place... place, std::size_t first, std::span<double> out) const { read_(place..., first, out); }
  /// A view of the samples first … first + count − 1. Samples that are not in memory are read into `buffer`.
  std::span<const double> view_or_read(Place... place, std::size_t first, std::size_t count,
                                       std::vector<double>& buffer) const {
    if (view_) return view_(place...).subspan(first, count);
    buffer.resize(count);
    read_(place..., first, buffer);
    return buffer;
  }
  /// The function that returns the whole row; empty if the samples are not in memory.
  const View& view() const { return view_; }

 private:
  Read read_;
  View view_;
};

}  // namespace percuss::acquire
