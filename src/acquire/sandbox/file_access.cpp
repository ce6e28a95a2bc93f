#include "acquire/sandbox/file_access.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstdint>

namespace percuss::acquire {
namespace {

// The C library does not declare these calls.
long landlock_version() { return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION); }

// The layout of landlock_ruleset_attr. The header of an older kernel lacks the later fields and kinds of access.
struct HandledAccess {
  std::uint64_t files = 0, network = 0, other_processes = 0;
};

HandledAccess all_of_version(long version) {
  constexpr std::array<unsigned, 5> kFileBits{13, 14, 15, 15, 16};  // kinds of access of versions 1 … 5
  const auto index = static_cast<std::size_t>(version < 5 ? version - 1 : 4);
  return {.files = (std::uint64_t{1} << kFileBits.at(index)) - 1,
          .network = version >= 4 ? 3U : 0U,           // bind and connect
          .other_processes = version >= 6 ? 3U : 0U};  // abstract sockets and signals
}

std::size_t size_of_version(long version) { return sizeof(std::uint64_t) * (version >= 6 ? 3 : version >= 4 ? 2 : 1); }

void allow_reading(int ruleset, const std::string& path) {
  const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);  // opens neither pipes nor devices
  struct stat status {};
  if (file >= 0 && ::fstat(file, &status) == 0 && S_ISREG(status.st_mode)) {
    const landlock_path_beneath_attr rule{.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE, .parent_fd = file};
    ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
  }
  if (file >= 0) ::close(file);
}

}  // namespace

bool can_restrict_files() { return landlock_version() >= 1; }

bool leave_one_readable_file(const std::string& path) {
  const long version = landlock_version();
  if (version < 1) return false;
  const HandledAccess handled = all_of_version(version);
  const auto ruleset = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, size_of_version(version), 0));
  if (ruleset < 0) return false;
  allow_reading(ruleset, path);
  const bool restricted = ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&  // NOLINT: C
                          ::syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
  ::close(ruleset);
  return restricted;
}

}  // namespace percuss::acquire
