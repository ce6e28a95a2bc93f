#include "acquire/sandbox/serve_in_sandbox.hpp"

#include <cxxabi.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

#include "acquire/sandbox/child_process.hpp"
#include "acquire/sandbox/enter_sandbox.hpp"
#include "acquire/sandbox/sandbox_limits.hpp"
#include "acquire/sandbox/sandbox_protocol.hpp"

namespace percuss::acquire {
namespace {

constexpr int kFailedExitCode = 12;

// The terminate handler of the child. The inherited handler of the parent would print a second message and remove the
// parent's temporary files.
[[noreturn]] void end_child() {
  const std::type_info* const type = abi::__cxa_current_exception_type();
  std::_Exit(type != nullptr && *type == typeid(std::bad_alloc) ? kNoMemoryExitCode : kFailedExitCode);
}

void serve(const ReaderDescriptors& descriptors, const std::string& path, const std::function<SandboxService()>& open) {
  reset_signals();
  double* const shared = map_shared_numbers(descriptors.memory);
  if (shared == nullptr) throw std::bad_alloc();
  keep_only_descriptors({descriptors.socket, descriptors.parent_pipe}, path);
  const std::uint64_t file_bytes = regular_file_bytes(path);
  SandboxService service;
  const bool connected = run_and_send_outcome(kSandboxSocket, [&] {
    start_processor_limit(file_bytes);  // first: libseccomp never ends when certain allocations fail
    enter_sandbox(path, file_bytes);
    service = open();
    return service.description;
  });
  SandboxRequest request;
  while (connected && service.read && receive_bytes(kSandboxSocket, &request, sizeof request)) {
    start_processor_limit(file_bytes);
    const auto out = std::span(shared, std::min<std::size_t>(request.count, kSharedNumbers));
    const bool sent = run_and_send_outcome(kSandboxSocket, [&] {
      service.read(request.row, request.signal, request.first, out);
      return std::string();
    });
    if (!sent) return;
  }
}

}  // namespace

std::uint64_t regular_file_bytes(const std::string& path) {
  struct stat status {};
  const bool known = ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
  return known ? static_cast<std::uint64_t>(status.st_size) : 0;
}

double* map_shared_numbers(int memory) {
  void* const shared = ::mmap(nullptr, kSharedNumbers_bytes, PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0);
  return shared == MAP_FAILED ? nullptr : static_cast<double*>(shared);
}

// No exception may leave this function: after the fork, its callers on the stack are code of the parent.
int serve_in_sandbox(const ReaderDescriptors& descriptors, const std::string& path,
                     const std::function<SandboxService()>& open) {
  std::set_terminate(end_child);
  try {
    serve(descriptors, path, open);
    return 0;
  } catch (const std::bad_alloc&) {
    return kNoMemoryExitCode;
  } catch (...) {
    return kFailedExitCode;
  }
}

}  // namespace percuss::acquire
