#include "acquire/live/plugin_device.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "acquire/live/polled_device.hpp"
#include "core/error.hpp"
#include "percuss/device_plugin.h"

namespace percuss::acquire {
namespace {

constexpr std::uint32_t kPluginTimeout_ms = 50;
constexpr std::size_t kMessage_bytes = 300, kMaxPluginChannels = 4096;
constexpr double kPluginPiece_s = 0.02, kMaxPluginRate_Hz = 1e8;
constexpr std::uint64_t kMaxPluginFrame = std::uint64_t{1} << 60U;

// The first version's sizes: plug-ins that were built with them still load after the structures grow.
constexpr std::size_t kTable_bytes = offsetof(percuss_device_plugin, close) + sizeof(percuss_device_plugin::close);
constexpr std::size_t kFormat_bytes = offsetof(percuss_device_format, units) + sizeof(percuss_device_format::units);

// A loaded library. It stays loaded until the device is closed.
class Library {
 public:
  explicit Library(const std::string& path) : handle_(::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) {
      const char* const why = ::dlerror();
      throw InputError("cannot load the plug-in: " + one_line(why != nullptr ? why : "unknown"), path,
                       "name a shared library with its folder, such as ./device.so", {"device"});
    }
  }
  ~Library() {
    if (handle_ != nullptr) ::dlclose(handle_);
  }
  Library(Library&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  Library& operator=(Library&&) = delete;

  void* symbol(const char* name) const { return ::dlsym(handle_, name); }

 private:
  void* handle_;
};

[[noreturn]] void refuse_plugin(const std::string& problem, const std::string& path) {
  throw InputError(problem, path, "ask the author of the plug-in, or rebuild it with percuss/device_plugin.h",
                   {"device"});
}

const percuss_device_plugin& table_of(const Library& library, const std::string& path) {
  void* const symbol = library.symbol(PERCUSS_DEVICE_PLUGIN_SYMBOL);
  if (symbol == nullptr) refuse_plugin("the library is no plug-in of percuss, or of another version", path);
  percuss_device_plugin_function function = nullptr;
  static_assert(sizeof function == sizeof symbol);
  std::memcpy(&function, &symbol, sizeof symbol);  // ISO C++ has no cast from void* to a function
  const percuss_device_plugin* const table = function();
  if (table == nullptr || table->size < kTable_bytes) refuse_plugin("the plug-in is of another version", path);
  if (table->open == nullptr || table->format == nullptr || table->start == nullptr || table->read == nullptr ||
      table->stop == nullptr || table->close == nullptr)
    refuse_plugin("the plug-in lacks a function", path);
  return *table;
}

std::string message_of(const std::array<char, kMessage_bytes>& message) {
  const std::string text(message.data(), ::strnlen(message.data(), message.size()));
  return text.empty() ? "it gave no reason" : one_line(text);
}

std::vector<std::string> texts_of(const char* const* texts, std::size_t channels) {
  std::vector<std::string> out;
  for (std::size_t c = 0; texts != nullptr && c < channels; ++c)
    out.push_back(texts[c] != nullptr ? one_line(texts[c]) : "");
  return out;
}

DeviceFormat format_of_plugin(const percuss_device_format* given, const std::string& path) {
  if (given == nullptr || given->size < kFormat_bytes || given->channels == 0 || given->channels > kMaxPluginChannels ||
      !(given->fs_hz > 0) || given->fs_hz > kMaxPluginRate_Hz || given->sample_type < PERCUSS_SAMPLE_INT32 ||
      given->sample_type > PERCUSS_SAMPLE_FLOAT64 || !std::isfinite(given->scale) ||
      !std::isfinite(given->full_scale) || given->full_scale < 0)
    refuse_plugin("the plug-in states an impossible format", path);
  constexpr std::array kTypes = {SampleType::int32, SampleType::float32, SampleType::float64};
  DeviceFormat format{.type = kTypes[given->sample_type - PERCUSS_SAMPLE_INT32],
                      .scale = given->scale,
                      .pace = given->waits != 0 ? DevicePace::reader : DevicePace::clock};
  format.stream = {.device = given->name != nullptr ? one_line(given->name) : path,
                   .fs_Hz = given->fs_hz,
                   .channels = given->channels,
                   .names = texts_of(given->channel_names, given->channels),
                   .units = texts_of(given->units, given->channels),
                   .full_scale = given->full_scale};
  return format;
}

class PluginDevice final : public PolledDevice {
 public:
  PluginDevice(const std::string& path, const std::string& arguments, const DeviceOptions& options)
      : path_(path), library_(path), table_(table_of(library_, path)) {
    std::array<char, kMessage_bytes> message{};
    device_ = table_.open(arguments.c_str(), options.fs_Hz.value_or(0), message.data(), message.size() - 1);
    if (device_ == nullptr) {
      throw InputError("the plug-in cannot open the device: " + message_of(message), path, "check its arguments",
                       {"device"});
    }
    try {
      format_ = format_of_plugin(table_.format(device_), path);
      capacity_ = static_cast<std::size_t>(std::clamp(kPluginPiece_s * format_.stream.fs_Hz, 16.0, 65536.0));
      frames_.resize(capacity_ * format_.stream.channels * bytes_per_sample(format_.type));
    } catch (...) {
      table_.close(device_);
      throw;
    }
  }
  ~PluginDevice() override {
    stop();
    if (started_) table_.stop(device_);
    table_.close(device_);
  }

  const DeviceFormat& format() const override { return format_; }

 protected:
  void prepare() override {
    std::array<char, kMessage_bytes> message{};
    if (table_.start(device_, message.data(), message.size() - 1) != 0) {
      throw InputError("the plug-in cannot start the device: " + message_of(message), path_, "check the device",
                       {"device"});
    }
    started_ = true;
  }

  void poll(FrameSink& sink) override {
    const std::size_t capacity = format_.pace == DevicePace::reader ? std::min(capacity_, sink.room()) : capacity_;
    if (capacity == 0) return wait_shortly();
    percuss_device_block block{.size = sizeof block, .flags = 0, .first_frame = 0, .frames = 0};
    table_.read(device_, frames_.data(), static_cast<std::uint32_t>(capacity), kPluginTimeout_ms, &block);
    const bool back_in_time = block.frames > 0 && block.first_frame < next_frame_;
    if (block.frames > capacity || back_in_time || block.first_frame > kMaxPluginFrame)
      return sink.end(StreamEnd::failed);
    if ((block.flags & PERCUSS_BLOCK_OVERRUN) != 0) sink.skip(0, true);
    if (block.frames > 0) {
      if (block.first_frame > next_frame_) sink.skip(block.first_frame - next_frame_, false);
      sink.write(frames_.data(), block.frames);
      next_frame_ = block.first_frame + block.frames;
    }
    if ((block.flags & PERCUSS_BLOCK_UNPLUGGED) != 0) sink.end(StreamEnd::unplugged);
    if ((block.flags & PERCUSS_BLOCK_RATE_CHANGED) != 0) sink.end(StreamEnd::rate_changed);
    if ((block.flags & PERCUSS_BLOCK_FAILED) != 0) sink.end(StreamEnd::failed);
    if ((block.flags & PERCUSS_BLOCK_FINISHED) != 0) sink.end(StreamEnd::finished);
  }

 private:
  const std::string path_;
  const Library library_;
  const percuss_device_plugin& table_;
  percuss_device* device_ = nullptr;
  DeviceFormat format_;
  std::size_t capacity_ = 0;
  std::vector<std::byte> frames_;
  std::uint64_t next_frame_ = 0;
  bool started_ = false;
};

}  // namespace

std::unique_ptr<Device> open_plugin_device(const std::string& path, const std::string& arguments,
                                           const DeviceOptions& options) {
  return std::make_unique<PluginDevice>(path, arguments, options);
}

}  // namespace percuss::acquire
