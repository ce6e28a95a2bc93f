#include "core/io/temporary_files.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <memory>
#include <string_view>
#include <utility>

namespace percuss {
inline namespace core {
namespace {

// An array of atomics: a signal handler may neither allocate nor lock. Files beyond its size are not removed there.
constexpr std::size_t kFilesKnown = 64;
std::array<std::atomic<const char*>, kFilesKnown>& known_files() {
  static std::array<std::atomic<const char*>, kFilesKnown> files{};
  return files;
}

// Whether the name ends as AtomicFile ends temporary names: ".percuss-123" or ".percuss-123-4".
bool is_temporary(std::string_view name) {
  constexpr std::string_view kMark = ".percuss-";
  const std::size_t mark = name.rfind(kMark);
  if (mark == std::string_view::npos) return false;
  const std::string_view number = name.substr(mark + kMark.size());
  return !number.empty() && number.find_first_not_of("0123456789-") == std::string_view::npos;
}

bool is_regular_file(int descriptor) {
  struct stat info {};
  return ::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode);
}

}  // namespace

TemporaryFile::TemporaryFile(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {
  ::flock(descriptor, LOCK_EX);  // waits for a process that checks whether the file is abandoned
  for (auto& slot : known_files()) {
    const char* empty = nullptr;
    if (slot.compare_exchange_strong(empty, path_.c_str())) return;
  }
}

TemporaryFile::~TemporaryFile() {
  for (auto& slot : known_files()) {
    const char* own = path_.c_str();
    if (slot.compare_exchange_strong(own, nullptr)) return;
  }
}

bool TemporaryFile::still_there() const {
  struct stat info {};
  return ::fstat(descriptor_, &info) == 0 && info.st_nlink > 0;
}

void remove_temporary_files() noexcept {
  for (auto& slot : known_files()) {
    const char* const path = slot.exchange(nullptr);
    if (path != nullptr) ::unlink(path);
  }
}

void remove_abandoned_files(const std::string& folder, const std::string& prefix) {
  const std::unique_ptr<DIR, int (*)(DIR*)> listing(::opendir(folder.c_str()), ::closedir);
  if (!listing) return;
  while (const dirent* const entry = ::readdir(listing.get())) {  // NOLINT(concurrency-mt-unsafe): not shared
    if (!std::string_view(entry->d_name).starts_with(prefix) || !is_temporary(entry->d_name)) continue;
    const std::string path = folder + "/" + entry->d_name;
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) continue;
    if (is_regular_file(descriptor) && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
    ::close(descriptor);
  }
}

}  // namespace core
}  // namespace percuss
