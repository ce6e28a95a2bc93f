#pragma once
#include <cstdint>
#include <vector>

#include "acquire/record/record.hpp"
#include "synth/spec.hpp"

namespace percuss::test {

/// A bat as they come, and its test as it is made: planes of bending at any angle, at ±45° to the sensors and on their
/// nodes; the two planes of a mode split or one; hoop pairs of any turn and split, single hoop modes; barrels so short
/// that a hoop mode lies below the second bending mode; sensors and hammer near axial nodes; 0.1 to 2 % of noise, gains
/// wrong by a few per cent. The sensors stand where they do, about 2° off; with_sensor_angles() puts into the record
/// where they are believed to be.
synth::SynthSpec random_bat(std::uint64_t seed);
acquire::Record with_sensor_angles(acquire::Record record);

}  // namespace percuss::test
