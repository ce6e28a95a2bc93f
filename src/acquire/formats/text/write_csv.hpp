#pragma once
#include <string>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Writes a record as text, one line per sample, row after row, with the columns
///   hit,t_s,force_N,acc0_m_s2,acc1_m_s2,…
/// The column force_N is absent in a record without a force. Columns of microphones are named mic0_Pa, … The column
/// point follows where a point differs from 0, the column run where the rows have different runs. Hits count from 0;
/// t_s starts at 0 in every row. Numbers are the shortest that read back exactly.
/// errors  InputError when the file exists and `force` is not set, or when it cannot be written.
void write_record_csv(const std::string& path, const Record& record, bool force);

}  // namespace percuss::acquire
