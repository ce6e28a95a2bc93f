#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::accuracy {

/// What no analysis of files can do without: their bytes come from the system (read() in blocks of 128 KiB, from the
/// page cache), and FFTW, called by hand, transforms each signal of each row once, on one thread. The transforms are of
/// one buffer that stays in the cache, planned beforehand (by measuring, up to 2^17 samples).
class FftReadBaseline {
 public:
  /// `record` describes the files: as many rows and signals, all rows of one length.
  FftReadBaseline(std::vector<std::string> paths, const acquire::Record& record);
  void run() const;

 private:
  std::vector<std::string> paths_;
  std::size_t samples_, transforms_;
};

/// One planned transform of so many values, in place of a limit where there are no records.
void transform_once(std::size_t samples);

}  // namespace percuss::accuracy
