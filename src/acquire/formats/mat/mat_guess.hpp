#pragma once
#include <cstddef>
#include <vector>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/formats/mat/mat_file.hpp"

namespace percuss::acquire {

/// Guesses the force and the accelerations (guess_roles) among the variables of these indices: the longest vectors
/// whose names are not those of spectra, else matrices of one shape, else the columns of the first matrix, named as
/// MATLAB does ("data(:,2)"). `known` holds the force if it is known.
RoleGuess guess_mat_roles(const MatFile& file, const std::vector<std::size_t>& index, const CsvColumns& known,
                          const ReadOptions& options);

}  // namespace percuss::acquire
