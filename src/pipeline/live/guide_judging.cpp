// The verdict on a blow, and its circumstances (BlowCircumstances).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/math/fft.hpp"
#include "core/math/statistics.hpp"
#include "pipeline/live/guide.hpp"

namespace percuss::pipeline {
namespace {

using Kind = SessionEvent::Kind;

constexpr std::size_t kCompared = 8;         // blows of the point: time and memory of a verdict stay bounded
constexpr std::size_t kGainAdviceBlows = 2;  // first blows, while ranges may still be set: advice on gains
constexpr double kMuchWeaker = 0.5;          // than an earlier blow: no reason to raise a gain
constexpr std::size_t kMinToCompare = 3;     // blows: two do not tell which is weak
constexpr std::size_t kResponses = 20;       // last accepted blows: the median of their responses is the usual one
constexpr std::size_t kMinTypical = 2;       // blows
constexpr double kSmallContact = 0.01;       // of the peak: a smaller one lets nothing ring

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

void Guide::judge(const Window& window) {
  if (session_.paused()) return;
  const BlowSamples samples = read_blow(history_, channels_, window.first, *length_);
  const bool cut = length_by_end_ || history_.end_frame() < window.first + *length_;  // by the end of the recording
  note_rest(window);
  BlowGrade graded = grade(samples, window);
  regrade_weak(graded);
  BlowReport report{.row = session_.blows().size(),
                    .end_frame = window.first + *length_,
                    .point = session_.point(),
                    .blow = session_.accepted_at(session_.point()) + 1,
                    .grade = graded,
                    .may_advise_gain = may_advise_gain(graded)};
  store_->append(samples);
  previous_end_ = report.end_frame;
  note_response(samples, graded);
  const SessionEvent event{.kind = Kind::blow,
                           .frame = window.first,
                           .mark = graded.mark,
                           .point = session_.point(),
                           .message = graded.accepted() ? "accepted" : graded.reason + "; " + graded.remedy,
                           .peak_N = graded.peak_N,
                           .bandwidth_Hz = graded.bandwidth_Hz,
                           .differ = graded.blows_differ};
  report.repeated = repeat_past(event);
  if (report.repeated) return observer_.on_blow(report);
  if (cut) {  // not in the journal: a resumed session judges it again, with the samples that follow
    session_.apply(event);
    return observer_.on_blow(report);
  }
  for (const auto& [row, mark] : graded.regraded)
    log_and_apply({.kind = Kind::regraded, .frame = window.first, .mark = mark, .row = row});
  log_and_apply(event);
  report.one_more = graded.accepted() && !session_.finished() && session_.point() == report.point &&
                    session_.accepted_at(report.point) >= session_.plan().hits;
  observer_.on_blow(report);
  for (const auto& [row, mark] : graded.regraded) observer_.on_regraded(row, mark);
  if (graded.accepted()) check_goals();
}

void Guide::note_response(const BlowSamples& samples, const BlowGrade& grade) {
  if (!grade.accepted()) return;
  const double to_mps2 = std::abs(channels_.accel_to_mps2.front());
  response_peaks_.push_back(extremes_of(samples[1]).max_distance_from(0) / to_mps2);
  if (response_peaks_.size() > kResponses) response_peaks_.erase(response_peaks_.begin());
}

bool Guide::may_advise_gain(const BlowGrade& grade) const {
  const auto& blows = session_.blows();
  return blows.size() < kGainAdviceBlows &&
         std::all_of(blows.begin(), blows.end(), [&](const SessionState::Blow& blow) {
           return kMuchWeaker * std::abs(blow.peak_N) <= std::abs(grade.peak_N);
         });
}

void Guide::regrade_weak(BlowGrade& grade) const {
  if (!grade.accepted()) return;
  std::vector<double> peaks_N{std::abs(grade.peak_N)};
  const std::vector<std::size_t> rows = session_.accepted_rows();
  for (const std::size_t row : rows) peaks_N.push_back(std::abs(session_.blows()[row].peak_N));
  if (peaks_N.size() < kMinToCompare) return;
  const double least_N = kWeakBlow * median(std::move(peaks_N));
  for (const std::size_t row : rows) {
    const bool known = std::any_of(grade.regraded.begin(), grade.regraded.end(),
                                   [row](const BlowGrade::Regraded& other) { return other.row == row; });
    if (!known && std::abs(session_.blows()[row].peak_N) < least_N)
      grade.regraded.push_back({.row = row, .mark = acquire::RowMark::weak});
  }
}

BlowGrade Guide::grade(const BlowSamples& samples, const Window& window) const {
  const auto past = past_.find(window.first);
  const bool whole = force_losses(window.first, window.first + *length_).empty();
  if (past != past_.end() && past->second.blow && whole) {
    const SessionEvent& blow = *past->second.blow;
    return {.mark = blow.mark,
            .reason = blow.message,
            .peak_N = blow.peak_N,
            .bandwidth_Hz = blow.bandwidth_Hz,
            .blows_differ = blow.differ};
  }
  std::vector<std::size_t> rows = session_.accepted_rows(session_.point());
  if (rows.size() > kCompared) rows.erase(rows.begin(), rows.end() - static_cast<std::ptrdiff_t>(kCompared));
  return grade_blow(samples, circumstances(window),
                    {.channels = channels_, .store = store_, .rows = std::move(rows), .options = options_.analysis});
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
    const double full_scale = full_scales_.at(channel);
    at.range.push_back(full_scale > 0 ? extremes_of(x).max_distance_from(0) / full_scale : 0);
  };
  largest(channels_.force);
  for (const std::size_t channel : channels_.accel) largest(channel);
  return at;
}

}  // namespace percuss::pipeline
