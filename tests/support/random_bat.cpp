#include "support/random_bat.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/units.hpp"
#include "synth/random_stream.hpp"

namespace percuss::test {
namespace {

using std::numbers::pi;

constexpr double kSensorAngleStd_rad = 2 * kDegree_rad;
constexpr double kGainStd = 0.03;                       // relative
constexpr double kPlaneAngleStd_rad = 4 * kDegree_rad;  // of a mode's plane from the bat's
constexpr double kHighest_Hz = 3000;
constexpr std::uint64_t kPurpose = 0xBA7;

double normal(synth::RandomStream& random, double mean, double deviation) {
  std::array<double, 1> x{mean};
  random.add_normal(deviation, x);
  return x[0];
}

// The angle of the softest plane from the first sensor: anywhere, half way between the sensors, or at a sensor.
double plane_of_bat(synth::RandomStream& random) {
  const double kind = random.uniform();
  if (kind < 0.6) return random.uniform(0, pi);
  if (kind < 0.8) return normal(random, (random.uniform() < 0.5 ? 45 : 135) * kDegree_rad, kDegree_rad);
  return normal(random, random.uniform() < 0.5 ? 0 : pi / 2, kDegree_rad);
}

void add_bending(synth::SynthSpec& spec, synth::RandomStream& random) {
  const double plane = plane_of_bat(random), kind = random.uniform();
  double f = random.uniform(110, 260);
  const std::array<double, 2> ratio{random.uniform(2.4, 3.6), random.uniform(1.75, 2.1)};  // to the mode below
  for (int order = 1; order <= 3; ++order) {
    if (order > 1) f *= ratio[static_cast<std::size_t>(order - 2)];
    if (f > kHighest_Hz) return;
    synth::SynthMode mode{.freq_Hz = f,
                          .damping_ratio = random.uniform(0.003, 0.012),
                          .order = order,
                          .angle_rad = normal(random, plane, kPlaneAngleStd_rad),
                          .amplitude_per_sqrt_kg = random.uniform(1.2, 2.4)};
    if (kind < 0.2) mode.angle_rad = spec.points[0].angle_rad;  // axisymmetric: it bends in the plane of the hit
    spec.modes.push_back(mode);
    if (kind < 0.5) continue;  // the other plane is not excited
    mode.freq_Hz *= 1 + random.uniform(0.004, 0.03);
    mode.angle_rad += pi / 2;
    spec.modes.push_back(mode);
  }
}

void add_hoop(synth::SynthSpec& spec, synth::RandomStream& random) {
  const bool low = random.uniform() < 0.2;  // the first hoop mode is below the second bending mode
  double f = spec.modes[0].freq_Hz * random.uniform(1.3, 2.1);
  if (!low) f = random.uniform(1000, 2500);
  const bool pairs = random.uniform() < 0.6;
  for (int order = 1; order <= 2 && f < kHighest_Hz; ++order, f *= random.uniform(1.2, 1.6)) {
    synth::SynthMode mode{.freq_Hz = f,
                          .damping_ratio = random.uniform(0.002, 0.006),
                          .type = synth::SynthModeType::hoop,
                          .order = order,
                          .angle_rad = random.uniform(0, pi),
                          .amplitude_per_sqrt_kg = random.uniform(1.5, 4)};
    spec.modes.push_back(mode);
    if (!pairs) continue;
    mode.freq_Hz += random.uniform(2, 40);
    mode.angle_rad += pi / 4;
    spec.modes.push_back(mode);
  }
}

}  // namespace

synth::SynthSpec random_bat(std::uint64_t seed) {
  synth::RandomStream random({kPurpose, seed});
  synth::SynthSpec spec{.fs_Hz = 8192, .samples = 4096, .seed = seed, .band_high_Hz = 3200};
  spec.pulse = {.width_s = 0.35e-3};
  spec.hits = 2;
  const double struck_rad = random.uniform() < 0.5 ? normal(random, 0, 3 * kDegree_rad) : random.uniform(0, pi);
  spec.points = {{.position_m = random.uniform(2, 8) * kInch_m, .angle_rad = struck_rad}};
  const double position_m = random.uniform(0.5, 7) * kInch_m;
  for (synth::SynthSensor& sensor : spec.sensors) {
    sensor.position_m = position_m;
    sensor.angle_rad = normal(random, sensor.angle_rad, kSensorAngleStd_rad);
    sensor.gain = normal(random, 1, kGainStd);
  }
  spec.noise = {.accel = std::exp(random.uniform(std::log(0.001), std::log(0.02)))};
  add_bending(spec, random);
  add_hoop(spec, random);
  return spec;
}

acquire::Record with_sensor_angles(acquire::Record record) {
  for (std::size_t c = 0; c < record.accel.size(); ++c) record.accel[c].angle_rad = pi / 2 * static_cast<double>(c);
  return record;
}

}  // namespace percuss::test
