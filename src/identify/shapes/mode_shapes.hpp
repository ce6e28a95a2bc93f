#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/model/mode.hpp"

namespace percuss::identify {

/// A roving-hammer test (fixed sensors) or a roving-sensor test (fixed hammer).
enum class Roving { hammer, sensor };

/// The FRF H(point, channel) of the test.
struct FrfIndex {
  std::size_t point = 0;
  std::size_t channel = 0;
  double sign = 1;  // of A_pc at a driving point: −1 where a positive force and a positive response are opposite
};
/// An impact point and a sensor at the same place, in the same or in opposite directions.
using DrivingPoint = FrfIndex;

enum class Normalisation { unit_modal_mass, largest_one };
const char* name_of(Normalisation normalisation);

/// A mode's shape at one place of the survey.
struct ShapePlace {
  std::size_t point = 0;
  std::size_t channel = 0;  // the sensor; 0 with a roving hammer, where all sensors contribute to one place
  Complex value;            // in 1/√kg, or relative to the largest
  double std = 0;           // of the real and of the imaginary part, without the scale's error
  bool sets_scale = false;  // its value is √A_dd: its only error is the scale's
};

/// A mode's shape over the places of a survey.
struct ModeShape {
  std::vector<ShapePlace> places;   // ascending by point, then channel
  std::vector<ShapePlace> sensors;  // roving hammer: the shape at the fixed sensors, in their order; point is 0
  Normalisation normalisation = Normalisation::largest_one;
  double scale_std = 0;                 // relative standard deviation of the common scale, for unit modal mass
  std::optional<double> modal_mass_kg;  // of the shape with its largest component 1; needs a driving point
  double modal_mass_std_kg = 0;
  double mpc = 0;           // modal phase collinearity: 1 for a real shape, 0 for a travelling wave
  double significance = 0;  // rms of residue over its noise: about 1 for noise
};

struct ShapeOptions {
  Roving roving = Roving::hammer;
  std::vector<DrivingPoint> driving;  // the driving points of the test
};

/// The mode's residue at this point and channel, or nullptr.
const Residue* find_residue(const Mode& mode, std::size_t point, std::size_t channel);
/// Standard deviation of a residue's real and of its imaginary part, including the force's gain error.
double total_std(const Residue& residue);

/// The phase factor that makes Σφ² real and positive, and so the shape as real as possible.
Complex turn_of(const std::vector<ShapePlace>& places);

/// The mode shape φ from the residues A_pc = φ_p φ_c.
///   roving hammer  φ_p and φ_c by weighted rank-one least squares over all points and channels;
///   roving sensor  every (point, channel) is a separate place, φ_pc ∝ A_pc.
/// With a driving point, where φ_d² = A_dd times its sign is significantly positive, the shape has unit modal mass
/// (1/√kg). Otherwise the shape is rotated to be as real as possible, and its largest component is 1. The sign makes
/// φ_d, or the largest component, positive.
/// MPC = ((S_xx − S_yy)² + 4 S_xy²)/(S_xx + S_yy)², S the sums of squares and products of real (x) and imaginary (y)
/// parts.
/// source  [4] in docs/theory/sources.md.
/// theory (5.1), (5.2), (5.3)
ModeShape shape_of(const Mode& mode, const ShapeOptions& options = {});

/// The residual of the rank-one fit to the residues of a roving-hammer test.
struct RankOneResidual {
  double chi2 = 0;     // Σ |A_pc − φ_p φ_c|²/σ_pc², without the gain that is common to a point's residues
  double freedom = 0;  // real degrees of freedom: 2 (points − 1)(channels − 1), less those of missing residues
  double second_singular = 0;  // second singular value of the residues over the first
};
RankOneResidual rank_one_residual(const Mode& mode);

}  // namespace percuss::identify
