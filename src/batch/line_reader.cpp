#include "batch/line_reader.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/read_at.hpp"

namespace percuss::batch {
namespace {

constexpr std::size_t kPiece_bytes = std::size_t{1} << 17U;

}  // namespace

LineReader::LineReader(std::string path, std::size_t longest_bytes)
    : path_(std::move(path)), longest_bytes_(longest_bytes), owned_(true) {
  std::uint64_t size_bytes = 0;
  descriptor_ = open_regular_file(path_, std::numeric_limits<std::uint64_t>::max(), size_bytes);
}

LineReader::LineReader(int descriptor, std::string path, std::size_t longest_bytes)
    : path_(std::move(path)), longest_bytes_(longest_bytes), descriptor_(descriptor) {}

LineReader::~LineReader() {
  if (owned_) ::close(descriptor_);
}

// Removes the previous lines from the buffer and appends the next bytes; false at the end of the file.
bool LineReader::fill() {
  buffer_.erase(0, std::exchange(start_, 0));
  const std::size_t had = buffer_.size();
  buffer_.resize(had + kPiece_bytes);
  ssize_t got = -1;
  do {
    got = ::read(descriptor_, buffer_.data() + had, kPiece_bytes);
  } while (got < 0 && errno == EINTR);
  buffer_.resize(had + static_cast<std::size_t>(got < 0 ? 0 : got));
  if (got < 0) throw_system_error("reading failed", errno, path_, "check the disk or network");
  return got > 0;
}

bool LineReader::next() {
  offset_ = end();
  if (number_ > 0) start_ += length_ + (ended_ ? 1 : 0);
  length_ = 0;
  std::size_t searched = 0, found = std::string::npos;
  while ((found = buffer_.find('\n', start_ + searched)) == std::string::npos) {
    searched = buffer_.size() - start_;
    if (searched > longest_bytes_) break;
    if (!fill()) break;
  }
  ended_ = found != std::string::npos;
  length_ = (ended_ ? found : buffer_.size()) - start_;
  if (length_ > longest_bytes_) {
    throw InputError(fmt::format("line {} is longer than {} bytes", number_ + 1, longest_bytes_), path_,
                     "use the file as percuss wrote it");
  }
  if (!ended_ && length_ == 0) return false;
  ++number_;
  return true;
}

std::string bytes_at(int descriptor, std::uint64_t offset, std::size_t count, const std::string& path) {
  std::string out(count, '\0');
  const ReadResult got = read_at(descriptor, offset, out.data(), count);
  if (got.error != 0) throw_system_error("reading failed", got.error, path, "check the disk or network");
  if (got.bytes < count) throw InputError("the file changed while it was read", path, "run again without changing it");
  return out;
}

}  // namespace percuss::batch
