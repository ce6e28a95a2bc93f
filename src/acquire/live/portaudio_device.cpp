#include "acquire/live/portaudio_device.hpp"

#include <fmt/format.h>
#include <portaudio.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

#include "acquire/live/sound_cards/portaudio_functions.hpp"
#include "acquire/live/sound_cards/portaudio_library.hpp"
#include "acquire/live/sound_cards/sound_cards.hpp"
#include "acquire/live/sound_cards/usb_front_end.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kUsualChannels = 2, kMaxUnasked = 32;  // a converting device of ALSA offers 128
constexpr double kMaxRateError = 1e-3;
constexpr std::chrono::seconds kSilence{2};  // without a callback: the device is gone

[[noreturn]] void fail_to_open(PaError error, const PortAudioInput& input) {
  check_card_is_free(sound_card_inputs(), input.name);
  if (error == paInvalidSampleRate) {
    throw InputError("the device does not offer this sampling rate", input.name, "percuss devices lists its rates",
                     {"fs"});
  }
  throw InputError(std::string("cannot open the device: ") + PERCUSS_PORTAUDIO(Pa_GetErrorText)(error), input.name,
                   "end programs that use it, or choose another device", {"device"});
}

class PortAudioDevice final : public Device {
 public:
  PortAudioDevice(const std::string& name, bool alsa_only, const DeviceOptions& options)
      : input_(find_input(library_.inputs(), name, alsa_only)) {
    const std::size_t usual = input_.channels <= kMaxUnasked ? input_.channels : kUsualChannels;
    const std::size_t channels = std::max(usual, options.channels.value_or(0));
    if (channels > input_.channels) {
      throw InputError(fmt::format("the device has {} channels", input_.channels), input_.name, "name fewer",
                       {"channels"});
    }
    const double fs_Hz = options.fs_Hz.value_or(input_.default_fs_Hz);
    const PaStreamParameters parameters{.device = input_.index,
                                        .channelCount = static_cast<int>(channels),
                                        .sampleFormat = paInt32,
                                        .suggestedLatency = input_.latency_s,
                                        .hostApiSpecificStreamInfo = nullptr};
    PaError error = paNoError;
    {
      const SilencedErrors quiet;
      error = PERCUSS_PORTAUDIO(Pa_OpenStream)(&stream_, &parameters, nullptr, fs_Hz, paFramesPerBufferUnspecified,
                                               paClipOff | paDitherOff, &PortAudioDevice::receive, this);
    }
    if (error != paNoError) fail_to_open(error, input_);
    describe(channels, fs_Hz);
  }
  ~PortAudioDevice() override {
    stop();
    const SilencedErrors quiet;
    PERCUSS_PORTAUDIO(Pa_CloseStream)(stream_);
  }

  const DeviceFormat& format() const override { return format_; }

  void start(FrameSink& sink) override {
    sink_ = &sink;
    const std::lock_guard guard(mutex_);
    const SilencedErrors quiet;
    if (const PaError error = PERCUSS_PORTAUDIO(Pa_StartStream)(stream_); error != paNoError)
      fail_to_open(error, input_);
    running_ = true;
    heard_ = Clock::now();
  }

  void stop() override {
    const std::lock_guard guard(mutex_);
    if (!running_) return;
    running_ = false;
    const SilencedErrors quiet;
    PERCUSS_PORTAUDIO(Pa_AbortStream)(stream_);
  }

  StreamEnd check() override {
    const std::lock_guard guard(mutex_);
    if (!running_) return StreamEnd::none;
    const std::uint64_t callbacks = callbacks_.load(std::memory_order_relaxed);
    const Clock::time_point now = Clock::now();
    if (callbacks != known_callbacks_) {
      known_callbacks_ = callbacks;
      heard_ = now;
    }
    return now - heard_ > kSilence || PERCUSS_PORTAUDIO(Pa_IsStreamActive)(stream_) != 1 ? StreamEnd::unplugged
                                                                                         : StreamEnd::none;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void describe(std::size_t channels, double fs_Hz) {
    const PaStreamInfo* const info = PERCUSS_PORTAUDIO(Pa_GetStreamInfo)(stream_);
    const double actual_Hz = info != nullptr ? info->sampleRate : fs_Hz;
    if (std::abs(actual_Hz - fs_Hz) > kMaxRateError * fs_Hz)
      throw InputError(fmt::format("the device runs at {:.10g} Hz", actual_Hz), input_.name, "state this rate", {"fs"});
    format_.stream = {.device = input_.name, .fs_Hz = fs_Hz, .channels = channels, .full_scale = 1};
    format_.type = SampleType::int32;
    format_.scale = 0x1p-31;
    const auto card = card_in_name(input_.name);
    const auto front_end = card ? front_end_of_card(*card) : std::nullopt;
    if (!front_end || channels > front_end->full_scales.size()) return;
    format_.stream.device = front_end->model + " " + front_end->serial;
    format_.stream.full_scale = front_end->full_scales[0];
    for (std::size_t c = 0; c < channels; ++c) {
      format_.stream.units.push_back(front_end->unit);
      format_.stream.full_scales.push_back(front_end->full_scales[c]);
      format_.scales.push_back(0x1p-31 * front_end->full_scales[c]);
    }
  }

  // Runs in a thread of PortAudio: no allocation, no lock, no system call.
  static int receive(const void* frames, void*, unsigned long count, const PaStreamCallbackTimeInfo*,
                     PaStreamCallbackFlags flags, void* self) {
    auto& device = *static_cast<PortAudioDevice*>(self);
    if ((flags & (paInputOverflow | paInputUnderflow)) != 0) device.sink_->skip(0, true);
    if (frames != nullptr) device.sink_->write(frames, count);
    device.callbacks_.fetch_add(1, std::memory_order_relaxed);
    return paContinue;
  }

  PortAudioLibrary library_;
  const PortAudioInput input_;
  DeviceFormat format_;
  PaStream* stream_ = nullptr;
  FrameSink* sink_ = nullptr;
  std::atomic<std::uint64_t> callbacks_{0};
  std::uint64_t known_callbacks_ = 0;
  std::mutex mutex_;  // of the calls of PortAudio once the stream runs, and the members below
  bool running_ = false;
  Clock::time_point heard_;
};

}  // namespace

std::unique_ptr<Device> open_portaudio_device(const std::string& name, bool alsa_only, const DeviceOptions& options) {
  return std::make_unique<PortAudioDevice>(name, alsa_only, options);
}

}  // namespace percuss::acquire
