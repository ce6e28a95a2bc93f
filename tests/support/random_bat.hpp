#pragma once
#include <cstdint>
#include <vector>

#include "acquire/record/record.hpp"
#include "synth/spec.hpp"

namespace percuss::test {

/// A random bat and its test. Bending planes lie at any angle, at ±45° to the sensors, or at one sensor, so that the
/// other lies on the nodal line; the two planes of a mode may be split. Hoop pairs have any angle and split, or are
/// single modes. In a fifth of the bats, the first hoop mode is below the second bending mode. Sensors and hammer may
/// lie near axial nodes. Noise is 0.1 to 2 %, gain errors a few per cent. The sensors are about 2° off;
/// with_sensor_angles() stores their nominal angles in the record.
synth::SynthSpec random_bat(std::uint64_t seed);
acquire::Record with_sensor_angles(acquire::Record record);

}  // namespace percuss::test
