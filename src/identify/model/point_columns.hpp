#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/truncation.hpp"

namespace percuss::identify {

// The columns φ of one mode at the points of a test, (1) in mode_column(), at lines first … first + count − 1. The
// terms common to all points are computed once.

/// H − φ: the part of a mode's decay after the records' end. H is the column of the whole decay.
class TruncatedDecay {
 public:
  TruncatedDecay(const Pole& pole, double window_decay_per_s, const acquire::LineRange& lines, std::size_t first,
                 std::size_t count);
  /// [count] H − φ for the hits at one point.
  std::vector<Complex> at(const PointForce& force) const;

 private:
  std::size_t first_;
  Truncation truncation_;
  std::vector<Complex> kernel_, mirror_;  // [count] c·D and conj(c)·D̃
};

/// φ without its derivatives.
class PointValues {
 public:
  PointValues(const Pole& pole, const FrfDataset& set, std::size_t first, std::size_t count);
  const Pole& pole() const { return pole_; }
  /// [count] φ for the hits at one point. It lies in `work` where the decay is truncated.
  std::span<const Complex> at(const PointForce& force, std::vector<Complex>& work) const;

 private:
  Pole pole_;
  acquire::LineRange lines_;
  Eigen::VectorXcd whole_;
  std::optional<TruncatedDecay> missing_;  // nothing where no point's decay is truncated
};

/// φ and its derivatives.
class PointColumns {
 public:
  PointColumns(const Pole& pole, const FrfDataset& set, std::size_t first, std::size_t count);
  /// φ and its derivatives for the hits at one point.
  ModeColumn at(const PointForce& force) const;

 private:
  Pole pole_;
  acquire::LineRange lines_;
  std::size_t first_;
  ModeColumn whole_;
  Truncation truncation_;
  std::vector<Truncation::Factors> factors_;  // empty where no point's decay is truncated
};

}  // namespace percuss::identify
