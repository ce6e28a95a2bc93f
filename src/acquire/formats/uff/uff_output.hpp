#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/formats/uff/uff_function.hpp"
#include "core/io/atomic_file.hpp"

namespace percuss::acquire {

enum class UffData { binary, text };

/// `value` in the Fortran format E13.5, E20.12 or D25.16.
std::string uff_e13(double value);
std::string uff_e20(double value);
std::string uff_d25(double value);

/// A universal file that appears whole under its name, or not at all; equal calls give equal bytes (dates are left
/// empty). Lines end in "\n".
/// errors  InputError: as AtomicFile.
class UffOutput {
 public:
  UffOutput(const std::string& path, bool force, UffData data = UffData::binary);

  /// Writes the sets 151 (program) and 164 (SI units).
  void header();
  /// Writes a data set of complete lines, each with its line end.
  void set(int number, std::string_view lines);
  /// Writes a data set 58 in double precision. The numbers of `description` are ignored. Complex values are real and
  /// imaginary parts, alternating.
  void function(const UffFunction& description, std::span<const double> values);
  /// As above, in blocks: calls next(first, out) for numbers first … first + out.size() − 1 of `count`.
  template <class Next>
  void function_of(const UffFunction& description, std::size_t count, Next&& next) {
    begin(description);
    std::vector<double> part(std::min(count, kNumbersAtOnce));
    for (std::size_t first = 0; first < count; first += part.size()) {
      const auto some = std::span(part).first(std::min(part.size(), count - first));
      next(first, some);
      append(some, first + some.size() == count);
    }
    end();
  }
  void commit() { file_.commit(); }

 private:
  static constexpr std::size_t kNumbersAtOnce = std::size_t{1} << 16U;  // a multiple of the four numbers per line

  void begin(const UffFunction& description);
  void append(std::span<const double> values, bool last);
  void end();

  AtomicFile file_;
  UffData data_;
};

}  // namespace percuss::acquire
