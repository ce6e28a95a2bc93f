#include "acquire/sandbox/fork_request.hpp"

#include <sys/socket.h>
#include <sys/uio.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstring>

namespace percuss::acquire {
namespace {

constexpr std::size_t kDescriptor_bytes = sizeof(ReaderDescriptors);
constexpr std::size_t kMaxPath_bytes = PATH_MAX;

// The arguments of sendmsg and recvmsg, with room for the descriptors.
struct SocketMessage {
  std::array<iovec, 2> parts{};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(kDescriptor_bytes)> control{};
  msghdr header{};

  SocketMessage(ForkCommand& command, char* path, std::size_t path_bytes) {
    parts = {iovec{&command, sizeof command}, iovec{path, path_bytes}};
    header.msg_iov = parts.data();
    header.msg_iovlen = parts.size();
  }
  SocketMessage(const SocketMessage&) = delete;
  SocketMessage& operator=(const SocketMessage&) = delete;
  void attach_control_buffer() {
    header.msg_control = control.data();
    header.msg_controllen = control.size();
  }
};

}  // namespace

bool send_fork_request(int socket, const ForkRequest& request) {
  if (request.path.size() > kMaxPath_bytes) return false;
  ForkRequest copy = request;
  SocketMessage message(copy.command, copy.path.data(), copy.path.size());
  if (copy.descriptors.socket >= 0) {
    message.attach_control_buffer();
    cmsghdr* const first = CMSG_FIRSTHDR(&message.header);
    first->cmsg_level = SOL_SOCKET;
    first->cmsg_type = SCM_RIGHTS;
    first->cmsg_len = CMSG_LEN(kDescriptor_bytes);
    std::memcpy(CMSG_DATA(first), &copy.descriptors, kDescriptor_bytes);
  }
  return ::sendmsg(socket, &message.header, MSG_NOSIGNAL) >= 0;
}

std::optional<ForkRequest> receive_fork_request(int socket) {
  ForkRequest request{.command = {}, .path = std::string(kMaxPath_bytes, '\0')};
  SocketMessage message(request.command, request.path.data(), request.path.size());
  message.attach_control_buffer();
  ssize_t got = -1;
  do {
    got = ::recvmsg(socket, &message.header, MSG_CMSG_CLOEXEC);
  } while (got < 0 && errno == EINTR);
  if (got < static_cast<ssize_t>(sizeof request.command)) return std::nullopt;
  request.path.resize(static_cast<std::size_t>(got) - sizeof request.command);
  const cmsghdr* const first = CMSG_FIRSTHDR(&message.header);
  if (first != nullptr && first->cmsg_len == CMSG_LEN(kDescriptor_bytes))
    std::memcpy(&request.descriptors, CMSG_DATA(first), kDescriptor_bytes);
  return request;
}

}  // namespace percuss::acquire
