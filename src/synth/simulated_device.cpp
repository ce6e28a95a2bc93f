#include "synth/simulated_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <span>
#include <thread>
#include <vector>

#include "acquire/live/polled_device.hpp"
#include "synth/blow_renderer.hpp"

namespace percuss::synth {
namespace {

using acquire::DevicePace;
using acquire::StreamEnd;

constexpr std::uint64_t kCounterRange = std::uint64_t{1} << 24U;  // exact in 32-bit floats
constexpr std::size_t kPiece_frames = 2048;                       // rendered at once; samples depend on it
constexpr double kPoll_s = 0.005;

acquire::DeviceFormat simulated_format(const SimulatedSession& session, const std::vector<double>& full_scales) {
  acquire::DeviceFormat format;
  format.stream = {.device = "sim:" + session.spec.name,
                   .fs_Hz = session.spec.fs_Hz,
                   .channels = 1 + session.accels + (session.numbered ? 1U : 0U),
                   .names = {"force"},
                   .units = {"N"},
                   .full_scale = full_scales.front(),
                   .full_scales = full_scales};
  for (std::size_t a = 0; a < session.accels; ++a) {
    format.stream.names.push_back(fmt::format("accel {}", a + 1));
    format.stream.units.emplace_back("m/s^2");
  }
  if (session.numbered) {
    format.stream.names.emplace_back("count");
    format.stream.units.emplace_back("");
    format.stream.full_scales.push_back(0);
  }
  format.pace = session.fast ? DevicePace::reader : DevicePace::clock;
  return format;
}

class SimulatedDevice final : public acquire::PolledDevice {
 public:
  SimulatedDevice(SimulatedSession session, std::uint64_t start_frame)
      : session_(std::move(session)),
        renderer_(session_),
        format_(simulated_format(session_, renderer_.full_scales())) {
    for (const auto& gap : session_.gaps) losses_.push_back({frame_at(gap.from_s), frame_at(gap.for_s), false});
    for (const auto& lost : session_.overruns) losses_.push_back({frame_at(lost.from_s), frame_at(lost.for_s), true});
    frame_ = start_frame_ = start_frame;
    std::erase_if(losses_, [&](const Loss& loss) { return loss.at < start_frame; });
    std::sort(losses_.begin(), losses_.end(), [](const Loss& a, const Loss& b) { return a.at < b.at; });
    const auto end_at = [&](double at_s, StreamEnd reason) {
      if (frame_at(at_s) >= end_) return;
      end_ = frame_at(at_s);
      reason_ = reason;
    };
    end_at(session_.end_s, StreamEnd::finished);
    if (session_.unplug_s) end_at(*session_.unplug_s, StreamEnd::unplugged);
    if (session_.rate_change_s) end_at(*session_.rate_change_s, StreamEnd::rate_changed);
  }
  ~SimulatedDevice() override { stop(); }

  const acquire::DeviceFormat& format() const override { return format_; }

 protected:
  void poll(acquire::FrameSink& sink) override {
    if (frame_ >= end_) return sink.end(reason_);
    if (session_.fast) return write_until(std::min(end_, frame_ + kPiece_frames), sink);
    const Clock::time_point now = Clock::now();
    if (frame_ == start_frame_) start_ = now - std::chrono::milliseconds(1);
    const double elapsed_s = std::chrono::duration<double>(now - start_).count() * session_.speed;
    write_until(std::min(end_, start_frame_ + frame_at(elapsed_s)), sink);
    std::this_thread::sleep_for(std::chrono::duration<double>(kPoll_s));
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct Loss {
    std::uint64_t at = 0, frames = 0;
    bool overrun = false;
  };

  std::uint64_t frame_at(double time_s) const {
    return static_cast<std::uint64_t>(std::llround(time_s * session_.spec.fs_Hz));
  }

  bool within(const std::vector<SimulatedPeriod>& periods, double time_s) const {
    return std::any_of(periods.begin(), periods.end(),
                       [&](const auto& p) { return time_s >= p.from_s && time_s < p.from_s + p.for_s; });
  }

  void render_piece(std::uint64_t first) {
    const std::size_t from = renderer_.channels(), to = format_.stream.channels;
    clean_.resize(kPiece_frames * from);
    piece_.resize(kPiece_frames * to);
    renderer_.render(first, clean_);
    for (std::size_t i = 0; i < kPiece_frames; ++i) {
      const double time_s = static_cast<double>(first + i) / session_.spec.fs_Hz;
      const bool overloaded = within(session_.overloads, time_s), lost = within(session_.dropouts, time_s),
                 no_number = within(session_.no_numbers, time_s);
      for (std::size_t c = 0; c < from; ++c) {
        float& value = piece_[i * to + c];
        value = static_cast<float>(clean_[i * from + c]);
        if (c == 0) continue;  // faults of the sensors
        if (overloaded) value = static_cast<float>(renderer_.full_scales()[c]);
        if (lost) value = 0;
        if (no_number) value = std::numeric_limits<float>::quiet_NaN();
      }
      if (session_.numbered) piece_[i * to + from] = static_cast<float>((first + i) % kCounterRange);
    }
    piece_first_ = first;
    has_piece_ = true;
  }

  // The frames of a loss count in time, but never arrive.
  void write_until(std::uint64_t last, acquire::FrameSink& sink) {
    while (frame_ < last && !stopping()) {
      if (next_loss_ < losses_.size() && frame_ >= losses_[next_loss_].at) {
        const Loss& loss = losses_[next_loss_++];
        sink.skip(loss.frames, loss.overrun);
        frame_ += loss.frames;
        continue;
      }
      const std::uint64_t piece = frame_ - frame_ % kPiece_frames;
      if (!has_piece_ || piece != piece_first_) render_piece(piece);
      std::uint64_t until = std::min(last, piece + kPiece_frames);
      if (next_loss_ < losses_.size()) until = std::min(until, losses_[next_loss_].at);
      const auto count = static_cast<std::size_t>(until - frame_);
      const std::size_t channels = format_.stream.channels;
      const auto frames =
          std::span(piece_).subspan(static_cast<std::size_t>(frame_ - piece) * channels, count * channels);
      if (session_.fast) {
        write_with_room(sink, std::as_bytes(frames), channels * sizeof(float));
      } else {
        sink.write(frames.data(), count);
      }
      frame_ = until;
    }
  }

  const SimulatedSession session_;
  BlowRenderer renderer_;
  const acquire::DeviceFormat format_;
  std::vector<Loss> losses_;
  std::size_t next_loss_ = 0;
  std::uint64_t frame_ = 0, start_frame_ = 0, end_ = std::numeric_limits<std::uint64_t>::max();
  StreamEnd reason_ = StreamEnd::finished;
  Clock::time_point start_;
  std::vector<double> clean_;
  std::vector<float> piece_;
  std::uint64_t piece_first_ = 0;
  bool has_piece_ = false;
};

}  // namespace

std::unique_ptr<acquire::Device> open_simulated_device(const std::string& description,
                                                       const acquire::DeviceOptions& options) {
  return std::make_unique<SimulatedDevice>(parse_simulated_session(description, options), options.start_frame);
}

}  // namespace percuss::synth
