#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "metrics/deflection/deflection.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::pipeline {

struct ImpactTestOptions {
  metrics::DeflectionOptions deflection;
  std::optional<double> effective_mass_kg;  // of the free body at the struck point: its own motion is known then
  std::optional<double> beam_distance_m;    // from the light beam to the structure
  double beam_time_s = 0;                   // when the ball broke the beam, from the row's beginning
  std::vector<double> position_m;           // of the points, in ascending order of their numbers; empty: not known
};

/// What one accelerometer saw of one impact.
struct DeflectedHit {
  std::size_t hit = 0, channel = 0;
  int point = 0;
  std::optional<double> position_m;
  double first_s = 0;  // of the samples below, from the row's beginning
  metrics::Deflection deflection;
};

/// The speed of the ball, from the light beam to the structure.
struct ImpactSpeed {
  std::size_t hit = 0;
  double speed_mps = 0, std_mps = 0;
};

/// Repeats at one point, one channel.
struct PointDeflection {
  int point = 0;
  std::size_t channel = 0, hits = 0;
  std::optional<double> position_m;
  double peak_m = 0;  // mean magnitude of the hits' peaks
  double std_m = 0;   // of the mean: from the scatter of two hits or more, no less than from the hits' own deviations
  double forward_m = 0, forward_std_m = 0;  // likewise of the deflections the way the structure first went
};

struct ImpactTest {
  std::vector<DeflectedHit> hits;  // hit by hit, channel by channel; hits without a pulse are left out
  std::vector<ImpactSpeed> speeds;
  std::vector<PointDeflection> points;
  std::vector<Warning> warnings;
};

/// Deflection at every accelerometer for every impact of the test that shows a pulse; hits that are no good for FRFs (a
/// second impact, a truncated decay) still have a deflection. Modes are identified only for the method modal, or where
/// an automatic choice needs them.
ImpactTest deflect(const Analysis& analysis, const ImpactTestOptions& options = {});

}  // namespace percuss::pipeline
