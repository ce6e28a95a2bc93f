#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "acquire/live/frame_ring.hpp"
#include "acquire/live/list_devices.hpp"
#include "acquire/live/open_device.hpp"
#include "acquire/live/sound_cards/portaudio_library.hpp"
#include "core/sanitized.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

// PortAudio itself, with ALSA's plug-in `file` in place of a sound card. The plug-in has no clock. After the end of its
// file it repeats its last buffer, so the test reads only the frames of the file.
namespace percuss::acquire::portaudio_test {

using namespace std::chrono_literals;
using test::input_error_of;
using test::ScratchFolder;
using test::write_bytes;
using testing::HasSubstr;

constexpr std::size_t kFileFrames = 300000;

/// The numbers of the file: every bit of 32 changes.
std::int32_t number(std::size_t frame, std::size_t channel) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(frame + 1) * 2654435761U +
                                   (channel == 0 ? 0U : 0x5a5a5a5aU));
}

/// A configuration of ALSA with the input "bench" and an empty device "default". While it lives, ALSA knows no other
/// device.
class AlsaConfiguration {
 public:
  AlsaConfiguration() {
    std::string bytes(kFileFrames * 2 * sizeof(std::int32_t), '\0');
    for (std::size_t i = 0; i < kFileFrames * 2; ++i) {
      const std::int32_t value = number(i / 2, i % 2);
      std::memcpy(bytes.data() + i * sizeof value, &value, sizeof value);
    }
    write_bytes(folder_.file("in.raw"), bytes);
    // PortAudio expects a device "default".
    write_bytes(folder_.file("asound.conf"),
                "pcm.default { type null }\n"
                "pcm.bench { type file slave.pcm { type null } file \"/dev/null\" infile \"" +
                    folder_.file("in.raw") + "\" format raw }\n");
    ::setenv("ALSA_CONFIG_PATH", folder_.file("asound.conf").c_str(), 1);
  }
  ~AlsaConfiguration() { ::unsetenv("ALSA_CONFIG_PATH"); }
  AlsaConfiguration(const AlsaConfiguration&) = delete;
  AlsaConfiguration& operator=(const AlsaConfiguration&) = delete;

 private:
  ScratchFolder folder_;
};

std::unique_ptr<Device> open_bench(const std::string& name,
                                   const DeviceOptions& options = {.fs_Hz = 51200, .channels = 2}) {
  return open_device(name, options, {});
}

TEST(PortAudio, DeliversEveryBitOfAnAlsaDevice) {
  const AlsaConfiguration alsa;
  const auto device = open_bench("alsa:bench");
  const StreamFormat& format = device->format().stream;
  EXPECT_EQ(format.device, "bench");
  EXPECT_EQ(format.channels, 2U);
  EXPECT_EQ(format.fs_Hz, 51200);
  EXPECT_EQ(format.full_scale, 1);
  // A ring that nobody reads keeps the first frames, however fast the device is.
  FrameRing ring({device->format().type, 2, {0, 1}, {0x1p-31, 0x1p-31}}, kFileFrames);
  const auto deadline = std::chrono::steady_clock::now() + 60s;
  device->start(ring);
  while (ring.written() < kFileFrames && device->check() == StreamEnd::none &&
         std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(1ms);
  device->stop();
  ASSERT_EQ(ring.written(), kFileFrames);
  std::vector<double> values(2 * kFileFrames);
  ring.read(0, values);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < values.size(); ++i) wrong += values[i] == number(i / 2, i % 2) * 0x1p-31 ? 0U : 1U;
  EXPECT_EQ(wrong, 0U);
}

TEST(PortAudio, FindsInputsByName) {
  const AlsaConfiguration alsa;
  const PortAudioLibrary library;
  const auto inputs = library.inputs();
  EXPECT_EQ(find_input(inputs, "bench", true).name, "bench");
  EXPECT_EQ(find_input(inputs, "ben", false).name, "bench");
#ifndef PERCUSS_SANITIZED  // the device "null" has a buffer of 800 MB, which the thread sanitizer clears slowly
  EXPECT_EQ(library.rates_Hz(find_input(inputs, "bench", true)).front(), 8000);
#endif
  EXPECT_THAT(input_error_of([&] { find_input(inputs, "no such card", false); }),
              HasSubstr("no such recording device"));
  EXPECT_THAT(input_error_of([&] { find_input(inputs, "e", true); }), HasSubstr("several recording devices"));
  const std::vector<PortAudioInput> cards{{.index = 4, .name = "485B39 x: USB Audio (hw:1,0)", .host = "ALSA"}};
  EXPECT_EQ(find_input(cards, "hw:1,0", true).index, 4);
}

TEST(PortAudio, RefusesWhatTheDeviceCannotDo) {
  const AlsaConfiguration alsa;
  EXPECT_THAT(input_error_of([] { open_bench("portaudio:bench", {.channels = 1000}); }), HasSubstr("channels"));
  EXPECT_THAT(input_error_of([] { open_bench("some card"); }), HasSubstr("no such recording device"));
}

#ifndef PERCUSS_SANITIZED  // as above
TEST(PortAudio, IsListed) {
  const AlsaConfiguration alsa;
  const ScratchFolder nothing;
  const auto listed = list_devices({nothing.path(), nothing.path(), nothing.path()});
  ASSERT_FALSE(listed.empty());
  const auto& bench = listed.front();
  EXPECT_EQ(bench.spec, "portaudio:bench");
  EXPECT_THAT(bench.rates_Hz, testing::Contains(51200));
  EXPECT_EQ(bench.problem, "");
}
#endif

}  // namespace percuss::acquire::portaudio_test
