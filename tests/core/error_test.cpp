#include "core/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace percuss::error_test {

TEST(InputError, StatesProblemPlaceAndRemedy) {
  EXPECT_STREQ(InputError("no force channel", "x.csv", "name it").what(), "no force channel (x.csv); name it");
}

TEST(UsageError, StatesProblemAndRemedy) {
  EXPECT_STREQ(UsageError("unknown option", "see --help").what(), "unknown option; see --help");
}

TEST(InputError, IsOneLineForAnyText) {
  const std::string message = InputError("a\nb", "c\r\td", std::string("e\0f", 3)).what();
  EXPECT_EQ(message, "a\\u000ab (c\\u000d\\u0009d); e\\u0000f");
}

TEST(InputError, IsShortForAnyText) {
  const std::string endless(1 << 20, 'x');
  EXPECT_LE(std::string(InputError(endless, endless, endless).what()).size(), 2000U);
}

TEST(InputError, HoldsItsFieldsWithoutControlCharacters) {
  const InputError error("a\nb", "c", std::string(1000, 'x'), {"fs", "survey.example"});
  EXPECT_EQ(error.problem(), "a\\u000ab");
  EXPECT_EQ(error.where(), "c");
  EXPECT_EQ(error.remedy(), std::string(600, 'x') + "...");
  EXPECT_EQ(error.options(), (std::vector<OptionId>{"fs", "survey.example"}));
}

TEST(InputError, AddsItsOptionsInTheNotationOfAnInterface) {
  const OptionWriter write = [](std::string_view id) { return "--" + std::string(id); };
  EXPECT_EQ(InputError("a", "b", "c", {"fs", "unit"}).written(write), "a (b); c (--fs, --unit)");
  EXPECT_EQ(InputError("a", "b", "c").written(write), "a (b); c");
}

TEST(InputError, RefersToOptionsOfOtherCommandsAfterItsOwn) {
  const OptionWriter write = [](std::string_view id) { return "--" + std::string(id); };
  EXPECT_EQ(InputError("a", "b", "c", {"x.fs"}).written(write), "a (b); c (see --x.fs)");
  EXPECT_EQ(InputError("a", "b", "c", {"x.fs", "unit", "y.fs"}).written(write),
            "a (b); c (--unit; see --x.fs, --y.fs)");
}

TEST(OneLine, KeepsPrintableTextAndBytesBeyondAscii) {
  EXPECT_EQ(one_line("m/s² at 90°"), "m/s² at 90°");
  EXPECT_EQ(one_line(""), "");
}

TEST(OneLine, ShowsCharactersThatCannotBeSeenAsEscapes) {
  for (int code = 0; code < 0x20; ++code)
    EXPECT_EQ(one_line(std::string(1, static_cast<char>(code))), fmt::format("\\u{:04x}", code));
  EXPECT_EQ(one_line("\x7f"), "\\u007f");
  EXPECT_EQ(one_line("\u009b\u202e\u2028\xff"), "\\u009b\\u202e\\u2028\\xff");
  EXPECT_EQ(one_line(" ~"), " ~");
}

TEST(OneLine, CutsOnlyTextLongerThanTheLimit) {
  EXPECT_EQ(one_line("abcdef", 6), "abcdef");
  EXPECT_EQ(one_line("abcdefg", 6), "abcdef...");
  EXPECT_EQ(one_line("abc", 0), "...");
}

TEST(OneLine, CutsBetweenCharactersNotInsideThem) {
  EXPECT_EQ(one_line("90°x", 4), "90°...");
  EXPECT_EQ(one_line("90°x", 3), "90...");
  for (const std::size_t limit : {1U, 2U, 3U}) EXPECT_EQ(one_line("\xF0\x9F\x94\xA8 hit", limit), "...") << limit;
  EXPECT_EQ(one_line("\xF0\x9F\x94\xA8 hit", 4), "\xF0\x9F\x94\xA8...");
}

TEST(OneLine, CutsBetweenEscapes) {
  EXPECT_EQ(one_line(std::string(20, '\x80'), 10), "\\x80\\x80...");
  EXPECT_EQ(one_line("\u202e\u202e", 11), "\\u202e...");
}

}  // namespace percuss::error_test
