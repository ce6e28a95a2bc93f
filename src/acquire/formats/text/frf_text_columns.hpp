#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/io/csv_header.hpp"

namespace percuss::acquire {

/// The columns of one FRF.
struct FrfColumns {
  std::size_t first = 0, second = 0;  // real and imaginary, or magnitude and phase
  bool polar = false, paired = false;
  bool in_dB = false;
  std::optional<double> phase_to_rad;
  std::optional<std::size_t> std, coherence;
  std::optional<int> point;  // set by frf_columns(), as is `channel`
  std::optional<std::size_t> channel;
};

/// Whether columns after the first are named as real and imaginary part, or as magnitude and phase, in this order.
bool names_frfs(const CsvHeader& header);

/// The columns of each FRF, with its point and its channel. Unless all names state both, each FRF is a point of one
/// channel, and a note says so. Empty when no name is a part of an FRF, or when the first column is no frequency. With
/// `forced`, the name of the first column does not matter, and columns with other names or none are frequency, real,
/// imaginary, …
/// errors  InputError: a column without its partner, or not one FRF of every channel for every point.
std::vector<FrfColumns> frf_columns(const CsvHeader& header, const std::string& file, bool forced,
                                    std::vector<Message>& notes);

}  // namespace percuss::acquire
