#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// The path of an input ("-" is standard input) and its first bytes: at least 64 KiB, or all where there are fewer.
struct FileHead {
  std::string path;
  std::string_view bytes;
};

/// Where a reader finds its input: a path, or the bytes of a stream that have been read already.
struct FormatInput {
  std::string path;
  const FileBytes* stream = nullptr;
};

/// The content that the caller accepts. With `record`, text is read as a record even if it holds FRFs: the error then
/// names the columns that are missing.
enum class Content { record, record_or_frfs };

/// One file format, for records and FRFs alike: an entry of the registry (acquire/format_registry.hpp). Members that a
/// format has no use for are empty.
struct FileFormat {
  std::string_view name;                         // for people: "HDF5", "MAT"
  std::span<const std::string_view> extensions;  // customary ones, lower case; on reading the content decides
  std::span<const std::string_view> written{};   // the extensions under which percuss writes it
  bool sandboxed = false;                        // a library of another project opens the path, in a sandboxed process
  bool names_variables = false;                  // ReadOptions::fs_variable has a meaning

  /// Whether the input is of this format. The registry asks in its order.
  bool (*detect)(const FileHead& head);
  /// Refuses an input before the rest of it is read.
  /// errors  InputError.
  void (*check)(const FileHead& head) = nullptr;
  /// The check of an input while it grows, if there is one.
  GrowthCheck (*growth_check)(const std::string& path) = nullptr;
  /// Opens the input and decides whether it is a record or FRFs.
  /// errors  InputError.
  Measurement (*open)(const FormatInput& input, const FrfReadOptions& options, Content content);
  /// errors  InputError: the file exists (without `force`) or cannot be written, or the format cannot hold the data.
  void (*write_record)(const std::string& path, const Record& record, bool force) = nullptr;
  void (*write_frfs)(const std::string& path, const FrfRecord& record, FrfKind kind, bool force) = nullptr;
  /// The parts of a record that a file of this name would lose, one line each. losses_of() adds the driving places and
  /// the directions of motion, which no format keeps; the faces, where keeps_faces is not set; the marks and faults,
  /// where keeps_marks is not set; and the date, where keeps_date is not set.
  std::vector<std::string> (*record_losses)(const std::string& path, const Record& record) = nullptr;
  /// The same for FRFs. losses_of() adds the names of channels, the driving places and the directions of motion, which
  /// no format keeps, and the geometry, where keeps_frf_geometry is not set.
  std::vector<std::string> (*frf_losses)(const FrfRecord& record) = nullptr;
  bool keeps_marks = false;         // RowInfo::mark and Record::faults
  bool keeps_date = false;          // of a record: common_date_of() its files
  bool keeps_faces = false;         // Record::trace_faces, except what record_losses names
  bool keeps_frf_geometry = false;  // files of FRFs keep points, lines and faces, except what frf_losses names
};

/// ".h5" of "bat.H5".
std::string file_extension(const std::string& path);

}  // namespace percuss::acquire
