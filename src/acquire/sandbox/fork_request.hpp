#pragma once
#include <array>
#include <optional>
#include <string>

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

/// A question and what goes with kStart.
struct NurseryLetter {
  NurseryQuestion question;
  std::string path;
  std::array<int, 2> descriptors{-1, -1};  // for the reader: to talk, and of the memory
};

/// Whether it went off; the descriptors go along as copies, where there are any.
bool send_letter(int socket, const NurseryLetter& letter);

/// Waits for the next, whose descriptors the caller closes; nothing when nobody holds the other end any more.
std::optional<NurseryLetter> receive_letter(int socket);

}  // namespace percuss
