#pragma once
#include <string>
#include <string_view>

namespace percuss::acquire {

/// The date of a recording as its file states it, verbatim; empty where none is stated. Sources: the third line of a
/// universal data set 58, lines such as "Date,2026-11-20" at the head of a text, the header of a MAT file (level 5),
/// and the chunks bext and ICRD of a WAV file. `head` is the beginning of the file. Its bytes are not trusted.
std::string stated_date(std::string_view head);

/// The same for a file; empty for a file that cannot be read. `path` "-" states none.
std::string stated_date_of_file(const std::string& path);

}  // namespace percuss::acquire
