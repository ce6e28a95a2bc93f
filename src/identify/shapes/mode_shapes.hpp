#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/model/mode.hpp"

namespace percuss::identify {

/// What was moved from point to point: the hammer (the sensors stay) or the sensor (the hammer stays).
enum class Roving { hammer, sensor };

/// The struck point and the sensor that stand at one place of the structure and look one way: H(point, channel) is a
/// driving-point FRF.
struct DrivingPoint {
  std::size_t point = 0;
  std::size_t channel = 0;
};

enum class Normalisation { unit_modal_mass, largest_one };
const char* name_of(Normalisation normalisation);

/// A mode's shape at one place of the survey.
struct ShapePlace {
  std::size_t point = 0;
  std::size_t channel = 0;  // the sensor that saw it; with a roving hammer 0, as all sensors tell of the same place
  Complex value;            // 1/√kg, or 1 at the largest
  double std = 0;           // of the real and of the imaginary part, but for what scales the whole shape
};

/// A mode's shape over the places of a survey.
struct ModeShape {
  std::vector<ShapePlace> places;   // ascending by point, then channel
  std::vector<ShapePlace> sensors;  // roving hammer: the same shape at the fixed sensors (point is 0), in their order
  Normalisation normalisation = Normalisation::largest_one;
  double scale_std = 0;                 // unit modal mass: of the common scale, as a fraction
  std::optional<double> modal_mass_kg;  // of the shape scaled to 1 at its largest; needs a driving point
  double modal_mass_std_kg = 0;
  double mpc = 0;           // modal phase collinearity: 1 for a real shape, 0 for a wave that runs round
  double significance = 0;  // root mean square of residue over its deviation: about 1 is noise
};

struct ShapeOptions {
  Roving roving = Roving::hammer;
  std::vector<DrivingPoint> driving;  // where there are any
};

/// The mode's residue at this point and channel, or nothing.
const Residue* find_residue(const Mode& mode, std::size_t point, std::size_t channel);
/// Deviation of a residue's real and imaginary part, the force's gain included.
double total_std(const Residue& residue);

/// The shape behind a mode's residues A_pc = φ_p φ_c.
///   roving hammer  φ_p and φ_c by least squares of rank one over all points and channels, weighted by the deviations;
///   roving sensor  every (point, channel) is a place of its own, φ_pc ∝ A_pc.
/// With a driving point, where A_dd = φ_d², the shape has unit modal mass (1/√kg). Else, and where A_dd is not
/// significantly positive, its largest component is 1 once the shape is turned to be as real as it can be. Signs: as
/// the driving point's positive φ_d, or the largest component's.
/// MPC = ((S_xx − S_yy)² + 4 S_xy²)/(S_xx + S_yy)², S the sums of squares and products of real (x) and imaginary parts.
/// source  [4] in docs/theory/sources.md.
/// theory (5.1), (5.2), (5.3)
ModeShape shape_of(const Mode& mode, const ShapeOptions& options = {});

}  // namespace percuss::identify
