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

/// A number in the Fortran formats E13.5, E20.12 and D25.16.
std::string uff_e13(double value);
std::string uff_e20(double value);
std::string uff_d25(double value);

/// A universal file that appears whole under its name, or not at all; equal calls give equal bytes (dates are left
/// empty). Lines end in "\n".
class UffOutput {
 public:
  UffOutput(const std::string& path, bool force, UffData data = UffData::binary);

  /// Sets 151 (program) and 164 (SI).
  void header();
  /// A data set of complete lines with their line ends.
  void set(int number, std::string_view lines);
  /// Data set 58 in double precision: `description` without its numbers; `values` real, or real and imaginary in turn.
  void function(const UffFunction& description, std::span<const double> values);
  /// As above, for values that come in parts: `count` numbers by next(first, out).
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
  static constexpr std::size_t kNumbersAtOnce = std::size_t{1} << 16U;  // whole lines of four

  void begin(const UffFunction& description);
  void append(std::span<const double> values, bool last);
  void end();

  AtomicFile file_;
  UffData data_;
};

}  // namespace percuss::acquire
