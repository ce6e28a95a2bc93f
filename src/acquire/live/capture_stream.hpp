#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "acquire/live/device.hpp"
#include "acquire/live/sample_store.hpp"
#include "acquire/live/sample_stream.hpp"

namespace percuss::acquire {

struct CaptureOptions {
  std::string journal;                  // path; empty: no journal
  bool overwrite = false;               // an existing journal
  bool resume = false;                  // continue an existing journal
  bool seamless = false;                // on resuming, the device goes on at the frame where the journal ends
  std::vector<std::size_t> channels{};  // of the device, from 0, in this order; empty: all
  StoreOptions store{};
};

/// The format of a stream of these channels of the device, counted from 0; empty: all.
/// errors  InputError: a channel that the device does not have
StreamFormat stream_format(const DeviceFormat& device, const std::vector<std::size_t>& channels);

/// The set-up that the device has applied, for these channels; their names are their numbers at the device, from 1
/// (StreamFormat::numbers). Empty: none.
/// errors  InputError: as stream_format
std::vector<ChannelSetup> stream_setup(const DeviceFormat& device, const std::vector<std::size_t>& channels);

/// A running device with its journal. The device's thread fills a ring without waiting for anybody, a thread writes the
/// journal, and the reader gets each block once: from memory, or from the journal when it has stalled. The journal is
/// made at once and takes events and findings; samples follow from keep_from() on, or when the reader stalls. A
/// kill of the process loses the samples that are not yet written: less than one block (StoreOptions::block_s), or more
/// on a busy machine. A loss of power loses what was written in the last second.
class CaptureStream final : public SampleStream, public SessionLog {
 public:
  /// Starts the capture.
  /// errors  InputError: a channel that the device does not have; as JournalWriter and Device::start
  CaptureStream(std::unique_ptr<Device> device, const CaptureOptions& options);
  ~CaptureStream() override;

  const StreamFormat& format() const override { return format_; }
  std::optional<SampleBlock> next(std::chrono::milliseconds patience) override;
  StreamEnd end() const override;
  void stop() override;

  /// The event is in the file when this returns. Where the disk is full, the event waits in memory until there is room.
  void append_event(const std::string& json) override;
  /// Begins the samples of the journal at this frame, which lies before the first trigger, or at the oldest frame in
  /// memory if that is later.
  void keep_from(std::uint64_t frame) { store_->keep_from(frame); }
  /// Findings since the last call. Whether the journal lacks samples is known after stop(): call it once more then. The
  /// journal holds the findings too.
  std::vector<CaptureFinding> take_findings() { return store_->take_findings(); }
  CaptureState state() const { return store_->state(); }

 private:
  void pump();

  std::unique_ptr<Device> device_;
  StreamFormat format_;
  std::chrono::microseconds pause_;
  std::unique_ptr<SampleStore> store_;
  std::atomic<bool> finished_{false}, stopping_{false};
  std::thread writer_;
};

}  // namespace percuss::acquire
