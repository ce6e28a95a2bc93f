#include "acquire/live/capture_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <numeric>
#include <utility>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

using namespace std::chrono_literals;

// A reader's block is at most this late. A replay without a clock has no reason to wait.
constexpr std::chrono::microseconds kPause = 3ms, kFastPause = 200us;

std::vector<std::size_t> channels_kept(const DeviceFormat& device, std::vector<std::size_t> channels) {
  if (channels.empty()) {
    channels.resize(device.stream.channels);
    std::iota(channels.begin(), channels.end(), std::size_t{0});
  }
  for (const std::size_t channel : channels) {
    if (channel >= device.stream.channels) {
      throw InputError(fmt::format("there is no channel {}", channel + 1), device.stream.device,
                       fmt::format("name channels from 1 to {}", device.stream.channels), {"channels"});
    }
  }
  return channels;
}

StreamFormat format_of(const StreamFormat& device, const std::vector<std::size_t>& channels) {
  StreamFormat format = device;
  format.channels = channels.size();
  const auto choose = [&](const auto& all, auto& chosen) {
    if (all.empty()) return;
    chosen.clear();
    for (const std::size_t channel : channels) chosen.push_back(all[channel]);
  };
  choose(device.names, format.names);
  choose(device.units, format.units);
  choose(device.full_scales, format.full_scales);
  if (!format.full_scales.empty()) format.full_scale = format.full_scales.front();
  for (const std::size_t channel : channels) format.numbers.push_back(channel + 1);
  return format;
}

FrameLayout layout_of(const DeviceFormat& device, const std::vector<std::size_t>& channels) {
  FrameLayout layout{.type = device.type, .device_channels = device.stream.channels, .channels = channels};
  for (const std::size_t channel : channels)
    layout.scales.push_back(device.scales.empty() ? device.scale : device.scales[channel]);
  return layout;
}

std::unique_ptr<SessionJournal> journal_of(const CaptureOptions& options, const StreamFormat& format) {
  if (options.journal.empty()) return nullptr;
  if (options.resume)
    return std::make_unique<SessionJournal>(JournalWriter::resumed(options.journal, format, options.seamless));
  return std::make_unique<SessionJournal>(JournalWriter(options.journal, format, options.overwrite));
}

}  // namespace

StreamFormat stream_format(const DeviceFormat& device, const std::vector<std::size_t>& channels) {
  return format_of(device.stream, channels_kept(device, channels));
}

std::vector<ChannelSetup> stream_setup(const DeviceFormat& device, const std::vector<std::size_t>& channels) {
  std::vector<ChannelSetup> out;
  if (device.setup.empty()) return out;
  for (const std::size_t channel : channels_kept(device, channels)) {
    out.push_back(device.setup[channel]);
    out.back().name = std::to_string(channel + 1);
  }
  return out;
}

CaptureStream::CaptureStream(std::unique_ptr<Device> device, const CaptureOptions& options)
    : device_(std::move(device)), pause_(device_->format().pace == DevicePace::reader ? kFastPause : kPause) {
  const DeviceFormat& given = device_->format();
  const std::vector<std::size_t> channels = channels_kept(given, options.channels);
  format_ = format_of(given.stream, channels);
  store_ = std::make_unique<SampleStore>(layout_of(given, channels), format_, given.pace, journal_of(options, format_),
                                         options.store);
  try {
    device_->start(store_->sink());
    writer_ = std::thread([this] { pump(); });
  } catch (...) {
    device_->stop();
    store_.reset();
    if (!options.journal.empty() && !options.resume) std::remove(options.journal.c_str());
    throw;
  }
}

CaptureStream::~CaptureStream() { stop(); }

void CaptureStream::pump() {
  try {
    while (store_->ended() == StreamEnd::none) {
      if (const StreamEnd reason = device_->check(); reason != StreamEnd::none) store_->sink().end(reason);
      if (!store_->pump()) std::this_thread::sleep_for(pause_);
    }
    store_->finish();
    finished_ = true;
    // The reader may ask for samples of the journal after the device has ended.
    while (!stopping_) {
      if (!store_->pump()) std::this_thread::sleep_for(pause_);
    }
    store_->close_journal();
  } catch (const std::exception&) {  // no memory is left
    store_->sink().end(StreamEnd::failed);
  }
  finished_ = true;
}

std::optional<SampleBlock> CaptureStream::next(std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  for (;;) {
    const bool last = finished_;  // read before take(): a block that arrives in between is not missed
    if (auto block = store_->take()) return block;
    if (last || std::chrono::steady_clock::now() >= deadline) return {};
    std::this_thread::sleep_for(pause_);
  }
}

StreamEnd CaptureStream::end() const {
  return finished_ && store_->everything_taken() ? store_->ended() : StreamEnd::none;
}

void CaptureStream::stop() {
  device_->stop();
  store_->sink().end(StreamEnd::finished);
  stopping_ = true;
  if (writer_.joinable()) writer_.join();
}

void CaptureStream::append_event(const std::string& json) { store_->append_event(json); }

}  // namespace percuss::acquire
