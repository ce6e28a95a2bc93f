#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace percuss::acquire {

/// A variable of a MAT file, or a field of a structure in it ("test.force").
struct MatVariable {
  std::string name;
  std::vector<std::size_t> shape;  // MATLAB's order: the first index runs fastest
  std::vector<double> real;        // numbers, or real parts
  std::vector<double> imaginary;   // imaginary parts; empty for real numbers
  std::string text;                // content of a char array
  bool is_text = false;
  bool is_abscissa = false;       // taken out of a matrix by split_abscissas
  std::size_t columns_taken = 0;  // columns of the file before the first one of `shape` (split_abscissas)

  bool is_complex() const { return !imaginary.empty(); }
  std::size_t size() const { return real.size(); }
};

struct MatFile {
  std::string path;
  std::uint64_t bytes = 0;
  std::vector<MatVariable> variables;
  std::vector<Message> notes;  // parts that could not be read
};

/// Whether these first bytes are the start of a MAT file of level 4, 5 or 7.3.
bool is_mat(std::string_view head);

/// Reads all variables of numbers and texts; fields of structures and cells become variables. In a structure array or
/// cell array, real arrays of equal size become a matrix [elements, size]; matrices of one shape become an array
/// [elements, shorter side, longer side]. A structure array whose texts name channels (name, label, …; one of them a
/// force) gives variables of these names. The notes name sparse arrays, functions, objects and other variables that are
/// not read.
/// errors  InputError: damaged; data or links in other files; more numbers than claim_limit_bytes allows.
MatFile read_mat_file(const std::string& path);

/// The variable of this name (letter case aside), else nullptr.
const MatVariable* find_variable(const MatFile& file, std::string_view name);

/// "4096x1"
std::string shape_name(const std::vector<std::size_t>& shape);

}  // namespace percuss::acquire
