#include "core/io/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>

#include "core/error.hpp"

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

/// The target of a chain of symbolic links; `path` itself when it does not exist.
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

/// The prefix of the temporary names for a target.
std::string temporary_prefix(const std::string& target) {
  return "." + name_of(target).substr(0, kNameBytesKept) + ".percuss-";
}

std::string temporary_name(const std::string& target, int attempt) {
  std::string name = folder_of(target) + "/" + temporary_prefix(target) + std::to_string(::getpid());
  if (attempt > 0) name += "-" + std::to_string(attempt);
  return name;
}

/// Calls make(name) with new names until one succeeds. Returns that name, or an empty text where a call fails for
/// another reason than an existing file.
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

/// rename(2) that keeps an existing target; errno is EEXIST then.
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

void sync_folder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  // The file is complete under its name. Some network drives cannot synchronise a folder, which is not an error.
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(std::string path, bool force, Temporary kind, Links links)
    : path_(std::move(path)), force_(force) {
  if (path_.empty()) throw InputError("empty file name", "output", "name the file to write");
  target_ = links == Links::followed ? resolved(path_) : path_;
  struct stat info {};
  const int flags = links == Links::followed ? 0 : AT_SYMLINK_NOFOLLOW;
  if (::fstatat(AT_FDCWD, target_.c_str(), &info, flags) == 0) {
    if (!S_ISREG(info.st_mode)) {
      throw InputError(S_ISDIR(info.st_mode) ? "is a folder" : "is not a regular file", path_,
                       "name a file, or - for standard output");
    }
    if (!force_) refuse_existing(path_);
  } else if (errno != ENOENT) {
    fail("cannot write");
  }
  if (links == Links::followed) remove_abandoned_files(folder_of(target_), temporary_prefix(target_));
  if (kind == Temporary::unnamed_if_possible) open_unnamed(folder_of(target_));
  if (descriptor_ < 0) open_named();
}

AtomicFile::~AtomicFile() {
  if (!committed_ && named_) ::unlink(temporary_path_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

void AtomicFile::open_unnamed(const std::string& folder) {
  descriptor_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kMode);
  if (descriptor_ < 0) return;
  temporary_path_ = "/proc/self/fd/" + std::to_string(descriptor_);
  unnamed_ = ::access(temporary_path_.c_str(), R_OK | W_OK) == 0;
  if (unnamed_) return;
  ::close(descriptor_);  // without /proc, the file cannot get a name
  descriptor_ = -1;
}

void AtomicFile::open_named() {
  remove_abandoned_files(folder_of(target_), temporary_prefix(target_));
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

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void AtomicFile::link_name() {
  const auto link_as = [this](const std::string& name) {
    return ::linkat(AT_FDCWD, temporary_path_.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if (!force_) {
    if (link_as(target_)) return;
    if (errno == EEXIST) refuse_existing(path_);
    fail("cannot write");
  }
  // A link cannot replace a file; a rename can. The lock keeps other writers from removing the file in between.
  ::flock(descriptor_, LOCK_EX);
  const std::string name = first_free_name(target_, link_as);
  if (name.empty()) fail("cannot write");
  if (::rename(name.c_str(), target_.c_str()) == 0) return;
  const int error = errno;
  ::unlink(name.c_str());
  errno = error;
  fail("cannot replace");
}

void AtomicFile::commit() {
  assert(!committed_);
  if (::fsync(descriptor_) != 0) fail("cannot write");
  if (unnamed_) {
    link_name();
  } else if (force_ ? ::rename(temporary_path_.c_str(), target_.c_str()) != 0
                    : !rename_to_new(temporary_path_, target_)) {
    if (errno == EEXIST) refuse_existing(path_);
    fail("cannot write");
  }
  committed_ = true;
  sync_folder(folder_of(target_));
}

void AtomicFile::fail(std::string_view problem) const {
  const int error = errno;
  throw_system_error(problem, error, path_, remedy_for(error));
}

void write_file(const std::string& path, std::string_view bytes, bool force) {
  AtomicFile file(path, force);
  file.write(bytes);
  file.commit();
}

}  // namespace core
}  // namespace percuss
