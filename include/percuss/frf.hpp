#pragma once
/// Frequency response functions (FRFs): estimated from a record, read from a file or given as arrays.
///
/// @code
/// #include <complex>
/// #include <iostream>
/// #include <percuss/frf.hpp>
/// #include <percuss/synth.hpp>
///
/// int main() {
///   const percuss::Record record = percuss::synthesise_preset("wood-bat").record;
///   const percuss::FrfSet frfs = percuss::estimate_frfs(record, {.band_Hz = percuss::Band{60, 1000}});
///   const percuss::FrfSet mobility = frfs.converted(percuss::FrfKind::mobility);
///   const percuss::Frf& first = mobility.frfs().at(0);
///   std::cout << mobility.freq_Hz().at(0) << " Hz: " << std::abs(first.value.at(0)) << " ± " << first.std.at(0) << ' '
///             << mobility.unit() << ", coherence " << first.coherence.at(0) << '\n';
/// }
/// @endcode
#include <percuss/hits.hpp>
#include <percuss/record.hpp>

#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace percuss {

namespace api {
struct FrfData;
}

struct Band {
  double low_Hz = 0, high_Hz = 0;
};

/// H1 is unbiased by noise on the acceleration, H2 by noise on the force; Hv is total least squares.
enum class Estimator { h1, h2, hv };

/// The response of one channel to hits at one point. shapes  every array has one element per frequency.
struct Frf {
  int point = 0;
  std::size_t channel = 0;
  std::vector<std::complex<double>> value;  // (m/s²)/N, (m/s)/N or m/N
  std::vector<double> std{};                // RMS of |value − truth|, in the unit of value; empty for one hit
  std::vector<double> coherence{};          // 0 … 1; empty for one hit
  std::size_t averages = 0;                 // hits averaged; 0: not known
};

/// FRFs on common frequencies. Copies are cheap and share the values.
class FrfSet {
 public:
  FrfKind kind() const;
  std::string unit() const;       // "(m/s^2)/N", "(m/s)/N" or "m/N"
  std::string estimator() const;  // "H1", "H2", "Hv"; empty: the file does not state it
  const std::vector<double>& freq_Hz() const;
  const std::vector<Frf>& frfs() const;  // ascending by point, then channel
  std::vector<Channel> channels() const;
  /// The same responses as accelerance, mobility or receptance. A mobility or receptance at 0 Hz is 0, unless an
  /// exponential window was applied.
  FrfSet converted(FrfKind kind) const;

  explicit FrfSet(std::shared_ptr<const api::FrfData> data) : data_(std::move(data)) {}
  const api::FrfData& data() const { return *data_; }

 private:
  std::shared_ptr<const api::FrfData> data_;
};

struct FrfOptions {
  std::optional<Band> band_Hz{};  // default: the range that the hammer excited
  Estimator estimator = Estimator::h1;
  HitOptions hits{};
  double exponential = 0;   // exponential window that falls to this fraction at the end; 0: none
  std::size_t threads = 0;  // 0: all; the result is the same
};

/// FRFs of the accepted hits of a record, averaged point by point.
/// errors  InputError: no hit can be used; too few frequencies in the band; several runs (see Record::runs).
FrfSet estimate_frfs(const Record& record, const FrfOptions& options = {});

/// Opens a file of FRFs (text, HDF5, MAT, UFF). errors  InputError: not such a file.
FrfSet open_frfs(const std::string& path, const ReadOptions& options = {});

/// FRFs measured or computed elsewhere. freq_Hz are multiples of their spacing; every point has every channel.
struct FrfArrays {
  std::vector<double> freq_Hz{};
  std::vector<Frf> frfs{};
  FrfKind kind = FrfKind::accelerance;
  std::vector<double> angle_rad{}, position_m{};  // per channel; empty: not known
};

/// errors  InputError: uneven frequencies, shapes that do not agree, values that are not finite.
FrfSet frfs_from_arrays(const FrfArrays& arrays);

}  // namespace percuss
