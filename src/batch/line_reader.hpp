#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace percuss::batch {

/// Reads a file line by line, in memory that does not grow with the file.
///   LineReader lines(path, 65536);
///   while (lines.next()) use(lines.line());
/// errors  InputError: as first_bytes; a line longer than `longest_bytes`
class LineReader {
 public:
  LineReader(std::string path, std::size_t longest_bytes);
  /// Reads an open file, which stays open, from its current position. Offsets count from there.
  LineReader(int descriptor, std::string path, std::size_t longest_bytes);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// Reads the next line; false after the last.
  bool next();
  /// The line without its end; valid until the next call of next().
  std::string_view line() const { return std::string_view(buffer_).substr(start_, length_); }
  /// False for a last line without its end, as a killed writer leaves it.
  bool ended() const { return ended_; }
  std::size_t number() const { return number_; }    // of the line, from 1
  std::uint64_t offset() const { return offset_; }  // of its first byte in the file
  std::uint64_t end() const { return offset_ + length_ + (ended_ ? 1 : 0); }

 private:
  bool fill();

  std::string path_, buffer_;
  std::size_t longest_bytes_, start_ = 0, length_ = 0, number_ = 0;
  std::uint64_t offset_ = 0;
  bool ended_ = false, owned_ = false;
  int descriptor_ = -1;
};

/// `count` bytes of an open file from `offset`. Several threads may read at the same time.
/// errors  InputError naming `path`: the file became shorter, or cannot be read
std::string bytes_at(int descriptor, std::uint64_t offset, std::size_t count, const std::string& path);

}  // namespace percuss::batch
