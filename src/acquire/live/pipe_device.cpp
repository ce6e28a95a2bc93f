#include "acquire/live/pipe_device.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "acquire/live/polled_device.hpp"
#include "acquire/live/wav_header.hpp"
#include "core/error.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::acquire {
namespace {

constexpr int kPipePoll_ms = 50;
constexpr std::size_t kPipePiece_bytes = std::size_t{1} << 16U;
constexpr std::chrono::seconds kHeaderTimeout{10};

// Reads the available bytes, at most out.size(). Returns their number: 0 if none came in time, negative at the end of
// the stream or after a failure.
ssize_t read_available(int descriptor, std::span<std::byte> out) {
  pollfd ready{.fd = descriptor, .events = POLLIN, .revents = 0};
  if (::poll(&ready, 1, kPipePoll_ms) <= 0) return 0;
  const ssize_t got = ::read(descriptor, out.data(), out.size());
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return 0;
  return got > 0 ? got : -1;
}

bool fill_from(int descriptor, std::span<std::byte> out) {
  const auto deadline = std::chrono::steady_clock::now() + kHeaderTimeout;
  while (!out.empty()) {
    const ssize_t got = read_available(descriptor, out);
    if (got < 0 || std::chrono::steady_clock::now() > deadline) return false;
    out = out.subspan(static_cast<std::size_t>(got));
  }
  return true;
}

double number_up_to(double high, const std::string& text, bool whole, const std::string& where) {
  const ParsedNumber parsed = parse_number(text, false);
  if (parsed.problem != NumberProblem::none || !(parsed.value > 0) || parsed.value > high ||
      (whole && parsed.value != std::floor(parsed.value)))
    throw InputError("a wrong rate or number of channels", one_line(where), "write stdin:raw:s24:51200:2", {"device"});
  return parsed.value;
}

WavHeader raw_header(const std::string& description) {
  std::vector<std::string> parts(1);
  for (const char c : description) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  if (parts.size() != 4 || parts[0] != "raw") {
    throw InputError("standard input is not described", one_line(description),
                     "write stdin:wav, or stdin:raw:ENCODING:RATE:CHANNELS such as stdin:raw:s24:51200:2", {"device"});
  }
  constexpr double kMaxRate_Hz = 1e7, kMaxPipeChannels = 1024;
  return {.encoding = pcm_encoding(parts[1]),
          .fs_Hz = number_up_to(kMaxRate_Hz, parts[2], false, description),
          .channels = static_cast<std::size_t>(number_up_to(kMaxPipeChannels, parts[3], true, description))};
}

DeviceFormat pipe_format(const WavHeader& header) {
  DeviceFormat format{.type = pcm_type(header.encoding), .pace = DevicePace::ring};
  const bool integer = format.type == SampleType::int32;
  format.scale = integer ? 0x1p-31 : 1;
  format.stream = {
      .device = "stdin", .fs_Hz = header.fs_Hz, .channels = header.channels, .full_scale = integer ? 1.0 : 0.0};
  return format;
}

// Whether a set-up states units or sensitivities. They apply to the stored numbers, so the scales of the header are
// then not used.
bool states_scales(const std::vector<ChannelSetup>& setup) {
  return std::any_of(setup.begin(), setup.end(), [](const ChannelSetup& channel) {
    return channel.unit.has_value() || channel.sensitivity_V_per_SI.has_value();
  });
}

// Takes the rate and the names. If `scaled`, also takes the scales: each channel is then in SI units, as in a file of
// the same bytes.
void take_calibration(const SoundCalibration& calibration, bool scaled, DeviceFormat& format) {
  const bool integer = format.type == SampleType::int32;
  StreamFormat& stream = format.stream;
  if (calibration.fs_Hz > 0) stream.fs_Hz = calibration.fs_Hz;
  for (const SoundCalibration::Signal& signal : calibration.signals) {
    stream.names.push_back(signal.name);
    if (!scaled) continue;
    stream.units.emplace_back(si_name(signal.measures));
    format.scales.push_back(format.scale * signal.to_SI);
    if (integer) stream.full_scales.push_back(std::abs(signal.to_SI));
  }
}

class PipeDevice final : public PolledDevice {
 public:
  PipeDevice(const WavHeader& header, DeviceFormat format, int descriptor)
      : descriptor_(descriptor),
        encoding_(header.encoding),
        frame_bytes_(pcm_bytes(header.encoding) * header.channels),
        left_bytes_(header.data_bytes),
        format_(std::move(format)),
        buffer_(std::max(kPipePiece_bytes, frame_bytes_)) {}
  ~PipeDevice() override { stop(); }

  const DeviceFormat& format() const override { return format_; }

 protected:
  void poll(FrameSink& sink) override {
    const std::size_t wanted = static_cast<std::size_t>(std::min<std::uint64_t>(buffer_.size() - held_, left_bytes_));
    if (wanted == 0) return sink.end(StreamEnd::finished);
    const ssize_t got = read_available(descriptor_, std::span(buffer_).subspan(held_, wanted));
    if (got < 0) return sink.end(StreamEnd::finished);
    held_ += static_cast<std::size_t>(got);
    left_bytes_ -= static_cast<std::uint64_t>(got);
    const std::size_t whole = held_ - held_ % frame_bytes_;
    if (whole == 0) return;
    decode_pcm(encoding_, std::span(buffer_).first(whole), decoded_);
    write_with_room(sink, decoded_, format_.stream.channels * bytes_per_sample(format_.type));
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(whole),
              buffer_.begin() + static_cast<std::ptrdiff_t>(held_), buffer_.begin());
    held_ -= whole;
  }

 private:
  const int descriptor_;
  const PcmEncoding encoding_;
  const std::size_t frame_bytes_;
  std::uint64_t left_bytes_;
  const DeviceFormat format_;
  std::vector<std::byte> buffer_, decoded_;
  std::size_t held_ = 0;
};

}  // namespace

std::unique_ptr<Device> open_pipe_device(const std::string& description, int descriptor, const DeviceOptions& options) {
  const auto fill = [&](std::span<std::byte> out) { return fill_from(descriptor, out); };
  const WavHeader header = description == "wav" ? read_wav_header(fill) : raw_header(description);
  DeviceFormat format = pipe_format(header);
  if (header.calibration) take_calibration(*header.calibration, !states_scales(options.setup), format);
  require_rate(format.stream.fs_Hz, options, "standard input");
  return std::make_unique<PipeDevice>(header, std::move(format), descriptor);
}

}  // namespace percuss::acquire
