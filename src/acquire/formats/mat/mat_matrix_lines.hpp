#pragma once
#include <cstddef>
#include <vector>

#include "acquire/formats/mat/mat_file.hpp"

namespace percuss::acquire {

/// A matrix as lines with a number per column. Its longer side counts the lines: a wide matrix is read transposed.
class MatrixLines {
 public:
  /// Precondition: the variable has two dimensions.
  explicit MatrixLines(const MatVariable& variable);

  std::size_t count() const { return count_; }
  std::size_t columns() const { return columns_; }
  /// One column of `numbers`, the real or imaginary parts of the variable; [count].
  std::vector<double> column(const std::vector<double>& numbers, std::size_t index) const;

 private:
  bool across_;
  std::size_t count_, columns_;
};

}  // namespace percuss::acquire
