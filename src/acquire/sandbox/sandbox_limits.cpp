#include "acquire/sandbox/sandbox_limits.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "acquire/record/sample_limits.hpp"
#include "core/sanitized.hpp"

namespace percuss::acquire {
namespace {

constexpr std::uint64_t kLibraries_bytes = std::uint64_t{192} << 20U;  // the libraries' buffers, without the numbers
constexpr std::uint64_t kMinTime_s = 2, kBytesPerSecond = 5'000'000, kMaxTime_s = 1'000'000;
constexpr rlim_t kTotalTime_s = 3600;  // of all answers together

void limit(__rlimit_resource resource, std::uint64_t value) {
  rlimit present{RLIM_INFINITY, RLIM_INFINITY};
  getrlimit(resource, &present);
  const rlim_t lowest = std::min<rlim_t>(value, present.rlim_cur);
  const rlimit soft_and_hard{lowest, lowest};
  setrlimit(resource, &soft_and_hard);
}

// Gives reserved but unused addresses of the heap back to the system: they would escape the limit.
void release_reserved_heap() {
  constexpr int kTopPad_bytes = 1 << 17;
  ::mallopt(M_TOP_PAD, kTopPad_bytes);
  ::malloc_trim(0);
}

std::uint64_t heap_before_bytes = 0;  // at the call of limit_resources

std::uint64_t heap_bytes() {
  const struct mallinfo2 heap = ::mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

std::uint64_t memory_now_bytes() {
  constexpr std::uint64_t kWithoutProc_bytes = std::uint64_t{1} << 30U;
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages == 0 ? kWithoutProc_bytes : pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

std::uint64_t memory_limit_bytes(std::uint64_t file_bytes) { return kLibraries_bytes + claim_limit_bytes(file_bytes); }

unsigned processor_limit_s(std::uint64_t file_bytes) {
  return static_cast<unsigned>(std::min(kMaxTime_s, kSlowness * (kMinTime_s + file_bytes / kBytesPerSecond)));
}

void limit_resources(std::uint64_t file_bytes) {
  heap_before_bytes = heap_bytes();
  if (!kSanitized) {
    release_reserved_heap();
    limit(RLIMIT_AS, memory_now_bytes() + memory_limit_bytes(file_bytes));
  }
  limit(RLIMIT_CPU, std::max<rlim_t>(kTotalTime_s, processor_limit_s(file_bytes)));
  limit(RLIMIT_NOFILE, kSandboxDescriptors);
  for (const auto resource : {RLIMIT_FSIZE, RLIMIT_NPROC, RLIMIT_CORE, RLIMIT_MEMLOCK, RLIMIT_MSGQUEUE})
    limit(resource, 0);
}

std::uint64_t heap_growth_bytes() { return std::max(heap_bytes(), heap_before_bytes) - heap_before_bytes; }

void start_processor_limit(std::uint64_t file_bytes) {
  const itimerval once{.it_interval = {}, .it_value = {.tv_sec = processor_limit_s(file_bytes), .tv_usec = 0}};
  ::setitimer(ITIMER_PROF, &once, nullptr);
}

}  // namespace percuss::acquire
