#include "core/io/pending_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>

#include "core/error.hpp"
#include "core/io/write_all.hpp"

namespace percuss {
inline namespace core {
namespace {

constexpr mode_t kMode = 0644;
constexpr int kNamesTried = 100;             // one process may write the same file from several threads
constexpr std::size_t kNameBytesKept = 200;  // of a long name, so that the temporary name stays below NAME_MAX

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

std::string name_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// Some network drives cannot synchronise a folder, which is not an error.
void sync_folder_named(const char* name) noexcept {
  const int folder = ::open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

// The target of a chain of symbolic links; `path` itself when it does not exist.
std::string resolved(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), &std::free);
  return real ? real.get() : path;
}

std::string remedy_for(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return "create the folder first";
    case ENOSPC:
    case EDQUOT:
      return "free some space or choose another folder";
    case EISDIR:
      return "name a file in it";
    default:
      return "choose another folder or file name";
  }
}

// The prefix of the temporary names for a target.
std::string temporary_prefix(const std::string& target) {
  return "." + name_of(target).substr(0, kNameBytesKept) + ".percuss-";
}

std::string temporary_name(const std::string& target, int attempt) {
  std::string name = folder_of(target) + "/" + temporary_prefix(target) + std::to_string(::getpid());
  if (attempt > 0) name += "-" + std::to_string(attempt);
  return name;
}

// Calls make(name) with new names until one succeeds, and returns this name. Returns an empty text when a call fails
// for another reason than an existing file, or after kNamesTried names.
template <class Make>
std::string first_free_name(const std::string& target, Make&& make) {
  for (int attempt = 0; attempt < kNamesTried; ++attempt) {
    std::string name = temporary_name(target, attempt);
    if (make(name)) return name;
    if (errno != EEXIST) break;
  }
  return {};
}

[[noreturn]] void refuse_existing(const std::string& path) {
  throw InputError("file exists", path, "give another name, or overwrite it", {"force"});
}

// rename(2) that keeps an existing target; errno is EEXIST then.
bool rename_to_new(const std::string& from, const std::string& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS) return false;
  // This file system needs two calls; a file created between them is replaced.
  if (::access(to.c_str(), F_OK) == 0) {
    errno = EEXIST;
    return false;
  }
  return ::rename(from.c_str(), to.c_str()) == 0;
}

}  // namespace

PendingFile::PendingFile(std::string path, bool force, bool unnamed_if_possible, bool follows_links)
    : path_(std::move(path)), force_(force) {
  check_target(follows_links);
  folder_ = folder_of(target_);
  if (follows_links) remove_abandoned_files(folder_, temporary_prefix(target_));
  if (unnamed_if_possible) open_unnamed();
  if (descriptor_ < 0) open_named();
}

PendingFile::~PendingFile() {
  if (!published_ && !unnamed_ && descriptor_ >= 0) ::unlink(temporary_path_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

void PendingFile::check_target(bool follows_links) {
  if (path_.empty()) throw InputError("empty file name", "output", "name the file to write");
  target_ = follows_links ? resolved(path_) : path_;
  struct stat info {};
  if (::fstatat(AT_FDCWD, target_.c_str(), &info, follows_links ? 0 : AT_SYMLINK_NOFOLLOW) == 0) {
    if (!S_ISREG(info.st_mode)) {
      throw InputError(S_ISDIR(info.st_mode) ? "is a folder" : "is not a regular file", path_,
                       "name a file, or - for standard output");
    }
    if (!force_) refuse_existing(path_);
    replaces_ = true;
  } else if (errno != ENOENT) {
    fail("cannot write");
  }
}

void PendingFile::open_unnamed() {
  descriptor_ = ::open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kMode);
  if (descriptor_ < 0) return;
  temporary_path_ = "/proc/self/fd/" + std::to_string(descriptor_);
  unnamed_ = ::access(temporary_path_.c_str(), R_OK | W_OK) == 0;
  if (unnamed_) return;
  ::close(descriptor_);  // without /proc, the file cannot get a name
  descriptor_ = -1;
}

void PendingFile::open_named() {
  remove_abandoned_files(folder_, temporary_prefix(target_));
  temporary_path_ = first_free_name(target_, [this](const std::string& name) {
    descriptor_ = ::open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, kMode);
    if (descriptor_ < 0) return false;
    named_.emplace(name, descriptor_);
    if (named_->still_there()) return true;
    named_.reset();
    ::close(std::exchange(descriptor_, -1));
    errno = EEXIST;  // try the next name
    return false;
  });
  if (descriptor_ < 0) fail("cannot write");
}

void PendingFile::write(std::string_view bytes) const {
  if (!write_all(descriptor_, bytes)) fail("cannot write");
}

void PendingFile::complete() const {
  if (::fsync(descriptor_) != 0) fail("cannot write");
}

void PendingFile::check_absent() const {
  if (!force_ && ::access(target_.c_str(), F_OK) == 0) refuse_existing(path_);
}

void PendingFile::publish() {
  const auto link_as = [this](const std::string& name) {
    return ::linkat(AT_FDCWD, temporary_path_.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if (!unnamed_ || !force_) {
    const bool done = unnamed_ ? link_as(target_)
                      : force_ ? ::rename(temporary_path_.c_str(), target_.c_str()) == 0
                               : rename_to_new(temporary_path_, target_);
    if (!done && errno == EEXIST) refuse_existing(path_);
    if (!done) fail("cannot write");
  } else {
    // A link cannot replace a file; a rename can. The lock keeps other writers from removing the file in between.
    ::flock(descriptor_, LOCK_EX);
    const std::string name = first_free_name(target_, link_as);
    if (name.empty()) fail("cannot write");
    if (::rename(name.c_str(), target_.c_str()) != 0) {
      const int error = errno;
      ::unlink(name.c_str());
      errno = error;
      fail("cannot replace");
    }
  }
  published_ = true;
}

void PendingFile::withdraw() const {
  if (published_ && !replaces_) ::unlink(target_.c_str());
}

void PendingFile::fail(std::string_view problem) const {
  const int error = errno;
  throw_system_error(problem, error, path_, remedy_for(error));
}

void PendingFile::sync_folder() const noexcept { sync_folder_named(folder_.c_str()); }

void sync_folder(const std::string& path) { sync_folder_named(folder_of(path).c_str()); }

}  // namespace core
}  // namespace percuss
