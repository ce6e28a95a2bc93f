#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// The FRFs of a test without truncation: the decays that the records cut off are added to the measured FRFs. All
/// points then share the columns of a joint fit, which costs a fraction of the work for tests of many points.
class CompletedDecays {
 public:
  /// `cut` must outlive this object. Nothing is added yet.
  explicit CompletedDecays(const FrfDataset& cut);

  const FrfDataset& set() const& { return whole_; }
  FrfDataset set() && { return std::move(whole_); }

  /// Whether the forces are known; otherwise the truncation of the FRFs is unknown.
  static bool truncation_is_known(const FrfDataset& cut);

  /// Adds the missing decays of these modes to the measured FRFs; residues [channels, modes]. The added decays have a
  /// relative error as large as the truncation of the FRFs to which the residues were fitted.
  void add_missing_decays(const std::vector<Pole>& poles, const Eigen::MatrixXcd& residues);

 private:
  const FrfDataset& cut_;
  FrfDataset whole_;
};

/// The smallest amplitude of a mode at the records' end, relative to its start, that counts as truncation.
inline constexpr double kMinTruncation = 1e-9;

}  // namespace percuss::identify
