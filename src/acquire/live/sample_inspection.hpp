#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "acquire/live/capture_finding.hpp"
#include "acquire/live/sample_stream.hpp"

namespace percuss::acquire {

/// Counts samples that are no numbers or at full scale. A channel has at most one finding of each kind per second.
class SampleInspection {
 public:
  explicit SampleInspection(const StreamFormat& format);

  /// Examines interleaved frames, and appends the findings of seconds that have passed.
  void add(std::uint64_t first_frame, std::span<const double> values, std::vector<CaptureFinding>& findings);
  /// Appends the findings of the present second.
  void finish(std::vector<CaptureFinding>& findings);

 private:
  struct Count {
    std::uint64_t first_frame = 0, samples = 0;
  };
  std::size_t channels_;
  std::vector<double> limits_;  // [channels]
  std::uint64_t second_frames_, second_end_ = 0;
  std::vector<Count> no_numbers_, overloads_;  // [channels]
};

}  // namespace percuss::acquire
