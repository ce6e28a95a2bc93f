#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "identify/classify/split_mode.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

enum class ModeType { bending, hoop, unknown };
inline constexpr double kMinTypeProbability = 0.6;  // probability below which a mode's family is unknown
const char* name_of(ModeType family);

/// What two accelerometers around the barrel say about one mode.
struct ModeClassification {
  ModeType family = ModeType::unknown;
  int order = 0;                        // counts from 1 within the family; 0 when unknown
  double confidence = 0;                // posterior probability of `family`
  std::optional<ModeType> alternative;  // the rival: always below 90 %, above it when as probable as 3 %
  std::optional<double> overlay_dB;     // magnitude of the second FRF over the first at the peak
  bool overlaid = false;                // |overlay_dB| within the threshold: the source's sign of a hoop mode
  std::optional<Complex> ratio;         // residue of the second sensor over that of the first
  double ratio_std = 0;                 // of the real and of the imaginary part
  std::optional<SplitMode> split_mode;
};

struct ClassifyOptions {
  double overlay_dB = 1;         // bending planes 1.7 dB apart exist, so the threshold is tighter than a plot's line
  double double_peak_Hz = 25;    // [8]: closer peaks are one split mode
  double angle_std_rad = 0.035;  // 2°: how well sensors are placed by hand
  double gain_std = 0.03;        // of each channel, relative: calibration and mounting
};

/// The two channels whose angles are nearest to 90° apart (modulo 180°); nothing when fewer than two have an angle.
struct SensorPair {
  std::size_t first = 0, second = 0;  // channels
  double first_rad = 0, second_rad = 0;
};
std::optional<SensorPair> pair_of_sensors(const std::vector<std::optional<double>>& angle_rad);

/// Names every mode from the ratio of its residues at two sensors, angles θ₁ and θ₂ apart:
///   bending in the plane ψ:      cos(θ₂ − ψ)/cos(θ₁ − ψ)             any value; tan ψ for 90°           (1)
///   hoop (n = 2), turned by θ₀:  cos 2(θ₂ − θ₀)/cos 2(θ₁ − θ₀)       −1 for 90°, whatever θ₀             (2)
/// Both likelihoods allow for the ratio's deviation, the sensors' placement and the channels' gains, and all modes are
/// judged together (family_belief.hpp). A verdict of 90 % confidence or more stands alone; below it the rival is named.
/// overlay_dB[m] is the measured magnitude difference at mode m's peak.
/// source  [8] section 3.6 for the overlay rule and the 25 Hz rule.
/// theory (6.1), (6.2), (6.3)
std::vector<ModeClassification> classify(const std::vector<Mode>& modes, const std::optional<SensorPair>& sensors,
                                         const std::vector<std::optional<double>>& overlay_dB,
                                         const ClassifyOptions& options = {});

/// Marks double peaks and numbers the orders anew from the verdicts' families. Two members of one family that lie close
/// together share an order.
void assign_orders(const std::vector<Mode>& modes, std::vector<ModeClassification>& classifications,
                   const ClassifyOptions& options);

}  // namespace percuss::identify
