#include "cli/terminal/visible_output.hpp"

#include <algorithm>

#include "core/visible_text.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kPiece_bytes = std::size_t{1} << 16U;

// The bytes at the end of `text` that may be the beginning of a UTF-8 character.
std::size_t begun_bytes(std::string_view text) {
  constexpr std::size_t kMaxCharacter_bytes = 4;
  for (std::size_t bytes = 1; bytes < std::min(kMaxCharacter_bytes, text.size() + 1); ++bytes) {
    const std::string_view last = text.substr(text.size() - bytes);
    const auto first = static_cast<unsigned char>(last.front());
    if ((first & 0xC0U) == 0x80U) continue;
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
    return bytes < length ? bytes : 0;
  }
  return 0;
}

}  // namespace

VisibleOutput::VisibleOutput(std::ostream& stream) : stream_(stream), to_(stream.rdbuf(this)) {}

VisibleOutput::~VisibleOutput() {
  copy(visible_text(begun_));
  const auto state = stream_.rdstate();
  stream_.rdbuf(to_);
  if (state != std::ios::goodbit) stream_.setstate(state);
}

// Allocates nothing, so that the message for missing memory can be printed.
bool VisibleOutput::copy(std::string_view text) {
  const auto count = static_cast<std::streamsize>(text.size());
  return to_->sputn(text.data(), count) == count;
}

bool VisibleOutput::show(std::string_view text) {
  begun_ += text;
  const std::size_t whole = begun_.size() - begun_bytes(begun_);
  const std::string shown = visible_text(std::string_view(begun_).substr(0, whole));
  begun_.erase(0, whole);
  return copy(shown);
}

std::streamsize VisibleOutput::xsputn(const char* bytes, std::streamsize count) {
  std::string_view rest(bytes, static_cast<std::size_t>(count));
  while (!rest.empty()) {
    const auto plain = static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), is_plain) - rest.begin());
    const bool copied = begun_.empty() && plain > 0;
    const std::string_view piece = rest.substr(0, copied ? plain : kPiece_bytes);
    rest.remove_prefix(piece.size());
    if (!(copied ? copy(piece) : show(piece))) return 0;
  }
  return count;
}

VisibleOutput::int_type VisibleOutput::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
  const char byte = traits_type::to_char_type(character);
  return xsputn(&byte, 1) == 1 ? character : traits_type::eof();
}

int VisibleOutput::sync() { return to_->pubsync(); }

}  // namespace percuss::tools
