#include "report/text/response_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::report::response_summary_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Two sensors at the same angle, the second upside down.
acquire::Record record() {
  synth::SynthSpec spec =
      test::bat_spec({{.freq_Hz = 200, .damping_ratio = 0.02, .order = 1, .amplitude_per_sqrt_kg = 1.7}}, 0.5);
  spec.sensors = {{.angle_rad = 0.35}, {.angle_rad = 0.35, .sign = -1}};
  spec.noise = {.force = 1e-4, .accel = 1e-4};
  return synth::synthesise(spec).record;
}

std::string summary_of(acquire::Record one) {
  const pipeline::Analysis analysis(std::move(one), {.band_Hz = std::pair{100.0, 400.0}, .threads = 1});
  return responses_text(analysis, 1000);
}

TEST(ResponsesText, StatesTheDirectionOfEachChannelsFirstMotion) {
  EXPECT_THAT(summary_of(record()), AllOf(HasSubstr("accel 1 first moves with the push"),
                                          HasSubstr("accel 2 first moves against the push"), Not(HasSubstr("-0."))));
}

TEST(ResponsesText, StatesThatHitsDisagree) {
  acquire::Record uneven = record();
  uneven.read_accel_mps2 = [inner = uneven.read_accel_mps2](std::size_t row, std::size_t channel, std::size_t first,
                                                            std::span<double> out) {
    inner(row, channel, first, out);
    if (channel == 1 && row == 1) std::transform(out.begin(), out.end(), out.begin(), std::negate<>());
  };
  EXPECT_THAT(summary_of(uneven), AllOf(HasSubstr("accel 1 first moves with the push"),
                                        HasSubstr("accel 2: the hits show no clear direction of its first motion")));
}

// Without another sensor that has a direction, the line would tell nothing.
TEST(ResponsesText, IsEmptyWhereNoSensorHasADirection) {
  acquire::Record one = record();
  one.accel.resize(1);
  one.contiguous.clear();
  one.read_accel_mps2 = [inner = one.read_accel_mps2](std::size_t row, std::size_t channel, std::size_t first,
                                                      std::span<double> out) {
    inner(row, channel, first, out);
    if (row == 1) std::transform(out.begin(), out.end(), out.begin(), std::negate<>());
  };
  EXPECT_EQ(summary_of(one), "");
}

// The points of a survey move in either direction, which tells nothing of a sensor.
TEST(ResponsesText, OmitsAChannelWhosePointsDiffer) {
  acquire::Record points = record();
  for (std::size_t row = 0; row < points.rows.size(); ++row) points.rows[row].point = static_cast<int>(row);
  points.read_accel_mps2 = [inner = points.read_accel_mps2](std::size_t row, std::size_t channel, std::size_t first,
                                                            std::span<double> out) {
    inner(row, channel, first, out);
    if (channel == 1 && row == 1) std::transform(out.begin(), out.end(), out.begin(), std::negate<>());
  };
  EXPECT_THAT(summary_of(points), AllOf(HasSubstr("accel 1 first moves with the push"), Not(HasSubstr("accel 2"))));
}

TEST(ResponsesText, OmitsADeadChannel) {
  acquire::Record dead = record();
  dead.read_accel_mps2 = [inner = dead.read_accel_mps2](std::size_t row, std::size_t channel, std::size_t first,
                                                        std::span<double> out) {
    inner(row, channel, first, out);
    if (channel == 1) std::fill(out.begin(), out.end(), 0.0);
  };
  EXPECT_THAT(summary_of(dead), Not(HasSubstr("accel 2")));
}

}  // namespace percuss::report::response_summary_test
