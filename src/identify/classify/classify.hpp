#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "identify/classify/split_mode.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

enum class ModeType { bending, hoop, unknown };
inline constexpr double kMinTypeProbability = 0.6;  // a mode with less probability is of unknown type
const char* name_of(ModeType type);

/// The type of a mode from two accelerometers around the barrel.
struct ModeClassification {
  ModeType type = ModeType::unknown;
  int order = 0;          // from 1 within the type; 0 for unknown
  double confidence = 0;  // posterior probability of `type`; for unknown, 1 − the larger of bending and hoop
  /// The second type, stated where `confidence` is below 0.9 or the second type's own probability is above 0.03. For
  /// unknown, classify() states the likelier of bending and hoop. The alternative `unknown` means three waves.
  std::optional<ModeType> alternative;
  std::optional<double> overlay_dB;   // level of the second FRF over the first at the peak
  bool overlaid = false;              // |overlay_dB| within the threshold: a hoop mode by the rule of [8]
  bool possible_three_waves = false;  // it may have n = 3 waves around the barrel (three_waves.hpp)
  bool order_uncertain = false;       // bending: the count depends on a mode below that may have three waves
  std::optional<Complex> ratio;       // residue of the second sensor over the residue of the first
  double ratio_std = 0;               // of the real and of the imaginary part
  std::optional<SplitMode> split_mode;
};

/// Relative distance below which two frequencies may belong to one mode of a tube, in its two planes.
inline constexpr double kPairSpacing = 0.04;

/// What was struck. Bending and hoop are types of a tube's modes only. automatic: a tube where the sensors' angles are
/// stated, or where the modes fit assumed angles.
enum class ObjectKind { automatic, tube, other };

struct ClassifyOptions {
  ObjectKind object = ObjectKind::automatic;
  bool angles_assumed = false;   // the sensors' angles are not stated
  double overlay_dB = 1;         // tight, because bending modes with a difference of 1.7 dB exist
  double double_peak_Hz = 25;    // [8]: closer peaks of one type are a split mode, if within 15 % of the frequency
  double angle_std_rad = 0.035;  // 2°: placement of a sensor by hand
  double gain_std = 0.03;        // relative, of each channel: calibration and mounting
};

/// Two acceleration channels and their angles around the barrel.
struct SensorPair {
  std::size_t first = 0, second = 0;  // channels
  double first_rad = 0, second_rad = 0;
};
/// The two channels whose angles differ most nearly by 90° (modulo 180°), however far from it. Nothing for fewer than
/// two channels with an angle, and where all have the same angle.
std::optional<SensorPair> pair_of_sensors(const std::vector<std::optional<double>>& angle_rad);

/// The number of modes of each type below the analysed band. The first order within the band is one more.
struct LowerOrders {
  int bending = 0, hoop = 0;
};

/// Classifies every mode from the ratio of its residues at two sensors, at the angles θ₁ and θ₂:
///   bending in the plane ψ:      cos(θ₂ − ψ)/cos(θ₁ − ψ)             any value; tan ψ for 90°           (1)
///   hoop (n = 2), turned by θ₀:  cos 2(θ₂ − θ₀)/cos 2(θ₁ − θ₀)       −1 for 90°, whatever θ₀             (2)
/// Both likelihoods include the errors of the ratio, of the sensors' placement and of the channels' gains. All modes
/// are classified together (type_posterior.hpp). Bending modes far above the lowest hoop mode may have three waves
/// (three_waves.hpp). ModeClassification::alternative says when the second type is stated as well.
///
/// Modes keep an unknown type and no order without sensors, for an `other` object, and if assumed angles do not fit the
/// modes (tube_evidence.hpp). They also have no split mode, unless `object` is tube: split modes of a stated tube are
/// marked without sensors too.
/// overlay_dB  [modes] the measured level difference at the mode's peak
/// source  [8] section 3.6 for the overlay rule and the 25 Hz rule
/// theory (6.1), (6.2), (6.3)
std::vector<ModeClassification> classify(const std::vector<Mode>& modes, const std::optional<SensorPair>& sensors,
                                         const std::vector<std::optional<double>>& overlay_dB,
                                         const ClassifyOptions& options = {});

/// Marks split modes and numbers the orders within each type. Two close members of one type share an order.
void assign_orders(const std::vector<Mode>& modes, std::vector<ModeClassification>& classifications,
                   const ClassifyOptions& options, const LowerOrders& lower = {});

/// The orders below the band, counted from the modes `below` it; `found` are the modes within the band. All hoop modes
/// count. Bending modes are counted downwards from the lowest bending mode of the band to the first order: the mode
/// whose upper neighbour has more than 2.3 times its frequency. On a tube, only the first two bending modes are so far
/// apart; if the two lowest bending modes of the band are so far apart, no bending mode is below the band. A frequency
/// less than 1/4.5 of its upper neighbour is motion on the suspension or hum: it ends the count and is not counted. A
/// mode below the band counts only if the confidence of its type is at least 90 %.
LowerOrders lower_orders(const std::vector<Mode>& below, const std::vector<ModeClassification>& below_types,
                         const std::vector<Mode>& found, const std::vector<ModeClassification>& types,
                         const ClassifyOptions& options);

}  // namespace percuss::identify
