#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "pipeline/live/online_trigger.hpp"

namespace percuss::pipeline {

/// Watches a response between blows. If the structure is struck while the force stays at rest, the hammer's channel is
/// silent.
class HammerWatch {
 public:
  /// `level`: motion that only a blow causes, in the unit of the response; default: above its noise.
  explicit HammerWatch(double fs_Hz, std::optional<double> level = {}) : fs_Hz_(fs_Hz), level_(level) {}

  /// Samples of the response that begin at this frame. After a gap, the search begins anew.
  void add(std::uint64_t first_frame, std::span<const double> response);
  /// Whether a motion of the response began more than half a second before the frame `force_searched_to`. The caller
  /// states that the force shows no blow up to this frame.
  bool is_silent(std::uint64_t force_searched_to) const;

 private:
  double fs_Hz_;
  std::optional<double> level_;
  std::unique_ptr<OnlineTrigger> trigger_;
  std::uint64_t end_frame_ = 0;
  std::optional<std::uint64_t> struck_;
};

}  // namespace percuss::pipeline
