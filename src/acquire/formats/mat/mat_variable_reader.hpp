#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "acquire/formats/mat/mat_file.hpp"

struct matvar_t;  // of matio

namespace percuss::acquire {

struct MatField;

/// Turns the variables of a MAT file, with the fields and cells in them, into variables of `out`.
/// errors  InputError: more than 10000 variables, 4096 elements or 8 levels; more numbers than the file can hold; a
/// variable that cannot be read.
class MatVariableReader {
 public:
  static constexpr std::size_t kNameShown = 63;  // characters of a name in a message

  /// `limit_bytes`: of all numbers that the headers may claim.
  MatVariableReader(MatFile& out, std::uint64_t limit_bytes) : out_(out), left_bytes_(limit_bytes) {}

  /// Checks the sizes that the headers claim, before any number is read.
  void check_claim(const matvar_t* variable, std::size_t depth = 0);

  /// Adds a variable whose data are read. A note names what is skipped.
  void add(const std::string& name, const matvar_t* variable);

  /// Whether `add` needs the data of such a variable.
  static bool reads(const matvar_t* variable);

 private:
  void skip(const std::string& name, const std::string& why);
  void spend(std::uint64_t count, std::uint64_t each_bytes);
  [[noreturn]] void refuse(const std::string& problem) const;
  void add_numbers(const std::string& name, const matvar_t* variable);
  void add_text(const std::string& name, const matvar_t* variable);
  void add_structure(const std::string& name, const matvar_t* variable);
  void add_fields(const std::string& name, const std::vector<MatField>& fields);
  // Adds a structure array whose elements are channels of these names. If only one field holds samples, its variables
  // are named as the channels, so that a unit in the name is found; otherwise CHANNEL.FIELD.
  void add_channels(const std::vector<std::string>& names, const std::vector<MatField>& fields);
  // Adds the cells of a cell array, or one field of a structure array: as one array whose first index is the element if
  // all elements are real arrays of equal size and equal name, else one by one.
  void add_elements(const std::string& name, const std::vector<const matvar_t*>& elements_of, char open, char close);

  MatFile& out_;
  std::uint64_t left_bytes_;
};

}  // namespace percuss::acquire
