#pragma once
#include <string>

namespace percuss::report {

/// The time in UTC for pages, "2026-11-22 21:45": the environment variable SOURCE_DATE_EPOCH if it is set, otherwise
/// the present time. With the variable set, the same input gives the same bytes.
///
/// errors  UsageError: the variable is not a number of seconds since 1970
std::string creation_time();

}  // namespace percuss::report
