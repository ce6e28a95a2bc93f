#include "acquire/live/journal_writer.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <utility>

#include "acquire/live/journal_reader.hpp"
#include "core/error.hpp"
#include "core/io/pending_file.hpp"
#include "core/io/read_at.hpp"

namespace percuss::acquire {
namespace {

constexpr mode_t kJournalMode = 0666;

int open_journal(const std::string& path, int flags) {
  int descriptor = -1;
  do descriptor = ::open(path.c_str(), flags | O_CLOEXEC, kJournalMode);
  while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

// Writes all bytes at an offset. errno, or 0.
int write_at(int descriptor, std::string_view bytes, std::uint64_t offset) {
  while (!bytes.empty()) {
    const ssize_t done = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return errno;
    if (done == 0) return ENOSPC;
    bytes.remove_prefix(static_cast<std::size_t>(done));
    offset += static_cast<std::uint64_t>(done);
  }
  return 0;
}

}  // namespace

void JournalWriter::fail(const char* problem, int error) const {
  throw_system_error(problem, error, path_, "name another output file, or free the disk");
}

void JournalWriter::lock() const {
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno == EWOULDBLOCK)
    throw InputError("another process writes the journal", path_, "end it first, or name another output file");
}

JournalWriter::JournalWriter(std::string path, const StreamFormat& format, bool overwrite)
    : path_(std::move(path)), descriptor_(open_journal(path_, O_RDWR | O_CREAT | (overwrite ? 0 : O_EXCL))) {
  if (descriptor_ < 0 && errno == EEXIST) {
    throw InputError("a journal exists: a session was not finished", path_, "resume it, or overwrite it",
                     {"resume", "force"});
  }
  if (descriptor_ < 0) fail("cannot make the journal", errno);
  bool existed = true;
  try {
    lock();
    struct stat status {};
    existed = ::fstat(descriptor_, &status) != 0 || status.st_size > 0;
    if (::ftruncate(descriptor_, 0) != 0) fail("cannot make the journal", errno);
    const std::string head = journal_header() + journal_block(JournalBlockType::format, format_json(format));
    if (const int error = write_at(descriptor_, head, 0); error != 0) fail("cannot write the journal", error);
    end_ = head.size();
    if (const int error = sync(); error != 0) fail("cannot write the journal", error);
    sync_folder(path_);
  } catch (...) {
    ::close(descriptor_);
    if (!existed) ::unlink(path_.c_str());
    throw;
  }
}

JournalWriter JournalWriter::resumed(const std::string& path, const StreamFormat& format, bool seamless) {
  JournalWriter writer(path, open_journal(path, O_RDWR));
  if (writer.descriptor_ < 0) writer.fail("cannot resume the journal", errno);
  writer.lock();
  const JournalReader reader(path);
  if (reader.format().channels != format.channels || reader.format().fs_Hz != format.fs_Hz) {
    throw InputError("the device has other channels or another rate than the session", path,
                     "select the device and the rate of the session", {"device", "fs"});
  }
  writer.end_ = reader.whole_bytes();
  if (::ftruncate(writer.descriptor_, static_cast<off_t>(writer.end_)) != 0)
    writer.fail("cannot resume the journal", errno);
  if (const std::uint64_t last = reader.end_frame(); last > 0)
    writer.next_frame_ = last + (seamless ? 0 : static_cast<std::uint64_t>(std::ceil(format.fs_Hz)));
  Outcome done = writer.append(journal_block(JournalBlockType::format, format_json(format), writer.next_frame_));
  if (done.error == 0) done = writer.append({.fault = CaptureFault::resumed, .frame = writer.next_frame_});
  if (done.error != 0) writer.fail("cannot resume the journal", done.error);
  return writer;
}

JournalWriter::JournalWriter(JournalWriter&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      end_(other.end_),
      next_frame_(other.next_frame_) {}

JournalWriter::~JournalWriter() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

JournalWriter::Outcome JournalWriter::append(const std::string& block) {
  const std::lock_guard guard(mutex_);
  const int error = write_at(descriptor_, block, end_);
  if (error != 0) {
    // If the file cannot be cut, the reader ignores the partial block, because its checksum is wrong.
    static_cast<void>(::ftruncate(descriptor_, static_cast<off_t>(end_)) == 0);
    return {error, end_};
  }
  const std::uint64_t offset = end_;
  end_ += block.size();
  return {0, offset};
}

JournalWriter::Outcome JournalWriter::append(const CaptureFinding& finding) {
  return append(journal_block(JournalBlockType::finding, finding_json(finding), finding.frame));
}

int JournalWriter::sync() const { return ::fdatasync(descriptor_) == 0 ? 0 : errno; }

std::string JournalWriter::block_at(std::uint64_t offset, std::size_t bytes) const {
  std::string out(bytes, '\0');
  if (read_at(descriptor_, offset, out.data(), bytes).bytes < bytes) return {};
  return out;
}

std::uint64_t JournalWriter::size_bytes() const {
  const std::lock_guard guard(mutex_);
  return end_;
}

}  // namespace percuss::acquire
