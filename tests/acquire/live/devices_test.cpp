#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "acquire/live/capture_stream.hpp"
#include "acquire/live/clock_drift.hpp"
#include "acquire/live/file_device.hpp"
#include "acquire/live/list_devices.hpp"
#include "acquire/live/open_device.hpp"
#include "acquire/live/sound_cards/sound_cards.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::devices_test {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using test::input_error_of;
using test::ScratchFolder;
using test::write_bytes;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(DeviceSpec, SeparatesKindAndName) {
  EXPECT_EQ(parse_device_spec("sim:wood-bat,fast").kind, DeviceKind::simulated);
  EXPECT_EQ(parse_device_spec("sim:wood-bat,fast").name, "wood-bat,fast");
  EXPECT_EQ(parse_device_spec("file:/a:b.h5").name, "/a:b.h5");
  EXPECT_EQ(parse_device_spec("alsa:hw:1,0").name, "hw:1,0");
  EXPECT_EQ(parse_device_spec("USB Audio (hw:1,0)").kind, DeviceKind::portaudio);
  EXPECT_EQ(parse_device_spec("USB Audio (hw:1,0)").name, "USB Audio (hw:1,0)");
  const DeviceSpec plugin = parse_device_spec("plugin:./d.so:a=1:b");
  EXPECT_EQ(plugin.name, "./d.so");
  EXPECT_EQ(plugin.arguments, "a=1:b");
  EXPECT_EQ(parse_device_spec("plugin:./d.so").arguments, "");
  EXPECT_EQ(parse_device_spec("stdin:").name, "wav");
  for (const char* wrong : {"", "sim:", "plugin:"}) input_error_of([&] { parse_device_spec(wrong); });
}

TEST(ReplayDevice, PlaysTheRowsOfARecord) {
  Record record = record_in_memory(1000, {{1, 2, 3}, {4, 5}}, {{{10, 20, 30}}, {{40, 50}}});
  CaptureStream stream(replay_device(record, {.fast = true}), {});
  EXPECT_THAT(stream.format().units, ElementsAre("N", "m/s^2"));
  std::vector<SampleBlock> blocks;
  while (stream.end() == StreamEnd::none) {
    if (auto block = stream.next(100ms)) blocks.push_back(std::move(*block));
  }
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_THAT(blocks[0].values, ElementsAre(1, 10, 2, 20, 3, 30));
  EXPECT_THAT(blocks[1].values, ElementsAre(4, 40, 5, 50));
  EXPECT_EQ(blocks[1].first_frame, 3U + 1000U);  // a second passes from row to row, and nothing is lost
  EXPECT_THAT(stream.take_findings(), IsEmpty());
  EXPECT_FALSE(blocks[1].overrun);
  record.has_force = false;
  EXPECT_EQ(replay_device(record)->format().stream.channels, 1U);
  EXPECT_THAT(input_error_of([] { replay_device(Record{}); }), HasSubstr("no samples"));
  EXPECT_THAT(input_error_of([] { open_device("file:missing.h5", {}, {}); }), HasSubstr("missing.h5"));
}

TEST(ReplayDevice, KeepsTheRateOfItsFile) {
  const ScratchFolder folder;
  const std::string timed = folder.file("timed.csv"), plain = folder.file("plain.csv");
  write_bytes(timed, "time (s),force (N),accel (m/s2)\n0,1,2\n0.001,3,4\n0.002,5,6\n0.003,7,8\n");
  write_bytes(plain, "force (N),accel (m/s2)\n1,2\n3,4\n5,6\n7,8\n");
  const std::string refused = input_error_of([&] { open_file_device(timed, {.fs_Hz = 2000}); });
  EXPECT_THAT(refused, HasSubstr("the samples come at 1000 Hz, and cannot come at 2000 Hz"));
  EXPECT_THAT(refused, HasSubstr("leave the rate out"));
  EXPECT_EQ(open_file_device(timed, {.fs_Hz = 1000})->format().stream.fs_Hz, 1000);
  EXPECT_EQ(open_file_device(plain, {.fs_Hz = 2000})->format().stream.fs_Hz, 2000);
  EXPECT_THAT(input_error_of([&] { open_file_device(plain); }), HasSubstr("no sampling rate"));
}

std::vector<double> first_frame(std::unique_ptr<Device> device) {
  CaptureStream stream(std::move(device), {});
  while (stream.end() == StreamEnd::none) {
    if (const auto block = stream.next(100ms))
      return {block->values.begin(), block->values.begin() + static_cast<std::ptrdiff_t>(stream.format().channels)};
  }
  return {};
}

TEST(ReplayDevice, ReadsAFileByTheSetUpThatNamesItsForce) {
  const ScratchFolder folder;
  const std::string path = folder.file("volts.csv");
  write_bytes(path, "time (s),CH1 (V),CH2 (cm/s2),CH3 (cm/s2)\n0,1,200,9\n0.001,3,400,9\n0.002,5,600,9\n");
  EXPECT_EQ(open_file_device(path)->format().stream.channels, 2U);  // the responses
  const DeviceOptions options{.fast = true,
                              .setup = {{.name = "CH1", .role = "force", .sensitivity_V_per_SI = 0.5},
                                        {.name = "CH2", .sign = -1, .angle_rad = 1.5},
                                        {.name = "CH3", .role = "ignore"}}};
  auto device = open_file_device(path, options);
  EXPECT_THAT(device->format().stream.units, ElementsAre("N", "m/s^2"));
  const auto setup = stream_setup(device->format(), {1, 0});
  ASSERT_EQ(setup.size(), 2U);
  EXPECT_EQ(setup[0].name, "2");
  EXPECT_EQ(setup[0].role, "acceleration");
  EXPECT_EQ(setup[0].angle_rad, 1.5);
  EXPECT_EQ(setup[0].sign, 1);  // applied
  EXPECT_EQ(setup[1].role, "force");
  EXPECT_FALSE(setup[1].sensitivity_V_per_SI);
  EXPECT_THAT(first_frame(std::move(device)), ElementsAre(2, -2));
}

TEST(ReplayDevice, AppliesUnitsOfTheSetUpOnce) {
  const ScratchFolder folder;
  const std::string path = folder.file("bare.csv");
  write_bytes(path, "time (s),force,accel\n0,1,2\n0.001,3,4\n0.002,5,6\n");
  auto device = open_file_device(path, {.fast = true, .setup = {{.name = "accel", .unit = "cm/s2"}}});
  EXPECT_EQ(device->format().setup.size(), 2U);
  EXPECT_THAT(first_frame(std::move(device)), ElementsAre(1, 0.02));
  // A number names a channel of the device: the file is read without this entry.
  auto plain = open_file_device(path, {.fast = true, .setup = {{.name = "2", .sign = -1}}});
  EXPECT_TRUE(plain->format().setup.empty());
  EXPECT_EQ(plain->format().notes.size(), 2U);  // units are assumed
  EXPECT_THAT(first_frame(std::move(plain)), ElementsAre(1, 2));
}

TEST(ReplayDevice, SuggestsTheSetUpWhereNothingNamesTheSignals) {
  const ScratchFolder folder;
  const std::string path = folder.file("bare.csv");
  write_bytes(path, "time (s),CH1,CH2\n0,1,2\n0.001,3,4\n0.002,5,6\n");
  try {
    open_file_device(path);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.remedy(), "name the hammer's channel and the responses in the set-up");
    EXPECT_THAT(error.options(), ElementsAre("setup"));
  }
}

TEST(ReplayDevice, KeepsRealTime) {
  const Record record = record_in_memory(1000, {std::vector<double>(300, 1.0)}, {{std::vector<double>(300)}});
  const auto begun = std::chrono::steady_clock::now();
  CaptureStream stream(replay_device(record), {});
  while (stream.end() == StreamEnd::none) stream.next(100ms);
  EXPECT_GE(std::chrono::steady_clock::now() - begun, 290ms);
}

TEST(UsbFrontEnd, IsReadFromItsProductString) {
  // 5000000 counts per volt; full scale is 2^23 counts.
  const auto volts = parse_front_end("485B39 2012345500000041943042401311");
  ASSERT_TRUE(volts);
  EXPECT_EQ(volts->model, "485B39");
  EXPECT_EQ(volts->serial, "012345");
  EXPECT_EQ(volts->unit, "V");
  EXPECT_DOUBLE_EQ(volts->full_scales[0], 8388608.0 / 5000000);
  EXPECT_DOUBLE_EQ(volts->full_scales[1], 2);
  EXPECT_EQ(volts->calibrated, "2024-01-31");
  const auto per_50_mV = parse_front_end("USB 485B39 301234541943044194304240131");
  ASSERT_TRUE(per_50_mV);
  EXPECT_DOUBLE_EQ(per_50_mV->full_scales[0], 0.1);
  const auto acceleration = parse_front_end("333D01 10123458554085540240131");
  ASSERT_TRUE(acceleration);
  EXPECT_EQ(acceleration->unit, "m/s^2");
  EXPECT_DOUBLE_EQ(acceleration->full_scales[1], 8388608.0 / 85540);
}

TEST(UsbFrontEnd, IgnoresOtherTexts) {
  for (const char* text :
       {"", "USB Audio CODEC", "485B39", "485B39 2012345", "485B39 901234550000004194304240131",
        "485B39 20123450000000419430424013", "485B39 2012345-00000-419430424013", "333D01 1012345855408"})
    EXPECT_FALSE(parse_front_end(text)) << text;
}

/// A sysfs with a front end as card 1, and what /proc and /dev say of its input.
struct FakeSystem {
  ScratchFolder folder;
  explicit FakeSystem(const std::string& status) {
    const fs::path root = folder.path();
    fs::create_directories(root / "sys/devices/usb1/1-2/1-2:1.0");
    fs::create_directories(root / "sys/class/sound/card1");
    fs::create_directory_symlink(root / "sys/devices/usb1/1-2/1-2:1.0", root / "sys/class/sound/card1/device");
    write_bytes(folder.file("sys/devices/usb1/1-2/product"), "485B39 201234550000004194304240131\n");
    fs::create_directories(root / "proc/card1/pcm0c/sub0");
    fs::create_directories(root / "dev");
    write_bytes(folder.file("proc/pcm"),
                "00-03: HDMI 0 : HDMI 0 : playback 1\n01-00: USB Audio : USB Audio : playback 1 : capture 1\n");
    write_bytes(folder.file("proc/card1/pcm0c/sub0/status"), status);
  }
  std::vector<ListedDevice> list() const {
    return list_devices({folder.file("sys"), folder.file("proc"), folder.file("dev")});
  }
};

TEST(ListDevices, SaysWhyACardCannotRecord) {
  const FakeSystem closed("closed\n");
  const auto forbidden = closed.list();
  ASSERT_FALSE(forbidden.empty());
  EXPECT_EQ(forbidden.back().spec, "alsa:hw:1,0");
  EXPECT_EQ(forbidden.back().name, "USB Audio (hw:1,0)");
  EXPECT_EQ(forbidden.back().problem, "no permission");  // its node in /dev is missing
  ASSERT_TRUE(forbidden.back().front_end);
  EXPECT_EQ(forbidden.back().front_end->serial, "012345");
  EXPECT_THAT(advice_without_devices({forbidden.back()}), HasSubstr("group audio"));
  const FakeSystem running("state: RUNNING\nowner_pid   : 1234\n");
  write_bytes(running.folder.file("dev/pcmC1D0c"), "");
  EXPECT_EQ(running.list().back().problem, "busy");
  EXPECT_THAT(advice_without_devices({running.list().back()}), HasSubstr("busy"));
  EXPECT_THAT(advice_without_devices({}), HasSubstr("plug one in"));
}

TEST(SoundCards, SayWhyTheyCannotBeOpened) {
  const std::vector<SoundCardInput> cards{{.card = 0, .device = 0, .name = "A"},
                                          {.card = 1, .device = 0, .name = "B", .permitted = false},
                                          {.card = 1, .device = 2, .name = "C", .busy = true}};
  const auto said = [&](const char* name) { return input_error_of([&] { check_card_is_free(cards, name); }); };
  for (const char* free : {"hw:0,0", "hw:2,0", "default"}) EXPECT_NO_THROW(check_card_is_free(cards, free)) << free;
  EXPECT_THAT(said("hw:1,0"), HasSubstr("no permission to record (hw:1,0)"));
  EXPECT_THAT(said("USB Audio: - (hw:1,2)"), HasSubstr("the device is busy (USB Audio: - (hw:1,2))"));
}

TEST(ListDevices, KnowsCardsByPortAudiosNames) {
  EXPECT_EQ(card_in_name("485B39 x: USB Audio (hw:12,0)"), 12);
  EXPECT_FALSE(card_in_name("default"));
  EXPECT_FALSE(card_in_name("(hw:"));
}

// A device that is 300 ppm fast, in buffers of 1024 frames, read up to 20 ms late.
TEST(ClockDrift, IsFoundBelowTheJitterOfBuffers) {
  ClockDrift drift(48000);
  std::uint32_t random = 1;
  for (int i = 1; i < 48000 / 1024 * 600; ++i) {
    random = random * 1664525U + 1013904223U;
    const double late_s = 0.02 * (random >> 8U) / double{1U << 24U};
    drift.add(static_cast<std::uint64_t>(i) * 1024, i * 1024 / (48000 * (1 + 300e-6)) + late_s);
  }
  const auto found = drift.estimate();
  ASSERT_TRUE(found);
  EXPECT_LT(found->standard_deviation, 3e-6);  // a hundredth of the drift
  EXPECT_NEAR(found->relative, 300e-6, 5 * found->standard_deviation);
}

TEST(ClockDrift, NeedsAMinute) {
  ClockDrift drift(1000);
  for (int i = 0; i < 500; ++i) drift.add(static_cast<std::uint64_t>(i) * 100, i * 0.1);
  EXPECT_FALSE(drift.estimate());
}

}  // namespace percuss::acquire::devices_test
