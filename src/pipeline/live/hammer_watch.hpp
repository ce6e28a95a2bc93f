#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "pipeline/live/online_trigger.hpp"

namespace percuss::pipeline {

/// Watches a response until the first blow: where it is struck and the force stays at rest, the hammer is silent.
class HammerWatch {
 public:
  explicit HammerWatch(double fs_Hz) : fs_Hz_(fs_Hz) {}

  /// Samples of the response that begin at this frame. After a gap, the search begins anew.
  void add(std::uint64_t first_frame, std::span<const double> response);
  /// Whether a response began half a second or more before this frame, up to which the force shows no blow.
  bool is_silent(std::uint64_t force_searched_to) const;

 private:
  double fs_Hz_;
  std::unique_ptr<OnlineTrigger> trigger_;
  std::uint64_t end_frame_ = 0;
  std::optional<std::uint64_t> struck_;
};

}  // namespace percuss::pipeline
