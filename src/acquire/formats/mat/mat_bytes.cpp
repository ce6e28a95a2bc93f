#include "acquire/formats/mat/mat_bytes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>

#include "core/error.hpp"

namespace percuss::acquire {

MatBytes::MatBytes(const std::string& path)
    : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)), size_(std::filesystem::file_size(path)) {}

MatBytes::~MatBytes() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void MatBytes::read(std::uint64_t at, void* out, std::size_t bytes) const {
  const ssize_t got = ::pread(descriptor_, out, bytes, static_cast<off_t>(at));
  if (got == static_cast<ssize_t>(bytes)) return;
  throw InputError("reading failed", path_,
                   got < 0 ? "check the disk and the file's permissions" : "is it damaged? Save it again");
}

bool level5::is_swapped(const MatBytes& file) {
  constexpr std::uint64_t kVersion_at = 124;
  constexpr std::uint32_t kOtherByteOrder = 0x494DU;  // the letters IM in the other byte order
  return file.words<1>(kVersion_at, false)[0] >> 16U == kOtherByteOrder;
}

}  // namespace percuss::acquire
