#pragma once
#include <span>
#include <string>
#include <string_view>

#include "acquire/record/record.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "frf/frf_record.hpp"

namespace percuss::fuzz {

/// What reads bytes that may be anything. run() returns whatever they are; what it must not do is crash, hang, take
/// memory that the bytes do not explain, or say more than one clean line (it aborts then).
struct Target {
  const char* name;  // also the folder of its corpus, and the end of percuss_fuzz_NAME
  void (*run)(std::string_view bytes);
};

std::span<const Target> targets();

// One for every reader of percuss's own: texts …
void run_csv(std::string_view bytes);
void run_lvm(std::string_view bytes);
void run_uff(std::string_view bytes);
void run_frf_text(std::string_view bytes);
// … what is found in files that a library decodes, without that library …
void run_mat(std::string_view bytes);
void run_hdf5(std::string_view bytes);
void run_sound_calibration(std::string_view bytes);
// … such files as they are, in a confined process …
void run_binary_formats(std::string_view bytes);
// … and what options name.
void run_channel_setup(std::string_view bytes);
void run_synth_spec(std::string_view bytes);
void run_bats(std::string_view bytes);
void run_tables(std::string_view bytes);
void run_document(std::string_view bytes);
// What workers of a batch leave for each other.
void run_batch(std::string_view bytes);

/// The bytes as a file that was read, in memory of exactly their length.
FileBytes as_file(std::string_view bytes);

/// A file of these bytes without a name, for readers that want a path.
class MemfdFile {
 public:
  explicit MemfdFile(std::string_view bytes);
  ~MemfdFile();
  MemfdFile(const MemfdFile&) = delete;
  MemfdFile& operator=(const MemfdFile&) = delete;
  std::string path() const;

 private:
  int descriptor_;
};

/// What somebody says about a file who was told that it is unclear: a rate, and which columns are which.
acquire::ReadOptions strict_read_options();

/// Every sample of a record, as an analysis reads them.
void read_all(const acquire::Record& record);
void read_all(const std::variant<acquire::Record, frf::FrfRecord>& measurement);

/// Aborts unless the message is one line without control characters, not longer than a screen.
void require_clean(const std::exception& refusal);

/// Runs `read`; an InputError is an answer as good as any, if it is one clean line. Whether there was none.
template <class Read>
bool accepted(Read&& read) {
  try {
    read();
    return true;
  } catch (const InputError& refusal) {
    require_clean(refusal);
    return false;
  }
}

}  // namespace percuss::fuzz
