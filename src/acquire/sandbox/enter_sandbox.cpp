#include "acquire/sandbox/enter_sandbox.hpp"

#include <sys/prctl.h>

#include "acquire/sandbox/child_process.hpp"
#include "acquire/sandbox/file_access.hpp"
#include "acquire/sandbox/sandbox_limits.hpp"
#include "acquire/sandbox/system_call_filter.hpp"
#include "core/error.hpp"

namespace percuss::acquire {

void enter_sandbox(const std::string& path, std::uint64_t file_bytes) {
  end_with_parent(kSandboxParentPipe);
  limit_resources(file_bytes);
  ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);  // NOLINT: C. Other readers cannot open its memory in /proc.
  const bool files_restricted = leave_one_readable_file(path) || !can_restrict_files();
  if (files_restricted && filter_system_calls()) return;
  throw InputError("this system cannot confine the process that reads the file", path,
                   "trust the input, or save it as CSV or UFF", {"trust_input"});
}

}  // namespace percuss::acquire
