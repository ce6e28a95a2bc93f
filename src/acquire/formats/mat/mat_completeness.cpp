#include "acquire/formats/mat/mat_completeness.hpp"

#include <array>
#include <cstdint>
#include <optional>

#include "acquire/formats/mat/mat_bytes.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMaxVariables4 = 100'000;  // the reader refuses more
// Bytes of a number, by the tens digit of a level 4 type: double, single, int32, int16, uint16, uint8.
constexpr std::array<std::uint64_t, 6> kBytes4{8, 4, 4, 2, 2, 1};

// Steps from variable to variable by the sizes that the file states.
class VariableWalk {
 public:
  explicit VariableWalk(const std::string& path) : file_(path) {}

  // Both return the number of variables.
  std::optional<std::size_t> check_level5() const {
    std::size_t variables = 0;
    const bool swapped = level5::is_swapped(file_);
    for (std::uint64_t at = level5::kHeader_bytes; holds_tag(at, level5::kTag_words); ++variables) {
      const auto [type, bytes] = file_.words<level5::kTag_words>(at, swapped);
      if (type != level5::kMatrix && type != level5::kCompressed) return {};  // the library handles other types
      at = next(at, level5::kTag_bytes + bytes);
    }
    return variables;
  }

  std::optional<std::size_t> check_level4() const {
    using level4::kTag_words;
    std::size_t variables = 0;
    for (std::uint64_t at = 0; holds_tag(at, kTag_words) && variables < kMaxVariables4; ++variables) {
      std::array<std::uint32_t, kTag_words> tag = file_.words<kTag_words>(at, false);
      if (level4::is_swapped(tag)) tag = file_.words<kTag_words>(at, true);
      const std::uint64_t kind = tag[0] % 100 / 10, parts = tag[3] == 1 ? 2 : 1;
      const std::uint64_t count = std::uint64_t{tag[1]} * tag[2];
      if (kind >= kBytes4.size()) return {};  // the library handles other types
      if (count > file_.size()) refuse_truncated();
      at = next(at, sizeof tag + tag[4] + count * parts * kBytes4.at(kind));
    }
    return variables;
  }

 private:
  [[noreturn]] void refuse_truncated() const {
    throw InputError("the file ends within a variable", file_.path(), "copy or save it again");
  }
  // Fewer bytes than a tag after the last variable are padding.
  bool holds_tag(std::uint64_t at, std::size_t words) const {
    return at + words * sizeof(std::uint32_t) <= file_.size();
  }
  std::uint64_t next(std::uint64_t at, std::uint64_t bytes) const {
    if (bytes > file_.size() - at) refuse_truncated();
    return at + bytes;
  }

  MatBytes file_;
};

}  // namespace

std::optional<std::size_t> require_complete_mat(const std::string& path, MatLevel level) {
  const VariableWalk walk(path);
  return level == MatLevel::v5 ? walk.check_level5() : walk.check_level4();
}

}  // namespace percuss::acquire
