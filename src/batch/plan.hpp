#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "batch/manifest.hpp"

namespace percuss::batch {

/// Whether the name is a pattern with * ? [ ], and no file has this name.
bool is_pattern(const std::string& name);

/// The files of a batch. Each argument is a file, a folder or a pattern with * ? [ ]. From a folder and its
/// sub-folders, all files with the extension of a record are taken, except hidden files and files in hidden folders.
/// The files of one folder or pattern are in natural order, "hit2" before "hit10".
struct RecordFiles {
  std::vector<std::string> paths;     // each once, absolute or relative to the working folder
  std::vector<std::string> left_out;  // files in the named folders, with other extensions
};
/// errors  InputError: no such file, a pattern without a match, a folder that cannot be read
RecordFiles record_files(const std::vector<std::string>& named);

/// The names in a text, one per line. Empty lines are ignored.
std::vector<std::string> parse_path_list(std::string_view text);

/// The records of a batch, ordered by id. An id is the name of the file without extension if it is unique, otherwise
/// the path. Relative paths become relative to `manifest_folder`, so that files and manifest can be moved together.
/// With `hashed`, every file is read once for its SHA-256. errors  InputError: a file cannot be accessed, or its name
/// is not UTF-8
std::vector<BatchRecord> records_of_files(const std::vector<std::string>& paths, const std::string& manifest_folder,
                                          bool hashed);

/// Files that are hits of one part by their names (acquire::files_called_hits), although each is a record of its own.
struct HitsOfOnePart {
  std::string part;                // the name before "hit1", else the folder's name; empty without either
  std::vector<std::string> paths;  // two or more
};
std::vector<HitsOfOnePart> hits_of_one_part(const std::vector<std::string>& paths);

}  // namespace percuss::batch
