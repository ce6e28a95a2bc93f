#pragma once
#include <string>
#include <string_view>

namespace percuss::acquire {

/// Requires that these first bytes of the file `name` can be the start of a text in ASCII, UTF-8 or Latin-1.
/// errors  InputError: empty, UTF-16, binary. The message names known kinds of files that percuss does not read.
void require_text(std::string_view head, const std::string& name);

/// Requires that no line is longer than 1 MiB. Takes little time: it reads only the ends of lines 1 MiB apart.
/// errors  InputError: a longer line, with its number
void require_short_lines(std::string_view text, char line_end, const std::string& name);

}  // namespace percuss::acquire
