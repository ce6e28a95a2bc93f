#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/formats/sound/sound_calibration.hpp"
#include "acquire/formats/sound/sound_file.hpp"
#include "acquire/open_measurement.hpp"
#include "acquire/record/record.hpp"
#include "acquire/write_record.hpp"
#include "support/files/csv_text.hpp"
#include "support/files/wav_bytes.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::sound_record_test {

using test::accel_mps2;
using test::bytes_of_number;
using test::force_N;
using test::input_error_of;
using test::wav_bytes;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::string integers(const std::vector<int>& values, std::size_t bytes, bool big = false) {
  std::string out;
  for (const int value : values) out += bytes_of_number(static_cast<std::uint32_t>(value), bytes, big);
  return out;
}

std::string calibration_chunk(std::string text) {
  text.resize((text.size() + 1) / 2 * 2, ' ');
  return "CAL1" + bytes_of_number(text.size(), 4) + text;
}

class SoundRecord : public testing::Test {
 protected:
  Record opened(const std::string& bytes, const ReadOptions& options = {}) const {
    test::write_bytes(path_, bytes);
    return open_record(path_, options);
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.wav");
};

const ReadOptions kHammerOnOne{.force_channel = "1", .accel_channels = {"2"}};

TEST_F(SoundRecord, IsReadFromEveryWidthAndByteOrder) {
  const std::vector<int> values{0, 1 << 6, 1 << 5, -(1 << 6), 1 << 4, 3};
  for (const std::uint64_t bits : {16U, 24U, 32U}) {
    for (const bool big : {false, true}) {
      SCOPED_TRACE(testing::Message() << bits << (big ? " big" : " little"));
      std::vector<int> shifted;
      shifted.reserve(values.size());
      for (const int value : values) shifted.push_back(value * (1 << (bits - 8)));
      const Record record =
          opened(wav_bytes({.bits = bits, .big = big}, integers(shifted, bits / 8, big)), kHammerOnOne);
      EXPECT_EQ(record.format, "WAV");
      EXPECT_EQ(record.fs_Hz, 1000);
      EXPECT_TRUE(record.continuous);
      EXPECT_THAT(force_N(record), ElementsAre(0, 0.25, 0.125));
      EXPECT_THAT(accel_mps2(record), ElementsAre(0.5, -0.5, 3.0 / 128));
    }
  }
}

TEST_F(SoundRecord, KeepsFloatingPointNumbersAsTheyAre) {
  std::string samples;
  for (const float value : {0.0F, 1e-3F, 250.5F, -2e4F}) samples.append(reinterpret_cast<const char*>(&value), 4);
  const Record record = opened(wav_bytes({.kind = 3, .bits = 32}, samples), kHammerOnOne);
  EXPECT_THAT(force_N(record), ElementsAre(0, 250.5));
  EXPECT_THAT(accel_mps2(record), ElementsAre(static_cast<double>(1e-3F), -2e4));
}

TEST_F(SoundRecord, IsCalibratedByOptions) {
  ReadOptions options = kHammerOnOne;
  const std::string bytes = wav_bytes({}, integers({1 << 14, 1 << 14, 0, 0}, 2));
  EXPECT_THAT(test::texts(opened(bytes, options).notes), Contains(HasSubstr("full scale")));
  options.force_scale = {1000};
  options.accel_scale = {98.0665};
  const Record record = opened(bytes, options);
  EXPECT_THAT(force_N(record), ElementsAre(500, 0));
  EXPECT_THAT(accel_mps2(record), ElementsAre(0.5 * 98.0665, 0));
  EXPECT_TRUE(record.notes.empty());
}

TEST_F(SoundRecord, SaysThatFullScaleIsTakenAsOneVolt) {
  ReadOptions options = kHammerOnOne;
  options.force_sensitivity_V_per_N = 0.01;
  options.accel_sensitivity_V_per_mps2 = {0.01};
  const Record record = opened(wav_bytes({}, integers({1 << 14, 1 << 14, 0, 0}, 2)), options);
  EXPECT_THAT(force_N(record), ElementsAre(50, 0));
  EXPECT_THAT(test::texts(record.notes), Contains(HasSubstr("full scale is taken as 1 V")));
}

// The scales of the options include the full scale, so they count before the sensitivities of a set-up, and no note on
// the full scale is given.
TEST_F(SoundRecord, TakesScalesBeforeTheSensitivitiesOfASetup) {
  ReadOptions options = kHammerOnOne;
  options.setup.resize(2);
  options.setup[0].sensitivity_V_per_SI = 0.01;
  options.force_scale = {1000};
  options.accel_scale = {98.0665};
  const Record record = opened(wav_bytes({}, integers({1 << 14, 1 << 14, 0, 0}, 2)), options);
  EXPECT_THAT(force_N(record), ElementsAre(500, 0));
  EXPECT_THAT(test::texts(record.notes), Not(Contains(HasSubstr("full scale"))));
}

TEST_F(SoundRecord, IsCalibratedByItsChunk) {
  const std::string chunk = calibration_chunk(
      R"({"fs_hz": 999.5, "signals": [{"name": "hammer", "measures": "force", "si_at_full_scale": 2048},)"
      R"( {"name": "barrel", "measures": "acceleration", "si_at_full_scale": -100, "angle_rad": 0.5}],)"
      R"( "rows": [{"samples": 2, "point": 3}, {"samples": 2, "point": 4}]})");
  const Record record = opened(wav_bytes({.before = chunk}, integers({0, 0, 1 << 14, 1 << 14, 0, 1 << 13, 0, 0}, 2)));
  EXPECT_EQ(record.fs_Hz, 999.5);
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_EQ(record.rows[1].point, 4);
  EXPECT_FALSE(record.continuous);
  EXPECT_EQ(record.accel.at(0).name, "barrel");
  EXPECT_EQ(record.accel[0].angle_rad, 0.5);
  EXPECT_THAT(force_N(record, 0), ElementsAre(0, 1024));
  EXPECT_THAT(accel_mps2(record, 0, 1), ElementsAre(-25, 0));
}

TEST_F(SoundRecord, ReadsARowAfterOneThatIsTooShort) {
  const std::string chunk = calibration_chunk(
      R"({"signals": [{"name": "f", "measures": "force", "si_at_full_scale": 32768}, {"si_at_full_scale": 1}],)"
      R"( "rows": [{"samples": 2}, {"samples": 1}, {"samples": 2}]})");
  const Record record = opened(wav_bytes({.before = chunk}, integers({1, 0, 2, 0, 3, 0, 4, 0, 5, 0}, 2)));
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_THAT(force_N(record, 1), ElementsAre(4, 5));
  EXPECT_THAT(test::texts(record.notes), testing::Not(Contains(HasSubstr("ends early"))));
}

TEST_F(SoundRecord, TakesTheOtherChannelsAsAccelerationsWhenTheForceIsNamed) {
  const std::string bytes = wav_bytes({.channels = 3}, integers({1 << 14, 0, 1 << 13, 0, 1 << 14, 0}, 2));
  const Record record = opened(bytes, {.force_channel = "2"});
  EXPECT_EQ(record.force.name, "channel 2");
  ASSERT_EQ(record.accel.size(), 2U);
  EXPECT_THAT(force_N(record), ElementsAre(0, 0.5));
  EXPECT_THAT(accel_mps2(record, 1), ElementsAre(0.25, 0));
}

TEST_F(SoundRecord, IsAmbiguousWithoutAForceChannel) {
  EXPECT_THROW(opened(wav_bytes({}, integers({1, 2, 3, 4}, 2))), AmbiguousColumns);
}

TEST_F(SoundRecord, ReadsATruncatedRecordingUpToItsEnd) {
  const std::string samples = integers({0, 0, 1 << 14, 1 << 14}, 2);
  EXPECT_THAT(force_N(opened(wav_bytes({.claimed_bytes = 4000}, samples), kHammerOnOne)), ElementsAre(0, 0.5));
  const std::string chunk = calibration_chunk(
      R"({"signals": [{"name": "f", "measures": "force", "si_at_full_scale": 1}, {"si_at_full_scale": 1}],)"
      R"( "rows": [{"samples": 2}, {"samples": 2}]})");
  const Record record = opened(wav_bytes({.before = chunk}, samples));
  EXPECT_EQ(record.rows.size(), 1U);
  EXPECT_THAT(test::texts(record.notes), Contains(HasSubstr("ends early: 1 of 2 rows")));
}

TEST_F(SoundRecord, RefusesFilesThatAreNoMeasurement) {
  const auto error = [&](const std::string& bytes) { return input_error_of([&] { opened(bytes, kHammerOnOne); }); };
  EXPECT_THAT(error(wav_bytes({.kind = 6, .bits = 8}, std::string(400, 'x'))), HasSubstr("compressed"));
  EXPECT_THAT(error(wav_bytes({.channels = 0}, "xxxx")), HasSubstr(path_));
  EXPECT_THAT(error(wav_bytes({.rate_Hz = 0}, integers({1, 2, 3, 4}, 2))), HasSubstr(path_));
  EXPECT_THAT(error(wav_bytes({.before = calibration_chunk("[")}, integers({1, 2, 3, 4}, 2))), HasSubstr("CAL1"));
  EXPECT_THAT(error(wav_bytes({.before = calibration_chunk(R"({"signals": []})")}, integers({1, 2, 3, 4}, 2))),
              HasSubstr("0 signals described for 2 channels"));
  std::string samples;
  for (const float value : {0.0F, NAN, 1.0F, 2.0F}) samples.append(reinterpret_cast<const char*>(&value), 4);
  EXPECT_THAT(input_error_of([&] {
                const Record record = opened(wav_bytes({.kind = 3, .bits = 32}, samples), kHammerOnOne);
                accel_mps2(record);
              }),
              HasSubstr("not a finite number"));
}

TEST_F(SoundRecord, SurvivesTruncationAndMutations) {
  const std::string chunk = calibration_chunk(
      R"({"signals": [{"name": "f", "measures": "force", "si_at_full_scale": 1}, {"si_at_full_scale": 1}]})");
  std::vector<int> samples;  // twice as many bytes as the header and the chunk have together: mutations change both
  samples.reserve(150);
  for (int n = 0; n < 150; ++n) samples.push_back(200 * (n % 100));
  const std::string whole = wav_bytes({.before = chunk}, integers(samples, 2));
  int read = 0, refused = 0;
  const auto read_all = [&](const std::string& bytes) {
    try {
      const Record record = opened(bytes);
      for (std::size_t row = 0; row < record.rows.size(); ++row) {
        for (const double sample : force_N(record, row)) ASSERT_TRUE(std::isfinite(sample));
        for (const double sample : accel_mps2(record, 0, row)) ASSERT_TRUE(std::isfinite(sample));
      }
      ++read;
    } catch (const InputError&) {
      ++refused;
    }
  };
  for (std::size_t length = 0; length < whole.size(); ++length) read_all(whole.substr(0, length));
  std::mt19937 random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    std::string changed = whole;
    for (int i = 0; i < 1 + trial % 3; ++i) changed[random() % changed.size()] = static_cast<char>(random() & 0xFFU);
    read_all(changed);
  }
  EXPECT_GT(read, 500);  // mutations that matter always or never would test little
  EXPECT_GT(refused, 500);
}

TEST(SoundCalibration, ReadsBackWhatItWrites) {
  const SoundCalibration made{.fs_Hz = 51200.0 / 3,
                              .signals = {{.name = "f \"1\"", .measures = Quantity::force, .to_SI = 0.1},
                                          {.name = "a", .to_SI = -3, .angle_rad = 0.1, .position_m = 1e-3}},
                              .rows = {{.samples = 7, .point = 1, .run = -2}},
                              .continuous = true,
                              .geometry = {{0.1, 0.2}, {0.3, 0.4}}};
  const std::string text = calibration_text(made);
  const SoundCalibration read = parse_calibration(text, "x");
  EXPECT_EQ(calibration_text(read), text);
  EXPECT_EQ(read.fs_Hz, made.fs_Hz);
  EXPECT_EQ(read.signals[1].to_SI, -3);
  EXPECT_EQ(read.geometry, made.geometry);
  EXPECT_EQ(read.rows[0].point, 1);
  EXPECT_EQ(read.rows[0].run, -2);
}

TEST_F(SoundRecord, WrittenKeepsEveryDigitInWavAndRf64) {
  for (const char* name : {"w.wav", "w.rf64"}) {
    Record record = record_in_memory(44100.25, {{0, 300.1, -5}, {1e-9, 2, 3}}, {{{0.1, 7e4, 3}}, {{1, 1.0 / 3, -1}}});
    record.accel[0].angle_rad = 0.25;
    record.rows[1].point = 5;
    const std::string path = folder_.file(name);
    write_record(path, record, false);
    const Record read = open_record(path);
    EXPECT_EQ(read.fs_Hz, record.fs_Hz);
    EXPECT_EQ(read.accel[0].angle_rad, 0.25);
    ASSERT_EQ(read.rows.size(), 2U);
    EXPECT_EQ(read.rows[1].point, 5);
    for (std::size_t row = 0; row < 2; ++row) {
      EXPECT_EQ(force_N(read, row), force_N(record, row));
      EXPECT_EQ(accel_mps2(read, 0, row), accel_mps2(record, 0, row));
    }
    const SoundInput sound(path);
    std::vector<double> stored(sound.frames());
    sound.read(0, 0, stored);
    for (const double value : stored) EXPECT_LE(std::abs(value), 1) << "players clip samples beyond ±1";
  }
}

TEST_F(SoundRecord, WrittenHasTheFormOfItsExtensionInAnyLetterCase) {
  const Record record = record_in_memory(1000, {{0, 300.1, -5}}, {{{0.1, 7e4, 3}}});
  for (const auto& [name, form] :
       {std::pair{"w.Rf64", "RF64"}, {"w.RF64", "RF64"}, {"w.Wav", "RIFF"}, {"w.W64", "riff"}, {"x.w64", "riff"}}) {
    write_record(folder_.file(name), record, false);
    EXPECT_EQ(test::bytes_of(folder_.file(name)).substr(0, 4), form) << name;
  }
}

TEST_F(SoundRecord, WrittenAsW64HoldsPlainNumbers) {
  const Record record = record_in_memory(1000, {{0, 300.1, -5}}, {{{0.1, 7e4, 3}}});
  const std::string path = folder_.file("w.w64");
  EXPECT_THAT(losses_of(path, record), ElementsAre("the channels' names"));
  write_record(path, record, false);
  const Record read = open_record(path, kHammerOnOne);
  EXPECT_EQ(read.format, "W64");
  EXPECT_EQ(force_N(read), force_N(record));
  EXPECT_EQ(accel_mps2(read), accel_mps2(record));
}

// A channel of the sound file keeps the name "force_N" of its column in the text. The scale in the sound file counts,
// not the unit in that name. Samples are 64-bit floats, as fractions of full scale: the
// tolerances are a few roundings.
TEST_F(SoundRecord, KeepsTheScaleOfChannelsWhoseNamesCarryUnits) {
  const Record text = test::csv_record("t_s,force_N,acc_g\n0,0,1\n0.01,300,-2\n0.02,10,0.5\n0.03,0,0\n");
  write_record(path_, text, false);
  const Record sound = open_record(path_);
  EXPECT_THAT(force_N(sound), ElementsAre(0, testing::DoubleNear(300, 1e-12), testing::DoubleNear(10, 1e-12), 0));
  const std::vector<double> expected = accel_mps2(text), found = accel_mps2(sound);
  for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_NEAR(found[n], expected[n], 1e-14);
}

}  // namespace percuss::acquire::sound_record_test
