#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "batch/manifest.hpp"

namespace percuss::batch {

/// Files that are to be records, from what was named: files; folders, of which all files below are taken whose
/// extension is one of those that records have (no hidden ones); patterns with * ? [ ] of which no file has the name.
struct RecordFiles {
  std::vector<std::string> paths;  // each once, as they are reached from here
  std::size_t left_out = 0;        // files in folders that are none of those kinds
};
/// errors  InputError: no such file, a pattern that fits none, a folder that cannot be read.
RecordFiles record_files(const std::vector<std::string>& named);

/// The names in a text, one a line; blank lines do not count.
std::vector<std::string> parse_path_list(std::string_view text);

/// The records of a batch, ordered by id. An id is the file's name without extension where no other record has that
/// name, else its path. Paths that are not absolute become those from the folder `manifest_folder`, so that both can
/// be moved together. With `hashed` every file is read once for its SHA-256.
/// errors  InputError: a file cannot be looked at, or its name is not UTF-8.
std::vector<BatchRecord> records_of_files(const std::vector<std::string>& paths, const std::string& manifest_folder,
                                          bool hashed);

}  // namespace percuss::batch
