#include "acquire/formats/mat/mat_completeness.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr std::uint64_t kHeader5_bytes = 128, kVersion5_at = 124;
constexpr std::uint32_t kMatrix5 = 14, kCompressed5 = 15;
constexpr std::uint32_t kOtherOrder = 0x494DU;  // the letters IM in the other byte order
constexpr std::size_t kTag5 = 2, kTag4 = 5;
constexpr std::size_t kMaxVariables4 = 100'000;  // the reader refuses more
// Bytes of a number, by the tens digit of a level 4 type: double, single, int32, int16, uint16, uint8.
constexpr std::array<std::uint64_t, 6> kBytes4{8, 4, 4, 2, 2, 1};

// Steps from variable to variable by the sizes that the file states.
class VariableWalk {
 public:
  explicit VariableWalk(const std::string& path)
      : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)), size_(std::filesystem::file_size(path)) {}
  ~VariableWalk() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  VariableWalk(const VariableWalk&) = delete;
  VariableWalk& operator=(const VariableWalk&) = delete;

  // Two numbers precede each variable: its type and its size in bytes. Returns the number of variables.
  std::optional<std::size_t> check_level5() const {
    std::size_t variables = 0;
    const bool swapped = words<1>(kVersion5_at, false)[0] >> 16U == kOtherOrder;
    for (std::uint64_t at = kHeader5_bytes; holds_tag(at, kTag5); ++variables) {
      const auto [type, bytes] = words<kTag5>(at, swapped);
      if (type != kMatrix5 && type != kCompressed5) return {};  // the library handles other types
      at = next(at, sizeof(std::uint32_t) * kTag5 + std::uint64_t{bytes});
    }
    return variables;
  }

  // Five numbers precede each variable: type, rows, columns, 1 for complex, length of the name in bytes.
  std::optional<std::size_t> check_level4() const {
    std::size_t variables = 0;
    for (std::uint64_t at = 0; holds_tag(at, kTag4) && variables < kMaxVariables4; ++variables) {
      std::array<std::uint32_t, kTag4> tag = words<kTag4>(at, false);
      if (tag[0] >= 0x1000000U || tag[4] >= 0x1000000U) tag = words<kTag4>(at, true);
      const std::uint64_t kind = tag[0] % 100 / 10, parts = tag[3] == 1 ? 2 : 1;
      const std::uint64_t count = std::uint64_t{tag[1]} * tag[2];
      if (kind >= kBytes4.size()) return {};  // the library handles other types
      if (count > size_) refuse_truncated();
      at = next(at, sizeof(std::uint32_t) * kTag4 + tag[4] + count * parts * kBytes4.at(kind));
    }
    return variables;
  }

 private:
  [[noreturn]] void refuse_truncated() const {
    throw InputError("the file ends within a variable", path_, "copy or save it again");
  }
  // Fewer bytes than a tag after the last variable are padding.
  bool holds_tag(std::uint64_t at, std::size_t words) const { return at + words * sizeof(std::uint32_t) <= size_; }
  std::uint64_t next(std::uint64_t at, std::uint64_t bytes) const {
    if (bytes > size_ - at) refuse_truncated();
    return at + bytes;
  }
  template <std::size_t kCount>
  std::array<std::uint32_t, kCount> words(std::uint64_t at, bool swapped) const {
    std::array<std::uint32_t, kCount> out{};
    const auto got = ::pread(descriptor_, out.data(), sizeof out, static_cast<off_t>(at));
    if (got != static_cast<ssize_t>(sizeof out)) {
      throw InputError("reading failed", path_, "check the disk and the file's permissions");
    }
    for (std::uint32_t& word : out) word = swapped ? __builtin_bswap32(word) : word;
    return out;
  }

  const std::string& path_;
  int descriptor_;
  std::uint64_t size_;
};

}  // namespace

std::optional<std::size_t> require_complete_mat(const std::string& path, MatLevel level) {
  const VariableWalk walk(path);
  return level == MatLevel::v5 ? walk.check_level5() : walk.check_level4();
}

}  // namespace percuss::acquire
