#include "acquire/formats/mat/mat_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "acquire/formats/mat/mat_variable_reader.hpp"
#include "support/files/mat_builder.hpp"
#include "support/input_error.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::acquire::mat_file_test {

using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// A MAT file of level 5 with variables of any class.
class MatWriter {
 public:
  explicit MatWriter(const std::string& path) : file_(Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5)) {}
  ~MatWriter() { Mat_Close(file_); }
  MatWriter(const MatWriter&) = delete;
  MatWriter& operator=(const MatWriter&) = delete;

  template <class Number>
  static matvar_t* numbers(const char* name, matio_classes kind, matio_types type) {
    std::array<Number, 2> values{Number{1}, Number{2}};
    std::array<std::size_t, 2> shape{1, 2};
    return Mat_VarCreate(name, kind, type, 2, shape.data(), values.data(), 0);
  }
  static matvar_t* cell(const char* name, std::vector<matvar_t*> items) {
    std::array<std::size_t, 2> shape{1, items.size()};
    items.push_back(nullptr);
    return Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, shape.data(), items.data(), 0);
  }
  void put(matvar_t* variable) {
    Mat_VarWrite(file_, variable, MAT_COMPRESSION_NONE);
    Mat_VarFree(variable);
  }

 private:
  mat_t* file_;
};

class MatFiles : public testing::Test {
 protected:
  test::ScratchFolder folder_;
  std::string path_ = folder_.file("x.mat");
};

// A header claims 2^60 elements with 16 fields: the count of their values does not fit into 64 bits.
TEST(MatVariableReader, RefusesAStructureWhoseCountOfValuesOverflows) {
  std::array<std::string, 16> names;
  std::array<const char*, 16> texts{};
  for (std::size_t f = 0; f < names.size(); ++f) texts[f] = (names[f] = "f" + std::to_string(f)).c_str();
  std::array<std::size_t, 2> shape{1, 1};
  const std::unique_ptr<matvar_t, decltype(&Mat_VarFree)> structure(
      Mat_VarCreateStruct("s", 2, shape.data(), texts.data(), texts.size()), Mat_VarFree);
  ASSERT_NE(structure, nullptr);
  const std::array<std::size_t, 2> stored{structure->dims[0], structure->dims[1]};
  structure->dims[0] = structure->dims[1] = std::size_t{1} << 30U;
  MatFile out;
  acquire::MatVariableReader reader(out, 1'000'000);
  EXPECT_THAT(input_error_of([&] { reader.check_claim(structure.get()); }), HasSubstr("claims more numbers"));
  std::copy(stored.begin(), stored.end(), structure->dims);  // Mat_VarFree frees as many values as these state
}

TEST_F(MatFiles, HoldNumbersOfEveryType) {
  {
    MatWriter file(path_);
    file.put(MatWriter::numbers<double>("f8", MAT_C_DOUBLE, MAT_T_DOUBLE));
    file.put(MatWriter::numbers<float>("f4", MAT_C_SINGLE, MAT_T_SINGLE));
    file.put(MatWriter::numbers<std::int8_t>("i1", MAT_C_INT8, MAT_T_INT8));
    file.put(MatWriter::numbers<std::uint8_t>("u1", MAT_C_UINT8, MAT_T_UINT8));
    file.put(MatWriter::numbers<std::int16_t>("i2", MAT_C_INT16, MAT_T_INT16));
    file.put(MatWriter::numbers<std::uint16_t>("u2", MAT_C_UINT16, MAT_T_UINT16));
    file.put(MatWriter::numbers<std::int32_t>("i4", MAT_C_INT32, MAT_T_INT32));
    file.put(MatWriter::numbers<std::uint32_t>("u4", MAT_C_UINT32, MAT_T_UINT32));
    file.put(MatWriter::numbers<std::int64_t>("i8", MAT_C_INT64, MAT_T_INT64));
    file.put(MatWriter::numbers<std::uint64_t>("u8", MAT_C_UINT64, MAT_T_UINT64));
  }
  const MatFile read = read_mat_file(path_);
  ASSERT_THAT(read.variables, SizeIs(10));
  for (const auto& variable : read.variables) EXPECT_THAT(variable.real, ElementsAre(1, 2)) << variable.name;
  EXPECT_NE(find_variable(read, "F8"), nullptr);
  EXPECT_EQ(find_variable(read, "none"), nullptr);
}

TEST_F(MatFiles, HoldCellsAsMatricesOrOneByOne) {
  {
    MatWriter file(path_);
    const auto pair = [] { return MatWriter::numbers<double>(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE); };
    file.put(MatWriter::cell("alike", {pair(), pair(), pair()}));
    file.put(MatWriter::cell("mixed", {pair(), MatWriter::cell(nullptr, {pair(), pair()})}));
    file.put(MatWriter::cell("single", {pair()}));
  }
  const MatFile read = read_mat_file(path_);
  ASSERT_NE(find_variable(read, "alike"), nullptr);
  EXPECT_THAT(find_variable(read, "alike")->shape, ElementsAre(3, 2));
  EXPECT_THAT(find_variable(read, "alike")->real, ElementsAre(1, 1, 1, 2, 2, 2));
  EXPECT_NE(find_variable(read, "mixed{1}"), nullptr);
  EXPECT_NE(find_variable(read, "mixed{2}"), nullptr);
  EXPECT_NE(find_variable(read, "single"), nullptr);
}

// Cell arrays with a matrix for each hit: [samples, channels], [channels, samples], and matrices of unlike shape.
TEST_F(MatFiles, StackMatricesAsHitsChannelsAndSamples) {
  const auto matrix = [](std::size_t rows, std::size_t columns, double first) {
    std::array<std::size_t, 2> shape{rows, columns};
    std::vector<double> values(rows * columns);
    std::iota(values.begin(), values.end(), first);
    return Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, shape.data(), values.data(), 0);
  };
  {
    MatWriter file(path_);
    file.put(MatWriter::cell("upright", {matrix(3, 2, 0), matrix(3, 2, 10)}));
    file.put(MatWriter::cell("lying", {matrix(2, 3, 0), matrix(2, 3, 10)}));
    file.put(MatWriter::cell("unlike", {matrix(2, 3, 0), matrix(3, 2, 10)}));
  }
  const MatFile read = read_mat_file(path_);
  const MatVariable* const upright = find_variable(read, "upright");
  ASSERT_NE(upright, nullptr);
  EXPECT_THAT(upright->shape, ElementsAre(2, 2, 3));
  EXPECT_THAT(upright->real, ElementsAre(0, 10, 3, 13, 1, 11, 4, 14, 2, 12, 5, 15));
  const MatVariable* const lying = find_variable(read, "lying");
  ASSERT_NE(lying, nullptr);
  EXPECT_THAT(lying->shape, ElementsAre(2, 2, 3));
  EXPECT_THAT(lying->real, ElementsAre(0, 10, 1, 11, 2, 12, 3, 13, 4, 14, 5, 15));
  ASSERT_NE(find_variable(read, "unlike"), nullptr);
  EXPECT_THAT(find_variable(read, "unlike")->shape, ElementsAre(2, 6));
}

TEST_F(MatFiles, KeepTheNamesOfInnerFields) {
  const auto with_field = [](const char* field) {
    const std::array<std::size_t, 2> one{1, 1};
    const std::array<const char*, 2> fields{field, nullptr};
    matvar_t* out = Mat_VarCreateStruct2(nullptr, 2, one.data(), fields.data());
    Mat_VarSetStructFieldByName(out, field, 0, MatWriter::numbers<double>(field, MAT_C_DOUBLE, MAT_T_DOUBLE));
    return out;
  };
  {
    MatWriter file(path_);
    file.put(MatWriter::cell("same", {with_field("force"), with_field("force")}));
    file.put(MatWriter::cell("other", {with_field("force"), with_field("accel")}));
  }
  const MatFile read = read_mat_file(path_);
  ASSERT_THAT(read.variables, SizeIs(3));
  ASSERT_NE(find_variable(read, "same.force"), nullptr);
  EXPECT_THAT(find_variable(read, "same.force")->shape, ElementsAre(2, 2));
  EXPECT_NE(find_variable(read, "other{1}.force"), nullptr);
  EXPECT_NE(find_variable(read, "other{2}.accel"), nullptr);
}

// One structure per hit in a cell array is a structure array in another form.
TEST_F(MatFiles, ReadCellsOfStructuresAsAStructureArray) {
  const auto hit = [] {
    const std::array<std::size_t, 2> one{1, 1};
    const std::array<const char*, 3> fields{"force", "acc", nullptr};
    matvar_t* out = Mat_VarCreateStruct2(nullptr, 2, one.data(), fields.data());
    for (const char* field : {"force", "acc"})
      Mat_VarSetStructFieldByName(out, field, 0, MatWriter::numbers<double>(field, MAT_C_DOUBLE, MAT_T_DOUBLE));
    return out;
  };
  {
    MatWriter file(path_);
    file.put(MatWriter::cell("test", {hit(), hit(), hit()}));
  }
  const MatFile read = read_mat_file(path_);
  ASSERT_THAT(read.variables, SizeIs(2));
  for (const char* name : {"test.force", "test.acc"}) {
    ASSERT_NE(find_variable(read, name), nullptr) << name;
    EXPECT_THAT(find_variable(read, name)->shape, ElementsAre(3, 2)) << name;
  }
}

TEST_F(MatFiles, NameWhatIsNotRead) {
  {
    MatWriter file(path_);
    std::array<mat_uint32_t, 2> rows{0, 1}, starts{0, 2};
    std::array<double, 2> values{3, 4};
    mat_sparse_t sparse{};
    sparse.nzmax = 2;
    sparse.ir = rows.data();
    sparse.nir = 2;
    sparse.jc = starts.data();
    sparse.njc = 2;
    sparse.ndata = 2;
    sparse.data = values.data();
    std::array<std::size_t, 2> shape{2, 1}, empty{0, 0};
    std::array<std::size_t, 9> nine{1, 2, 1, 1, 1, 1, 1, 1, 1};
    file.put(Mat_VarCreate("thin", MAT_C_SPARSE, MAT_T_DOUBLE, 2, shape.data(), &sparse, MAT_F_DONT_COPY_DATA));
    file.put(Mat_VarCreate("nothing", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, empty.data(), values.data(), 0));
    file.put(Mat_VarCreate("far", MAT_C_DOUBLE, MAT_T_DOUBLE, 9, nine.data(), values.data(), 0));
    file.put(MatWriter::numbers<double>("x", MAT_C_DOUBLE, MAT_T_DOUBLE));
  }
  const MatFile read = read_mat_file(path_);
  ASSERT_THAT(read.notes, SizeIs(2));
  EXPECT_THAT(read.notes.front().text, HasSubstr("thin is not read: it is sparse (save full(…))"));
  EXPECT_THAT(read.notes.back().text, HasSubstr("far is not read: it has 9 dimensions"));
  EXPECT_THAT(read.variables, SizeIs(1));
}

TEST_F(MatFiles, HoldComplexNumbersTextsAndStructures) {
  test::MatBuilder(path_, test::MatLevel::v5_compressed)
      .complex("c", {1, 2}, {{1, 2}, {3, 4}})
      .text("t", "text")
      .structure("s", {"a", "b"}, {{{1, 2}, {3}}, {{4, 5}, {6, 7}}});
  const MatFile read = read_mat_file(path_);
  EXPECT_THAT(find_variable(read, "c")->imaginary, ElementsAre(2, 4));
  EXPECT_EQ(find_variable(read, "t")->text, "text");
  EXPECT_THAT(find_variable(read, "s.a")->shape, ElementsAre(2, 2));    // of equal length: a matrix
  EXPECT_THAT(find_variable(read, "s.b(2)")->real, ElementsAre(6, 7));  // otherwise one by one
}

TEST_F(MatFiles, AreRefusedWhenNestedTooDeep) {
  {
    MatWriter file(path_);
    matvar_t* inner = MatWriter::numbers<double>(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE);
    for (int depth = 0; depth < 12; ++depth) inner = MatWriter::cell(depth < 11 ? nullptr : "deep", {inner});
    file.put(inner);
  }
  EXPECT_THAT(input_error_of([&] { read_mat_file(path_); }), HasSubstr("more than 8 deep"));
}

TEST_F(MatFiles, AreRefusedWhenNoMatFile) {
  test::write_bytes(path_, "MATLAB 5.0");
  EXPECT_THAT(input_error_of([&] { read_mat_file(path_); }), HasSubstr("cannot be read"));
}

}  // namespace percuss::acquire::mat_file_test
