#pragma once
#include <cstddef>
#include <optional>

#include "acquire/hits/hits.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Samples first … last − 1 of a row.
struct SampleRange {
  std::size_t first, last;
};

/// The time selection of the options in a row.
/// errors  InputError: no samples between `from_s` and `to_s`
SampleRange select_time_range(const Record& record, std::size_t row, const HitOptions& options);
/// The pre-trigger in samples. `rise`: samples from the beginning of the pulse to its peak. If the user states no
/// pre-trigger, it is at least twice `rise`, so that a slowly rising pulse is also preceded by samples at rest.
std::size_t pretrigger_samples(const Record& record, const HitOptions& options, std::size_t rise = 0);

/// `length_s` in samples; nothing if it is not stated.
/// errors  InputError: fewer than two samples
std::optional<std::size_t> selected_length(const Record& record, const HitOptions& options);

}  // namespace percuss::acquire
