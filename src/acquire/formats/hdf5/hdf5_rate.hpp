#pragma once
#include <vector>

#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire::hdf5 {

/// The sampling rate: of the options, or else the attribute fs of the file or of its data sets. A note says if the
/// options differ from the file. `force` may be nullptr.
/// errors  InputError: no rate, two rates, or a rate that cannot be.
double read_rate_Hz(const InputHdf5& file, const InputDataSet* force, const InputDataSet& accel,
                    const ReadOptions& options, std::vector<Message>& notes);

/// Converts the times of missing samples to the rate of the record, if the user states another rate than the file. The
/// file states these times at its own rate. They then still name the same samples.
void convert_missing_times(const InputHdf5& file, Record& record);

}  // namespace percuss::acquire::hdf5
