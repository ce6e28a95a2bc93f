#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "acquire/record/frf.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// An FRF of one point and one channel.
struct PointFrf {
  int point = 0;
  std::size_t channel = 0;  // index into FrfRecord::accel
  Frf frf;
};

/// A test of which only the FRFs were stored: no hits, no force.
struct FrfRecord {
  std::vector<InputFile> files;
  std::string format;                   // for people: "FRF text", "FRF HDF5"
  FrfKind kind = FrfKind::accelerance;  // as stored; `frfs` are accelerances
  LineRange lines;                // of every FRF; fs_Hz is twice the highest frequency, the true rate is not known
  std::vector<SignalInfo> accel;  // [channels]; to_SI is the factor applied to the stored FRF: unit and sign
  std::vector<PointFrf> frfs;     // [points × channels], point by point, ascending
  std::string estimator{};        // "H1", "H2", "Hv"; empty: not stated
  std::vector<std::vector<double>> geometry;  // as in Record; may be empty
  std::vector<TraceLine> trace_lines;         // likewise
  std::vector<TraceFace> trace_faces;         // likewise
  std::vector<DrivingPlace> driving;          // likewise
  std::vector<PointMotion> motions;           // likewise
  bool sensor_roves = false;                  // likewise
  double decay_per_s = 0;                     // of the exponential window that the file states for force and response
  std::vector<Message> notes;                 // what was assumed, one line each
  /// As Record::source().
  std::string source() const { return files.empty() ? format : files.front().path; }
};

/// The content of a file.
using Measurement = std::variant<Record, FrfRecord>;

/// The user's statements about a file of FRFs, beyond ReadOptions.
struct FrfReadOptions {
  ReadOptions read;
  std::optional<FrfKind> kind{};          // overrides what the file states
  std::optional<std::size_t> averages{};  // of every FRF, at least 1; must agree with what the file states
};

/// FRFs that another program computed with an exponential window which it does not state: they lie at s = jω + σ. The
/// factors from a mobility or receptance to the accelerance change from powers of jω to powers of s. A line at 0 Hz,
/// where jω is 0, is left out then. A window of the same decay that the FRFs state already changes nothing.
/// errors  InputError: the FRFs state a window of another decay.
FrfRecord with_exponential_window(FrfRecord frfs, double decay_per_s);

/// Joins several files of FRFs to one test. The points of a file follow the points of the file before it.
/// errors  InputError: no records; lines, channels or exponential windows differ; names the file.
FrfRecord join_frfs(std::vector<FrfRecord> records);

}  // namespace percuss::acquire
