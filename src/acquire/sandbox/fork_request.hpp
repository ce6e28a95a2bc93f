#pragma once
#include <array>
#include <optional>
#include <string>

namespace percuss::acquire {

enum ForkCommandKind : int {
  kStartReader,
  kPoll,
  kKillReader,
  kRelease
};  // kStartReader and kRelease are not answered

struct ForkCommand {
  int kind = 0;
  int reader = 0;
  int processor = -1;  // kStartReader: of the thread that asks
};

struct ForkReply {
  int reader = -1, status = 0;
};

/// A question and what goes with kStartReader.
struct ForkRequest {
  ForkCommand command;
  std::string path;
  std::array<int, 2> descriptors{-1, -1};  // for the reader: to talk, and of the memory
};

/// Whether it went off; the descriptors go along as copies, where there are any.
bool send_fork_request(int socket, const ForkRequest& request);

/// Waits for the next, whose descriptors the caller closes; nothing when nobody holds the other end any more.
std::optional<ForkRequest> receive_fork_request(int socket);

}  // namespace percuss::acquire
