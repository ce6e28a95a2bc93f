#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::accuracy {

/// The unavoidable work of an analysis of files. It reads the bytes (read() in blocks of 128 KiB, from the page cache)
/// and transforms each signal of each row once with FFTW, on one thread. The transforms use one buffer that stays in
/// the cache, and are planned in advance (by measurement, up to 2^17 samples).
class FftReadBaseline {
 public:
  /// `record` describes the files: their rows and signals, with all rows of one length.
  FftReadBaseline(std::vector<std::string> paths, const acquire::Record& record);
  void run() const;

 private:
  std::vector<std::string> paths_;
  std::size_t samples_, transforms_;
};

/// Runs one planned transform of `samples` values: the baseline of tasks without records.
void transform_once(std::size_t samples);

}  // namespace percuss::accuracy
