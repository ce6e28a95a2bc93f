#include "pipeline/live/hammer_watch.hpp"

namespace percuss::pipeline {

void HammerWatch::add(std::uint64_t first_frame, std::span<const double> response) {
  if (!trigger_ || first_frame != end_frame_)
    trigger_ = std::make_unique<OnlineTrigger>(OnlineTriggerOptions{.fs_Hz = fs_Hz_, .trigger_N = level_}, first_frame);
  end_frame_ = first_frame + response.size();
  trigger_->add(response);
  while (const auto event = trigger_->next()) {
    if (!struck_) struck_ = event->first;
  }
}

bool HammerWatch::is_silent(std::uint64_t force_searched_to) const {
  constexpr double kPatience_s = 0.5;
  return struck_ && static_cast<double>(force_searched_to) > static_cast<double>(*struck_) + kPatience_s * fs_Hz_;
}

}  // namespace percuss::pipeline
