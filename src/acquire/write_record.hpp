#pragma once
#include <string>
#include <vector>

#include "acquire/format_registry.hpp"

namespace percuss::acquire {

/// Writes a record in the format of the path's extension, one of record_extensions().
/// errors  InputError: the file exists (without `force`) or cannot be written, or its format cannot hold the record.
void write_record(const std::string& path, const Record& record, bool force);

/// Writes FRFs, converted to `kind`, in the format of the path's extension, one of frf_extensions(). Equal FRFs give
/// equal bytes; the file is whole or absent.
/// errors  InputError: as write_record.
void write_frfs(const std::string& path, const FrfRecord& record, FrfKind kind, bool force);

/// The parts of a record or of FRFs that a file of this name would lose, one line each.
std::vector<std::string> losses_of(const std::string& path, const Record& record);
std::vector<std::string> losses_of(const std::string& path, const FrfRecord& record);

}  // namespace percuss::acquire
