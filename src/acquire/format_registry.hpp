#pragma once
#include <span>
#include <string>
#include <vector>

#include "acquire/record/file_format.hpp"

namespace percuss::acquire {

/// Every format that percuss knows, in the order of detection. A new format is one entry here and one folder.
std::span<const FileFormat* const> file_formats();

/// The first format that detects the input. The last format accepts every input.
const FileFormat& detected_format(const FileHead& head);

/// The format that percuss writes under the path's extension; nullptr when there is none.
const FileFormat* written_format(const std::string& path);
/// Whether that format is HDF5.
bool writes_hdf5(const std::string& path);

/// The extensions that write_record and write_frfs accept.
const std::vector<std::string>& record_extensions();
const std::vector<std::string>& frf_extensions();

/// Whether the file name has the extension of a known format. Of a folder, only such files are read.
bool has_known_extension(const std::string& path);

/// Whether the file is a text without numbers, such as a README beside records. False for a file of more than 64 KiB,
/// whose content is not examined, and for one that cannot be read.
bool is_text_without_numbers(const std::string& path);

}  // namespace percuss::acquire
