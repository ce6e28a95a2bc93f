#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/model/modal_model.hpp"

namespace percuss::identify {

/// Groups of neighbouring spectral lines: single lines around the poles (or groups of `core_share` half-power
/// bandwidths, where that is more), and wider groups farther away, where an FRF is smooth. Data and model are summed
/// over the same groups, so that the model stays exact. The poles' information falls by only 0.3 %, at a fraction of
/// the work.
class LineGroups {
 public:
  LineGroups(const acquire::LineRange& lines, const std::vector<Pole>& poles, double core_share = 0);

  Eigen::Index count() const { return static_cast<Eigen::Index>(begin_.size()) - 1; }
  /// The middle line of each group.
  std::vector<std::size_t> middles() const;
  /// Σ w·z over each group, divided by √(lines of the group): noise of standard deviation 1/w becomes 1. Real parts
  /// stand above imaginary parts. shapes  z, w [lines]; column [2 count()].
  void sum(const Eigen::VectorXcd& z, const Eigen::VectorXd& w, Eigen::Ref<Eigen::VectorXd> column) const;

 private:
  std::vector<std::size_t> begin_;  // [count + 1]
  std::vector<double> scale_;
};

}  // namespace percuss::identify
