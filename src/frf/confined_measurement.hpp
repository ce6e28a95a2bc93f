#pragma once
#include <functional>
#include <string>
#include <variant>

#include "frf/frf_record.hpp"

namespace percuss {

/// What `open` gives, opened in a confined process (acquire/confined_process.hpp): a record is served from there, FRFs
/// come over whole.
std::variant<Record, FrfRecord> open_measurement_confined(const std::string& path,
                                                          const std::function<std::variant<Record, FrfRecord>()>& open);

}  // namespace percuss
