#include "acquire/live/file_device.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <thread>
#include <utility>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/live/polled_device.hpp"
#include "acquire/open_measurement.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kReplayPiece_frames = 4096;
constexpr double kReplayPoll_s = 0.005;

// Opens the file. Applies the stated rate only if the file states none.
Record open_at_own_rate(const std::string& path, ReadOptions read, const DeviceOptions& options) {
  read.force_optional = read.sandboxed = true;
  if (!options.fs_Hz) return open_record(path, read);
  try {
    return open_record(path, read);
  } catch (const InputError& error) {
    const auto& concerned = error.options();
    if (std::find(concerned.begin(), concerned.end(), "fs") == concerned.end()) throw;
  }
  read.fs_Hz = options.fs_Hz;
  return open_record(path, read);
}

bool is_number(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// Whether the file, read as `plain` without the set-up, must be read again with it. A number names a channel of the
// device, not a signal of the file.
bool needs_setup(const Record& plain, const std::vector<ChannelSetup>& setup) {
  if (setup.empty()) return false;
  const auto needed = [&](const ChannelSetup& entry) {
    if (is_number(entry.name) || entry.role == "ignore") return false;
    return entry.unit || entry.sensitivity_V_per_SI ||
           (entry.name != plain.force.name &&
            std::none_of(plain.accel.begin(), plain.accel.end(),
                         [&](const SignalInfo& signal) { return signal.name == entry.name; }));
  };
  return !plain.has_force || std::any_of(setup.begin(), setup.end(), needed);
}

// Roles, angles and positions. Signs and units have been applied: the samples are in SI units.
std::vector<ChannelSetup> applied_setup(const Record& record) {
  std::vector<ChannelSetup> out;
  const auto add = [&](const SignalInfo& signal, const char* role) {
    out.push_back({.name = signal.name, .role = role, .angle_rad = signal.angle_rad, .position_m = signal.position_m});
  };
  if (record.has_force) add(record.force, "force");
  for (const SignalInfo& signal : record.accel) add(signal, "acceleration");
  return out;
}

struct ReplayedFile {
  Record record;
  bool set_up = false;  // the set-up served to read it
};

ReplayedFile open_with_setup(const std::string& path, const DeviceOptions& options) {
  try {
    Record plain = open_at_own_rate(path, {}, options);
    if (!needs_setup(plain, options.setup)) return {std::move(plain), false};
  } catch (const InputError&) {
    if (options.setup.empty()) throw;
  }
  return {open_at_own_rate(path, {.setup = options.setup}, options), true};
}

// Errors name the option `setup` in place of the reader's options, which a device does not have.
ReplayedFile open_replayed(const std::string& path, const DeviceOptions& options) {
  try {
    return open_with_setup(path, options);
  } catch (const AmbiguousColumns& error) {
    throw InputError(error.problem(), error.where(),
                     error.roles_known ? error.remedy() : "name the hammer's channel and the responses in the set-up",
                     {"setup"});
  } catch (const MachineFault&) {
    throw;
  } catch (const InputError& error) {
    const auto& concerned = error.options();
    if (concerned.empty() || std::find(concerned.begin(), concerned.end(), "fs") != concerned.end()) throw;
    throw InputError(error.problem(), error.where(), error.remedy(), {"setup"});
  }
}

// A second passes from row to row.
DeviceFormat replay_format(const Record& record, bool fast, bool set_up) {
  DeviceFormat format{.type = SampleType::float64, .pace = fast ? DevicePace::reader : DevicePace::clock};
  if (set_up) format.setup = applied_setup(record);
  format.notes = record.notes;
  if (record.points().size() > 1)
    format.notes.emplace_back("the points of the record's rows are not used: blows go to the points of the session");
  format.stream.device = "file:" + record.source();
  format.stream.fs_Hz = record.fs_Hz;
  format.stream.pause_frames = static_cast<std::uint64_t>(std::ceil(record.fs_Hz));
  if (record.has_force) {
    format.stream.names.push_back(record.force.name);
    format.stream.units.emplace_back("N");
  }
  for (const SignalInfo& signal : record.accel) {
    format.stream.names.push_back(signal.name);
    format.stream.units.emplace_back(si_name(signal.measures));
  }
  format.stream.channels = format.stream.names.size();
  return format;
}

void require_samples(const Record& record) {
  if (record.rows.empty() || !(record.fs_Hz > 0) || (record.accel.empty() && !record.has_force))
    throw InputError("the record has no samples to replay", record.source(), "name another record", {"device"});
}

class ReplayDevice final : public PolledDevice {
 public:
  ReplayDevice(Record record, const DeviceOptions& options, bool set_up = false)
      : record_(std::move(record)), fast_(options.fast), format_(replay_format(record_, fast_, set_up)) {
    seek(options.start_frame);
  }
  ~ReplayDevice() override { stop(); }

  const DeviceFormat& format() const override { return format_; }

 protected:
  void poll(FrameSink& sink) override {
    if (row_ == record_.rows.size()) return sink.end(StreamEnd::finished);
    if (at_ == record_.rows[row_].samples) return next_row(sink);
    std::size_t count = std::min(kReplayPiece_frames, record_.rows[row_].samples - at_);
    if (!fast_) count = std::min(count, frames_due());
    if (count > 0) {
      play(sink, count);
    } else {
      std::this_thread::sleep_for(std::chrono::duration<double>(kReplayPoll_s));
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  // Frames count over rows and pauses.
  void seek(std::uint64_t frame) {
    const std::uint64_t pause = format_.stream.pause_frames;
    while (row_ < record_.rows.size() && frame > record_.rows[row_].samples + pause) {
      frame -= record_.rows[row_].samples + pause;
      ++row_;
    }
    if (row_ < record_.rows.size())
      at_ = static_cast<std::size_t>(std::min<std::uint64_t>(frame, record_.rows[row_].samples));
  }

  void next_row(FrameSink& sink) {
    at_ = 0;
    if (++row_ < record_.rows.size()) sink.skip(format_.stream.pause_frames, false);
  }

  std::size_t frames_due() {
    const Clock::time_point now = Clock::now();
    if (played_ == 0) start_ = now - std::chrono::milliseconds(1);
    const auto due = static_cast<std::uint64_t>(std::chrono::duration<double>(now - start_).count() * record_.fs_Hz);
    return static_cast<std::size_t>(due - std::min(due, played_));
  }

  void play(FrameSink& sink, std::size_t count) {
    const std::size_t channels = format_.stream.channels;
    frames_.resize(count * channels);
    signal_.resize(count);
    std::size_t channel = 0;
    const auto add = [&] {
      for (std::size_t i = 0; i < count; ++i) frames_[i * channels + channel] = signal_[i];
      ++channel;
    };
    if (record_.has_force) {
      record_.read_force_N(row_, at_, signal_);
      add();
    }
    for (std::size_t c = 0; c < record_.accel.size(); ++c) {
      record_.read_accel_mps2(row_, c, at_, signal_);
      add();
    }
    if (fast_) {
      write_with_room(sink, std::as_bytes(std::span(frames_)), channels * sizeof(double));
    } else {
      sink.write(frames_.data(), count);
    }
    at_ += count;
    played_ += count;
  }

  const Record record_;
  const bool fast_;
  const DeviceFormat format_;
  std::size_t row_ = 0, at_ = 0;
  std::uint64_t played_ = 0;
  Clock::time_point start_;
  std::vector<double> frames_, signal_;
};

}  // namespace

std::unique_ptr<Device> replay_device(Record record, const DeviceOptions& options) {
  require_samples(record);
  return std::make_unique<ReplayDevice>(std::move(record), options);
}

std::unique_ptr<Device> open_file_device(const std::string& path, const DeviceOptions& options) {
  ReplayedFile file = open_replayed(path, options);
  require_rate(file.record.fs_Hz, options, path);
  require_samples(file.record);
  return std::make_unique<ReplayDevice>(std::move(file.record), options, file.set_up);
}

}  // namespace percuss::acquire
