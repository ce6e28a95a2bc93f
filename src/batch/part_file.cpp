#include "batch/part_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "core/error.hpp"
#include "core/io/read_at.hpp"
#include "core/io/temporary_files.hpp"

namespace percuss::batch {
namespace {

constexpr const char* kRemedy = "remove it, or name another folder for the results";

[[noreturn]] void refuse_to_open(const std::string& path, int error) {
  if (error == ELOOP) throw InputError("a symbolic link has the name of a part", path, kRemedy);
  if (error == EISDIR) throw InputError("a folder has the name of a part", path, kRemedy);
  if (error == ENXIO) throw InputError("a pipe or a device has the name of a part", path, kRemedy);
  throw_system_error("cannot open the part", error, path, "free some space or choose another folder");
}

void require_regular(int descriptor, const std::string& path) {
  struct stat info {};
  if (::fstat(descriptor, &info) != 0) refuse_to_open(path, errno);
  if (S_ISDIR(info.st_mode)) refuse_to_open(path, EISDIR);
  if (!S_ISREG(info.st_mode)) refuse_to_open(path, ENXIO);
}

}  // namespace

std::string part_beginning() { return R"({"schema":"percuss/batch-part/)"; }

PartFile::PartFile(const std::string& path, bool append) : path_(path) {
  constexpr mode_t kMode = 0644;
  const int how = append ? O_RDWR | O_CREAT | O_APPEND : O_RDONLY;
  descriptor_ = ::open(path.c_str(), how | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, kMode);
  if (descriptor_ < 0 && (append || errno != ENOENT)) refuse_to_open(path, errno);
  if (descriptor_ < 0) return;
  try {
    require_regular(descriptor_, path);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

PartFile::PartFile(PartFile&& from) noexcept
    : path_(std::move(from.path_)), descriptor_(std::exchange(from.descriptor_, -1)) {}

PartFile::~PartFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string PartFile::first_bytes(std::size_t count) const {
  std::string bytes(count, '\0');
  const ReadResult got = read_at(descriptor_, 0, bytes.data(), count);
  if (got.error != 0) throw_system_error("reading failed", got.error, path_, "check the disk or network");
  bytes.resize(got.bytes);
  return bytes;
}

// A killed writer may leave an empty file or an incomplete label.
void PartFile::require_own() const {
  const std::string wanted = part_beginning(), found = first_bytes(wanted.size());
  if (!wanted.starts_with(found))
    throw InputError("this file is no part of a batch, but has the name of one", path_, kRemedy);
}

void remove_abandoned_parts(const std::string& folder) { remove_abandoned_files(folder, ".part-"); }

}  // namespace percuss::batch
