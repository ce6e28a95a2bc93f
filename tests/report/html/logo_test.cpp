#include "report/html/logo.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "report/text/digest.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::report::logo_test {

using testing::StartsWith;

// One pixel, half transparent.
std::string small_png() {
  return from_base64(
      "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg==");
}

// Start, application segment, frame of 2 × 3 pixels, end: what a reader of sizes sees of a JPEG.
std::string small_jpeg() {
  const std::string app("\xFF\xD8\xFF\xE0\x00\x04\x00\x00", 8),
      frame("\xFF\xC0\x00\x0B\x08\x00\x03\x00\x02\x01\x01\x11\x00", 13);
  return app + frame + "\xFF\xD9";
}

std::string svg(const std::string& inside) {
  return "<?xml version=\"1.0\"?>\n<!-- drawn -->\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1 1\">" +
         inside + "</svg>";
}

TEST(Logo, AcceptsPictures) {
  EXPECT_EQ(logo_data_uri(small_png(), "a"),
            "data:image/png;base64," +
                base64({reinterpret_cast<const std::uint8_t*>(small_png().data()), small_png().size()}));
  EXPECT_THAT(logo_data_uri(small_jpeg(), "a"), StartsWith("data:image/jpeg;base64,"));
  EXPECT_THAT(logo_data_uri(svg("<circle r=\"1\" fill=\"url(#paint)\"/><use href=\"#one\"/>"), "a"),
              StartsWith("data:image/svg+xml;base64,"));
}

TEST(Logo, RefusesWhatIsNoPicture) {
  for (const std::string& bytes :
       {std::string(), std::string("text"), std::string("<html><svg></svg></html>"), std::string("GIF89a"),
        small_png().substr(0, 60), small_png() + "more", small_jpeg().substr(0, 12), std::string("\xFF\xD8\xFF\xD9")})
    EXPECT_THROW(logo_data_uri(bytes, "a"), InputError) << bytes.size();
}

TEST(Logo, RefusesPicturesThatAreTooLarge) {
  std::string wide = small_png();
  wide[17] = '\x01';  // 65537 pixels wide
  EXPECT_THROW(logo_data_uri(wide, "a"), InputError);
  EXPECT_THROW(logo_data_uri(svg(std::string(kMaxLogo_bytes, ' ')), "a"), InputError);
}

TEST(Logo, RefusesActiveSvg) {
  for (const char* inside :
       {"<script>alert(1)</script>", "<SCRIPT/>", "<g onload=\"alert(1)\"/>", "<g\nonclick = 'x'/>", "<g/onload=x>",
        "<foreignObject/>", "<a href=\"javascript:alert(1)\"/>", "<image xlink:href=\"http://x/y.png\"/>",
        "<image href='data:text/html,x'/>", "<style>@import url(x.css)</style>", "<g fill=\"url(http://x)\"/>",
        "<!ENTITY x 'y'>", "<iframe src=\"x\"/>"})
    EXPECT_THROW(logo_data_uri(svg(inside), "a"), InputError) << inside;
}

TEST(Logo, SaysHowLargeAFileMayBe) {
  const test::ScratchFolder folder;
  test::write_bytes(folder.file("big.svg"), svg(std::string(kMaxLogo_bytes, ' ')));
  EXPECT_THAT(test::input_error_of([&] { logo_of_file(folder.file("big.svg")); }),
              testing::HasSubstr("more than 200000"));
}

}  // namespace percuss::report::logo_test
