#include "acquire/live/plugin_device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <string>

#include "acquire/live/capture_stream.hpp"
#include "acquire/live/open_device.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

// PERCUSS_EXAMPLE_PLUGIN is examples/device_plugin.c as a library.
namespace percuss::acquire::plugin_device_test {

using namespace std::chrono_literals;
using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

struct Outcome {
  std::uint64_t frames = 0, wrong = 0, jumps = 0, overruns = 0;
  StreamEnd end = StreamEnd::none;
};

Outcome play(const std::string& arguments, const DeviceOptions& options = {}) {
  CaptureStream stream(open_device("plugin:" PERCUSS_EXAMPLE_PLUGIN ":" + arguments, options, {}), {});
  Outcome out;
  std::uint64_t next = 0;
  const std::size_t channels = stream.format().channels;
  while (stream.end() == StreamEnd::none) {
    const auto block = stream.next(100ms);
    if (!block) continue;
    out.jumps += block->first_frame == next ? 0U : 1U;
    out.overruns += block->overrun ? 1U : 0U;
    for (std::size_t i = 0; i < block->frames; ++i) {
      const auto frame = static_cast<double>(block->first_frame + i);
      const double sine = std::sin(2 * std::numbers::pi * 100 * frame / stream.format().fs_Hz);
      const bool right = std::abs(block->values[i * channels] - sine) < 1e-6 &&  // of a 32-bit float
                         block->values[i * channels + channels - 1] == frame;
      out.wrong += right ? 0U : 1U;
    }
    out.frames += block->frames;
    next = block->first_frame + block->frames;
  }
  out.end = stream.end();
  return out;
}

TEST(PluginDevice, DeliversTheFramesOfTheExample) {
  const Outcome out = play("channels=3,seconds=2");
  EXPECT_EQ(out.frames, 96000U);
  EXPECT_EQ(out.wrong + out.jumps + out.overruns, 0U);
  EXPECT_EQ(out.end, StreamEnd::finished);
  EXPECT_EQ(play("", {.fs_Hz = 1000}).frames, 1000U);
}

TEST(PluginDevice, StatesItsFormat) {
  const auto device = open_plugin_device(PERCUSS_EXAMPLE_PLUGIN, "");
  EXPECT_EQ(device->format().stream.device, "example generator");
  EXPECT_THAT(device->format().stream.units, ElementsAre("V", ""));
  EXPECT_EQ(device->format().stream.full_scale, 10);
}

TEST(PluginDevice, PassesOnLossesAndUnplugging) {
  const Outcome out = play("seconds=1,lose=5000,unplug");
  EXPECT_EQ(out.frames, 48000U - 64U);
  EXPECT_EQ(out.jumps, 1U);
  EXPECT_EQ(out.overruns, 1U);
  EXPECT_EQ(out.wrong, 0U);
  EXPECT_EQ(out.end, StreamEnd::unplugged);
}

TEST(PluginDevice, ReportsErrorsInOneLine) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("text.so"), "no library");
  const auto refusal = [](const std::string& device) { return input_error_of([&] { open_device(device, {}, {}); }); };
  EXPECT_THAT(refusal("plugin:" PERCUSS_EXAMPLE_PLUGIN ":volume=11"), HasSubstr("an argument is unknown"));
  EXPECT_THAT(refusal("plugin:" PERCUSS_EXAMPLE_PLUGIN ":channels=99"), HasSubstr("out of range"));
  EXPECT_THAT(refusal("plugin:" + folder.file("missing.so")), HasSubstr("cannot load the plug-in"));
  EXPECT_THAT(refusal("plugin:" + folder.file("text.so")), HasSubstr("cannot load the plug-in"));
  EXPECT_THAT(refusal("plugin:libz.so.1"), HasSubstr("no plug-in of percuss"));
}

}  // namespace percuss::acquire::plugin_device_test
