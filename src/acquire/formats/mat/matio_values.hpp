#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

struct matvar_t;  // of matio

namespace percuss::acquire {

/// A field of a structure array, with its value in each element.
struct MatField {
  std::string name;
  std::vector<const matvar_t*> values;
};

}  // namespace percuss::acquire

/// What a variable of matio holds, for MatVariableReader.
namespace percuss::acquire::matio {

/// Appends numbers of the variable's type. False if the type is no number.
bool to_doubles(const matvar_t* variable, const void* data, std::size_t count, std::vector<double>& out);

/// Whether the class of the variable holds numbers of a fixed width, as double, single and int32 do.
bool holds_numbers(const matvar_t* variable);

/// The product of the dimensions, at most UINT64_MAX/16.
std::uint64_t element_count(const matvar_t* variable);

std::size_t field_count(const matvar_t* structure);

/// The low byte of each character of a text: units are ASCII.
std::string text_of(const matvar_t* variable);

std::vector<MatField> fields_of(const matvar_t* structure);

/// The fields of cells that each hold one structure of the same fields, as of a structure array; otherwise none.
std::vector<MatField> fields_of_cells(const std::vector<const matvar_t*>& cells);

}  // namespace percuss::acquire::matio
