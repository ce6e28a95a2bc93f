#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/formats/mat/read_mat.hpp"
#include "acquire/formats/mat/write_mat.hpp"
#include "acquire/open_measurement.hpp"
#include "acquire/record/frf_record.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "support/files/mat_builder.hpp"
#include "support/input_error.hpp"
#include "support/record_samples.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::mat_record_test {

using test::accel_mps2;
using test::force_N;
using test::input_error_of;
using test::MatBuilder;
using test::MatLevel;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class MatRecord : public testing::Test {
 protected:
  Record opened(const ReadOptions& options = {}) const { return open_record(path_, options); }
  FrfRecord frfs(const FrfReadOptions& options = {}) const {
    return std::get<FrfRecord>(open_measurement(path_, options));
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("r.mat");
};

TEST_F(MatRecord, IsReadFromEveryLevel) {
  for (const MatLevel level : {MatLevel::v4, MatLevel::v5, MatLevel::v5_compressed, MatLevel::v73}) {
    SCOPED_TRACE(static_cast<int>(level));
    MatBuilder(path_, level)
        .numbers("fs", {1, 1}, {1000})
        .numbers("force", {4, 1}, {0, 5, 2, 1})
        .numbers("accel", {4, 2}, {1, 2, 3, 4, 5, 6, 7, 8});
    const Record record = opened();
    EXPECT_EQ(record.format, "MAT");
    EXPECT_EQ(record.fs_Hz, 1000);
    ASSERT_EQ(record.rows.size(), 1U);
    ASSERT_EQ(record.accel.size(), 2U);
    EXPECT_THAT(force_N(record), ElementsAre(0, 5, 2, 1));
    EXPECT_THAT(accel_mps2(record, 1), ElementsAre(5, 6, 7, 8));
  }
}

// A level 4 file, written byte by byte in both byte orders. Five numbers precede the name of a variable: type, rows,
// columns, 1 for complex, length of the name.
TEST_F(MatRecord, ReadsLevel4LaidOutByHand) {
  const auto variable = [](const std::string& name, const std::vector<double>& values, bool big) {
    std::string out;
    for (const std::uint32_t word : {big ? 1000U : 0U, static_cast<std::uint32_t>(values.size()), 1U, 0U,
                                     static_cast<std::uint32_t>(name.size() + 1)}) {
      const std::uint32_t stored = big ? __builtin_bswap32(word) : word;
      out.append(reinterpret_cast<const char*>(&stored), 4);
    }
    out += name + '\0';
    for (const double value : values) {
      std::string bytes(reinterpret_cast<const char*>(&value), 8);
      out += big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
    }
    return out;
  };
  for (const bool big : {false, true}) {
    test::write_bytes(path_, variable("hammer_N", {1, 2, 3}, big) + variable("acc_g", {1, 0, -1}, big) +
                                 variable("dt", {0.001}, big));
    const Record record = opened();
    EXPECT_EQ(record.fs_Hz, 1000);
    EXPECT_THAT(force_N(record), ElementsAre(1, 2, 3));
    EXPECT_THAT(accel_mps2(record), ElementsAre(kStandardGravity_mps2, 0, -kStandardGravity_mps2));
  }
}

TEST_F(MatRecord, ReadsHitsInEitherOrientation) {
  // Two hits of three samples, four channels. Sample i of hit h is 10 h + i in the force, and 100 (c + 1) more in
  // channel c.
  const auto value = [](std::size_t h, std::size_t i) { return static_cast<double>(10 * h + i); };
  std::vector<double> force_time_first, force_time_last, accel_time_first, accel_time_last;
  for (std::size_t h = 0; h < 2; ++h) {
    for (std::size_t i = 0; i < 3; ++i) force_time_first.push_back(value(h, i));  // [samples, hits]
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t h = 0; h < 2; ++h) force_time_last.push_back(value(h, i));  // [hits, samples]
  }
  for (std::size_t h = 0; h < 2; ++h) {
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t i = 0; i < 3; ++i) accel_time_first.push_back(100.0 * static_cast<double>(c + 1) + value(h, i));
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t h = 0; h < 2; ++h) accel_time_last.push_back(100.0 * static_cast<double>(c + 1) + value(h, i));
    }
  }
  for (const bool time_last : {false, true}) {
    using Shape = std::vector<std::size_t>;
    MatBuilder(path_, MatLevel::v5)
        .numbers("fs", {1, 1}, {1000})
        .numbers("force", time_last ? Shape{2, 3} : Shape{3, 2}, time_last ? force_time_last : force_time_first)
        .numbers("accel", time_last ? Shape{2, 4, 3} : Shape{3, 4, 2}, time_last ? accel_time_last : accel_time_first);
    const Record record = opened();
    ASSERT_EQ(record.rows.size(), 2U);
    ASSERT_EQ(record.accel.size(), 4U);
    EXPECT_THAT(force_N(record, 1), ElementsAre(10, 11, 12));
    EXPECT_THAT(accel_mps2(record, 2, 1), ElementsAre(310, 311, 312));
    const Record chosen = opened({.accel_channels = {"accel 4", "1"}});
    EXPECT_THAT(accel_mps2(chosen, 0, 0), ElementsAre(400, 401, 402));
    EXPECT_THAT(accel_mps2(chosen, 1, 0), ElementsAre(100, 101, 102));
  }
}

TEST_F(MatRecord, ReadsTheUnitOfTheTimes) {
  const auto build = [&](const std::string& unit) {
    MatBuilder builder(path_, MatLevel::v5);
    builder.numbers("force", {1, 3}, {0, 1, 2}).numbers("accel", {1, 3}, {3, 4, 5}).numbers("t", {1, 3}, {0, 1, 2});
    if (!unit.empty()) builder.text("t_unit", unit);
  };
  build("ms");
  EXPECT_EQ(opened().fs_Hz, 1000);
  build("s");
  EXPECT_EQ(opened().fs_Hz, 1);
  build("");
  EXPECT_THAT(
      input_error_of([&] { opened(); }),
      HasSubstr("t states no unit: its steps give 1 Hz if they are seconds and 1000 Hz if they are milliseconds"));
}

TEST_F(MatRecord, ReadsStructuresAndStructureArrays) {
  MatBuilder(path_, MatLevel::v5).structure("test", {"force", "accel", "fs"}, {{{0, 1, 2}, {3, 4, 5}, {500}}});
  EXPECT_THAT(accel_mps2(opened()), ElementsAre(3, 4, 5));
  EXPECT_EQ(opened().fs_Hz, 500);
  MatBuilder(path_, MatLevel::v5_compressed)
      .structure("hit", {"force", "acc"}, {{{0, 1, 2}, {3, 4, 5}}, {{6, 7, 8}, {9, 10, 11}}})
      .numbers("t", {1, 3}, {0, 0.001, 0.002});
  const Record record = opened();
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_EQ(record.fs_Hz, 1000);
  EXPECT_THAT(force_N(record, 1), ElementsAre(6, 7, 8));
  EXPECT_THAT(accel_mps2(record, 0, 1), ElementsAre(9, 10, 11));
}

TEST_F(MatRecord, ReadsStructureArraysOfNamedChannels) {
  const auto build = [&](const std::string& first, const std::string& second) {
    MatBuilder(path_, MatLevel::v5)
        .channels("ch", {{first, {0, 1, 2}, "kN"}, {second, {3, 4, 5}, "m/s^2"}})
        .numbers("fs", {1, 1}, {500});
  };
  build("Hammer 1", "Acc.");
  EXPECT_THAT(force_N(opened(), 0), ElementsAre(0, 1000, 2000));
  EXPECT_THAT(accel_mps2(opened()), ElementsAre(3, 4, 5));
  EXPECT_EQ(opened().force.name, "Hammer 1");
  MatBuilder(path_, MatLevel::v5)
      .channels("ch", {{"force_N", {0, 1, 2}, ""}, {"acc_g", {3, 4, 5}, ""}})
      .numbers("fs", {1, 1}, {500});
  EXPECT_EQ(opened().accel.front().to_SI, 9.80665);
  // Where no name is that of a force, and where names are equal, the elements may be hits.
  for (const auto& [first, second] : {std::pair("a", "b"), std::pair("hammer", "hammer")}) {
    build(first, second);
    EXPECT_THAT(input_error_of([&] { opened(); }), HasSubstr("ch.data [2x3]"));
  }
}

TEST_F(MatRecord, ReadsVariablesThatOptionsName) {
  MatBuilder(path_, MatLevel::v5)
      .singles("Time_chan_1", {3, 1}, {1, 2, 3})
      .singles("Time_chan_2", {3, 1}, {4, 5, 6})
      .singles("Time_Sample_Rate", {1, 1}, {1280})
      .numbers("data", {3, 2}, {7, 8, 9, 10, 11, 12})
      .numbers("speed", {1, 1}, {2000});
  EXPECT_THAT(input_error_of([&] { opened(); }), AllOf(HasSubstr("Time_chan_1 [3x1]"), HasSubstr("data [3x2]")));
  const ReadOptions named{.force_channel = "Time_chan_1", .accel_channels = {"Time_chan_2"}};
  EXPECT_EQ(opened(named).fs_Hz, 1280);
  EXPECT_THAT(accel_mps2(opened(named)), ElementsAre(4, 5, 6));
  ReadOptions other{.fs_variable = "speed", .force_channel = "data(:,1)", .accel_channels = {"data(:,2)"}};
  EXPECT_EQ(opened(other).fs_Hz, 2000);
  EXPECT_THAT(force_N(opened(other)), ElementsAre(7, 8, 9));
  EXPECT_THAT(accel_mps2(opened(other)), ElementsAre(10, 11, 12));
  other.fs_variable = "none";
  EXPECT_THAT(input_error_of([&] { opened(other); }), HasSubstr("no such variable"));
}

TEST_F(MatRecord, RefusesContradictions) {
  MatBuilder(path_, MatLevel::v5)
      .numbers("fs", {1, 1}, {1000})
      .numbers("dt", {1, 1}, {0.5})
      .numbers("force", {3, 1}, {1, 2, 3})
      .numbers("accel", {3, 1}, {1, 2, 3});
  EXPECT_THAT(input_error_of([&] { opened(); }), HasSubstr("0.5 s between samples"));
  MatBuilder(path_, MatLevel::v5).numbers("force", {3, 1}, {1, 2, 3}).numbers("accel", {3, 1}, {1, 2, 3});
  EXPECT_THAT(input_error_of([&] { opened(); }), HasSubstr("no sampling rate"));
  MatBuilder(path_, MatLevel::v5)
      .numbers("fs", {1, 1}, {1000})
      .numbers("force", {3, 1}, {1, 2, 3})
      .numbers("accel", {4, 1}, {1, 2, 3, 4});
  EXPECT_THAT(input_error_of([&] { opened(); }), HasSubstr("accel is 4x1: the force has 1 hit of 3 samples"));
  MatBuilder(path_, MatLevel::v5)
      .numbers("fs", {1, 1}, {1000})
      .numbers("force", {2, 2}, {1, 2, 3, 4})
      .numbers("accel", {2, 2}, {1, 2, 3, 4});
  EXPECT_THAT(input_error_of([&] { opened(); }), HasSubstr("time is unclear"));
  MatBuilder(path_, MatLevel::v5).text("note", "nothing here");
  EXPECT_THAT(input_error_of([&] { opened(); }), HasSubstr("no arrays of numbers"));
  MatBuilder(path_, MatLevel::v5)
      .numbers("fs", {1, 1}, {1000})
      .numbers("force", {2, 1}, {1, std::nan("")})
      .numbers("accel", {2, 1}, {1, 2});
  EXPECT_THAT(input_error_of([&] { force_N(opened()); }), HasSubstr("not a finite number"));
}

TEST_F(MatRecord, GivesFrfsWithTheirFrequencies) {
  const std::vector<std::complex<double>> lines{{1, 2}, {3, 4}, {5, 6}, {7, 8}, {9, 10}, {11, 12}};
  MatBuilder(path_, MatLevel::v5).complex("H", {3, 2}, lines).numbers("freq", {3, 1}, {10, 20, 30});
  const FrfRecord record = frfs();
  ASSERT_EQ(record.frfs.size(), 2U);
  EXPECT_EQ(record.lines.first, 1U);
  EXPECT_NEAR(record.lines.df_Hz(), 10, 1e-12);  // rounding, here and below
  EXPECT_EQ(record.frfs[1].frf.value[2], Complex(11, 12));
  EXPECT_EQ(frfs({.read = {.df_Hz = 10}}).lines.first, 1U);
  EXPECT_THAT(input_error_of([&] { frfs({.read = {.df_Hz = 0.5}}); }), HasSubstr("contradicts the frequencies"));
  MatBuilder(path_, MatLevel::v4).complex("MEscope1", {3, 2}, lines);
  EXPECT_THAT(input_error_of([&] { frfs(); }), HasSubstr("MEscope1 [3x2 complex]"));
  EXPECT_THAT(test::options_of_error([&] { frfs(); }), testing::ElementsAre("df"));
  EXPECT_NEAR(frfs({.read = {.df_Hz = 0.5}}).lines.freq_Hz(2), 1, 1e-12);
  EXPECT_NEAR(frfs({.read = {.fs_Hz = 400}}).lines.freq_Hz(2), 200, 1e-9);
}

TEST_F(MatRecord, IsAmbiguousWithSeveralComplexArrays) {
  const std::vector<std::complex<double>> lines{{1, 2}, {3, 4}};
  MatBuilder(path_, MatLevel::v5).complex("H1", {2, 1}, lines).complex("H2", {2, 1}, lines).numbers("df", {1, 1}, {2});
  EXPECT_THAT(input_error_of([&] { frfs(); }), HasSubstr("2 complex arrays could be the FRFs"));
  EXPECT_EQ(frfs({.read = {.accel_channels = {"H2"}}}).frfs.size(), 1U);
  // A time record beside FRFs: the options must choose one.
  MatBuilder(path_, MatLevel::v5)
      .complex("H1", {2, 1}, lines)
      .numbers("df", {1, 1}, {2})
      .numbers("chan_1", {4, 1}, {1, 2, 3, 4});
  EXPECT_THROW(open_measurement(path_), AmbiguousColumns);
  EXPECT_EQ(frfs({.kind = FrfKind::mobility}).kind, FrfKind::mobility);
}

class MatWritten : public MatRecord {
 protected:
  static Record example() {
    Record record = record_in_memory(25600, {{1, 2, 3.25}, {-4, 1e-300, 6}},
                                     {{{1, 2, 1.0 / 3}, {0, 0, 1}}, {{7, 8, 9}, {-1, -2, -3}}});
    record.rows[1].point = 3;
    record.rows[1].run = 2;
    record.accel[1].angle_rad = 1.5;
    record.geometry = {{0, 0}, {0.1, 90}, {0.2, 180}, {0.3, -1}};
    return record;
  }
};

TEST_F(MatWritten, IsReadBackExactly) {
  write_mat(path_, example(), false);
  const Record record = opened();
  ASSERT_EQ(record.rows.size(), 2U);
  EXPECT_EQ(record.fs_Hz, 25600);
  EXPECT_THAT(force_N(record, 1), ElementsAre(-4, 1e-300, 6));
  EXPECT_THAT(accel_mps2(record, 1, 1), ElementsAre(-1, -2, -3));
  EXPECT_THAT(accel_mps2(record, 0, 0), ElementsAre(1, 2, 1.0 / 3));
  EXPECT_EQ(record.rows[1].point, 3);
  EXPECT_EQ(record.rows[1].run, 2);
  EXPECT_NEAR(*record.accel[1].angle_rad, 1.5, 1e-15);  // degrees in the file
  EXPECT_FALSE(record.accel[0].angle_rad.has_value());
  EXPECT_EQ(record.geometry, example().geometry);
  EXPECT_FALSE(record.continuous);
  EXPECT_THAT(record.notes, IsEmpty());
  write_mat(folder_.file("again.mat"), record, false);
  EXPECT_EQ(test::bytes_of(path_), test::bytes_of(folder_.file("again.mat")));
}

TEST_F(MatWritten, DistinguishesASingleHitFromAContinuousRow) {
  for (const bool continuous : {false, true}) {
    Record record = record_in_memory(1000, {{1, 2, 3}}, {{{4, 5, 6}}});
    record.continuous = continuous;
    write_mat(path_, record, true);
    EXPECT_EQ(opened().continuous, continuous);
  }
}

TEST_F(MatWritten, IsRefusedWhenTruncated) {
  write_mat(path_, example(), false);
  const std::string good = test::bytes_of(path_);
  const auto try_bytes = [&](const std::string& bytes) {
    test::write_bytes(path_, bytes);
    try {
      const Record record = opened();
      std::vector<double> samples(record.rows.at(0).samples);
      for (std::size_t c = 0; c < record.accel.size(); ++c) record.read_accel_mps2(0, c, 0, samples);
      return true;
    } catch (const InputError&) {
      return false;
    }
  };
  // After `accel`, a cut between two variables leaves a readable file. The cuts end before the end of `accel`: its
  // samples and the header of accel_unit take less than 200 bytes.
  const std::size_t accel_unit = good.find("accel_unit");
  for (std::size_t cut = 0; cut < accel_unit - 200; cut += 3) EXPECT_FALSE(try_bytes(good.substr(0, cut))) << cut;
  EXPECT_TRUE(try_bytes(good));
}

}  // namespace percuss::acquire::mat_record_test
