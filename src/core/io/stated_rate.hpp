#pragma once
#include <optional>
#include <string_view>

#include "core/io/csv_dialect.hpp"

namespace percuss {
inline namespace core {

/// The sampling rate in Hz in a header line: "Sampling Rate(Hz),50" → 50, "fs = 25.6 kHz" → 25600, "dt [ms];0,5" →
/// 2000.
std::optional<double> stated_rate_Hz(std::string_view line, const CsvDialect& dialect);

}  // namespace core
}  // namespace percuss
