#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "acquire/formats/uff/uff_contents.hpp"
#include "core/error.hpp"
#include "support/files/csv_text.hpp"
#include "support/files/uff_text.hpp"
#include "support/input_error.hpp"

// Every layout of data set 58 and its ambiguous cases, and the data sets of a geometry, written by hand.
namespace percuss::acquire::uff_function_test {

using test::csv_bytes;
using test::input_error_of;
using test::number_bytes;
using test::UffText;
using testing::ElementsAre;
using testing::HasSubstr;

UffFunction only_function(const std::string& text) {
  static FileBytes kept;  // binary functions point into it
  kept = csv_bytes(text);
  auto contents = read_uff_contents(kept);
  EXPECT_EQ(contents.functions.size(), 1U);
  return std::move(contents.functions.at(0));
}

std::vector<double> part_of(const UffFunction& function, std::size_t part = 0) {
  std::vector<double> out(function.count);
  function.read(part, 0, out);
  return out;
}

TEST(UffFunction, ReadsRealSinglesSixToALine) {
  const UffText set{.values = 7};
  const auto f =
      only_function(set.text("  1.00000E+00 -2.50000E+00  3.00000E-01  4.00000E+02  5.00000E+00  6.00000E+00\n"
                             "  7.00000E+00\n"));
  EXPECT_THAT(part_of(f), ElementsAre(1, -2.5, 0.3, 400, 5, 6, 7));
  EXPECT_TRUE(f.single);
  EXPECT_FALSE(f.complex);
}

TEST(UffFunction, ReadsComplexSinglesAndDoubles) {
  auto f = only_function(
      UffText{.ordinate_type = 5, .values = 2}.text("  1.00000E+00  2.00000E+00  3.00000E+00 -4.00000E+00\n"));
  EXPECT_THAT(part_of(f), ElementsAre(1, 3));
  EXPECT_THAT(part_of(f, 1), ElementsAre(2, -4));
  f = only_function(UffText{.ordinate_type = 4, .values = 5}.text(
      "  1.000000000001E+00  2.000000000000E+00  3.000000000000E+00  4.000000000000E+00\n  5.000000000000E+00\n"));
  EXPECT_THAT(part_of(f), ElementsAre(1.000000000001, 2, 3, 4, 5));
  f = only_function(UffText{.ordinate_type = 6, .values = 2}.text(
      "  1.000000000000E+00  2.000000000000E+00  3.000000000000E+00  4.000000000000E+00\n"));
  EXPECT_THAT(part_of(f, 1), ElementsAre(2, 4));
}

TEST(UffFunction, ReadsUnevenLayoutsWithTheirAbscissa) {
  auto f =
      only_function(UffText{.values = 2, .spacing = 0}.text("  0.00000E+00  1.00000E+01  2.00000E+00  2.00000E+01\n"));
  EXPECT_EQ(f.x(1), 2);
  EXPECT_THAT(part_of(f), ElementsAre(10, 20));
  f = only_function(UffText{.ordinate_type = 4, .values = 3, .spacing = 0}.text(
      "  0.00000E+00  1.000000000000E+01  2.00000E+00  2.000000000000E+01\n  5.00000E+00  3.000000000000E+01\n"));
  EXPECT_EQ(f.x(2), 5);
  EXPECT_THAT(part_of(f), ElementsAre(10, 20, 30));
  f = only_function(UffText{.ordinate_type = 6, .values = 2, .spacing = 0}.text(
      "  0.00000E+00  1.000000000000E+01 -1.000000000000E+00\n  2.00000E+00  2.000000000000E+01 "
      "-2.000000000000E+00\n"));
  EXPECT_EQ(f.x(1), 2);
  EXPECT_THAT(part_of(f, 1), ElementsAre(-1, -2));
}

TEST(UffFunction, ReadsColumnsThatTouchAndFortransExponents) {
  const auto f =
      only_function(UffText{.values = 6}.text("-1.000000E+00-2.000000D+00 0.300000E+01-4.00000E-101"
                                              "  1.50000-101          6.0\n"));
  EXPECT_THAT(part_of(f), ElementsAre(-1, -2, 3, -4e-101, 1.5e-101, 6));
}

TEST(UffFunction, ReadsLinesPaddedToEightyAndMixedLineEnds) {
  const UffText set{.values = 2, .end = "\r\n"};
  std::string text = set.text("  1.00000E+00  2.00000E+00" + std::string(54, ' ') + "\r\n");
  text.replace(text.rfind("    -1\r\n"), 8, "    -1" + std::string(74, ' ') + "\n");
  EXPECT_THAT(part_of(only_function(text)), ElementsAre(1, 2));
}

// A delimiter is a line, not a text: coordinates and values may be −1.
TEST(UffFunction, DistinguishesNumbersFromDelimiters) {
  const auto f = only_function(UffText{.values = 2}.text("    -1.000000    -1.000000\n"));
  EXPECT_THAT(part_of(f), ElementsAre(-1, -1));
}

TEST(UffFunction, ReadsBinaryInBothByteOrders) {
  for (const bool big : {false, true}) {
    std::string singles, doubles;
    for (const double x : {1.5, -2.0, 3.25}) {
      singles += number_bytes(static_cast<float>(x), big);
      doubles += number_bytes(x, big);
    }
    const int order = big ? 2 : 1;
    EXPECT_THAT(part_of(only_function(UffText{.values = 3}.binary(singles, order, 12))), ElementsAre(1.5, -2, 3.25));
    EXPECT_THAT(part_of(only_function(UffText{.ordinate_type = 4, .values = 3}.binary(doubles, order, 24))),
                ElementsAre(1.5, -2, 3.25));
    const std::string pairs = doubles + number_bytes(7.0, big);
    const auto f = only_function(UffText{.ordinate_type = 6, .values = 2}.binary(pairs, order, 32));
    EXPECT_THAT(part_of(f), ElementsAre(1.5, 3.25));
    EXPECT_THAT(part_of(f, 1), ElementsAre(-2, 7));
  }
}

// Uneven binary data have an abscissa in single precision, also beside ordinates in double precision.
TEST(UffFunction, ReadsUnevenBinary) {
  std::string real, complex;
  for (const double x : {1.0, 2.0}) {
    real += number_bytes(static_cast<float>(x)) + number_bytes(10 * x);
    complex += number_bytes(static_cast<float>(x)) + number_bytes(10 * x) + number_bytes(-x);
  }
  auto f = only_function(UffText{.ordinate_type = 4, .values = 2, .spacing = 0}.binary(real, 1, 24));
  EXPECT_EQ(f.x(1), 2);
  EXPECT_THAT(part_of(f), ElementsAre(10, 20));
  f = only_function(UffText{.ordinate_type = 6, .values = 2, .spacing = 0}.binary(complex, 1, 40));
  EXPECT_EQ(f.x(1), 2);
  EXPECT_THAT(part_of(f, 1), ElementsAre(-1, -2));
}

TEST(UffFunction, PrefersTheValueCountToAWrongByteCount) {
  const std::string bytes = number_bytes(1.0) + number_bytes(2.0);
  const UffText set{.ordinate_type = 4, .values = 2};
  for (const std::size_t stated : {0U, 8U, 17U, 400U}) {
    EXPECT_THAT(part_of(only_function(set.binary(bytes, 1, stated))), ElementsAre(1, 2)) << stated;
  }
}

TEST(UffFunction, ReadsBinaryThatIsPaddedOrFollowedByALineEnd) {
  const std::string bytes = number_bytes(1.0F) + number_bytes(2.0F) + number_bytes(3.0F);
  const UffText set{.values = 3};
  for (const std::string& after : {std::string(4, '\0'), std::string("\r\n"), std::string("\n")})
    EXPECT_THAT(part_of(only_function(set.binary(bytes + after, 1, 12))), ElementsAre(1, 2, 3));
}

// Bytes of numbers may look like a delimiter.
TEST(UffFunction, ReadsBinaryThatHoldsADelimiter) {
  std::string bytes = "\n    -1\n";
  bytes += number_bytes(2.0);
  const auto f = only_function(UffText{.ordinate_type = 4, .values = 2}.binary(bytes, 1, 16));
  EXPECT_EQ(part_of(f).at(1), 2);
}

TEST(UffFunction, ReadsNamesInLatin1AndNodesWithoutThem) {
  const auto f =
      only_function(UffText{.response = "M\xFCller", .response_node = 12, .response_direction = -2, .values = 2}.text(
          "  1.00000E+00  2.00000E+00\n"));
  EXPECT_EQ(f.response.name, "M\u00FCller");
  EXPECT_EQ(f.response.node, 12);
  EXPECT_EQ(f.response.direction, -2);
  EXPECT_EQ(f.reference.name, "");
}

TEST(UffFunction, RemovesTheStepsRounding) {
  struct Case {
    const char* dx;
    double fs_Hz;
  };
  // The steps of 25600 Hz as C and as Fortran write them, and of 48 kHz, 44.1 kHz and 1000 Hz.
  for (const auto& [dx, fs_Hz] :
       {Case{"  3.90625E-05", 25600}, Case{"  0.39063E-04", 25600}, Case{"  2.08333E-05", 48000},
        Case{"  0.22676E-04", 44100}, Case{"  1.00000E-03", 1000}}) {
    const auto f = only_function(UffText{.values = 2, .dx = dx}.text("  1.00000E+00  2.00000E+00\n"));
    UffStepNote note;
    EXPECT_NEAR(1 / uff_step(f, false, 1, note), fs_Hz, 1e-9 * fs_Hz) << dx;  // rounding
    EXPECT_EQ(note.text.empty(), fs_Hz == 1000 || std::string(dx) == "  3.90625E-05") << note.text;
    // The largest error is that of the most coarsely written step, 0.22676E-04: half a unit of its last digit, and as
    // much again for the distance of the chosen step from the written one.
    EXPECT_LT(note.largest_error, 0.5 / 22676 * 2);
  }
}

TEST(UffFunction, RefusesDamageWithItsLine) {
  const UffText set{.values = 3};
  const std::string good = set.text("  1.00000E+00  2.00000E+00  3.00000E+00\n");
  const auto refusal = [](const std::string& text) {
    const FileBytes bytes = csv_bytes(text);
    return input_error_of([&] { read_uff_contents(bytes); });
  };
  EXPECT_THAT(refusal(good.substr(0, good.size() - 8)), HasSubstr("not closed"));
  EXPECT_THAT(refusal(set.text("  1.00000E+00  2.00000E+00\n")), HasSubstr("line 14"));
  EXPECT_THAT(refusal(set.text("  1.00000E+00  2.00x00E+00  3.00000E+00\n")), HasSubstr("a text where a number"));
  EXPECT_THAT(refusal(UffText{.ordinate_type = 3, .values = 1}.text("  1.0\n")), HasSubstr("ordinate type 3"));
  EXPECT_THAT(refusal(UffText{.values = 99999999}.text("  1.00000E+00\n")), HasSubstr("fewer numbers"));
  EXPECT_THAT(refusal(UffText{.values = 9}.binary("abc", 1, 36)), HasSubstr("no delimiter after the 36 bytes"));
  EXPECT_THAT(refusal(UffText{.values = 1}.binary("abcd", 3, 4)), HasSubstr("byte order 3"));
  EXPECT_THAT(refusal("    -1\n    58\nNONE\n    -1\n"), HasSubstr("within its header"));
  EXPECT_THAT(refusal("    -1\n  x58\nNONE\n    -1\n"), HasSubstr("number cannot be read"));
}

TEST(UffContents, ReadsNodesOfBothKindsInTheirUnitsAndSystems) {
  const std::string units = test::uff_units(1000, 1);
  // System 7: at (1000, 0, 0), its x along y and its z along z.
  const std::string systems =
      "    -1\n    18\n         7         0         0         8         1\nCS7\n"
      "  1.00000E+03  0.00000E+00  0.00000E+00  1.00000E+03  1.00000E+00  0.00000E+00\n"
      "  1.00000E+03  0.00000E+00  1.00000E+00\n    -1\n";
  const std::string nodes =
      "    -1\n    15\n         5         0         0        11 -1.00000E+00 -1.00000E+00  2.00000E+03\n    -1\n"
      "    -1\n  2411\n        12         7         0        11\n"
      "   2.0000000000000000D+00   0.0000000000000000D+00   0.0000000000000000D+00\n    -1\n"
      "    -1\n    82\n         1         2         0\nNONE\n         5        12\n    -1\n"
      "    -1\n  9999\nwhatever\n    -1\n";
  const FileBytes bytes = csv_bytes(units + systems + nodes);
  const UffContents contents = read_uff_contents(bytes);
  ASSERT_EQ(contents.nodes_m.size(), 2U);
  EXPECT_THAT(contents.nodes_m.at(5), ElementsAre(-0.001, -0.001, 2));
  EXPECT_THAT(contents.nodes_m.at(12), ElementsAre(1, 0.002, 0)) << "SI is the stored value divided by its factor";
  EXPECT_THAT(uff_trace_lines(contents, 1), ElementsAre(TraceLine{4, 11}));
  EXPECT_THAT(uff_notes(contents), ElementsAre(information("data sets not used: 9999 (1)")));
  std::vector<Message> notes;
  const auto geometry = uff_geometry(contents, 0, notes);
  ASSERT_EQ(geometry.size(), 13U);
  EXPECT_EQ(geometry[12][1], 0.002);
  EXPECT_TRUE(std::isnan(geometry[0][0]));
}

// Data set 2420 defines the systems 1 (equal to the global system) and 3 (rotated). Only the first is understood.
TEST(UffContents, LeavesOutNodesInSystemsThatItDoesNotRead) {
  const auto row = [](double x, double y, double z) { return fmt::format("{:25.16E}{:25.16E}{:25.16E}\n", x, y, z); };
  const std::string origin = row(0, 0, 0);
  const std::string systems = "    -1\n  2420\n         1\nPart\n         1         0        11\nGlobal\n" +
                              row(1, 0, 0) + row(0, 1, 0) + row(0, 0, 1) + origin +
                              "         3         0        11\nRotated\n" + row(0, 1, 0) + row(-1, 0, 0) +
                              row(0, 0, 1) + origin + "    -1\n";
  const auto node = [&](int label, int system) {
    return fmt::format("{:10}{:10}{:10}{:10}\n", label, system, 0, 11) + row(1, 2, 3);
  };
  const FileBytes bytes = csv_bytes(systems + "    -1\n  2411\n" + node(1, 0) + node(2, 1) + node(3, 3) + "    -1\n");
  const UffContents contents = read_uff_contents(bytes);
  EXPECT_EQ(contents.nodes_m.size(), 2U);
  EXPECT_THAT(contents.nodes_m.at(2), ElementsAre(1, 2, 3));
  const std::vector<Message> notes = uff_notes(contents);
  ASSERT_EQ(notes.size(), 1U) << "the data set itself is used";
  EXPECT_THAT(notes.front().text, HasSubstr("nodes in coordinate systems of data set 2420: 1, not used"));
}

}  // namespace percuss::acquire::uff_function_test
