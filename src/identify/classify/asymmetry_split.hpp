#pragma once
#include <optional>

#include "identify/classify/classify.hpp"
#include "identify/classify/split_mode.hpp"

namespace percuss::identify {

/// The plane that two sensors' residues tell: A_c ∝ cos n(θ_c − plane). Nothing where they cannot: n times the angle
/// between them is near a multiple of 180° (hoop modes with sensors at 90°), or the mode is seen by neither. The
/// deviation allows for sensors placed to within `angle_std_rad`.
std::optional<PatternPlane> plane_from_sensors(const Mode& mode, const SensorPair& sensors, int order,
                                               double angle_std_rad);

/// Fills what the two members of a double peak say of one another: the deviation of their separation, how high the
/// first stands over the second, which one is quoted, and their planes where both are known. The source quotes the
/// first; the second is quoted where the first is hidden under it (20 dB lower).
/// source  [8] section 3.6.
void describe_split(const Mode& first, const Mode& second, const std::optional<PatternPlane>& first_plane,
                    const std::optional<PatternPlane>& second_plane, SplitMode& of_first, SplitMode& of_second);

}  // namespace percuss::identify
