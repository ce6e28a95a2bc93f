#include "core/io/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <utility>

#include "core/error.hpp"
#include "core/io/lazy_file.hpp"

namespace percuss {
inline namespace core {
namespace {

constexpr std::size_t kHead_bytes = std::size_t{1} << 16U;
constexpr std::size_t kCheckInterval_bytes = std::size_t{1} << 24U;  // between two calls of a GrowthCheck
// Memory for larger files grows with the bytes read.
constexpr std::size_t kMaxFirstGuess_bytes = std::size_t{1} << 30U;

class Descriptor {
 public:
  explicit Descriptor(int number, bool owned) : number_(number), owned_(owned) {}
  ~Descriptor() {
    if (owned_ && number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  // Hands the open descriptor to the caller, who closes it.
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
  bool owned_;
};

constexpr const char* kCannotOpen = "cannot open the file";

[[noreturn]] void fail_to_open(const std::string& path, int error) {
  if (error == ENOENT) throw InputError("no such file", path, "check the path");
  if (error == EACCES) throw_system_error(kCannotOpen, error, path, "ask for permission to read it");
  throw_system_error(kCannotOpen, error, path, is_machine_fault(error) ? "try again later" : "check the path");
}

std::uint64_t require_regular(const struct stat& status, const std::string& path) {
  if (S_ISDIR(status.st_mode)) throw InputError("this is a folder", path, "name the files in it");
  if (!S_ISREG(status.st_mode)) {
    throw InputError("this is not a regular file but a device or a pipe", path,
                     "redirect it and give - to read standard input");
  }
  return static_cast<std::uint64_t>(status.st_size);
}

// Checks the kind before opening: opening a device can have effects, and opening a pipe waits. O_NONBLOCK in case the
// file was replaced in between.
int open_regular(const std::string& path, std::uint64_t& size_bytes) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) fail_to_open(path, errno);
  require_regular(status, path);
  const int number =
      ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  if (number < 0) fail_to_open(path, errno);
  Descriptor opened{number, true};
  if (::fstat(number, &status) != 0) fail_to_open(path, errno);
  size_bytes = require_regular(status, path);
  return opened.release();
}

// The available bytes, at most `count`.
std::size_t read_fully(const Descriptor& file, char* to, std::size_t count, const std::string& path) {
  constexpr std::size_t kMaxRead_bytes = std::size_t{1} << 30U;
  std::size_t done = 0;
  while (done < count) {
    const auto got = ::read(file.number(), to + done, std::min(count - done, kMaxRead_bytes));
    if (got == 0) break;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_system_error("reading failed", errno, input_name(path), "check the disk or pipe");
    done += static_cast<std::size_t>(got);
  }
  return done;
}

struct Free {
  void operator()(char* bytes) const { std::free(bytes); }  // NOLINT: pairs with realloc, which grows without copying
};

class GrowingBuffer {
 public:
  void reserve(std::size_t capacity) {
    char* grown = static_cast<char*>(std::realloc(bytes_.get(), capacity));  // NOLINT: as above
    if (grown == nullptr) throw std::bad_alloc();
    static_cast<void>(bytes_.release());
    bytes_.reset(grown);
    capacity_ = capacity;
  }
  char* data() const { return bytes_.get(); }
  std::size_t capacity() const { return capacity_; }
  std::shared_ptr<const char> share() {
    return {bytes_.release(), [](const char* p) { Free{}(const_cast<char*>(p)); }};
  }

 private:
  std::unique_ptr<char, Free> bytes_;
  std::size_t capacity_ = 0;
};

FileBytes read_all(const Descriptor& file, std::size_t first_guess, std::uint64_t limit, const HeadCheck& check_head,
                   const GrowthCheck& check_growth, const char* too_long_remedy, const std::string& path) {
  GrowingBuffer buffer;
  buffer.reserve(kHead_bytes);
  std::size_t size = read_fully(file, buffer.data(), kHead_bytes, path);
  if (check_head) check_head({buffer.data(), size});
  if (size == kHead_bytes && first_guess > size) buffer.reserve(first_guess);
  for (bool ended = size < kHead_bytes; !ended;) {
    if (size == buffer.capacity()) buffer.reserve(2 * size);
    const std::size_t room = buffer.capacity() - size;
    const std::size_t wanted = check_growth ? std::min(room, kCheckInterval_bytes) : room;
    const std::size_t got = read_fully(file, buffer.data() + size, wanted, path);
    size += got;
    ended = got < wanted;
    if (check_growth) check_growth({buffer.data(), size});
    if (size > limit)
      throw InputError(fmt::format("longer than {} MiB", limit >> 20U), input_name(path), too_long_remedy);
  }
  return {.path = path, .data = buffer.share(), .size = size};
}

}  // namespace

std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }

int open_regular_file(const std::string& path, std::uint64_t limit_bytes, std::uint64_t& size_bytes,
                      const char* too_long_remedy) {
  Descriptor opened{open_regular(path, size_bytes), true};
  if (size_bytes > limit_bytes)
    throw InputError(fmt::format("longer than {} MiB", limit_bytes >> 20U), path, too_long_remedy);
  return opened.release();
}

FileBytes lazy_input(const std::string& path, std::uint64_t limit_bytes) {
  const auto file = std::make_shared<LazyFile>(path, limit_bytes);
  file->load(0, kHead_bytes);
  return {.path = path, .data = {file, file->data()}, .size = file->size(), .lazy = file};
}

std::string first_bytes(const std::string& path, std::size_t count) {
  std::uint64_t size = 0;
  const Descriptor file{open_regular(path, size), true};
  std::string head(count, '\0');
  head.resize(read_fully(file, head.data(), count, path));
  return head;
}

FileBytes read_input(const std::string& path, std::uint64_t limit_bytes, const HeadCheck& check_head,
                     const GrowthCheck& check_growth, const char* too_long_remedy) {
  if (path == "-")
    return read_all(Descriptor{STDIN_FILENO, false}, 0, limit_bytes, check_head, check_growth, too_long_remedy, path);
  std::uint64_t size = 0;
  const Descriptor file{open_regular_file(path, limit_bytes, size, too_long_remedy), true};
  // One byte more than the file, so that its end is found without growing.
  const auto guess = static_cast<std::size_t>(std::min<std::uint64_t>(size + 1, kMaxFirstGuess_bytes));
  return read_all(file, guess, limit_bytes, check_head, check_growth, too_long_remedy, path);
}

}  // namespace core
}  // namespace percuss
