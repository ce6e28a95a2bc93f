#pragma once
#include <span>
#include <string>
#include <vector>

#include "acquire/record/file_format.hpp"

namespace percuss::acquire {

/// Every format that percuss knows, in the order of detection. A new format is one entry here and one folder.
std::span<const FileFormat* const> file_formats();

/// The first format that detects the input; the last one detects all.
const FileFormat& detected_format(const FileHead& head);

/// The format that percuss writes under the path's extension; nullptr when there is none.
const FileFormat* written_format(const std::string& path);

/// The extensions that write_record knows; that write_frfs knows.
const std::vector<std::string>& record_extensions();
const std::vector<std::string>& frf_extensions();

/// Whether a file's name has the extension of a format, as for the files of a folder.
bool has_known_extension(const std::string& path);

}  // namespace percuss::acquire
