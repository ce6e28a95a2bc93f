#include "acquire/live/pipe_device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "acquire/live/capture_stream.hpp"
#include "support/input_error.hpp"

namespace percuss::acquire::pipe_device_test {

using namespace std::chrono_literals;
using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

template <class... Numbers>
std::string bytes_of_numbers(Numbers... numbers) {
  std::string out;
  const auto add = [&](auto number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    out += bytes;
  };
  (add(numbers), ...);
  return out;
}

/// A pipe that a thread fills in pieces of `piece` bytes.
class FilledPipe {
 public:
  explicit FilledPipe(std::string bytes, std::size_t piece = 7) {
    EXPECT_EQ(::pipe(ends_.data()), 0);
    writer_ = std::thread([this, text = std::move(bytes), piece] {
      for (std::size_t at = 0; at < text.size(); at += piece) {
        const std::string part = text.substr(at, piece);
        if (::write(ends_[1], part.data(), part.size()) < 0) break;
      }
      ::close(ends_[1]);
    });
  }
  ~FilledPipe() {
    writer_.join();
    ::close(ends_[0]);
  }
  FilledPipe(const FilledPipe&) = delete;
  FilledPipe& operator=(const FilledPipe&) = delete;
  int reading() const { return ends_[0]; }

 private:
  std::array<int, 2> ends_{};
  std::thread writer_;
};

std::vector<double> values_of(const std::string& description, const std::string& bytes) {
  const FilledPipe pipe(bytes);
  CaptureStream stream(open_pipe_device(description, pipe.reading()), {});
  std::vector<double> out;
  while (stream.end() == StreamEnd::none) {
    if (const auto block = stream.next(100ms)) out.insert(out.end(), block->values.begin(), block->values.end());
  }
  EXPECT_EQ(stream.end(), StreamEnd::finished);
  return out;
}

std::string wav(const std::string& format, std::uint32_t data_bytes, const std::string& data,
                const std::string& chunks = {}) {
  const auto chunk = [](const std::string& name, const std::string& content) {
    return name + bytes_of_numbers(static_cast<std::uint32_t>(content.size())) + content +
           std::string(content.size() % 2, '\0');
  };
  return "RIFF" + bytes_of_numbers(std::uint32_t{0xffffffff}) + "WAVE" + chunks + chunk("fmt ", format) + "data" +
         bytes_of_numbers(data_bytes) + data;
}

std::string format_chunk(std::uint16_t tag, std::uint16_t channels, std::uint32_t rate, std::uint16_t bits) {
  return bytes_of_numbers(tag, channels, rate, std::uint32_t{0}, std::uint16_t{0}, bits);
}

std::string wav_with_calibration(const std::string& calibration, const std::string& data) {
  const std::string text = calibration + std::string(calibration.size() % 2, ' ');
  return wav(format_chunk(1, 2, 1000, 16), 0xffffffff, data,
             "CAL1" + bytes_of_numbers(static_cast<std::uint32_t>(text.size())) + text);
}

const std::string kTwoSignals = R"({"fs_hz": 1000.5, "continuous": true, "rows": [], "signals": [)"
                                R"({"name": "hammer", "measures": "force", "si_at_full_scale": 512},)"
                                R"({"name": "tip", "measures": "acceleration", "si_at_full_scale": -4096}]})";

// The scales are those of a WAV file of the same bytes.
TEST(PipeDevice, KeepsTheScalesOfAWavThatPercussWrote) {
  const std::string stream = wav_with_calibration(kTwoSignals, bytes_of_numbers(std::int16_t{16384}, std::int16_t{1}));
  EXPECT_THAT(values_of("wav", stream), ElementsAre(256, -0.125));
  const FilledPipe pipe(stream);
  const auto device = open_pipe_device("wav", pipe.reading());
  EXPECT_EQ(device->format().stream.fs_Hz, 1000.5);
  EXPECT_THAT(device->format().stream.names, ElementsAre("hammer", "tip"));
  EXPECT_THAT(device->format().stream.units, ElementsAre("N", "m/s^2"));
  EXPECT_THAT(device->format().stream.full_scales, ElementsAre(512, 4096));
}

TEST(PipeDevice, StatesPascalsForAMicrophone) {
  const std::string calibration = R"({"fs_hz": 1000, "continuous": true, "rows": [], "signals": [)"
                                  R"({"name": "tip", "measures": "acceleration", "si_at_full_scale": 1},)"
                                  R"({"name": "mic", "measures": "pressure", "si_at_full_scale": 2}]})";
  const FilledPipe pipe(wav_with_calibration(calibration, bytes_of_numbers(std::int16_t{1}, std::int16_t{1})));
  EXPECT_THAT(open_pipe_device("wav", pipe.reading())->format().stream.units, ElementsAre("m/s^2", "Pa"));
}

// Units in a set-up apply to the stored numbers. The scales of the stream are then not used.
TEST(PipeDevice, LeavesNumbersToASetUpWithUnits) {
  const std::string stream = wav_with_calibration(kTwoSignals, bytes_of_numbers(std::int16_t{16384}, std::int16_t{1}));
  const FilledPipe pipe(stream);
  const auto device = open_pipe_device("wav", pipe.reading(), {.setup = {{.name = "hammer", .unit = "N"}}});
  EXPECT_THAT(device->format().stream.names, ElementsAre("hammer", "tip"));
  EXPECT_TRUE(device->format().stream.units.empty());
  EXPECT_TRUE(device->format().scales.empty());
  EXPECT_EQ(device->format().stream.full_scale, 1);
}

TEST(PipeDevice, RefusesACalibrationOfOtherChannels) {
  const auto refusal = [](const std::string& calibration) {
    const FilledPipe pipe(wav_with_calibration(calibration, {}));
    return input_error_of([&] { open_pipe_device("wav", pipe.reading()); });
  };
  EXPECT_THAT(refusal(R"({"fs_hz": 1000, "rows": [], "signals": [{"name": "a", "si_at_full_scale": 1}]})"),
              HasSubstr("describes other channels than it has"));
  EXPECT_THAT(refusal("{"), HasSubstr("standard input: CAL1"));
}

TEST(PipeDevice, DecodesEachEncodingExactly) {
  EXPECT_THAT(values_of("raw:s16:1000:2", bytes_of_numbers(std::int16_t{-32768}, std::int16_t{1})),
              ElementsAre(-1, 0x1p-15));
  EXPECT_THAT(values_of("raw:s24:1000:1", std::string("\x01\x00\x00\xff\xff\xff\x00\x00\x80", 9)),
              ElementsAre(0x1p-23, -0x1p-23, -1));
  EXPECT_THAT(values_of("raw:s32:1000:1", bytes_of_numbers(std::int32_t{1}, std::int32_t{INT32_MIN})),
              ElementsAre(0x1p-31, -1));
  EXPECT_THAT(values_of("raw:f32:1000:1", bytes_of_numbers(0.5F, -3.0F)), ElementsAre(0.5, -3));
  EXPECT_THAT(values_of("raw:f64:1000:1", bytes_of_numbers(1.0 / 3)), ElementsAre(1.0 / 3));
}

TEST(PipeDevice, ReadsWavFromPrograms) {
  const std::string data =
      bytes_of_numbers(std::int16_t{16384}, std::int16_t{-16384}, std::int16_t{8192}, std::int16_t{0});
  const std::string format = format_chunk(1, 2, 51200, 16);
  for (const std::uint32_t unknown : {std::uint32_t{0}, std::uint32_t{0x7ffff024}, std::uint32_t{0xffffffff}})
    EXPECT_THAT(values_of("wav", wav(format, unknown, data)), ElementsAre(0.5, -0.5, 0.25, 0));
  EXPECT_THAT(values_of("wav", wav(format, 4, data)), ElementsAre(0.5, -0.5));  // what follows is no sample
  const std::string list = "LIST" + bytes_of_numbers(std::uint32_t{3}) + "abc" + std::string(1, '\0');
  EXPECT_THAT(values_of("wav", wav(format, 0, data, list)), ElementsAre(0.5, -0.5, 0.25, 0));
  EXPECT_THAT(values_of("wav", wav(format_chunk(3, 1, 8000, 64), 0, bytes_of_numbers(0.1))), ElementsAre(0.1));
  std::string extensible = format_chunk(0xfffe, 1, 8000, 32) +
                           bytes_of_numbers(std::uint16_t{22}, std::uint16_t{32}, std::uint32_t{0}, std::uint16_t{3});
  extensible.resize(40);
  EXPECT_THAT(values_of("wav", wav(extensible, 0, bytes_of_numbers(2.0F))), ElementsAre(2));
}

// The ring holds 8192 frames at this low rate, and the pipe brings 30 000 at once.
TEST(PipeDevice, WaitsForRoomFrameByFrame) {
  const FilledPipe pipe(std::string(80000, '\0'), 60000);
  CaptureStream stream(open_pipe_device("raw:s16:10:1", pipe.reading()), {});
  std::size_t frames = 0;
  while (stream.end() == StreamEnd::none) {
    if (const auto block = stream.next(100ms)) frames += block->frames;
  }
  EXPECT_EQ(frames, 40000U);
}

TEST(PipeDevice, StatesRateChannelsAndScale) {
  const FilledPipe pipe(wav(format_chunk(1, 3, 44100, 24), 0, {}));
  const auto device = open_pipe_device("wav", pipe.reading());
  EXPECT_EQ(device->format().stream.channels, 3U);
  EXPECT_EQ(device->format().stream.fs_Hz, 44100);
  EXPECT_EQ(device->format().stream.full_scale, 1);
  EXPECT_EQ(open_pipe_device("raw:f64:1000:1", 0)->format().stream.full_scale, 0);
}

TEST(PipeDevice, KeepsTheRateOfItsStream) {
  EXPECT_THAT(input_error_of([] { open_pipe_device("raw:s16:1000:1", 0, {.fs_Hz = 48000}); }),
              HasSubstr("the samples come at 1000 Hz, and cannot come at 48000 Hz"));
  EXPECT_EQ(open_pipe_device("raw:s16:1000:1", 0, {.fs_Hz = 1000})->format().stream.fs_Hz, 1000);
  const FilledPipe pipe(wav(format_chunk(1, 1, 44100, 16), 0, {}));
  EXPECT_THAT(input_error_of([&] { open_pipe_device("wav", pipe.reading(), {.fs_Hz = 48000}); }),
              HasSubstr("the samples come at 44100 Hz"));
}

TEST(PipeDevice, RefusesOtherStreams) {
  const auto refusal = [](const std::string& bytes) {
    const FilledPipe pipe(bytes, 4096);
    return input_error_of([&] { open_pipe_device("wav", pipe.reading()); });
  };
  EXPECT_THAT(refusal(""), HasSubstr("ends in its header"));
  EXPECT_THAT(refusal("ID3 something else"), HasSubstr("not WAV"));
  EXPECT_THAT(refusal(wav(format_chunk(1, 2, 44100, 8), 0, {})), HasSubstr("unusual size"));
  EXPECT_THAT(refusal(wav(format_chunk(85, 2, 44100, 16), 0, {})), HasSubstr("compressed"));
  EXPECT_THAT(refusal(wav(format_chunk(1, 0, 44100, 16), 0, {})), HasSubstr("no channels"));
  EXPECT_THAT(refusal(wav("short", 0, {})), HasSubstr("damaged format"));
  EXPECT_THAT(refusal("RIFF0000WAVEdata0000"), HasSubstr("before their format"));
  EXPECT_THAT(refusal("RIFF0000WAVEjunk" + bytes_of_numbers(std::uint32_t{0x7fffffff})), HasSubstr("16 MiB"));
  for (const char* wrong : {"raw", "raw:s16:1000", "raw:s17:1000:1", "raw:s16:0:1", "raw:s16:1000:-1",
                            "raw:s16:1000:0.5", "raw:s16:1000:2.7", "mp3", ""})
    input_error_of([&] { open_pipe_device(wrong, 0); });
}

// A program that writes nothing does not keep the stream from stopping.
TEST(PipeDevice, StopsWhileItWaits) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  CaptureStream stream(open_pipe_device("raw:s16:1000:1", ends[0]), {});
  const auto begun = std::chrono::steady_clock::now();
  stream.stop();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 1s);
  ::close(ends[0]);
  ::close(ends[1]);
}

}  // namespace percuss::acquire::pipe_device_test
