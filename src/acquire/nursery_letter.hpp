#pragma once
#include <sys/socket.h>
#include <sys/uio.h>

#include <array>
#include <climits>
#include <cstring>

namespace percuss {

enum NurseryKind : int { kStart, kEnded, kEnd, kForget };  // kStart and kForget are not answered

struct NurseryQuestion {
  int kind = 0;
  int reader = 0;
  int processor = -1;  // kStart: of the thread that asks
};

struct NurseryAnswer {
  int reader = -1, status = 0;
};

inline constexpr std::size_t kDescriptors = 2;
inline constexpr std::size_t kLongestPath = PATH_MAX;

/// A message with room for the descriptors that go with it.
struct NurseryLetter {
  std::array<iovec, 2> parts{};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(kDescriptors * sizeof(int))> control{};
  msghdr header{};

  NurseryLetter(NurseryQuestion& question, char* path, std::size_t path_bytes) {
    parts = {iovec{&question, sizeof question}, iovec{path, path_bytes}};
    header.msg_iov = parts.data();
    header.msg_iovlen = parts.size();
  }
  NurseryLetter(const NurseryLetter&) = delete;
  NurseryLetter& operator=(const NurseryLetter&) = delete;
  void make_room() {
    header.msg_control = control.data();
    header.msg_controllen = control.size();
  }
  void enclose(const int* descriptors) {
    make_room();
    cmsghdr* const first = CMSG_FIRSTHDR(&header);
    first->cmsg_level = SOL_SOCKET;
    first->cmsg_type = SCM_RIGHTS;
    first->cmsg_len = CMSG_LEN(kDescriptors * sizeof(int));
    std::memcpy(CMSG_DATA(first), descriptors, kDescriptors * sizeof(int));
  }
  bool enclosed(std::array<int, kDescriptors>& descriptors) {
    const cmsghdr* const first = CMSG_FIRSTHDR(&header);
    if (first == nullptr || first->cmsg_len != CMSG_LEN(kDescriptors * sizeof(int))) return false;
    std::memcpy(descriptors.data(), CMSG_DATA(first), kDescriptors * sizeof(int));
    return true;
  }
};

}  // namespace percuss
