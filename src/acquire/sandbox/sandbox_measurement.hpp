#pragma once
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "frf/formats/frf_record.hpp"

namespace percuss::acquire {
class ForkServer;
}

namespace percuss::frf {

/// Whether a library of others decodes the file (MAT, HDF5, sound), and so a process of its own reads it.
bool needs_sandbox(const std::string& path);

/// What `open` gives, opened in a confined process (acquire/confined_process.hpp): a record is served from there, FRFs
/// come over whole.
std::variant<acquire::Record, FrfRecord> open_measurement_sandboxed(
    const std::string& path, const std::function<std::variant<acquire::Record, FrfRecord>()>& open);

/// Readers of measurements with these options, for open_measurement_forked.
std::shared_ptr<acquire::ForkServer> measurement_fork_server(const FrfReadOptions& options);

/// As open_measurement with the options of the nursery, which forks the processes in which foreign files are read.
std::variant<acquire::Record, FrfRecord> open_measurement_forked(
    const std::shared_ptr<acquire::ForkServer>& fork_server, const std::string& path, const FrfReadOptions& options);

}  // namespace percuss::frf
