#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <thread>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/record/contiguous_samples.hpp"
#include "core/units.hpp"
#include "support/files/hdf5_builder.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::read_hdf5_test {

using test::accel_mps2;
using test::force_N;
using test::Hdf5Builder;
using test::input_error_of;
using test::ramp_value;
using testing::HasSubstr;

class Hdf5Read : public testing::Test {
 protected:
  /// ramp_value of `count` elements from `first`, times `scale`.
  std::vector<double> ramp(std::size_t first, std::size_t count, double scale = 1) const {
    std::vector<double> out;
    for (std::size_t i = 0; i < count; ++i) out.push_back(ramp_value(first + i) * scale);
    return out;
  }
  void expect_ramps(const Record& record) const {
    for (std::size_t row = 0; row < record.rows.size(); ++row) {
      const std::size_t samples = record.rows[row].samples;
      EXPECT_EQ(force_N(record, row), ramp(row * samples, samples));
      for (std::size_t c = 0; c < record.accel.size(); ++c) {
        EXPECT_EQ(accel_mps2(record, c, row), ramp((row * record.accel.size() + c) * samples, samples));
      }
    }
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.h5");
};

TEST_F(Hdf5Read, DescribesHitsAndChannelsAndReadsThem) {
  Hdf5Builder(path_)
      .ramp("force", {3, 50})
      .ramp("accel", {3, 2, 50})
      .numbers("", "fs", {25600})
      .numbers("accel", "angle_deg", {0, 90})
      .numbers("accel", "position_m", {0.05, 0.1})
      .values("point", {3}, {4, 4, 7}, {.type = H5T_STD_I32LE})
      .values("run", {3}, {0, 1, 1}, {.type = H5T_STD_I64BE})
      .values("geometry", {2, 3}, {0, 1, 2, 3, 4, 5})
      .ramp("deflection", {3, 50})
      .text("force", "unit_str", "N", true)
      .text("accel", "unit_str", "m/s^2", true);
  const Record record = open_hdf5(path_);
  EXPECT_EQ(record.format, "HDF5");
  EXPECT_EQ(record.fs_Hz, 25600);
  EXPECT_FALSE(record.continuous);
  ASSERT_EQ(record.files.size(), 1u);
  EXPECT_EQ(record.files[0].bytes, test::bytes_of(path_).size());
  ASSERT_EQ(record.accel.size(), 2u);
  EXPECT_EQ(record.accel[1].name, "accel 2");
  EXPECT_DOUBLE_EQ(record.accel[1].angle_rad.value(), std::numbers::pi / 2);
  EXPECT_EQ(record.accel[0].position_m, 0.05);
  ASSERT_EQ(record.rows.size(), 3u);
  EXPECT_EQ(record.rows[2].point, 7);
  EXPECT_EQ(record.rows[1].run, 1);
  EXPECT_EQ(record.geometry, (std::vector<std::vector<double>>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_THAT(test::texts(record.notes), testing::ElementsAre("not used: /deflection"));
  expect_ramps(record);
}

TEST_F(Hdf5Read, RefusesNegativePoints) {
  Hdf5Builder(path_)
      .ramp("force", {2, 50})
      .ramp("accel", {2, 1, 50})
      .numbers("", "fs", {25600})
      .values("run", {2}, {-1, 0})
      .values("point", {2}, {0, -5});
  EXPECT_EQ(test::input_error_of([&] { open_hdf5(path_); }),
            "-5 is not a point number (" + path_ + ": /point); number points from 0 to 1000000000");
}

TEST_F(Hdf5Read, AcceptsEveryNumberTypeAndStorage) {
  const std::vector<test::Hdf5Storage> storages{{.type = H5T_IEEE_F32LE}, {.type = H5T_IEEE_F32BE},
                                                {.type = H5T_IEEE_F64BE}, {.type = H5T_STD_I16BE},
                                                {.type = H5T_STD_I8LE},   {.type = H5T_STD_I32LE}};
  for (test::Hdf5Storage storage : storages) {
    for (const int gzip : {-1, 0, 9}) {
      storage.gzip = gzip;
      storage.chunk = gzip == 0 ? std::vector<hsize_t>{} : std::vector<hsize_t>{1, 1, 16};
      Hdf5Builder(path_)
          .numbers("", "fs", {1000})
          .ramp("force", {3, 50}, {.type = storage.type})
          .ramp("accel", {3, 2, 50}, storage);
      expect_ramps(open_hdf5(path_));
    }
  }
}

TEST_F(Hdf5Read, ReadsAChunkThatHoldsTheWholeRecord) {
  constexpr hsize_t kSamples = 40'000;  // the chunk exceeds the library's own cache
  Hdf5Builder(path_)
      .numbers("", "fs", {1000})
      .ramp("force", {3, kSamples})
      .ramp("accel", {3, 2, kSamples}, {.chunk = {3, 2, kSamples}, .gzip = 1});
  expect_ramps(open_hdf5(path_));
}

TEST_F(Hdf5Read, AcceptsOneDimensionFewer) {
  const std::vector<std::tuple<std::vector<hsize_t>, std::vector<hsize_t>, std::size_t, bool>> cases{
      {{50}, {2, 50}, 2, true},      // [samples], [channels, samples]
      {{50}, {50}, 1, true},         // one channel
      {{50}, {1, 3, 50}, 3, true},   // one hit
      {{3, 50}, {3, 50}, 1, false},  // [hits, samples], one channel
      {{1, 50}, {2, 50}, 2, false},  // one hit, [channels, samples]
      {{1, 50}, {50}, 1, false},
  };
  for (const auto& [force, accel, channels, continuous] : cases) {
    Hdf5Builder(path_).numbers("", "fs", {1000}).ramp("force", force).ramp("accel", accel);
    const Record record = open_hdf5(path_);
    EXPECT_EQ(record.accel.size(), channels);
    EXPECT_EQ(record.continuous, continuous);
    expect_ramps(record);
  }
}

TEST_F(Hdf5Read, ReadsOnlyTheRangeRequested) {
  Hdf5Builder(path_).numbers("", "fs", {1000}).ramp("force", {2, 100}).ramp("accel", {2, 2, 100});
  const Record record = open_hdf5(path_);
  std::vector<double> part(7);
  record.read_force_N(1, 90, part);
  EXPECT_EQ(part, ramp(190, 7));
  record.read_accel_mps2(1, 0, 13, part);
  EXPECT_EQ(part, ramp(213, 7));
}

TEST_F(Hdf5Read, FindsTheRateOnTheDataSets) {
  Hdf5Builder(path_).ramp("force", {2, 9}).ramp("accel", {2, 1, 9}).numbers("accel", "fs", {2000});
  EXPECT_EQ(open_hdf5(path_).fs_Hz, 2000);
  EXPECT_EQ(open_hdf5(path_, {.fs_Hz = 512}).fs_Hz, 512);
}

TEST_F(Hdf5Read, ConvertsUnitsInTextsOfFixedAndVariableLength) {
  for (const bool fixed : {false, true}) {
    Hdf5Builder(path_)
        .numbers("", "fs", {1000})
        .ramp("force", {2, 9})
        .ramp("accel", {2, 1, 9})
        .text("force", "unit_str", "lbf", fixed)
        .text("accel", "unit_str", "g", fixed);
    const Record record = open_hdf5(path_);
    EXPECT_EQ(record.force.unit, "lbf");
    EXPECT_EQ(force_N(record, 1), ramp(9, 9, kPoundForce_N));
    EXPECT_EQ(accel_mps2(record, 0, 1), ramp(9, 9, kStandardGravity_mps2));
  }
}

TEST_F(Hdf5Read, PrefersTheUsersStatementsToTheFiles) {
  Hdf5Builder(path_)
      .numbers("", "fs", {1000})
      .ramp("force", {2, 9})
      .ramp("accel", {2, 3, 9})
      .numbers("accel", "angle_deg", {0, 45, 90})
      .text("accel", "unit_str", "furlong");
  ReadOptions options;
  options.accel_channels = {"3", "accel 1"};
  options.force_scale = {2};
  options.accel_unit = "g";
  options.position_m = {0.5, 0.25};
  options.setup = {{.name = "accel 1", .sign = -1, .angle_rad = 1.5}, {.name = "force", .sign = -1, .unit = "mV"}};
  const Record record = open_hdf5(path_, options);
  ASSERT_EQ(record.accel.size(), 2u);
  EXPECT_EQ(record.accel[0].name, "accel 3");
  EXPECT_DOUBLE_EQ(record.accel[0].angle_rad.value(), std::numbers::pi / 2);
  EXPECT_EQ(record.accel[1].angle_rad, 1.5);
  EXPECT_EQ(record.accel[1].position_m, 0.25);
  EXPECT_EQ(force_N(record, 0), ramp(0, 9, -2));
  EXPECT_EQ(accel_mps2(record, 0, 1), ramp(45, 9, kStandardGravity_mps2));
  EXPECT_EQ(accel_mps2(record, 1, 1), ramp(27, 9, -kStandardGravity_mps2));
}

TEST_F(Hdf5Read, KeepsAForceInVoltsWithANote) {
  Hdf5Builder(path_)
      .numbers("", "fs", {1000})
      .ramp("force", {2, 9})
      .ramp("accel", {2, 9})
      .text("accel", "unit_str", "m/s^2")
      .text("force", "unit_str", "mV");
  const Record record = open_hdf5(path_, {});
  ASSERT_EQ(record.notes.size(), 1u);
  EXPECT_THAT(record.notes[0].text, HasSubstr("FRFs are per volt"));
  EXPECT_EQ(record.force.to_SI, 1e-3);
  EXPECT_TRUE(open_hdf5(path_, {.force_sensitivity_V_per_N = 0.01}).notes.empty());
}

TEST_F(Hdf5Read, OmitsChannelsThatTheSetupIgnores) {
  Hdf5Builder(path_).numbers("", "fs", {1000}).ramp("force", {2, 9}).ramp("accel", {2, 3, 9});
  const Record record = open_hdf5(path_, {.setup = {{.name = "2", .role = "ignore"}}});
  ASSERT_EQ(record.accel.size(), 2u);
  EXPECT_EQ(record.accel[1].name, "accel 3");
  EXPECT_EQ(accel_mps2(record, 1, 0), ramp(18, 9));
}

TEST_F(Hdf5Read, ReadsDataSetsThatTheOptionsName) {
  {
    Hdf5Builder file(path_);
    H5Gclose(H5Gcreate2(file.id(), "measurement", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    file.numbers("", "fs", {1000}).ramp("measurement/hammer", {2, 9}).ramp("measurement/acc", {2, 3, 9});
    file.text("measurement/hammer", "unit_str", "N").text("measurement/acc", "unit_str", "m/s^2").ramp("spare", {4});
  }
  const Record record =
      open_hdf5(path_, {.force_channel = "/measurement/hammer", .accel_channels = {"measurement/acc"}});
  EXPECT_EQ(force_N(record, 1), ramp(9, 9));
  EXPECT_EQ(accel_mps2(record, 2, 1), ramp(45, 9));
  EXPECT_THAT(test::texts(record.notes), testing::ElementsAre("not used: /spare"));
  const auto message = [&](const ReadOptions& options) { return input_error_of([&] { open_hdf5(path_, options); }); };
  EXPECT_THAT(message({}), HasSubstr("no data set /force among: measurement/acc, measurement/hammer, spare ("));
  EXPECT_THAT(message({.force_channel = "measurement/none"}), HasSubstr("no data set /measurement/none among"));
  EXPECT_THAT(message({.force_channel = "none/hammer"}), HasSubstr("no data set /none/hammer among"));
  EXPECT_THAT(message({.force_channel = "measurement"}), HasSubstr("not a data set"));
  EXPECT_THAT(message({.force_channel = "measurement/hammer", .accel_channels = {"measurement/acc", "spare"}}),
              HasSubstr("several data sets named for the accelerations"));
  EXPECT_THAT(test::options_of_error([&] { open_hdf5(path_, {}); }),
              testing::ElementsAre("force_channel", "accel_channel"));
}

// The hammer was plugged into the first channel, and the first sensor into the hammer's.
TEST_F(Hdf5Read, ExchangesTheForceAndAChannelByTheirNames) {
  Hdf5Builder(path_)
      .numbers("", "fs", {1000})
      .ramp("force", {2, 9})
      .ramp("accel", {2, 2, 9})
      .text("force", "unit_str", "N")
      .text("accel", "unit_str", "m/s^2")
      .numbers("accel", "angle_deg", {0, 90});
  const auto expect_exchanged = [&](const ReadOptions& options) {
    const Record record = open_hdf5(path_, options);
    EXPECT_EQ(record.force.name, "accel 1");
    EXPECT_EQ(force_N(record, 1), ramp(18, 9));
    ASSERT_EQ(record.accel.size(), 2u);
    EXPECT_EQ(record.accel[0].name, "force");
    EXPECT_EQ(accel_mps2(record, 0, 1), ramp(9, 9));
    EXPECT_EQ(accel_mps2(record, 1, 1), ramp(27, 9));
    EXPECT_EQ(record.accel[0].angle_rad, 0) << "the place of the channel that is the force";
    EXPECT_DOUBLE_EQ(record.accel[1].angle_rad.value(), std::numbers::pi / 2);
    EXPECT_THAT(test::texts(record.notes), testing::ElementsAre(HasSubstr("states for accel 1, which is the force")));
    EXPECT_EQ(record.contiguous.size(), 3u);
    // The samples that are read directly from the file are the same ones.
    const Record direct = with_contiguous_readers(record);
    EXPECT_EQ(force_N(direct, 1), ramp(18, 9));
    EXPECT_EQ(accel_mps2(direct, 0, 1), ramp(9, 9));
    EXPECT_EQ(accel_mps2(direct, 1, 0), ramp(9, 9));
  };
  expect_exchanged(
      {.force_channel = "accel 1", .accel_channels = {"force", "accel 2"}, .force_unit = "N", .accel_unit = "m/s^2"});
  expect_exchanged({.force_unit = "N",
                    .accel_unit = "m/s^2",
                    .setup = {{.name = "accel 1", .role = "force"},
                              {.name = "force", .role = "acceleration"},
                              {.name = "accel 2", .role = "acceleration"}}});
  const Record one = open_hdf5(path_, {.force_channel = "accel 2", .force_unit = "N"});
  ASSERT_EQ(one.accel.size(), 1u);
  EXPECT_EQ(one.accel[0].name, "accel 1");
  EXPECT_EQ(force_N(one, 0), ramp(9, 9));
  // The file states its units for the roles that it gives to the signals. For other roles, the user states the units.
  EXPECT_THAT(input_error_of([&] { open_hdf5(path_, {.force_channel = "accel 1", .accel_channels = {"force"}}); }),
              HasSubstr("\"m/s^2\" measures an acceleration, not a force"));
  EXPECT_THAT(test::options_of_error([&] { open_hdf5(path_, {.force_channel = "accel 1"}); }),
              testing::ElementsAre("force_unit"));
}

TEST_F(Hdf5Read, FindsTheForceAmongTheChannels) {
  Hdf5Builder(path_).numbers("", "fs", {1000}).ramp("accel", {2, 3, 9});
  const Record record = open_hdf5(path_, {.force_channel = "accel 1"});
  EXPECT_EQ(force_N(record, 1), ramp(27, 9));
  ASSERT_EQ(record.accel.size(), 2u);
  EXPECT_EQ(accel_mps2(record, 1, 0), ramp(18, 9));
}

TEST_F(Hdf5Read, SaysWhichUnitsItAssumes) {
  Hdf5Builder(path_).numbers("", "fs", {1000}).ramp("force", {2, 9}).ramp("accel", {2, 2, 9});
  const Record record = open_hdf5(path_);
  EXPECT_THAT(test::texts(record.notes),
              testing::ElementsAre("the unit of force is not stated; taken as N",
                                   "the units of accel 1 and accel 2 are not stated; taken as m/s^2"));
  EXPECT_TRUE(record.force.unit_assumed);
  EXPECT_THAT(open_hdf5(path_, {.force_unit = "N", .accel_unit = "g"}).notes, testing::IsEmpty());
  EXPECT_THAT(open_hdf5(path_, {.force_scale = {2}, .accel_scale = {3}}).notes, testing::IsEmpty());
}

TEST_F(Hdf5Read, RefusesChannelsThatDoNotExist) {
  Hdf5Builder(path_).numbers("", "fs", {1000}).ramp("force", {2, 9}).ramp("accel", {2, 2, 9});
  const auto message = [&](const ReadOptions& options) { return input_error_of([&] { open_hdf5(path_, options); }); };
  EXPECT_THAT(message({.accel_channels = {"3"}}), HasSubstr("accel 1 to accel 2"));
  EXPECT_THAT(message({.accel_channels = {"0"}}), HasSubstr("no acceleration channel 0 (" + path_ + ");"));
  EXPECT_THAT(message({.accel_channels = {"1", "accel 1"}}), HasSubstr("twice"));
  EXPECT_THAT(message({.force_channel = "hammer"}), HasSubstr("force"));
  EXPECT_THAT(message({.setup = {{.name = "accel 9"}}}), HasSubstr("accel 9"));
  EXPECT_THAT(message({.force_channel = "accel 3"}), HasSubstr("no force channel accel 3"));
  EXPECT_THAT(message({.accel_channels = {"force"}}), HasSubstr("is named as an acceleration and is the force"));
  EXPECT_THAT(message({.force_channel = "accel 1", .accel_channels = {"force", "accel 1"}}),
              HasSubstr("is named as an acceleration and is the force"));
  EXPECT_THAT(message({.setup = {{.name = "force", .role = "acceleration"}}}),
              HasSubstr("give the role force to another channel"));
  EXPECT_THAT(message({.angle_rad = {0, 1, 2}}), HasSubstr("3 values for 2 acceleration channels (" + path_ + ");"));
}

TEST_F(Hdf5Read, NamesTheSampleThatIsNotFinite) {
  std::vector<double> accel(36, 1.0);
  accel[(1 * 2 + 1) * 9 + 4] = std::numeric_limits<double>::quiet_NaN();
  Hdf5Builder(path_).numbers("", "fs", {1000}).ramp("force", {2, 9}).values("accel", {2, 2, 9}, accel);
  const Record record = open_hdf5(path_);
  EXPECT_EQ(accel_mps2(record, 1, 0), std::vector<double>(9, 1.0));
  EXPECT_THAT(input_error_of([&] { accel_mps2(record, 1, 1); }), HasSubstr("/accel[1, 1, 4]"));
  std::vector<double> part(3);
  EXPECT_THAT(input_error_of([&] { record.read_accel_mps2(1, 1, 3, part); }), HasSubstr("/accel[1, 1, 4]"));
}

TEST_F(Hdf5Read, ServesSeveralThreads) {
  Hdf5Builder(path_)
      .numbers("", "fs", {1000})
      .ramp("force", {4, 300})
      .ramp("accel", {4, 2, 300}, {.chunk = {2, 1, 64}, .gzip = 3});
  const Record record = open_hdf5(path_);
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int turn = 0; turn < 20; ++turn) {
        expect_ramps(record);
        EXPECT_EQ(open_hdf5(path_).fs_Hz, 1000);
      }
    });
  }
  for (auto& thread : threads) thread.join();
}

}  // namespace percuss::acquire::read_hdf5_test
