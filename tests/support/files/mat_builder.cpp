#include "support/files/mat_builder.hpp"

#include <gtest/gtest.h>
#include <matio.h>

#include <array>
#include <cstdint>
#include <vector>

namespace percuss::test {
namespace {

mat_t* file_of(void* file) { return static_cast<mat_t*>(file); }

matvar_t* array_of(const std::string& name, std::vector<std::size_t> shape, const std::vector<double>& values) {
  return Mat_VarCreate(name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int>(shape.size()), shape.data(),
                       const_cast<double*>(values.data()), 0);
}

matvar_t* text_variable(const char* name, const std::string& text) {
  std::array<std::size_t, 2> dims{1, text.size()};
  return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, dims.data(), const_cast<char*>(text.data()), 0);
}

}  // namespace

MatBuilder::MatBuilder(const std::string& path, MatLevel level)
    : file_(Mat_CreateVer(path.c_str(), "MATLAB 5.0 MAT-file, for a test",
                          level == MatLevel::v4    ? MAT_FT_MAT4
                          : level == MatLevel::v73 ? MAT_FT_MAT73
                                                   : MAT_FT_MAT5)),
      compressed_(level == MatLevel::v5_compressed) {
  EXPECT_NE(file_, nullptr);
}

MatBuilder::~MatBuilder() { Mat_Close(file_of(file_)); }

void MatBuilder::write(void* variable) {
  auto* const made = static_cast<matvar_t*>(variable);
  EXPECT_EQ(Mat_VarWrite(file_of(file_), made, compressed_ ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE), 0);
  Mat_VarFree(made);
}

MatBuilder& MatBuilder::numbers(const std::string& name, const std::vector<std::size_t>& shape,
                                const std::vector<double>& values) {
  write(array_of(name, shape, values));
  return *this;
}

MatBuilder& MatBuilder::singles(const std::string& name, const std::vector<std::size_t>& shape,
                                const std::vector<float>& values) {
  std::vector<std::size_t> dims = shape;
  matvar_t* const variable = Mat_VarCreate(name.c_str(), MAT_C_SINGLE, MAT_T_SINGLE, static_cast<int>(dims.size()),
                                           dims.data(), const_cast<float*>(values.data()), 0);
  write(variable);
  return *this;
}

MatBuilder& MatBuilder::bytes_of_zero(const std::string& name, std::size_t count) {
  std::vector<std::uint8_t> zeros(count);
  std::array<std::size_t, 2> dims{1, count};
  matvar_t* const variable =
      Mat_VarCreate(name.c_str(), MAT_C_UINT8, MAT_T_UINT8, 2, dims.data(), zeros.data(), MAT_F_DONT_COPY_DATA);
  write(variable);
  return *this;
}

MatBuilder& MatBuilder::complex(const std::string& name, const std::vector<std::size_t>& shape,
                                const std::vector<std::complex<double>>& values) {
  std::vector<std::size_t> dims = shape;
  std::vector<double> real, imaginary;
  for (const auto& value : values) {
    real.push_back(value.real());
    imaginary.push_back(value.imag());
  }
  mat_complex_split_t parts{real.data(), imaginary.data()};
  matvar_t* const variable = Mat_VarCreate(name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int>(dims.size()),
                                           dims.data(), &parts, MAT_F_COMPLEX);
  write(variable);
  return *this;
}

MatBuilder& MatBuilder::text(const std::string& name, const std::string& text) {
  write(text_variable(name.c_str(), text));
  return *this;
}

MatBuilder& MatBuilder::structure(const std::string& name, const std::vector<std::string>& fields,
                                  const std::vector<std::vector<std::vector<double>>>& elements) {
  std::vector<const char*> names;
  names.reserve(fields.size());
  for (const auto& field : fields) names.push_back(field.c_str());
  std::array<std::size_t, 2> dims{1, elements.size()};
  matvar_t* const variable =
      Mat_VarCreateStruct(name.c_str(), 2, dims.data(), names.data(), static_cast<unsigned>(names.size()));
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (std::size_t f = 0; f < fields.size(); ++f) {
      const auto& values = elements[e][f];
      Mat_VarSetStructFieldByIndex(variable, f, e, array_of(fields[f], {1, values.size()}, values));
    }
  }
  write(variable);
  return *this;
}

MatBuilder& MatBuilder::channels(const std::string& name, const std::vector<MatChannel>& channels) {
  std::array<const char*, 3> fields{"name", "data", "unit"};
  std::array<std::size_t, 2> dims{1, channels.size()};
  matvar_t* const variable = Mat_VarCreateStruct(name.c_str(), 2, dims.data(), fields.data(), fields.size());

  for (std::size_t c = 0; c < channels.size(); ++c) {
    const MatChannel& channel = channels[c];
    Mat_VarSetStructFieldByIndex(variable, 0, c, text_variable("name", channel.name));
    Mat_VarSetStructFieldByIndex(variable, 1, c, array_of("data", {1, channel.data.size()}, channel.data));
    Mat_VarSetStructFieldByIndex(variable, 2, c, text_variable("unit", channel.unit));
  }
  write(variable);
  return *this;
}

}  // namespace percuss::test
