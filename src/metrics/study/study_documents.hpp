#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/study/study_table.hpp"

namespace percuss::metrics {

/// The bats, or the states of one bat in their order, in a document of percuss:
///   percuss/analysis/1   its "bat", and the first and second frequency of each family, or kWithoutFamily
///   percuss/metrics/1    each bat with readings and metrics
///   percuss/certify/1    the bat, and the metrics at its best location once the session has ended
///   percuss/abi/1        a state per performance test: performance, location and hoop frequency. The first has the id
///                        of the bat unless its test states one; later ones have the condition "abi"
/// None for another text.
/// errors  InputError: a document without the id of its bat, several analyses in one document.
std::optional<std::vector<BatProperties>> states_in_document(std::string_view text, const std::string& where);

/// Columns of a table of percuss metrics that a study does not use.
inline constexpr std::array<const char*, 21> kUnusedMetricsColumns{
    "cg_in",         "period_s",    "gate_times_s", "diameter_in",       "handle_diameter_in",
    "ball_g",        "v_in_mph",    "v_out_mph",    "v_swing_mph",       "v_contact_mph",
    "ncaa_besr",     "k",           "drop_std",     "moi_oz_in2_std",    "besr_std",
    "ncaa_besr_std", "bbs_mph_std", "bbcor_std",    "v_contact_mph_std", "v_swing_mph_std",
    "k_std"};

}  // namespace percuss::metrics
