#include "report/json/rice_code.hpp"

#include <cassert>
#include <cstdlib>
#include <limits>

#include "report/text/digest.hpp"

namespace percuss::report {
namespace {

constexpr unsigned kParameterBits = 4, kMaxParameter = 15, kMaxOnes = 20, kEscapedBits = 24;

std::vector<std::uint32_t> zigzag_differences(std::span<const std::int32_t> values) {
  std::vector<std::uint32_t> out;
  out.reserve(values.size());
  std::int32_t before = 0;
  for (const std::int32_t value : values) {
    assert(std::abs(value) < 1 << 22);
    const std::int32_t d = value - before;
    out.push_back(static_cast<std::uint32_t>(d >= 0 ? 2 * d : -2 * d - 1));
    before = value;
  }
  return out;
}

std::size_t bits_of(const std::vector<std::uint32_t>& codes, unsigned k) {
  std::size_t bits = 0;
  for (const std::uint32_t z : codes) bits += (z >> k) < kMaxOnes ? (z >> k) + 1 + k : kMaxOnes + kEscapedBits;
  return bits;
}

}  // namespace

void RiceCode::put(std::uint32_t value, unsigned bits) {
  while (bits > 0) {
    if (free_ == 0) {
      bytes_.push_back(0);
      free_ = 8;
    }
    --bits;
    --free_;
    bytes_.back() |= static_cast<std::uint8_t>((value >> bits & 1U) << free_);
  }
}

void RiceCode::add(std::span<const std::int32_t> values) {
  const std::vector<std::uint32_t> codes = zigzag_differences(values);
  unsigned best = 0;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (unsigned k = 0; k <= kMaxParameter; ++k) {
    if (const std::size_t bits = bits_of(codes, k); bits < fewest) {
      fewest = bits;
      best = k;
    }
  }
  put(best, kParameterBits);
  for (const std::uint32_t z : codes) {
    const std::uint32_t ones = z >> best;
    if (ones >= kMaxOnes) {
      put((1U << kMaxOnes) - 1, kMaxOnes);
      put(z, kEscapedBits);
    } else {
      put((1U << (ones + 1)) - 2, ones + 1);
      put(z & ((1U << best) - 1), best);
    }
  }
}

std::string RiceCode::base64_text() const { return base64(bytes_); }

}  // namespace percuss::report
