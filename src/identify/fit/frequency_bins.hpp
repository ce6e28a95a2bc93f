#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/model/modal_model.hpp"

namespace percuss::identify {

/// Lines taken together: one by one around the poles, and ever more of them the farther away, where an FRF is smooth.
/// Data and model go through the same sums, so that nothing is approximated, and next to nothing of what the lines know
/// of the poles is lost (0.3 %), at a fraction of the work.
class FrequencyBins {
 public:
  FrequencyBins(const frf::LineRange& lines, const std::vector<Pole>& poles);

  Eigen::Index count() const { return static_cast<Eigen::Index>(begin_.size()) - 1; }
  /// The line in the middle of each block.
  std::vector<std::size_t> middles() const;
  /// Σ w·z over each block, over the square root of its lines: noise of deviation 1/w keeps the deviation 1. Real parts
  /// above imaginary parts. shapes  z, w [lines]; column [2 count()].
  void sum(const Eigen::VectorXcd& z, const Eigen::VectorXd& w, Eigen::Ref<Eigen::VectorXd> column) const;

 private:
  std::vector<std::size_t> begin_;  // [count + 1]
  std::vector<double> scale_;
};

}  // namespace percuss::identify
