#include "core/io/parse_number.hpp"

#include <gtest/gtest.h>

#include <string>

namespace percuss::parse_number_test {

double value_of(std::string_view cell, bool decimal_comma = false) {
  const auto number = parse_number(cell, decimal_comma);
  EXPECT_EQ(number.problem, NumberProblem::none) << cell;
  return number.value;
}

NumberProblem problem_of(std::string_view cell, bool decimal_comma = false) {
  return parse_number(cell, decimal_comma).problem;
}

TEST(ParseNumber, AcceptsTheFormatsOfInstruments) {
  EXPECT_EQ(value_of("-1.25"), -1.25);
  EXPECT_EQ(value_of("+1.25"), 1.25);
  EXPECT_EQ(value_of("+.5"), 0.5);
  EXPECT_EQ(value_of("5."), 5);
  EXPECT_EQ(value_of(" \t7\r"), 7);
  EXPECT_EQ(value_of("\"7.5\""), 7.5);
  EXPECT_EQ(value_of("1.5E+003"), 1500);
  EXPECT_EQ(value_of("1.5D+03"), 1500);
  EXPECT_EQ(value_of("-1.5d-1"), -0.15);
}

TEST(ParseNumber, AcceptsADecimalCommaOnlyWhenRequested) {
  EXPECT_EQ(value_of("-1,25", true), -1.25);
  EXPECT_EQ(value_of("+,5", true), 0.5);
  EXPECT_EQ(value_of("1,5E3", true), 1500);
  EXPECT_EQ(value_of("3", true), 3);
  EXPECT_EQ(problem_of("1,25"), NumberProblem::not_a_number);
  EXPECT_EQ(problem_of("1.25", true), NumberProblem::not_a_number);
  EXPECT_EQ(problem_of("1.234,5", true), NumberProblem::not_a_number);
}

TEST(ParseNumber, RejectsTextsThatAreNotNumbers) {
  for (const char* cell : {"1.5x", "1 2", "--1", "+-1", "1e", "0x10", "x", "-", ".", "1,5,5", "16:34:01", "\"", "D5"}) {
    EXPECT_EQ(problem_of(cell), NumberProblem::not_a_number) << cell;
  }
  EXPECT_EQ(problem_of(std::string(100, '1') + ",5", true), NumberProblem::not_a_number);
}

TEST(ParseNumber, FindsEmptyCells) {
  for (const char* cell : {"", "  ", "\"\"", " \" \" "}) EXPECT_EQ(problem_of(cell), NumberProblem::empty) << cell;
}

TEST(ParseNumber, RejectsTooLargeNumbersAndRoundsTooSmallOnesToZero) {
  EXPECT_EQ(problem_of("1e400"), NumberProblem::too_large);
  EXPECT_EQ(problem_of("-1D400"), NumberProblem::too_large);
  EXPECT_EQ(problem_of(std::string(400, '9')), NumberProblem::too_large);
  EXPECT_EQ(value_of("1e-400"), 0);
  EXPECT_EQ(value_of("0." + std::string(400, '0') + "1"), 0);
  EXPECT_EQ(problem_of("1" + std::string(400, '0') + "e-50"), NumberProblem::too_large);
  EXPECT_EQ(value_of("-0." + std::string(400, '0') + "1e10"), 0);
  EXPECT_EQ(value_of("1e-99999999999999999999"), 0);
  EXPECT_EQ(problem_of("1e+99999999999999999999"), NumberProblem::too_large);
}

TEST(ParseNumber, RecognisesTextsForNonFiniteNumbers) {
  for (const char* cell : {"nan", "NaN", "-inf", "INF", "infinity", "1.#INF", "#DIV/0!", "#N/A"}) {
    EXPECT_EQ(problem_of(cell), NumberProblem::not_finite) << cell;
  }
}

TEST(ParseNumber, CountsDecimalsWithTheExponentApplied) {
  EXPECT_EQ(decimals_of("0.25", false), 2);
  EXPECT_EQ(decimals_of("0,250", true), 3);
  EXPECT_EQ(decimals_of("12", false), 0);
  EXPECT_EQ(decimals_of("3.90625e-05", false), 10);
  EXPECT_EQ(decimals_of("4E+03", false), -3);
}

}  // namespace percuss::parse_number_test
