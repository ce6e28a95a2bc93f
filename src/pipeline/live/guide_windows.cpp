// The samples that belong to a blow.
#include <algorithm>

#include "acquire/hits/time_selection.hpp"
#include "core/math/fft.hpp"
#include "pipeline/live/guide.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kFirstHorizon_s = 0.5;
constexpr std::size_t kHorizons = 6;  // 0.5 s … 16 s
constexpr double kMinCut_s = 0.5;     // of a window that the next blow or a gap ends
constexpr double kMinRow_s = 0.1;     // of one that ends with the row of a replayed record: all rows may be short
constexpr double kSpareAtCut = 0.98;  // the next blows come a little later in their windows

}  // namespace

// Whether the loss is a pause between the rows of a replayed record.
bool Guide::is_pause(const SampleLoss& loss) const {
  return !loss.channel && format_.is_pause(loss.frames, loss.overrun);
}

std::size_t Guide::pretrigger_of(std::size_t rise) const {
  return acquire::pretrigger_samples(channels_.description, {.pretrigger_s = options_.pretrigger_s}, rise);
}

// The row of a replayed record may begin later than a pretrigger before its pulse.
std::uint64_t Guide::window_start(const BlowEvent& event) const {
  const std::uint64_t pretrigger = pretrigger_of(event.rise);
  std::uint64_t start = std::max(event.peak - std::min(event.peak, pretrigger), history_.first_frame());
  for (const SampleLoss& loss : history_.losses(start, event.peak)) {
    if (is_pause(loss)) start = std::max(start, loss.frame + loss.frames);
  }
  return start;
}

// The frame at which the samples of the next blow begin, or samples were lost; otherwise the newest frame.
std::uint64_t Guide::undisturbed_end(const Window& window) const {
  std::uint64_t end = history_.end_frame();
  if (windows_.size() > 1) end = std::min(end, windows_[1].first);
  const auto losses = force_losses(window.event.peak + 1, end);
  return losses.empty() ? end : std::clamp(losses.front().frame, window.first, end);
}

std::vector<SampleLoss> Guide::force_losses(std::uint64_t first, std::uint64_t last) const {
  auto losses = history_.losses(first, last);
  std::erase_if(losses, [&](const SampleLoss& loss) { return loss.channel && *loss.channel != channels_.force; });
  return losses;
}

// Samples of pre-trigger that a blow at the very beginning lacks. Later windows have them, so the common length counts
// them.
std::size_t Guide::missing_pretrigger(const Window& window) const {
  if (window.first != start_frame_ || format_.pause_frames > 0) return 0;
  const std::size_t whole = pretrigger_of(window.event.rise), own = window.event.peak - window.first;
  return whole > own ? whole - own : 0;
}

// Whether too few samples precede the blow to measure the noise, against which its decay is judged.
bool Guide::too_early(const Window& window) const {
  const std::size_t usual = std::min(pretrigger_of(0), acquire::pretrigger_samples(channels_.description, {}));
  return missing_pretrigger(window) > 0 && 2 * (window.event.peak - window.first) < usual;
}

bool Guide::choose_length(Window& window, bool last) {
  if (too_early(window)) return true;
  const std::uint64_t end = undisturbed_end(window);
  const bool next_known = last || windows_.size() > 1, cut = next_known || end < history_.end_frame();
  const std::size_t pretrigger = window.event.peak - window.first;
  const std::size_t missing = missing_pretrigger(window);
  // The next window begins before its blow.
  const auto known_before = [&](std::uint64_t frame) { return next_known || all_known_before(frame + pretrigger_); };
  for (; window.horizon < kHorizons; ++window.horizon) {
    auto samples = static_cast<std::size_t>(std::ldexp(kFirstHorizon_s, static_cast<int>(window.horizon)) * fs_Hz_);
    if (pretrigger > samples / 8) samples += pretrigger;  // a long one comes before the decay
    if (window.first + samples > end) break;
    if (!known_before(window.first + samples)) return false;  // the next blow may lie within
    const auto decayed =
        decayed_samples(channels_.description, read_blow(history_, channels_, window.first, samples), pretrigger);
    if (!decayed && window.horizon + 1 < kHorizons) continue;
    length_ = fast_length_at_least(decayed.value_or(samples) + missing);
    observer_.on_length(*length_, false);
    return true;
  }
  if (!cut || !known_before(end)) return false;
  const std::size_t whole = end - window.first;
  const auto after = history_.losses(end, end + 1);
  const bool row_ends = std::any_of(after.begin(), after.end(), [&](const SampleLoss& loss) { return is_pause(loss); });
  if (static_cast<double>(whole) >= (row_ends ? kMinRow_s : kMinCut_s) * fs_Hz_) {
    length_ = fast_length_at_most(static_cast<std::size_t>(kSpareAtCut * static_cast<double>(whole)) + missing);
    length_by_end_ = last && end == history_.end_frame();
    observer_.on_length(*length_, !row_ends && !length_by_end_);
  }
  return true;
}

}  // namespace percuss::pipeline
