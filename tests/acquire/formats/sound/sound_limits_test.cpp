#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "acquire/formats/sound/read_sound.hpp"
#include "acquire/formats/sound/sound_calibration.hpp"
#include "acquire/formats/sound/sound_file.hpp"
#include "support/files/wav_bytes.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

// Sound files with unusual chunks, numbers and options.
namespace percuss::acquire::sound_limits_test {

using test::accel_mps2;
using test::bytes_of_number;
using test::force_N;
using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

// Two channels of 8 bits, and chunks after the samples.
std::string wav(const std::string& samples, const std::string& after = "") {
  return test::wav_bytes({.bits = 8, .after = after}, samples);
}

class SoundLimits : public testing::Test {
 protected:
  Record opened(const std::string& bytes, const ReadOptions& options) const {
    test::write_bytes(path_, bytes);
    return open_sound(path_, options);
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.wav");
  const std::string samples_ = std::string("\x80\xC0\xC0\x40", 4);
};

TEST_F(SoundLimits, BytesAreUnsigned) {
  const Record record = opened(wav(samples_), {.force_channel = "1"});
  EXPECT_THAT(force_N(record), ElementsAre(0, 0.5));
  EXPECT_THAT(accel_mps2(record), ElementsAre(0.5, -0.5));
}

TEST_F(SoundLimits, AnyScaleOptionRemovesTheNoteOnFullScale) {
  const auto has_note = [&](ReadOptions options) {
    options.force_channel = "1";
    for (const std::string& text : test::texts(opened(wav(samples_), options).notes)) {
      if (text.find("give N and m/s^2 at full scale") != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(has_note({}));
  EXPECT_FALSE(has_note({.force_scale = {2}}));
  EXPECT_FALSE(has_note({.accel_scale = {2}}));
  EXPECT_FALSE(has_note({.force_sensitivity_V_per_N = 0.01}));
  EXPECT_FALSE(has_note({.accel_sensitivity_V_per_mps2 = {0.01}}));
  EXPECT_FALSE(has_note({.force_unit = "N"}));
  EXPECT_FALSE(has_note({.accel_unit = "g"}));
  EXPECT_FALSE(has_note({.setup = {{.name = "channel 1", .sign = -1}}}));
}

// A copy that stopped: the header states more samples than follow.
TEST_F(SoundLimits, AFileThatEndsEarlyIsNamed) {
  const auto early = [&](const std::string& bytes) {
    const auto notes = test::texts(opened(bytes, {.force_channel = "1"}).notes);
    const auto says = [](const std::string& note) { return note.starts_with("the file ends early: "); };
    const auto at = std::find_if(notes.begin(), notes.end(), says);
    return at == notes.end() ? "" : *at;
  };
  std::string samples;
  for (int frame = 0; frame < 1000; ++frame) samples += samples_.substr(0, 2);
  const std::string whole = wav(samples);
  EXPECT_EQ(early(whole), "");
  EXPECT_THAT(early(whole.substr(0, 44 + 780)), HasSubstr("it holds 0.39 of the 1 s that its header states"));
  EXPECT_EQ(early(wav(samples, "LIST" + bytes_of_number(4, 4) + "abcd")), "") << "a chunk after the samples";
  // A program that writes to a pipe does not know the length.
  for (const std::uint32_t unknown : {0x7FFFFFDBU, 0xFFFFFFFFU}) {
    std::string stream = whole;
    stream.replace(40, 4, bytes_of_number(unknown, 4));
    EXPECT_EQ(early(stream), "") << unknown;
  }
  for (const SoundKind kind : {SoundKind::rf64, SoundKind::w64}) {
    {
      SoundOutput out(path_, true, kind, 2, 1000, {}, std::nullopt);
      out.append(std::vector<double>(2000, 0.25));
      out.commit();
    }
    const std::string bytes = test::bytes_of(path_);
    EXPECT_EQ(early(bytes), "");
    EXPECT_THAT(early(bytes.substr(0, bytes.size() - 8000)), HasSubstr("it holds 0.5 of the 1 s"))
        << bytes.substr(0, 4);
  }
}

TEST_F(SoundLimits, ChunksThatClaimMoreThanTheFileAreRefused) {
  for (const std::uint32_t claimed : {100'000U, 0x7FFFFFF0U}) {
    EXPECT_EQ(input_error_of([&] { opened(wav(samples_, "CAL1" + bytes_of_number(claimed, 4) + "{}  "), {}); }),
              "a custom chunk that is too long (" + path_ + "); export the file again");
  }
  const std::uint32_t large = (16U << 20U) + 2;  // the limit is 16 MiB
  EXPECT_THAT(
      input_error_of([&] { opened(wav(samples_, "CAL1" + bytes_of_number(large, 4) + std::string(large, ' ')), {}); }),
      HasSubstr("a custom chunk that is too long"));
}

TEST_F(SoundLimits, OtherFilesAndRangesAreRefused) {
  test::write_bytes(path_, "FORM....AIFF");
  EXPECT_THAT(input_error_of([&] { SoundInput sound(path_); }), HasSubstr("not a WAV, RF64 or W64 file"));
  test::write_bytes(path_, wav(samples_));
  const SoundInput sound(path_);
  std::vector<double> out(1);
  EXPECT_THAT(input_error_of([&] { sound.read(0, 5, out); }), HasSubstr("truncated"));
  out.resize(3);
  EXPECT_THAT(input_error_of([&] { sound.read(0, 0, out); }), HasSubstr("truncated"));
}

TEST_F(SoundLimits, AWrittenFileMayLackAChunk) {
  {
    SoundOutput out(path_, false, SoundKind::wav, 2, 1000, {}, std::nullopt);
    out.append(std::vector<double>{0.25, -0.5});
    out.commit();
  }
  const SoundInput sound(path_);
  EXPECT_FALSE(sound.chunk(kCalibrationChunk).has_value());
  std::vector<double> second(1);
  sound.read(1, 0, second);
  EXPECT_EQ(second[0], -0.5);
  EXPECT_THAT(input_error_of([&] {
                SoundOutput many(folder_.file("many.wav"), false, SoundKind::wav, 2000, 1000, {}, std::nullopt);
              }),
              HasSubstr("2000 channels, or the sampling rate, exceed the limits of the format"));
}

TEST(SoundCalibrationText, IsRefusedWithThePlace) {
  const auto refusal = [](const std::string& members) {
    return input_error_of([&] { parse_calibration(R"({"signals": [])" + members + "}", "x"); });
  };
  EXPECT_EQ(refusal(R"(, "rows": [{"samples": 2, "point": 1.5}])"),
            "not a whole number (x, rows[0].point); write a whole number");
  EXPECT_EQ(refusal(R"(, "rows": [{"samples": 2, "point": -5}])"),
            "-5 is out of range (x, rows[0].point); give 0 to 1e+09");
  const std::string not_coordinates =
      "not 2 or 3 coordinates for every point (x, geometry_m); write them point by point";
  EXPECT_EQ(refusal(R"(, "geometry_m": [0, 1, 2, 3])"), not_coordinates);
  EXPECT_EQ(refusal(R"(, "geometry_m": [0, 1], "coordinates": 1)"), not_coordinates);
  EXPECT_EQ(refusal(R"(, "geometry_m": [0, 1, 2, 3], "coordinates": 4)"), not_coordinates);
  EXPECT_EQ(refusal(R"(, "geometry_m": [0, 1, 2], "geometry_points": [0, 1])"),
            "not one number for every point (x, geometry_points); write one each");
  EXPECT_EQ(refusal(R"(, "geometry_m": [0, 1, 2], "points": 2000, "geometry_points": [0])"),
            "points numbered too far apart (x, points); number them from 0");
  const std::string not_rising =
      "point numbers that do not rise, or are not below \"points\" (x, geometry_points); number points from 0";
  for (const char* numbers : {"[1, 1]", "[0, 5]", "[0, 1.5]", "[-1, 0]"}) {
    EXPECT_EQ(refusal(R"(, "geometry_m": [0, 1, 2, 3, 4, 5], "points": 3, "geometry_points": )" + std::string(numbers)),
              not_rising);
  }
  const SoundCalibration read =
      parse_calibration(R"({"signals": [], "geometry_m": [0, 1, 2], "points": 3, "geometry_points": [1]})", "x");
  ASSERT_EQ(read.geometry.size(), 3U);
  EXPECT_THAT(read.geometry[1], ElementsAre(0, 1, 2));
  EXPECT_TRUE(std::isnan(read.geometry[0][0]) && std::isnan(read.geometry[2][2]));
}

}  // namespace percuss::acquire::sound_limits_test
