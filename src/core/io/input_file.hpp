#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace percuss::inline core {

class LazyFile;

/// A file's bytes, read once and shared.
struct FileBytes {
  std::string path;  // as people know it; "-" is standard input
  std::shared_ptr<const char> data;
  std::size_t size = 0;
  std::shared_ptr<LazyFile> lazy{};  // where bytes are in their places only once they have been loaded

  std::string_view view() const { return {data.get(), size}; }
};

/// A file of which the first 64 KiB have been read, and a place for all is kept. errors  as read_input.
FileBytes lazy_input(const std::string& path, std::uint64_t limit_bytes);

/// Sees the first bytes (up to 64 KiB) before the rest is read, and throws InputError when they cannot be what is
/// wanted.
using HeadCheck = std::function<void(std::string_view head)>;

/// `path` for messages: "standard input" for "-".
std::string input_name(const std::string& path);

/// Opens a regular file for reading and tells its size. errors  as first_bytes; longer than `limit_bytes`.
int open_regular_file(const std::string& path, std::uint64_t limit_bytes, std::uint64_t& size_bytes);

/// A regular file's first bytes, at most `count`. Pipes, devices and folders are refused without waiting for them.
/// errors  InputError: missing, no permission, not a regular file.
std::string first_bytes(const std::string& path, std::size_t count);

/// The whole of a regular file, or of standard input for "-". Memory follows what was really read, never a size that is
/// claimed. errors  as first_bytes; longer than `limit_bytes`; whatever `look` throws.
FileBytes read_input(const std::string& path, std::uint64_t limit_bytes, const HeadCheck& check_head = {});

}  // namespace percuss::inline core
