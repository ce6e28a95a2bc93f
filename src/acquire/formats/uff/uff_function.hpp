#pragma once
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "acquire/formats/uff/uff_file.hpp"

namespace percuss::acquire {

/// Codes of data set 58.
struct Uff58 {
  enum Function {
    time_response = 1,
    auto_spectrum = 2,
    cross_spectrum = 3,
    frequency_response = 4,
    coherence = 6,
    power_spectral_density = 9,
    energy_spectral_density = 10,
    spectrum = 12
  };
  enum Quantity {
    unknown = 0,
    general = 1,
    displacement = 8,
    reaction_force = 9,
    velocity = 11,
    acceleration = 12,
    excitation_force = 13,
    pressure = 15,
    time = 17,
    frequency = 18
  };
};

/// A point and direction of the structure, as in record 6.
struct UffDof {
  std::string name;
  int node = 0;
  int direction = 0;  // ±1 … ±3 along, ±4 … ±6 around x, y, z; 0 none
  friend bool operator==(const UffDof&, const UffDof&) = default;
  friend auto operator<=>(const UffDof&, const UffDof&) = default;  // NOLINT(modernize-use-nullptr): no pointer
};

/// Whether both are one node, moved or struck along one line, as at a driving point.
inline bool same_place(const UffDof& a, const UffDof& b) {
  return a.node == b.node && a.node != 0 && std::abs(a.direction) == std::abs(b.direction) && a.direction != 0;
}

struct UffAxis {
  int quantity = 0;
  std::string label, unit;
};

/// One function of data set 58 or 58b: its description and the place of its numbers.
struct UffFunction {
  std::array<std::string, 5> id;
  int type = 0, version = 0, load_case = 0;
  UffDof response, reference;
  std::size_t count = 0;
  bool even = true, complex = false, single = false;
  double x0 = 0, dx = 0;
  std::string dx_text;  // as written, which shows its rounding
  UffAxis abscissa, ordinate, denominator;

  std::string_view at;         // the set's place in the file
  std::vector<double> values;  // of a text: abscissa (if uneven), real, imaginary part (if complex), value by value
  std::string_view bytes;      // of a binary set, in the same order
  std::shared_ptr<const LazyFile> file{};  // set while `bytes` are not loaded: read() copies them from `file_offset` on
  std::size_t file_offset = 0;
  bool big_endian = false;

  /// Real parts (part 0) or imaginary parts (part 1) of values first … first + out.size() − 1.
  /// errors  InputError: the file has become shorter since it was opened, or cannot be read.
  void read(std::size_t part, std::size_t first, std::span<double> out) const;
  /// Value i's abscissa.
  double x(std::size_t i) const;

 private:
  void decode(const char* from, std::size_t stride, std::span<double> out) const;
};

/// errors  InputError with file and line: a record cannot be read, there are fewer numbers than record 7 states, the
/// type of ordinate is not 2, 4, 5 or 6.
UffFunction parse_uff_function(const UffSet& set, const FileBytes& file);

}  // namespace percuss::acquire
