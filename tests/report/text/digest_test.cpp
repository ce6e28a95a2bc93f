#include "report/text/digest.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace percuss::report::digest_test {

// FIPS 180-2, appendix B, and RFC 4648, section 10.
TEST(Digest, MatchesTheStandardsExamples) {
  EXPECT_EQ(hexadecimal(sha256("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const auto coded = [](std::string_view text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(coded(""), "");
  EXPECT_EQ(coded("f"), "Zg==");
  EXPECT_EQ(coded("fo"), "Zm8=");
  EXPECT_EQ(coded("foobar"), "Zm9vYmFy");
}

TEST(Base64, IsRestoredExactly) {
  std::string bytes;
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(from_base64(base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()})), bytes);
    bytes += static_cast<char>(i * 37);
  }
  EXPECT_EQ(from_base64("Zm9vYmE="), "fooba");  // RFC 4648
  for (const char* bad : {"Zm9", "Zm9*", "Z===", "Zm=v", "\xff\xff\xff\xff"})
    EXPECT_THROW(from_base64(bad), std::out_of_range) << bad;
}

}  // namespace percuss::report::digest_test
