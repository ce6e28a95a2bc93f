#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "core/io/atomic_file.hpp"

namespace percuss::acquire {

/// A MAT file of level 5 that appears whole under its name, or not at all. Equal calls give equal bytes: the text of
/// the header is fixed, nothing is compressed. begin() states a variable's shape; append() fills it in MATLAB's order.
///   MatOutput out("x.mat", force);
///   out.begin("force", std::array<std::size_t, 2>{2, 3});
///   out.append(six_numbers);
///   out.commit();
/// errors  InputError: as AtomicFile; a variable longer than 2 GiB, which level 5 cannot hold.
class MatOutput {
 public:
  MatOutput(const std::string& path, bool force);

  void begin(std::string_view name, std::span<const std::size_t> shape, bool complex = false);
  /// All real parts come before all imaginary parts.
  void append(std::span<const double> values);
  void number(std::string_view name, double value);
  void numbers(std::string_view name, std::span<const double> values);  // a row
  void text(std::string_view name, std::string_view ascii);
  void commit() { file_.commit(); }

 private:
  void write_header(std::string_view name, std::span<const std::size_t> shape, unsigned kind, bool complex,
                    std::size_t data_bytes);

  std::string path_;
  AtomicFile file_;
  std::size_t part_ = 0, left_ = 0;  // numbers of a part (real or imaginary); numbers missing in the current part
  bool imaginary_to_come_ = false;
};

}  // namespace percuss::acquire
