#pragma once
#include <optional>
#include <string>

#include "acquire/sandbox/sandbox_process.hpp"

namespace percuss::acquire {

/// kStartReader and kRelease have no reply.
enum ForkCommandKind : int { kStartReader, kPoll, kKillReader, kRelease };

struct ForkCommand {
  int kind = 0;
  int reader = 0;
  int cpu = -1;  // kStartReader: the processor of the requesting thread
};

struct ForkReply {
  int reader = -1, status = 0;
};

/// A command. `path` and `descriptors` are for kStartReader.
struct ForkRequest {
  ForkCommand command;
  std::string path;
  ReaderDescriptors descriptors{};
};

/// False when sending fails. The receiver gets copies of the descriptors.
bool send_fork_request(int socket, const ForkRequest& request);

/// Waits for the next request. The caller closes its descriptors. Nothing once the other end is closed.
std::optional<ForkRequest> receive_fork_request(int socket);

}  // namespace percuss::acquire
