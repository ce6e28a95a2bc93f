#pragma once
#include <optional>

#include "identify/classify/classify.hpp"
#include "identify/classify/split_mode.hpp"

namespace percuss::identify {

/// The plane of a pattern from the residues at two sensors, A_c ∝ cos n(θ_c − plane). Nothing where n times the angle
/// between the sensors is near a multiple of 180° (hoop modes with sensors at 90°), or where neither sensor observes
/// the mode. The standard deviation includes the sensors' placement error `angle_std_rad`.
std::optional<PatternPlane> plane_from_sensors(const Mode& mode, const SensorPair& sensors, int order,
                                               double angle_std_rad);

/// Describes the two members of a split mode in `of_first` and `of_second`: standard deviation of the separation, level
/// of the first over the second, the quoted member, and both planes where known. The source quotes the first member.
/// The second is quoted where the first is 20 dB lower and therefore hidden. source  [8] section 3.6.
void describe_split(const Mode& first, const Mode& second, const std::optional<PatternPlane>& first_plane,
                    const std::optional<PatternPlane>& second_plane, SplitMode& of_first, SplitMode& of_second);

}  // namespace percuss::identify
