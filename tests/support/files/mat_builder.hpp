#pragma once
#include <complex>
#include <string>
#include <vector>

namespace percuss::test {

enum class MatLevel { v4, v5, v5_compressed, v73 };

/// An element of a structure array.
struct MatChannel {
  std::string name;
  std::vector<double> data;
  std::string unit;
};

/// Writes MAT files with libmatio, which percuss does not use for writing.
class MatBuilder {
 public:
  MatBuilder(const std::string& path, MatLevel level);
  ~MatBuilder();
  MatBuilder(const MatBuilder&) = delete;
  MatBuilder& operator=(const MatBuilder&) = delete;

  /// `values` in MATLAB's order: the first index varies fastest.
  MatBuilder& numbers(const std::string& name, const std::vector<std::size_t>& shape,
                      const std::vector<double>& values);
  MatBuilder& singles(const std::string& name, const std::vector<std::size_t>& shape, const std::vector<float>& values);
  /// A row vector of zeros of 8 bits.
  MatBuilder& bytes_of_zero(const std::string& name, std::size_t count);
  MatBuilder& complex(const std::string& name, const std::vector<std::size_t>& shape,
                      const std::vector<std::complex<double>>& values);
  MatBuilder& text(const std::string& name, const std::string& text);
  /// A structure array: elements[e][f] is a row vector in field f.
  MatBuilder& structure(const std::string& name, const std::vector<std::string>& fields,
                        const std::vector<std::vector<std::vector<double>>>& elements);
  /// A structure array with the fields name, data and unit.
  MatBuilder& channels(const std::string& name, const std::vector<MatChannel>& channels);

 private:
  /// Writes a variable of libmatio and frees it.
  void write(void* variable);

  void* file_;
  bool compressed_;
};

}  // namespace percuss::test
