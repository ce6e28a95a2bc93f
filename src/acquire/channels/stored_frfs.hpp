#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "acquire/channels/frf_unit.hpp"
#include "acquire/record/frequency_lines.hpp"
#include "acquire/record/frf_record.hpp"

namespace percuss::acquire {

/// An FRF with its numbers as the file stores them.
struct StoredFrf {
  int point = 0;
  std::size_t channel = 0;
  std::vector<Complex> value;
  std::vector<double> std, coherence;  // empty if the file has none
  std::size_t averages = 0;            // 0: not stated
};

/// The content of a file of FRFs, before options are applied.
struct StoredFrfs {
  FrfRecord record;  // files, format, lines, notes, decay; accel by name with angle and position if stated
  std::vector<StoredFrf> frfs;
  std::optional<FrfUnit> unit;           // as the file states it; includes the kind
  std::optional<FrfKind> kind;           // as the file states it; not used if `unit` is stated
  std::optional<SpacingLimits> spacing;  // if the file states frequencies
  std::string spacing_note;              // about these frequencies; not used if the user states the spacing

  /// Takes the lines of the file's frequencies, their limits and the note.
  void set_lines(FrequencyLines frequencies);
};

/// Applies spacing, unit, kind, averages, channel choice, signs, scales, angles and positions: stored numbers become
/// accelerances. Where an FRF has a coherence and a number of averages but no standard deviation, it gets the one of H1
/// that follows from both. A note with the code kReversedPhase says if the FRFs are probably for exp(−jωt).
/// errors  InputError: options without a meaning for FRFs, a spacing or a number of averages that contradicts the file,
/// channels that do not exist, implausibly large numbers.
FrfRecord to_accelerances(StoredFrfs stored, const FrfReadOptions& options);

}  // namespace percuss::acquire
