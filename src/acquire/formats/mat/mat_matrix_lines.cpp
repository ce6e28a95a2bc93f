#include "acquire/formats/mat/mat_matrix_lines.hpp"

namespace percuss::acquire {

MatrixLines::MatrixLines(const MatVariable& variable)
    : across_(variable.shape[1] > variable.shape[0]),
      count_(variable.shape[across_ ? 1 : 0]),
      columns_(variable.shape[across_ ? 0 : 1]) {}

std::vector<double> MatrixLines::column(const std::vector<double>& numbers, std::size_t index) const {
  std::vector<double> out(count_);
  for (std::size_t i = 0; i < count_; ++i) out[i] = numbers[across_ ? i * columns_ + index : index * count_ + i];
  return out;
}

}  // namespace percuss::acquire
