#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "acquire/hits/time_selection.hpp"
#include "core/math/fft.hpp"
#include "core/math/statistics.hpp"
#include "pipeline/live/guide.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kFirstHorizon_s = 0.5;
constexpr std::size_t kHorizons = 6;    // 0.5 s … 16 s
constexpr double kMinCut_s = 0.5;       // of a window that the next blow or a gap ends
constexpr double kMinRow_s = 0.1;       // of one that ends with the row of a replayed record: all rows may be short
constexpr double kSpareAtCut = 0.98;    // the next blows come a little later in their windows
constexpr std::size_t kMinTypical = 2;  // blows
constexpr double kSmallContact = 0.01;  // of the peak: a smaller one lets nothing ring

// The rms of the strongest sinusoid, from a spectrum with a Hann window: a mode that rings stands out from the noise
// long after the noise has the larger rms.
double strongest_tone(std::vector<double> x) {
  x.resize(fast_length_at_most(x.size()));
  const auto n = static_cast<double>(x.size());
  const double mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = (x[i] - mean) * (0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / n));
  const std::vector<Complex> lines = real_dft(x);
  double largest = 0;
  for (std::size_t k = 2; k < lines.size(); ++k) largest = std::max(largest, std::abs(lines[k]));  // no slow drift
  return largest * 4 / n / std::numbers::sqrt2;
}

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

// The samples from the blow to the next blow, or to lost samples.
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

double Guide::typical(double SessionState::Blow::*value) const {
  std::vector<double> values;
  for (const SessionState::Blow& blow : session_.blows()) {
    if (blow.accepted()) values.push_back(std::abs(blow.*value));
  }
  return values.size() < kMinTypical ? 0 : median(std::move(values));
}

double Guide::clipped_at_N() const {
  constexpr std::size_t kMinClipped = 2;  // blows
  constexpr double kSpread = 1.01;        // largest over smallest of one level
  std::vector<double> peaks_N;
  for (const SessionState::Blow& blow : session_.blows()) {
    if (blow.mark == acquire::RowMark::force_overload) peaks_N.push_back(std::abs(blow.peak_N));
  }
  if (peaks_N.size() < kMinClipped) return 0;
  const auto [least, most] = std::minmax_element(peaks_N.begin(), peaks_N.end());
  return *most < kSpread * *least ? *most : 0;
}

void Guide::note_rest(const Window& window) {
  const std::size_t guard = pretrigger_ / 8;  // a filter may let the response begin a little early
  std::uint64_t first = window.event.first - std::min<std::uint64_t>(window.event.first, rest_frames_);
  const std::uint64_t last = window.event.first - std::min<std::uint64_t>(window.event.first, guard);
  first = std::max({first, start_frame_, history_.first_frame()});
  for (const SampleLoss& loss : history_.losses(first, last)) first = std::max(first, loss.frame + loss.frames);
  rest_.resize(channels_.accel.size());
  constexpr std::size_t kMinRest = 12;  // samples that give a level
  if (last < first + kMinRest) {
    for (BlowCircumstances::Rest& rest : rest_) rest.before_mps2 = 0;
    return;
  }
  std::vector<double> x(last - first);
  for (std::size_t c = 0; c < rest_.size(); ++c) {
    history_.read(channels_.accel[c], first, x);
    const double level_mps2 = strongest_tone(x) * std::abs(channels_.accel_to_mps2[c]);
    rest_[c].before_mps2 = level_mps2;
    rest_[c].noise_mps2 = std::min(rest_[c].noise_mps2, level_mps2);
  }
}

BlowCircumstances Guide::circumstances(const Window& window) const {
  const std::uint64_t end = window.first + *length_;
  const auto losses = history_.losses(window.first, end);
  const auto any = [&](const auto& is) { return std::any_of(losses.begin(), losses.end(), is); };
  const bool row_ended = any([&](const SampleLoss& loss) { return is_pause(loss); });
  const bool frames_lost = any([&](const SampleLoss& loss) { return !loss.channel && !is_pause(loss); });
  BlowCircumstances at{.lost_samples = frames_lost,
                       .row_ended = row_ended,
                       .recording_ended = history_.end_frame() < end,
                       .struck_again = windows_.size() > 1 && windows_[1].event.first < end,
                       .during_previous = window.event.first < previous_end_,
                       .typical_peak_N = typical(&SessionState::Blow::peak_N),
                       .typical_bandwidth_Hz = typical(&SessionState::Blow::bandwidth_Hz),
                       .pretrigger = static_cast<std::size_t>(window.event.peak - window.first),
                       .rest = rest_,
                       .none_accepted = session_.accepted() == 0,
                       .all_rejected = session_.accepted() == 0 && !session_.blows().empty(),
                       .length_stated = options_.length_s.has_value(),
                       .clipped_at_N = clipped_at_N()};
  // The analysis sees contacts within the samples.
  const auto& earlier = window.event.earlier;
  if (earlier && earlier->peak < window.first && earlier->ratio > kSmallContact) {
    at.contact_before = earlier->ratio;
    at.contact_before_s = static_cast<double>(window.event.peak - earlier->peak) / fs_Hz_;
  }
  for (std::size_t s = 0; s <= channels_.accel.size() && !at.no_numbers; ++s) {
    const std::size_t channel = s == 0 ? channels_.force : channels_.accel[s - 1];
    if (any([&](const SampleLoss& loss) { return loss.channel == channel; })) at.no_numbers = s;
  }
  if (!(full_scales_.at(channels_.force) > 0)) return at;
  std::vector<double> x(*length_);
  const auto largest = [&](std::size_t channel) {
    history_.read(channel, window.first, x);
    const Extremes all = extremes_of(x);
    const double full_scale = full_scales_.at(channel);
    at.range.push_back(full_scale > 0 ? std::max(std::abs(all.low), std::abs(all.high)) / full_scale : 0);
  };
  largest(channels_.force);
  for (const std::size_t channel : channels_.accel) largest(channel);
  return at;
}

}  // namespace percuss::pipeline
