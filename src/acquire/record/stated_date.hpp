#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The date of a recording as its file states it; empty where none is stated. Sources: the third line of a
/// universal data set 58, lines such as "Test date,2026-11-20" or "Messdatum;20.11.2026" at the head of a text, and the
/// chunks bext and ICRD of a WAV file. Day and month keep their order. Dates of a calibration, an export or a service
/// do not count. The date in the header of a MAT file does not count either: it says when the file was written. `head`
/// is the beginning of the file. Its bytes are not trusted.
std::string stated_date(std::string_view head);

/// The same for a file; empty for a file that cannot be read. `path` "-" states none.
std::string stated_date_of_file(const std::string& path);

/// The text if it can be a date: at least three digits, printable ASCII, at most 60 characters. Otherwise empty.
std::string plausible_date(std::string_view text);

/// The date that the reader found, else stated_date_of_file().
std::string date_of(const InputFile& file);

/// The date that all these files state; empty where they differ or one states none.
std::string common_date_of(const std::vector<InputFile>& files);

}  // namespace percuss::acquire
