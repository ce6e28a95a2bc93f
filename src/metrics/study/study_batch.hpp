#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/study/study_table.hpp"

namespace percuss::metrics {

/// Keeps the frequency of a mode as the bat's "hoop1_hz" where a study has such a column, and none of that name before
/// it: of a double peak the first counts.
void add_frequency(BatProperties& bat, const std::string& family, std::int64_t order, double freq_Hz);

/// Whether a text is what percuss batch merge writes, as lines of JSON or as a table.
bool holds_batch(std::string_view text);

/// Ids and frequencies of the records in it that have modes, in their order.
/// errors  InputError: lines that no batch has.
std::vector<BatProperties> batch_bats(std::string_view text, const std::string& where);

}  // namespace percuss::metrics
