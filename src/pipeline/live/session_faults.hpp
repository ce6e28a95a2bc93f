#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "acquire/live/capture_finding.hpp"
#include "acquire/record/row_mark.hpp"
#include "pipeline/live/sample_history.hpp"

namespace percuss::pipeline {

/// The faults of a session: faults that its samples show, and faults that only the capture knows.
class SessionFaults {
 public:
  explicit SessionFaults(double fs_Hz);

  /// Adds a loss, or a part of one. Returns the new fault. Samples that are no numbers, less than a second after the
  /// channel's last ones, extend its fault; then nothing is returned.
  std::optional<acquire::CaptureFinding> add(const SampleLoss& loss);
  /// Adds what the capture states. Losses are known from the samples; `dropped` and `resumed` say why they happened.
  void add(const acquire::CaptureFinding& finding);
  /// Adds what the journal of an interrupted session states. Its samples begin at `first_frame`: losses before it are
  /// not in them.
  void add_past(const acquire::CaptureFinding& finding, std::uint64_t first_frame);
  /// Adds the remaining faults of the capture, in the order of frames, and returns them. If the session was finished
  /// before the device ended, only the drift of the clock is kept.
  std::vector<acquire::CaptureFinding> finish(bool finished_before);

  struct Row {
    std::uint64_t frame = 0;
    std::size_t samples = 0;
  };
  /// As a record holds them, in the order of time.
  std::vector<acquire::RecordFault> for_record(const std::vector<Row>& rows) const;

 private:
  struct Run {
    std::size_t fault = 0;  // index
    std::uint64_t end = 0;  // after the last sample without a number
  };
  void keep(acquire::CaptureFinding finding);

  double fs_Hz_;
  std::vector<acquire::CaptureFinding> faults_;   // `frame` is the first one of a loss
  std::vector<acquire::CaptureFinding> reasons_;  // of losses that the samples have not shown yet
  std::vector<acquire::CaptureFinding> pending_;  // until finish()
  std::map<std::size_t, Run> runs_;               // by channel
};

}  // namespace percuss::pipeline
