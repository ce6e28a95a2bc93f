#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace percuss::pipeline {

inline constexpr std::size_t kMaxFault = 40;  // samples; a longer fault is not replaced

/// Samples of a free decay that do not follow from their neighbours.
struct SampleFault {
  enum class Kind {
    wrong,    // `count` samples from `first` on do not show the structure's motion
    missing,  // `count` samples are missing before `first`
    jump      // neither: the motion itself changes, as by a contact
  };
  Kind kind = Kind::jump;
  std::size_t first = 0, count = 0;
  bool constant = false;       // all wrong samples are equal, in all channels
  std::vector<bool> channels;  // that hold wrong samples; all for missing samples
  double size = 0;             // largest difference between wrong and expected samples
  double error_before = 0;     // rms of the prediction errors at the recorded fault, over the rms around it
  double error_after = 0;      // the same after the repair
  Eigen::MatrixXd repair;      // expected samples [count, channels]
};

/// Part [first, end) of the samples, without the pulse of the force.
struct DecayRange {
  std::size_t first = 0, end = 0;
};

/// The fault near sample `at` of the responses to one hit, [channels], all of the same length. Two linear predictions
/// of a sample are fitted to the surroundings: from the samples before it, and from the samples after it. A sum of
/// decaying oscillations obeys both. The forward errors show where a fault begins, the backward errors where it ends.
/// Nothing where the prediction is not disturbed or the surroundings are too short. theory (1.8)
std::optional<SampleFault> diagnose_samples(std::span<const std::span<const double>> channels, std::size_t at,
                                            const DecayRange& range);

}  // namespace percuss::pipeline
