#pragma once
#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The record of one file with readers that take its plain signals (Record::plain) straight from the file, which is
/// several times faster than through a library in a process of its own. Numbers that are not finite they leave to the
/// readers the record had, and so to their messages. errors (of the readers)  InputError: the file was cut meanwhile.
Record with_contiguous_readers(Record record);

}  // namespace percuss::acquire
