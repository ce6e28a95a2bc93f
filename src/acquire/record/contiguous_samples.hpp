#pragma once
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The record with readers that read its contiguous signals (Record::contiguous) directly from the file. That is
/// several times faster than a library in a child process. For numbers that are too large or not finite, the new
/// readers call the record's former readers, whose messages name the sample. A record without contiguous signals, of
/// several files, or of a file that cannot be opened is returned unchanged.
/// errors  (of the readers)  InputError: the file was truncated meanwhile.
Record with_contiguous_readers(Record record);

}  // namespace percuss::acquire
