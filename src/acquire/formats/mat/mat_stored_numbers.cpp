#include "acquire/formats/mat/mat_stored_numbers.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "acquire/formats/mat/mat_bytes.hpp"
#include "acquire/record/sample_limits.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace level5 {
namespace {

constexpr std::uint32_t kInt32 = 5, kUint32 = 6;
constexpr std::uint32_t kCell = 1, kStructure = 2, kDouble = 6, kUint64 = 15, kComplexFlag = 0x800;
constexpr std::size_t kMaxDepth = 16, kMaxDimensions = 64;  // the reader refuses or skips more
constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 48U;
// Bytes of a number, by the type of an element; 0 for types that hold no numbers.
constexpr std::array<std::uint64_t, 14> kNumberBytes{0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8};

const char* const kTooLong = "the content of a variable exceeds its stated length";

[[noreturn]] void refuse(const std::string& problem, const std::string& path) {
  throw InputError(problem, path, "is it damaged? Save it again");
}

// The bytes of a part of the file, as they are or decompressed.
class Bytes {
 public:
  Bytes(const MatBytes& file, std::uint64_t at, std::uint64_t bytes, bool compressed)
      : file_(file), at_(at), left_(bytes), compressed_(compressed) {
    if (compressed_ && inflateInit(&stream_) != Z_OK) refuse("decompression failed", file_.path());
  }
  ~Bytes() {
    if (compressed_) inflateEnd(&stream_);
  }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;

  // The number of bytes taken and skipped so far, after decompression.
  std::uint64_t position() const { return position_; }

  void take(void* out, std::size_t bytes) {
    position_ += bytes;
    if (compressed_) return inflate_to(out, bytes);
    file_.read(at_, out, bytes);
    at_ += bytes;
  }

  void skip(std::uint64_t bytes) {
    if (!compressed_) {
      position_ += bytes;
      at_ += bytes;
      return;
    }
    std::array<char, kBlock_bytes> unused;  // NOLINT(cppcoreguidelines-pro-type-member-init): output only
    for (std::uint64_t done = 0; done < bytes; done += unused.size())
      take(unused.data(), static_cast<std::size_t>(std::min<std::uint64_t>(unused.size(), bytes - done)));
  }

 private:
  static constexpr std::size_t kBlock_bytes = std::size_t{1} << 14U;

  void inflate_to(void* out, std::size_t bytes) {
    stream_.next_out = static_cast<Bytef*>(out);
    stream_.avail_out = static_cast<uInt>(bytes);
    while (stream_.avail_out > 0) {
      if (stream_.avail_in == 0) {
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(left_, block_.size()));
        file_.read(at_, block_.data(), count);
        at_ += count;
        left_ -= count;
        stream_.next_in = block_.data();
        stream_.avail_in = static_cast<uInt>(count);
      }
      const int result = inflate(&stream_, Z_NO_FLUSH);
      if (result != Z_OK && stream_.avail_out > 0) refuse("a compressed variable is damaged", file_.path());
    }
  }

  const MatBytes& file_;
  std::uint64_t at_, left_, position_ = 0;
  bool compressed_;
  z_stream stream_{};
  std::array<Bytef, kBlock_bytes> block_{};
};

// An element's type and length. The eight bytes of a tag also hold the content of a small element, of up to four bytes.
struct Tag {
  std::uint32_t type = 0, bytes = 0, small_content = 0;
  bool small = false;
};

class Variable {
 public:
  Variable(Bytes& bytes, bool swapped, const std::string& path) : bytes_(bytes), swapped_(swapped), path_(path) {}

  // Checks an array of `length` bytes. Leaves arrays of an unexpected form to the library.
  void check(std::uint64_t length, std::size_t depth) {
    const std::uint64_t end = bytes_.position() + length;
    if (depth < kMaxDepth) check_content(end, depth);
    if (bytes_.position() > end) refuse(kTooLong, path_);
    bytes_.skip(end - bytes_.position());
  }

  std::optional<Tag> next_tag(std::uint64_t end) {
    if (bytes_.position() + kTag_bytes > end) return std::nullopt;
    const std::uint32_t first = word(), second = word();
    if (first >> 16U == 0) return Tag{.type = first, .bytes = second};
    return Tag{.type = first & 0xFFFFU, .bytes = first >> 16U, .small_content = second, .small = true};
  }

 private:
  std::uint32_t word() {
    std::uint32_t out = 0;
    bytes_.take(&out, sizeof out);
    return native_word(out, swapped_);
  }

  // The last element may lack its padding.
  void skip_content(const Tag& tag, std::uint64_t end) {
    if (tag.small) return;
    const std::uint64_t left = end - bytes_.position();
    if (tag.bytes > left) refuse(kTooLong, path_);
    bytes_.skip(std::min(left, (std::uint64_t{tag.bytes} + 7) / 8 * 8));
  }

  void check_content(std::uint64_t end, std::size_t depth) {
    const auto flags = next_tag(end);
    if (!flags || flags->type != kUint32 || flags->bytes != 8) return;
    const std::uint32_t kind_and_flags = word();
    word();  // unused: the number of nonzero elements of a sparse array
    const auto count = element_count(end);
    const auto name = next_tag(end);
    if (!count || !name) return;
    skip_content(*name, end);
    const std::uint32_t kind = kind_and_flags & 0xFFU;
    if (kind >= kDouble && kind <= kUint64 && *count > 0) {
      require_numbers(*count, end);
      if ((kind_and_flags & kComplexFlag) != 0) require_numbers(*count, end);
    }
    if (kind == kCell) check_arrays(*count, end, depth);
    if (kind == kStructure) check_arrays(*count * field_count(end), end, depth);
  }

  // The product of the dimensions.
  std::optional<std::uint64_t> element_count(std::uint64_t end) {
    const auto tag = next_tag(end);
    if (!tag || tag->type != kInt32 || tag->small || tag->bytes % 4 != 0 || tag->bytes / 4 > kMaxDimensions)
      return std::nullopt;
    std::uint64_t count = 1;
    for (std::uint32_t i = 0; i < tag->bytes / 4; ++i) count = std::min(count * word(), kMaxCount / UINT16_MAX);
    if (tag->bytes % 8 != 0) word();
    return count;
  }

  void require_numbers(std::uint64_t count, std::uint64_t end) {
    const auto tag = next_tag(end);
    const std::uint64_t each_bytes = tag && tag->type < kNumberBytes.size() ? kNumberBytes.at(tag->type) : 0;
    if (each_bytes == 0 || tag->bytes / each_bytes < count)
      refuse("an array stores fewer numbers than it states", path_);
    skip_content(*tag, end);
  }

  std::uint64_t field_count(std::uint64_t end) {
    const auto length = next_tag(end);
    if (!length || !length->small) return 0;
    const auto names = next_tag(end);
    if (!names) return 0;
    skip_content(*names, end);
    return length->small_content == 0 ? 0 : names->bytes / length->small_content;
  }

  void check_arrays(std::uint64_t count, std::uint64_t end, std::size_t depth) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto tag = next_tag(end);
      if (!tag || tag->type != kMatrix) return;
      check(tag->bytes, depth + 1);
    }
  }

  Bytes& bytes_;
  bool swapped_;
  const std::string& path_;
};

void check_file(const std::string& path) {
  const MatBytes file(path);
  const bool swapped = is_swapped(file);
  std::uint64_t left_bytes = claim_limit_bytes(file.size());  // of decompressed variables
  for (std::uint64_t at = kHeader_bytes, length = 0; at + kTag_bytes <= file.size(); at += kTag_bytes + length) {
    const std::array<std::uint32_t, kTag_words> tag = file.words<kTag_words>(at, swapped);
    const std::uint32_t type = tag[0];
    length = tag[1];
    Bytes bytes(file, at + kTag_bytes, length, type == kCompressed);
    Variable variable(bytes, swapped, path);
    if (type == kMatrix) variable.check(length, 0);
    if (type == kCompressed) {
      const Tag inner = variable.next_tag(kTag_bytes).value();
      if (inner.type != kMatrix) continue;
      if (inner.bytes > left_bytes) refuse("the file claims more numbers than it can hold", path);
      left_bytes -= inner.bytes;
      variable.check(inner.bytes, 0);
    }
  }
}

}  // namespace
}  // namespace level5

void require_stored_numbers(const std::string& path) { level5::check_file(path); }

}  // namespace percuss::acquire
