#pragma once
#include <memory>
#include <string>

#include "acquire/record/frf_record.hpp"

namespace percuss::acquire {
class ForkServer;

/// Opens a file of any format ("-" is standard input) and describes its content. The result is FRFs where the columns,
/// variables or data sets are FRFs, else a record.
/// errors  InputError: not readable, damaged, options that the content contradicts; AmbiguousColumns: nothing says
/// which signal is the force or an acceleration.
Measurement open_measurement(const std::string& path, const FrfReadOptions& options = {});

/// As open_measurement, for a record only: FRFs are refused.
Record open_record(const std::string& path, const ReadOptions& options = {});

/// Whether a library of another project decodes the file (MAT, HDF5, sound). A sandboxed process then reads it.
bool needs_sandbox(const std::string& path);

/// A server that forks sandboxed processes for open_measurement_forked. They open files with these options.
std::shared_ptr<ForkServer> measurement_fork_server(const FrfReadOptions& options);

/// As open_measurement, but where needs_sandbox(path), the server forks the process that reads the file. `options` must
/// equal the server's.
Measurement open_measurement_forked(const std::shared_ptr<ForkServer>& fork_server, const std::string& path,
                                    const FrfReadOptions& options);

}  // namespace percuss::acquire
