#pragma once
#include <span>
#include <string>
#include <string_view>

#include "acquire/record/frf_record.hpp"
#include "acquire/record/record.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "mutators.hpp"

namespace percuss::fuzz {

/// A reader of arbitrary bytes. run() must return for all of them. It must not crash, hang or take memory without
/// bound, and aborts when an error message is not one clean line.
struct Target {
  const char* name;  // also the folder of its corpus, and part of the program name percuss_fuzz_NAME
  void (*run)(std::string_view bytes);
  void (*mutate)(std::string& bytes, Random& random) = nullptr;  // changes the structure of an input (mutators.hpp)
};

std::span<const Target> targets();

// Readers of texts.
void run_csv(std::string_view bytes);
void run_lvm(std::string_view bytes);
void run_uff(std::string_view bytes);
void run_frf_text(std::string_view bytes);
// Well-formed contents of files that libraries decode.
void run_mat(std::string_view bytes);
void run_hdf5(std::string_view bytes);
// Arbitrary bytes as the calibration that percuss stores in a sound file.
void run_sound_calibration(std::string_view bytes);
// Arbitrary bytes as files of these formats, in a sandboxed process.
void run_binary_formats(std::string_view bytes);
// Files that options name.
void run_channel_setup(std::string_view bytes);
void run_synth_spec(std::string_view bytes);
void run_bats(std::string_view bytes);
void run_tables(std::string_view bytes);
void run_document(std::string_view bytes);
// Files that the workers of a batch exchange.
void run_batch(std::string_view bytes);
// A stream of samples from a pipe, and the journal of an interrupted recording.
void run_wav_header(std::string_view bytes);
void run_journal(std::string_view bytes);

/// The bytes as a file in memory of exactly their length, so that a sanitizer finds a read beyond the end.
FileBytes as_file(std::string_view bytes);

/// An anonymous file in memory that holds these bytes, for readers that need a path.
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

/// Options that resolve every ambiguity: a rate, and the roles of the columns.
acquire::ReadOptions strict_read_options();

/// Reads every sample of a record, as an analysis does.
void read_all(const acquire::Record& record);
void read_all(const std::variant<acquire::Record, acquire::FrfRecord>& measurement);

/// Aborts unless the message is one line of at most 2000 bytes without control characters.
void require_clean(const std::exception& refusal);

/// Runs `read`. Returns false for an InputError, whose message must be one clean line.
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
