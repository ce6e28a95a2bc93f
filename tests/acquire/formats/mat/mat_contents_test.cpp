#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>

#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/formats/mat/mat_stored_numbers.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/scratch_folder.hpp"

// Variables of level 5 written byte by byte. The types of data elements are 1 (int8), 4 (uint16), 5 (int32), 6
// (uint32), 9 (double), 14 (array), 15 (compressed array), 16 (UTF-8) and 17 (UTF-16).
namespace percuss::acquire::mat_contents_test {

using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// Classes of arrays.
constexpr std::uint32_t kCell = 1, kStruct = 2, kObject = 3, kChar = 4, kDouble = 6, kFunction = 16, kOpaque = 17;

std::string words(const std::vector<std::uint32_t>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]};
}

std::string padded(std::string bytes) {
  bytes.resize((bytes.size() + 7) / 8 * 8, '\0');
  return bytes;
}

std::string element(std::uint32_t type, const std::string& content) {
  return words({type, static_cast<std::uint32_t>(content.size())}) + padded(content);
}

std::string doubles(const std::vector<double>& values) {
  return element(9, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]});
}

// The start of an array's content: class, dimensions and name.
std::string head(std::uint32_t kind, const std::vector<std::uint32_t>& shape, const std::string& name,
                 bool complex = false) {
  return element(6, words({kind | (complex ? 0x800U : 0U), 0})) + element(5, words(shape)) + element(1, name);
}

std::string array(const std::string& content) { return element(14, content); }

// `stated` replaces the length in the tag if it is not 0.
std::string compressed(const std::string& content, std::uint32_t stated = 0) {
  const std::string plain = words({14, stated == 0 ? static_cast<std::uint32_t>(content.size()) : stated}) + content;
  std::string out(plain.size() + 1000, '\0');
  uLongf size = out.size();
  compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(plain.data()), plain.size());
  out.resize(size);
  return words({15, static_cast<std::uint32_t>(size)}) + out;
}

// A structure of one field called a.
std::string structure(const std::string& name, const std::string& arrays, std::uint32_t elements = 1) {
  return head(kStruct, {1, elements}, name) + words({0x00040005U, 8}) + element(1, padded("a")) + arrays;
}

class MatContents : public testing::Test {
 protected:
  void write(const std::string& variables) const {
    std::string header = "MATLAB 5.0 MAT-file";
    header.resize(124, ' ');
    test::write_bytes(path_, header + std::string("\x00\x01IM", 4) + variables);
  }
  MatFile read(const std::string& variables) const {
    write(variables);
    return read_mat_file(path_);
  }
  std::string refusal(const std::string& variables) const {
    return input_error_of([&] { read(variables); });
  }
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("x.mat");
};

TEST_F(MatContents, AreReadInEveryForm) {
  const std::string plain = head(kDouble, {1, 2}, "x") + doubles({1.5, 2.5});
  for (const std::string& variable : {array(plain), compressed(plain)}) {
    const MatFile file = read(variable);
    ASSERT_THAT(file.variables, SizeIs(1));
    EXPECT_EQ(file.variables[0].name, "x");
    EXPECT_THAT(file.variables[0].real, ElementsAre(1.5, 2.5));
  }
  const MatFile complex = read(array(head(kDouble, {1, 2}, "z", true) + doubles({1, 2}) + doubles({3, 4})));
  EXPECT_THAT(complex.variables.at(0).imaginary, ElementsAre(3, 4));
  const std::string inner = array(head(kDouble, {1, 2}, "") + element(1, "\x05\x06"));
  for (const std::string& variable : {array(structure("s", inner)), compressed(structure("s", inner))})
    EXPECT_THAT(find_variable(read(variable), "s.a")->real, ElementsAre(5, 6));
  EXPECT_THAT(find_variable(read(array(head(kCell, {1, 1}, "c") + inner)), "c")->real, ElementsAre(5, 6));
  const std::string small = head(kDouble, {1, 2}, "x") + words({0x00020001U, 0x0605U});
  EXPECT_THAT(read(array(small)).variables.at(0).real, ElementsAre(5, 6)) << "content within the tag";
}

// libmatio would fill the missing numbers with uninitialised memory.
TEST_F(MatContents, MustBeAsManyNumbersAsTheirDimensionsState) {
  const std::string refused =
      "an array stores fewer numbers than it states (" + path_ + "); is it damaged? Save it again";
  for (const std::string& content :
       {head(kDouble, {1, 9}, "x") + doubles({1.5, 2.5}), head(kDouble, {1, 9}, "x") + element(1, "abcd"),
        head(kDouble, {1, 2}, "x") + element(16, "abcdefghijklmnop"), head(kDouble, {1, 2}, "x") + element(30, "ab"),
        head(kDouble, {1, 2}, "x") + words({0x00010001U, 5}), head(kDouble, {1, 2}, "x"),
        head(kDouble, {1, 2}, "x", true) + doubles({1, 2}) + doubles({3})}) {
    EXPECT_EQ(refusal(array(content)), refused);
    EXPECT_EQ(refusal(compressed(content)), refused);
    EXPECT_EQ(refusal(array(head(kCell, {1, 1}, "c") + array(content))), refused);
    EXPECT_EQ(refusal(compressed(structure("s", array(content)))), refused);
  }
  EXPECT_EQ(refusal(array(head(kDouble, {0x7FFFFFFF, 0x7FFFFFFF, 0x7FFFFFFF}, "x") + doubles({1}))), refused);
}

TEST_F(MatContents, StayWithinTheirLengths) {
  const std::string plain = head(kDouble, {1, 2}, "x") + doubles({1.5, 2.5});
  std::string longer = plain;
  longer[longer.size() - 20] = 100;  // the length of the numbers
  EXPECT_THAT(refusal(array(longer)), HasSubstr("the content of a variable exceeds its stated length"));
  const std::string inner = array(plain);
  EXPECT_THAT(refusal(array(head(kCell, {1, 1}, "c") + inner.substr(0, inner.size() - 8))),
              HasSubstr("the content of a variable exceeds its stated length"));
  const std::string packed = compressed(plain);
  EXPECT_THAT(refusal(compressed(plain, 1000)), HasSubstr("a compressed variable is damaged"));
  std::string broken = packed;
  broken[30] = static_cast<char>(broken[30] ^ 0x55);
  broken[31] = static_cast<char>(broken[31] ^ 0x55);
  EXPECT_THAT(refusal(broken), HasSubstr("a compressed variable is damaged"));
  const std::string cut =
      words({15, static_cast<std::uint32_t>(packed.size() - 20)}) + packed.substr(8, packed.size() - 20);
  EXPECT_THAT(refusal(cut), HasSubstr("a compressed variable is damaged"));
  EXPECT_THAT(refusal(compressed(plain, 0x10000000U)), HasSubstr("the file claims more numbers than it can hold"));
}

// libmatio refuses or skips these variables.
TEST_F(MatContents, OfUnexpectedFormAreLeftToTheLibrary) {
  const std::string flags = element(6, words({kDouble, 0})), shape = element(5, words({1, 9})), name = element(1, "x");
  const std::string fields = words({0x00040005U, 8}), short_one = array(flags + shape + name + doubles({1}));
  std::string nested = short_one;
  for (int level = 0; level < 16; ++level) nested = array(head(kCell, {1, 1}, "") + nested);
  for (const std::string& variable :
       {array("1234"), array(element(5, words({kDouble, 0})) + shape + name),
        array(element(6, words({kDouble, 0, 0, 0})) + shape + name), array(flags), array(flags + shape),
        array(flags + element(6, words({1, 9})) + name), array(flags + words({0x00040005U, 9}) + name),
        array(flags + element(5, "12345") + name), array(flags + element(5, words(std::vector(65, 1U))) + name),
        array(flags + element(5, words({1, 1, 0})) + name), array(head(kStruct, {1, 1}, "s")),
        array(head(kStruct, {1, 1}, "s") + element(5, words({8}))), array(head(kStruct, {1, 1}, "s") + fields),
        array(head(kStruct, {1, 1}, "s") + words({0x00040005U, 0}) + element(1, "a")), array(head(kCell, {1, 2}, "c")),
        array(head(kCell, {1, 1}, "c") + doubles({1})), nested, element(9, "12345678")}) {
    write(variable);
    EXPECT_NO_THROW(require_stored_numbers(path_));
  }
  EXPECT_THAT(refusal(short_one), HasSubstr("an array stores fewer numbers than it states"));
  test::write_bytes(path_, std::string(126, ' '));
  EXPECT_THAT(input_error_of([&] { require_stored_numbers(path_); }), HasSubstr("reading failed"));
}

// libmatio ends at the second variable, without an error.
TEST_F(MatContents, AreReadToTheLast) {
  const std::string good = array(head(kDouble, {1, 2}, "x") + doubles({1.5, 2.5}));
  const std::string long_shape = array(element(6, words({kDouble, 0})) + words({5, 5000, 1, 2}) + doubles({1.5, 2.5}));
  EXPECT_EQ(refusal(good + long_shape + good),
            "only 1 of 3 variables can be read (" + path_ + "); is it damaged? Save it again");
}

TEST_F(MatContents, NameWhatIsNotRead) {
  const auto notes = [&](const std::string& content) { return test::texts(read(array(content)).notes); };
  EXPECT_THAT(notes(head(kFunction, {1, 1}, "f")), ElementsAre("f is not read: it is a function"));
  const std::string object = "it is a string or an object (save it as char, or as a structure)";
  EXPECT_THAT(notes(head(kObject, {1, 1}, "o") + element(1, "class")), ElementsAre("o is not read: " + object));
  EXPECT_THAT(notes(head(kOpaque, {1, 1}, "q") + element(1, "MCOS")), ElementsAre("q is not read: " + object));
  EXPECT_THAT(notes(head(0, {1, 1}, "e")), IsEmpty());
}

TEST_F(MatContents, AreLeftOutWhenTheyHaveNoNumbers) {
  for (const std::string& content :
       {head(kDouble, {1, 1, 1, 1, 1, 1, 1, 1, 2}, "nine") + doubles({1, 2}),
        head(kDouble, {0, 3}, "none") + doubles({}), head(kCell, {0, 0}, "cells"),
        head(kCell, {1, 1}, "cell") + array(""),
        head(kStruct, {1, 1}, "fields") + words({0x00040005U, 8}) + element(1, ""), structure("elements", "", 0)})
    EXPECT_THAT(read(array(content)).variables, IsEmpty());
}

TEST_F(MatContents, AreTextsOfSeveralTypes) {
  const auto text = [&](std::uint32_t type, const std::string& stored, std::uint32_t length = 2) {
    return read(array(head(kChar, {1, length}, "t") + element(type, stored))).variables.at(0).text;
  };
  EXPECT_EQ(text(4, std::string("m\0s\0", 4)), "ms");
  EXPECT_EQ(text(17, std::string("m\0s\0", 4)), "ms");
  EXPECT_EQ(text(16, "ms"), "ms");
  EXPECT_EQ(text(16, "ms", 9), "");
  EXPECT_THAT(refusal(array(head(kChar, {0x7FFFFFFF, 0x7FFFFFFF, 0x7FFFFFFF}, "t") + element(16, "ms"))),
              HasSubstr("the file claims more numbers than it can hold"));
}

TEST_F(MatContents, AreTenThousandVariablesAtMost) {
  const std::string number = array(head(kDouble, {1, 1}, "") + doubles({1}));
  const std::string text = array(head(kChar, {1, 1}, "") + element(16, "t"));
  const auto cells = [&](std::uint32_t count) {
    std::string out = head(kCell, {1, count}, "c");
    for (std::uint32_t i = 0; i < count; ++i) out += i % 2 == 0 ? number : text;
    return array(out);
  };
  const std::string two = cells(4096) + cells(4096);
  std::string more;
  // 2 · 4096 + 1808 = 10 000.
  for (int n = 0; n < 1808; ++n) more += array(head(kDouble, {1, 1}, "n") + doubles({1}));
  EXPECT_THAT(read(two + more).variables, SizeIs(10'000));
  EXPECT_THAT(refusal(two + more + number), HasSubstr("more than 10000 variables"));
  EXPECT_THAT(refusal(two + cells(4096)), HasSubstr("more than 10000 variables"));
  EXPECT_THAT(refusal(cells(4097)), HasSubstr("more than 4096 elements in c"));
}

TEST_F(MatContents, AreMatricesOnlyOfEqualRows) {
  const auto of = [&](const std::vector<double>& values) {
    return array(head(kDouble, {1, static_cast<std::uint32_t>(values.size())}, "") + doubles(values));
  };
  const auto names = [&](const std::string& first, const std::string& second) {
    std::vector<std::string> out;
    for (const MatVariable& v : read(array(head(kCell, {1, 2}, "c") + first + second)).variables) out.push_back(v.name);
    return out;
  };
  const std::string complex = array(head(kDouble, {1, 1}, "", true) + doubles({1}) + doubles({2}));
  const std::string text = array(head(kChar, {1, 1}, "") + element(16, "t"));
  EXPECT_THAT(names(of({1}), of({2})), ElementsAre("c"));
  EXPECT_THAT(names(of({1}), of({2, 3})), ElementsAre("c{1}", "c{2}"));
  EXPECT_THAT(names(of({1}), complex), ElementsAre("c{1}", "c{2}"));
  EXPECT_THAT(names(text, of({1})), ElementsAre("c{1}", "c{2}"));
  EXPECT_THAT(names(array(""), of({1})), ElementsAre("c{2}"));
  EXPECT_THAT(names(of({1}), array("")), ElementsAre("c{1}"));
}

}  // namespace percuss::acquire::mat_contents_test
