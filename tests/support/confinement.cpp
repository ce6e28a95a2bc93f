#include "support/confinement.hpp"

#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace percuss::test {

bool has_seccomp() {
  const std::uint32_t action = SECCOMP_RET_ERRNO;
  return ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

bool has_landlock() {
  constexpr unsigned kGetVersion = 1;
  return ::syscall(__NR_landlock_create_ruleset, nullptr, 0, kGetVersion) > 0;
}

// On a system without seccomp, the filter cannot be loaded, and nothing needs to be removed.
void remove_seccomp() {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(seccomp), 0);
  const scmp_arg_cmp sets_filter{.arg = 0, .op = SCMP_CMP_EQ, .datum_a = PR_SET_SECCOMP, .datum_b = 0};
  seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(prctl), 1, &sets_filter);
  seccomp_load(filter);
  seccomp_release(filter);
}

void remove_landlock() {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), __NR_landlock_create_ruleset, 0);
  seccomp_load(filter);
  seccomp_release(filter);
}

}  // namespace percuss::test
