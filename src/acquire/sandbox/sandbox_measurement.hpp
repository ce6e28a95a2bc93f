#pragma once
#include <functional>
#include <memory>
#include <string>

#include "acquire/record/frf_record.hpp"
#include "acquire/sandbox/sandbox_process.hpp"

namespace percuss::acquire {

/// The service of a measurement: samples of a record on request, FRFs as a whole.
SandboxService measurement_service(Measurement opened);

/// The measurement of a child process that runs measurement_service.
/// errors  InputError: the child's description is impossible.
Measurement sandboxed_measurement(const std::shared_ptr<SandboxProcess>& process);

/// The result of `open`, called in a sandboxed child process.
/// errors  InputError: as SandboxProcess.
Measurement open_in_sandbox(const std::string& path, const std::function<Measurement()>& open);

}  // namespace percuss::acquire
