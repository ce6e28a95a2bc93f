#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

// Parts of a record that a format may be unable to hold. Each function adds an entry where the record has the part.

/// Trace lines, when the file keeps only `kept` of them.
void add_lost_lines(const std::vector<TraceLine>& lines, std::size_t kept, std::vector<std::string>& losses);
/// The sensors' angles and positions.
void add_lost_places(const Record& record, std::vector<std::string>& losses);
/// The quantities of the responses, if they differ: the file states one unit for all.
void add_lost_quantities(const Record& record, std::vector<std::string>& losses);
/// Names other than "accel 1", "accel 2", …
void add_lost_names(const Record& record, std::vector<std::string>& losses);

}  // namespace percuss::acquire
