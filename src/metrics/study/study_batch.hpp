#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/study/study_table.hpp"

namespace percuss::metrics {

/// Sets the bat's "hoop1_hz" (or a similar column of a study) to the frequency of a mode. An earlier value stays: the
/// first of a close pair counts.
void add_frequency(BatProperties& bat, const std::string& family, std::int64_t order, double freq_Hz);

/// Whether a text is a merged batch, as lines of JSON or as a table.
bool holds_batch(std::string_view text);

/// The ids and frequencies of the records with modes, and kWithoutFamily, in their order.
/// errors  InputError: a line that is not a row of a batch.
std::vector<BatProperties> batch_bats(std::string_view text, const std::string& where);

}  // namespace percuss::metrics
