#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace percuss::report {

/// Packs sequences of integers that change little from one to the next, such as quantised curves, with a Rice code:
/// a sequence is 4 bits k, then per value the zigzag z of its difference from the value before (from 0 for the first),
///   z = 2d for d ≥ 0, −2d − 1 for d < 0;  ⌊z/2^k⌋ ones, a zero, the k low bits of z
/// or, if that needs 20 ones or more, 20 ones and z in 24 bits. k gives the shortest sequence. Bits fill bytes from
/// the highest bit down. Values are below 2²² in magnitude.
class RiceCode {
 public:
  void add(std::span<const std::int32_t> values);
  /// The bytes in base64.
  std::string base64_text() const;

 private:
  void put(std::uint32_t value, unsigned bits);

  std::vector<std::uint8_t> bytes_;
  unsigned free_ = 0;  // unused bits of the last byte
};

}  // namespace percuss::report
