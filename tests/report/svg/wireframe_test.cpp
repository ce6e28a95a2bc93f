#include "report/svg/wireframe.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"

namespace percuss::report::wireframe_test {

using testing::ElementsAre;

/// The sensors of a survey of a plate. Its points were struck along `blow`; the sensor points along `sensor`.
std::vector<WireframeSensor> sensors(std::optional<acquire::Direction> sensor, const acquire::Direction& blow) {
  synth::SynthSpec spec = synth::synth_preset("plate");
  acquire::Record record = synth::synthesise(spec).record;
  record.accel.at(0).axis = sensor;
  record.accel.at(0).angle_rad.reset();
  record.motions.clear();
  record.geometry.clear();
  acquire::Geometry geometry;
  for (int p = 0; p < 20; ++p) {
    const int row = p / 5;
    geometry.points.push_back({.point = p, .xyz_m = std::array<double, 3>{0.1 * (p % 5), 0.1 * row, 0}, .along = blow});
  }
  const pipeline::Analysis analysis(record,
                                    {.band_Hz = std::pair{40.0, 250.0}, .modes = {.effort = identify::Effort::quick}});
  return wireframe(pipeline::Survey(analysis, {.geometry = geometry, .driving = {{.point = 0, .channel = 0}}})).sensors;
}

// A hammer from above strikes a plate that has its sensor on top.
TEST(Wireframe, DrawsAFixedSensorInItsOwnDirection) {
  const auto drawn = sensors(acquire::Direction{0, 0, 1}, {0, 0, -1});
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_THAT(drawn.front().direction, ElementsAre(0, 0, 1));
}

TEST(Wireframe, DrawsASensorWithoutADirectionAlongTheBlow) {
  const auto drawn = sensors(std::nullopt, {0, 0, -1});
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_THAT(drawn.front().direction, ElementsAre(0, 0, -1));
}

}  // namespace percuss::report::wireframe_test
