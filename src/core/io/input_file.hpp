#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace percuss {
inline namespace core {

class LazyFile;

/// The bytes of a file, read once and shared.
struct FileBytes {
  std::string path;  // as the user wrote it; "-" is standard input
  std::shared_ptr<const char> data;
  std::size_t size = 0;
  std::shared_ptr<LazyFile> lazy{};  // set when bytes must be loaded before use

  std::string_view view() const { return {data.get(), size}; }
};

/// Remedies for a file that exceeds a limit of bytes. Records can be split or stored in HDF5, which is read in parts.
inline constexpr const char* kGiveSmallerFile = "give a smaller file";
inline constexpr const char* kSplitRecord = "split it, or save it as HDF5";

/// A record with its first 64 KiB loaded, and address space for all its bytes.
/// errors  as read_input, with the remedy kSplitRecord
FileBytes lazy_input(const std::string& path, std::uint64_t limit_bytes);

/// Checks the first bytes (up to 64 KiB) before the rest is read. Throws InputError for a wrong kind of file.
using HeadCheck = std::function<void(std::string_view head)>;

/// Checks all bytes read so far (`text`), each time more bytes have arrived after the first 64 KiB. Throws InputError
/// to stop reading.
using GrowthCheck = std::function<void(std::string_view text)>;

/// `path` for messages: "standard input" for "-".
std::string input_name(const std::string& path);

/// Opens a regular file for reading and gets its size. Returns the descriptor, which the caller closes.
/// errors  as first_bytes; longer than `limit_bytes`, with the remedy `too_long_remedy`
int open_regular_file(const std::string& path, std::uint64_t limit_bytes, std::uint64_t& size_bytes,
                      const char* too_long_remedy = kGiveSmallerFile);

/// The first bytes of a regular file, at most `count`. Rejects pipes, devices and folders without waiting for them.
/// errors  InputError: missing, no permission, not a regular file
std::string first_bytes(const std::string& path, std::size_t count);

/// The bytes of a regular file, or of standard input for "-". Memory grows with the bytes read, never with a size that
/// a file claims. `check_growth` is called every 16 MiB at least.
/// errors  as first_bytes; longer than `limit_bytes`, with the remedy `too_long_remedy`; the errors of `check_head` and
/// `check_growth`
FileBytes read_input(const std::string& path, std::uint64_t limit_bytes, const HeadCheck& check_head = {},
                     const GrowthCheck& check_growth = {}, const char* too_long_remedy = kGiveSmallerFile);

}  // namespace core
}  // namespace percuss
