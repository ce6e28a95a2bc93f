#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "support/files/hdf5_builder.hpp"
#include "support/rejection.hpp"
#include "support/scratch_folder.hpp"

// Well-formed files that are not usable measurements.
namespace percuss::hostile_samples_test {

using test::expect_analyses_reject;
using test::expect_reading_commands_reject;
using test::Hdf5Builder;
using test::rejection_of;
using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kSamples = 2048;

/// A hit after 100 samples and its decay, with a little noise.
double force_at(std::size_t i) {
  return (i >= 100 && i < 105 ? 80.0 : 0) + 1e-3 * std::sin(7.0 * static_cast<double>(i * i));
}

double accel_at(std::size_t i) {
  const double t = (static_cast<double>(i) - 100) / 2048;
  return (t > 0 ? 10 * std::exp(-8 * t) * std::sin(900 * t) : 0) + 1e-3 * std::sin(5.0 * static_cast<double>(i * i));
}

class HostileSamples : public testing::Test {
 protected:
  static std::vector<double> column(double (*value)(std::size_t)) {
    std::vector<double> samples;
    for (std::size_t i = 0; i < kSamples; ++i) samples.push_back(value(i));
    return samples;
  }
  void write_hdf5(const std::vector<double>& fs_Hz) {
    Hdf5Builder file(hdf5_);
    if (!fs_Hz.empty()) file.numbers("", "fs", fs_Hz);
    file.values("force", {1, kSamples}, force_).values("accel", {1, 1, kSamples}, accel_);
  }
  /// Lines of time, force and acceleration; `line` can replace each.
  void write_csv(const std::string& header, const std::function<std::string(std::size_t)>& line = {},
                 std::size_t lines = kSamples) {
    std::string text = header;
    for (std::size_t i = 0; i < lines; ++i) text += line ? line(i) : good_line(i);
    test::write_bytes(csv_, text);
  }
  std::string good_line(std::size_t i) const {
    return fmt::format("{:.9f},{:.9f},{:.9f}\n", static_cast<double>(i) / 2048, force_[i], accel_[i]);
  }

  const std::string header_ = "t_s,force_N,acc_m_s2\n";
  test::ScratchFolder folder_;
  std::string hdf5_ = folder_.file("bad.h5"), csv_ = folder_.file("bad.csv");
  std::vector<double> force_ = column(force_at), accel_ = column(accel_at);
};

TEST_F(HostileSamples, AreAcceptedWithoutADefect) {
  write_hdf5({2048});
  write_csv(header_);
  for (const auto& path : {hdf5_, csv_}) {
    for (const auto& command : {std::vector<std::string>{"analyze", path}, {"frf", path}, {"info", path}}) {
      const auto outcome = test::run_percuss(command);
      EXPECT_EQ(outcome.code, 0) << testing::PrintToString(command) << outcome.err;
    }
  }
}

TEST_F(HostileSamples, AreRejectedWithThePlaceOfANonFiniteValue) {
  // 9.91e37 is the NaN of SCPI instruments.
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e308, 9.91e37}) {
    accel_[1500] = bad;
    write_hdf5({2048});
    expect_analyses_reject(hdf5_, "bad.h5: /accel[0, 0, 1500]");
    accel_[1500] = 0;
    force_[50] = bad;
    write_hdf5({2048});
    expect_analyses_reject(hdf5_, "bad.h5: /force[0, 50]");
    rejection_of({"calibrate", hdf5_, "--mass", "1"}, {".json"}, "bad.h5: /force[0, 50]");
    force_[50] = 0;
  }
  for (const char* bad : {"nan", "NaN", "inf", "-Inf", "1e400", "9.91e37", "", "x", "0x1p3", "1e", "--1"}) {
    write_csv(header_, [&](std::size_t i) {
      return i == 1500 ? fmt::format("{:.9f},0,{}\n", static_cast<double>(i) / 2048, bad) : good_line(i);
    });
    expect_analyses_reject(csv_, "bad.csv: line 1502");
  }
}

TEST_F(HostileSamples, AreRejectedForImpossibleSamplingRates) {
  for (const double fs_Hz : {0.0, -5.0, kNan, kInfinity, 1e300, 1e-300}) {
    write_hdf5({fs_Hz});
    expect_reading_commands_reject(hdf5_, "bad.h5");
  }
  write_hdf5({1000, 2000});
  expect_reading_commands_reject(hdf5_, "bad.h5: attribute fs");
  write_hdf5({});
  EXPECT_THAT(rejection_of({"analyze", hdf5_}, {".json"}, "bad.h5"), HasSubstr("--fs"));
  write_hdf5({2048});
  for (const char* fs_Hz : {"0", "-5", "nan", "inf", "1e300"}) {
    rejection_of({"analyze", hdf5_, "--fs", fs_Hz}, {".json"}, "--fs");
    rejection_of({"info", hdf5_, "--fs", fs_Hz}, {}, "--fs");
  }
}

TEST_F(HostileSamples, AreRejectedForTimesWithoutARate) {
  const auto with_time = [&](const std::function<std::string(std::size_t)>& time) {
    write_csv(header_, [&](std::size_t i) { return fmt::format("{},{},{}\n", time(i), force_[i], accel_[i]); });
    expect_reading_commands_reject(csv_, "bad.csv");
  };
  with_time([](std::size_t) { return "0"; });
  with_time([](std::size_t i) { return fmt::format("{}", -static_cast<double>(i)); });
  with_time([](std::size_t i) { return fmt::format("{}e-300", i); });
  with_time([](std::size_t i) { return fmt::format("{}", i % 100); });
  with_time([](std::size_t i) { return i == 700 ? std::string("nan") : fmt::format("{}", i); });
  with_time([](std::size_t i) { return i == 700 ? std::string("1e300") : fmt::format("{}", i); });
  write_csv("force_N,acc_m_s2\n", [&](std::size_t i) { return fmt::format("{},{}\n", force_[i], accel_[i]); });
  expect_reading_commands_reject(csv_, "bad.csv");
  write_csv("Sampling Rate(Hz),0\nforce_N,acc_m_s2\n",
            [&](std::size_t i) { return fmt::format("{},{}\n", force_[i], accel_[i]); });
  expect_reading_commands_reject(csv_, "bad.csv");
}

TEST_F(HostileSamples, AreRejectedForASingleSample) {
  Hdf5Builder(hdf5_).numbers("", "fs", {2048}).values("force", {1, 1}, {5}).values("accel", {1, 1, 1}, {2});
  expect_reading_commands_reject(hdf5_, "bad.h5");
  write_csv(header_, {}, 1);
  expect_reading_commands_reject(csv_, "bad.csv");
  write_csv(header_, {}, 0);
  expect_reading_commands_reject(csv_, "bad.csv");
}

TEST_F(HostileSamples, AreRejectedWithTooFewSamplesForAnFrf) {
  Hdf5Builder(hdf5_)
      .numbers("", "fs", {2048})
      .values("force", {1, 12}, {0, 0, 0, 40, 80, 40, 0, 0, 0, 0, 0, 0})
      .values("accel", {1, 1, 12}, {0, 0, 0, 2, 3, 1, -1, -2, 1, 0, 1, 0});
  expect_analyses_reject(hdf5_, "bad.h5");
}

TEST_F(HostileSamples, AreRejectedWithoutTheChannels) {
  Hdf5Builder(hdf5_).numbers("", "fs", {2048}).values("accel", {1, 1, kSamples}, accel_);
  expect_analyses_reject(hdf5_, "bad.h5");  // info shows a record without a force
  rejection_of({"calibrate", hdf5_, "--mass", "1"}, {".json"}, "bad.h5");
  Hdf5Builder(hdf5_).numbers("", "fs", {2048}).values("force", {1, kSamples}, force_);
  expect_reading_commands_reject(hdf5_, "bad.h5");
  Hdf5Builder(hdf5_).numbers("", "fs", {2048});
  expect_reading_commands_reject(hdf5_, "bad.h5");
  write_csv("force_N\n", [&](std::size_t i) { return fmt::format("{}\n", force_[i]); });
  expect_analyses_reject(csv_, "bad.csv");
  rejection_of({"calibrate", csv_, "--mass", "1"}, {".json"}, "bad.csv");
  write_csv("t_s,force_N\n",
            [&](std::size_t i) { return fmt::format("{},{}\n", static_cast<double>(i) / 2048, force_[i]); });
  expect_analyses_reject(csv_, "bad.csv");
  write_csv("t_s,left,right\n");
  expect_analyses_reject(csv_, "bad.csv");
  EXPECT_THAT(rejection_of({"calibrate", csv_, "--mass", "1"}, {".json"}, "bad.csv"), HasSubstr("--force-channel"));
  write_csv(header_);
  EXPECT_THAT(rejection_of({"analyze", csv_, "--force-channel", "hammer"}, {".json"}, "bad.csv"), HasSubstr("force_N"));
  EXPECT_THAT(rejection_of({"analyze", csv_, "--accel-channel", "7"}, {".json"}, "bad.csv"), HasSubstr("acc_m_s2"));
}

TEST_F(HostileSamples, AreRejectedForMixedLengths) {
  Hdf5Builder(hdf5_).numbers("", "fs", {2048}).ramp("force", {2, 64}).ramp("accel", {2, 1, 63});
  expect_reading_commands_reject(hdf5_, "bad.h5");
  Hdf5Builder(hdf5_).numbers("", "fs", {2048}).ramp("force", {2, 64}).ramp("accel", {3, 1, 64});
  expect_reading_commands_reject(hdf5_, "bad.h5");
  for (const char* odd : {"0.7,1\n", "0.7\n", "0.7,1,2,3\n"}) {
    write_csv(header_, [&](std::size_t i) { return i == 1434 ? odd : good_line(i); });
    expect_reading_commands_reject(csv_, "bad.csv: line 1436");
  }
}

TEST_F(HostileSamples, AreRejectedInFilesThatDoNotMatch) {
  write_hdf5({2048});
  const std::string other = folder_.file("other.h5");
  Hdf5Builder(other)
      .numbers("", "fs", {1024})
      .values("force", {1, kSamples}, force_)
      .values("accel", {1, 1, kSamples}, accel_);
  EXPECT_THAT(rejection_of({"analyze", hdf5_, other}, {".json"}, "other.h5"), HasSubstr("--files"));
  Hdf5Builder(other).numbers("", "fs", {2048}).ramp("force", {1, 64}).ramp("accel", {1, 2, 64});
  rejection_of({"analyze", hdf5_, other}, {".json"}, "other.h5");
  rejection_of({"analyze", hdf5_, folder_.file("none.h5")}, {".json"}, "none.h5");
}

}  // namespace percuss::hostile_samples_test
