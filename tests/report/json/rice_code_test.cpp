#include "report/json/rice_code.hpp"

#include <gtest/gtest.h>

#include "report/text/digest.hpp"

namespace percuss::report::rice_code_test {

// As rice.js decodes it.
class Reader {
 public:
  explicit Reader(const std::string& text) : bytes_(from_base64(text)) {}
  std::vector<std::int32_t> read(std::size_t count) {
    const unsigned k = number(4);
    std::vector<std::int32_t> out;
    std::int32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t ones = 0;
      while (ones < 20 && bit()) ++ones;
      const std::uint32_t z = ones < 20 ? (ones << k) + number(k) : number(24);
      value += z % 2 != 0 ? -static_cast<std::int32_t>((z + 1) / 2) : static_cast<std::int32_t>(z / 2);
      out.push_back(value);
    }
    return out;
  }

 private:
  bool bit() {
    const auto byte = static_cast<std::uint8_t>(bytes_.at(at_ / 8));
    const bool value = (byte >> (7 - at_ % 8) & 1U) != 0;
    ++at_;
    return value;
  }
  std::uint32_t number(unsigned bits) {
    std::uint32_t value = 0;
    for (; bits > 0; --bits) value = 2 * value + (bit() ? 1 : 0);
    return value;
  }
  std::string bytes_;
  std::size_t at_ = 0;
};

// 4 bits k = 0; differences 1, 0, −1 have z = 2, 0, 1: 110, 0, 10. 0000 1100 10 and zeros: 0x0C 0x80.
TEST(RiceCode, IsTheStatedOne) {
  RiceCode code;
  code.add(std::vector<std::int32_t>{1, 1, 0});
  EXPECT_EQ(code.base64_text(), base64(std::vector<std::uint8_t>{0x0C, 0x80}));
}

TEST(RiceCode, ReturnsWhatWasPacked) {
  const std::vector<std::int32_t> still(50, 7), wild{0, 4'000'000, -4'000'000, 1, -1, 300, 299, 298}, none;
  RiceCode code;
  for (const auto& values : {still, wild, none, still}) code.add(values);
  Reader reader(code.base64_text());
  for (const auto& values : {still, wild, none, still}) EXPECT_EQ(reader.read(values.size()), values);
}

TEST(RiceCode, TakesAboutABitForAValueThatStays) {
  RiceCode code;
  code.add(std::vector<std::int32_t>(8000, 3));
  EXPECT_LT(code.base64_text().size(), 1400U);  // 1000 bytes in base64
}

}  // namespace percuss::report::rice_code_test
