#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "acquire/record/record.hpp"
#include "core/io/input_file.hpp"
#include "frf/convert.hpp"
#include "frf/formats/frf_unit.hpp"

namespace percuss::frf {

/// An FRF and whose it is.
struct PointFrf {
  int point = 0;
  std::size_t channel = 0;
  Frf frf;
};

/// A test of which only the FRFs are left: no hits, no force.
struct FrfRecord {
  std::vector<acquire::InputFile> files;
  std::string format;                   // for people: "FRF text", "FRF HDF5"
  FrfKind kind = FrfKind::accelerance;  // as stored; `frfs` are accelerances
  LineRange lines;  // of every FRF; its fs_Hz is twice the highest frequency, the true one is not known
  std::vector<acquire::SignalInfo>
      accel;                   // [channels]; to_SI is what the stored FRF was multiplied with: unit and sign
  std::vector<PointFrf> frfs;  // [points × channels], point by point, ascending
  std::string estimator = "H1";
  std::vector<std::vector<double>> geometry;    // [points][3], as in Record; may be empty
  std::vector<acquire::TraceLine> trace_lines;  // likewise
  double decay_per_s = 0;                       // of the exponential window the file says was on force and response
  std::vector<std::string> notes;               // what was assumed, one line each
  /// As Record::source().
  std::string source() const { return files.empty() ? format : files.front().path; }
};

/// What the user says about FRF files beyond ReadOptions; wins over what the file says.
struct FrfReadOptions {
  acquire::ReadOptions read;
  std::optional<FrfKind> kind;
};

/// An FRF as the file's reader found it: stored numbers, nothing applied.
struct StoredFrf {
  int point = 0;
  std::size_t channel = 0;
  std::vector<Complex> value;
  std::vector<double> std, coherence;  // empty where the file has none
  std::size_t averages = 0;            // 0: not stated
};

/// What a reader knows of a file.
struct StoredFrfs {
  FrfRecord record;  // files, format, lines, notes, decay; accel by name with angle and position where stated
  std::vector<StoredFrf> frfs;
  std::optional<FrfUnit> unit;  // as the file states it …
  std::optional<FrfKind> kind;  // … or a kind without unit
};

/// Applies unit, kind, channel choice, signs, scales, angles and positions: stored numbers become accelerances.
/// errors  InputError: options that FRFs have no use for, channels that are not there, numbers beyond any sensor.
FrfRecord to_accelerances(StoredFrfs stored, const FrfReadOptions& options);

/// The lines of evenly spaced frequencies that are multiples of their spacing (to 5 % of it: they may be rounded).
/// errors  InputError at `where`: fewer than two, uneven, falling, negative.
LineRange lines_from_frequencies(const std::vector<double>& freq_Hz, const std::string& where);

/// Opens a file of any kind: FRFs, where its columns or data sets are those of FRFs, else a record (open_record).
std::variant<acquire::Record, FrfRecord> open_measurement(const std::string& path, const FrfReadOptions& options = {});

/// Several files of FRFs as one test: each file's points after those of the file before. errors  InputError: lines or
/// channels differ; names the file.
FrfRecord join_frfs(std::vector<FrfRecord> records);

}  // namespace percuss::frf
