#include "pipeline/live/guide.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "acquire/hits/time_selection.hpp"
#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kLongGap_s = 1;     // after a longer one the trigger begins anew
constexpr std::size_t kFeed = 4096;  // samples
constexpr double kStrongPush = 0.2;  // of the usual blow, or of the last push: a weaker one was no attempt to strike
constexpr double kRest_s = 0.2;      // before a blow, where the structure should be at rest
constexpr double kMissedResponse = 0.3;  // of the usual response: no such motion comes without a blow

// The frames of a block before `frame`, and the rest.
std::pair<acquire::SampleBlock, acquire::SampleBlock> split(acquire::SampleBlock block, std::uint64_t frame) {
  acquire::SampleBlock rest{.first_frame = frame};
  const std::size_t channels = block.values.size() / block.frames, kept = frame - block.first_frame;
  const auto at = block.values.begin() + static_cast<std::ptrdiff_t>(kept * channels);
  rest.values.assign(at, block.values.end());
  rest.frames = block.frames - kept;
  block.values.erase(at, block.values.end());
  block.frames = kept;
  return {std::move(block), std::move(rest)};
}

}  // namespace

Guide::Guide(const acquire::StreamFormat& format, LiveChannels channels, GuideOptions options, acquire::SessionLog& log,
             GuideObserver& observer)
    : channels_(std::move(channels)),
      options_(std::move(options)),
      log_(log),
      observer_(observer),
      format_(format),
      fs_Hz_(format.fs_Hz),
      full_scales_(format.full_scales.empty() ? std::vector(format.channels, format.full_scale) : format.full_scales),
      pretrigger_(pretrigger_of(0)),
      session_(options_.plan),
      history_(format.channels),
      rest_frames_(std::max(pretrigger_, static_cast<std::size_t>(kRest_s * fs_Hz_))),
      store_(std::make_shared<RowStore>(options_.folder, channels_.accel.size())),
      faults_(format.fs_Hz) {
  channels_.description.geometry = options_.geometry;
  channels_.description.trace_lines = options_.trace_lines;
  channels_.description.trace_faces = options_.trace_faces;
  if (options_.length_s) length_ = acquire::selected_length(channels_.description, {.length_s = options_.length_s});
}

void Guide::take(acquire::SampleBlock block) {
  // A command of the interrupted session applies after the same frame as then.
  while (!past_commands_.empty() && block.frames > 0) {
    const SessionEvent command = past_commands_.front();
    if (command.frame >= block.first_frame + block.frames) break;
    if (command.frame > block.first_frame) {
      auto [before, after] = split(std::move(block), command.frame);
      take_whole(std::move(before));
      block = std::move(after);
    }
    past_commands_.pop_front();
    commands_.push_back(command);
    apply_commands(false);
  }
  take_whole(std::move(block));
}

void Guide::take_whole(acquire::SampleBlock block) {
  if (session_.finished() || block.frames == 0) return;
  if (!started_) {
    started_ = true;
    start_frame_ = fed_ = previous_end_ = noted_ = block.first_frame;
    trigger_ =
        std::make_unique<OnlineTrigger>(OnlineTriggerOptions{.fs_Hz = fs_Hz_, .trigger_N = options_.trigger_N}, fed_);
    watch_.emplace(fs_Hz_);
  }
  const std::uint64_t before = history_.end_frame(), first = std::max(before, block.first_frame);
  history_.add(std::move(block));
  feed_trigger(before);
  collect_events();
  watch_hammer(first);
  advance(false);
  apply_commands(false);
  const std::uint64_t searched = trigger_->searched_to();
  note_losses(windows_.empty() ? searched : std::min(searched, windows_.front().event.first));
  forget();
}

void Guide::feed_trigger(std::uint64_t from) {
  const auto losses = force_losses(from, history_.end_frame());
  for (const SampleLoss& loss : losses) {
    if (loss.frame < fed_ || static_cast<double>(loss.frames) < kLongGap_s * fs_Hz_) continue;
    trigger_->finish();
    collect_events();
    fed_ = loss.frame + loss.frames;
    trigger_ =
        std::make_unique<OnlineTrigger>(OnlineTriggerOptions{.fs_Hz = fs_Hz_, .trigger_N = options_.trigger_N}, fed_);
  }
  std::vector<double> x;
  while (fed_ < history_.end_frame()) {
    std::uint64_t until = std::min(fed_ + kFeed, history_.end_frame());
    bool lost = false;
    for (const SampleLoss& loss : losses) {
      if (loss.frames == 0 || loss.frame + loss.frames <= fed_ || loss.frame >= until) continue;
      lost = loss.frame <= fed_;
      until = lost ? std::min(until, loss.frame + loss.frames) : loss.frame;
      break;
    }
    x.resize(until - fed_);
    history_.read(channels_.force, fed_, x);
    for (double& value : x) value *= channels_.force_to_N;
    trigger_->add(x, lost);
    fed_ = until;
  }
}

void Guide::collect_events() {
  while (const auto event = trigger_->next()) {
    windows_.push_back({.event = *event, .first = window_start(*event)});
  }
  while (const auto push = trigger_->next_long_push()) {
    watch_.reset();  // the hammer is not silent
    if (is_attempt(*push)) observer_.on_long_push(*push);
  }
}

bool Guide::is_attempt(const LongPush& push) {
  const double size_N = std::abs(push.peak_N), usual_N = typical(&SessionState::Blow::peak_N);
  const bool strong = size_N >= kStrongPush * (usual_N > 0 ? usual_N : std::abs(reported_push_.peak_N));
  const bool handling = reported_push_.peak > 0 && push.peak < reported_push_.peak + static_cast<std::uint64_t>(fs_Hz_);
  if (!strong || handling) return false;
  reported_push_ = push;
  return true;
}

// A sensor that is moved shakes more than a blow shakes it.
void Guide::watch_on(std::uint64_t from) {
  const bool moving = options_.sensor_moves && session_.accepted_at(session_.point()) == 0;
  if (moving || response_peaks_.empty()) return watch_.reset();
  watch_.emplace(fs_Hz_, kMissedResponse * median(response_peaks_));
  watch_from_ = from;
}

void Guide::watch_hammer(std::uint64_t from) {
  from = std::max(from, watch_from_);
  if (!watch_ || session_.paused() || from >= history_.end_frame()) return;
  if (!windows_.empty()) return watch_.reset();
  std::vector<double> x(history_.end_frame() - from);
  history_.read(channels_.accel.front(), from, x);
  watch_->add(from, x);
  if (!watch_->is_silent(trigger_->searched_to())) return;
  watch_.reset();
  observer_.on_silent_hammer();
  if (length_) watch_on(history_.end_frame() + *length_);
}

bool Guide::all_known_before(std::uint64_t frame) const { return trigger_->searched_to() >= frame; }

bool Guide::is_complete(const Window& window, bool last) const {
  const std::uint64_t end = window.first + *length_;
  if (last) return true;
  if (history_.end_frame() < end) return false;
  const bool next_known = windows_.size() > 1 && windows_[1].event.first < end;
  return next_known || all_known_before(end);
}

void Guide::advance(bool last) {
  while (!windows_.empty() && !session_.finished()) {
    apply_commands(false);
    if (session_.finished()) return;
    Window& window = windows_.front();
    note_losses(window.event.first);
    if (!length_ && !choose_length(window, last)) return;
    if (length_) {
      if (!is_complete(window, last)) return;
      judge(window);
      if (session_.finished()) {
        note_losses(previous_end_);
        complete_ = true;
      }
    } else if (!session_.paused()) {
      observer_.on_left_out(window.event.first, too_early(window));
    }
    windows_.pop_front();
    if (windows_.empty() && length_) watch_on(previous_end_);
  }
}

void Guide::finish() {
  if (started_ && !session_.finished()) {
    trigger_->finish();
    collect_events();
    advance(true);
  }
  apply_commands(true);
  note_losses(history_.end_frame());
  for (const acquire::CaptureFinding& fault : faults_.finish(complete_)) observer_.on_fault(fault);
}

void Guide::forget() {
  const std::uint64_t searched = trigger_->searched_to();
  const auto rest_before = [&](std::uint64_t frame) { return frame - std::min<std::uint64_t>(frame, rest_frames_); };
  std::uint64_t needed = rest_before(searched);
  if (!windows_.empty()) needed = std::min(needed, rest_before(windows_.front().event.first));
  history_.discard_before(needed);
}

}  // namespace percuss::pipeline
