#include "batch/sha256_file.hpp"

namespace percuss {

void DigestedFile::add(std::string_view text) {
  constexpr std::size_t kWritten_bytes = std::size_t{1} << 20U;  // at a time
  text_ += text;
  if (text_.size() >= kWritten_bytes) flush();
}

void DigestedFile::flush() {
  file_.write(text_);
  digest_.add(text_);
  bytes_ += text_.size();
  text_.clear();
}

void DigestedFile::commit() {
  flush();
  file_.commit();
  sha256_ = hexadecimal(digest_.result());
}

}  // namespace percuss
