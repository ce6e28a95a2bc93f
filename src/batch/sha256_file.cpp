#include "batch/sha256_file.hpp"

#include "core/error.hpp"
#include "core/io/input_file.hpp"

namespace percuss::batch {

std::string sha256_of_record(const std::string& path) {
  std::string digest = report::sha256_of_file(path);
  if (!digest.empty()) return digest;
  first_bytes(path, 1);  // states why the file cannot be opened
  throw MachineFault("the file cannot be read", path, "check the disk or network");
}

void Sha256File::add(std::string_view text) {
  constexpr std::size_t kWritten_bytes = std::size_t{1} << 20U;  // at a time
  text_ += text;
  if (text_.size() >= kWritten_bytes) flush();
}

void Sha256File::flush() {
  file_.write(text_);
  digest_.add(text_);
  bytes_ += text_.size();
  text_.clear();
}

void Sha256File::commit() {
  flush();
  file_.commit();
  sha256_ = report::hexadecimal(digest_.result());
}

}  // namespace percuss::batch
