#include "acquire/formats/mat/mat_file.hpp"

#include <fmt/format.h>
#include <matio.h>
#include <sys/stat.h>

#include <algorithm>
#include <memory>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "acquire/formats/hdf5/hdf5_self_contained.hpp"
#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/formats/mat/mat_completeness.hpp"
#include "acquire/formats/mat/mat_stored_numbers.hpp"
#include "acquire/record/sample_limits.hpp"
#include "core/error.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMaxVariables = 10'000, kMaxDepth = 8, kMaxElements = 4096;
constexpr std::size_t kMaxMatDimensions = 8, kNameShown = 63;

void ignore_log(int, char*) {}

struct CloseMat {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeMat {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};

template <class Stored>
void append_as_double(std::vector<double>& out, const void* data, std::size_t count) {
  const auto* values = static_cast<const Stored*>(data);
  out.reserve(count);
  for (std::size_t i = 0; i < count; ++i) out.push_back(static_cast<double>(values[i]));
}

bool to_doubles(matio_types type, const void* data, std::size_t count, std::vector<double>& out) {
  switch (type) {
    case MAT_T_DOUBLE:
      return append_as_double<double>(out, data, count), true;
    case MAT_T_SINGLE:
      return append_as_double<float>(out, data, count), true;
    case MAT_T_INT8:
      return append_as_double<std::int8_t>(out, data, count), true;
    case MAT_T_UINT8:
      return append_as_double<std::uint8_t>(out, data, count), true;
    case MAT_T_INT16:
      return append_as_double<std::int16_t>(out, data, count), true;
    case MAT_T_UINT16:
      return append_as_double<std::uint16_t>(out, data, count), true;
    case MAT_T_INT32:
      return append_as_double<std::int32_t>(out, data, count), true;
    case MAT_T_UINT32:
      return append_as_double<std::uint32_t>(out, data, count), true;
    case MAT_T_INT64:
      return append_as_double<std::int64_t>(out, data, count), true;
    case MAT_T_UINT64:
      return append_as_double<std::uint64_t>(out, data, count), true;
    default:
      return false;
  }
}

bool is_number_class(matio_classes kind) { return kind >= MAT_C_DOUBLE && kind <= MAT_C_UINT64; }

// Turns the fields and cells of variables into variables of their own.
class Flattener {
 public:
  Flattener(MatFile& out, std::uint64_t limit_bytes) : out_(out), left_bytes_(limit_bytes) {}

  // Checks the sizes that the headers claim, before any number is read.
  void check_claim(const matvar_t* variable, std::size_t depth = 0) {
    if (variable == nullptr || variable->dims == nullptr) return;
    if (depth > kMaxDepth) refuse("structures within structures more than 8 deep");
    const std::uint64_t count = elements(variable);
    if (variable->class_type == MAT_C_STRUCT || variable->class_type == MAT_C_CELL) {
      const std::uint64_t fields =
          variable->class_type == MAT_C_CELL ? 1 : Mat_VarGetNumberOfFields(to_mutable(variable));
      const auto* const children = static_cast<matvar_t* const*>(variable->data);
      spend(count * fields, sizeof(matvar_t*));
      for (std::uint64_t i = 0; children != nullptr && i < count * fields; ++i) check_claim(children[i], depth + 1);
      return;
    }
    const bool numbers = is_number_class(variable->class_type);  // become doubles
    const std::uint64_t each_bytes = numbers ? sizeof(double) : static_cast<std::uint64_t>(variable->data_size);
    spend(count, std::max<std::uint64_t>(each_bytes, 1) * (variable->isComplex != 0 ? 2 : 1));
  }

  void add(const std::string& name, const matvar_t* variable) {
    if (variable == nullptr || variable->dims == nullptr) return;
    if (out_.variables.size() >= kMaxVariables) refuse("more than 10000 variables");
    if (is_number_class(variable->class_type)) return add_numbers(name, variable);
    if (variable->class_type == MAT_C_CHAR) return add_text(name, variable);
    if (variable->class_type == MAT_C_STRUCT) return add_structure(name, variable);
    if (variable->class_type == MAT_C_CELL) {
      const auto* const cells = static_cast<matvar_t* const*>(variable->data);
      if (cells != nullptr) add_elements(name, {cells, cells + elements(variable)}, '{', '}');
      return;
    }
    if (variable->class_type == MAT_C_EMPTY) return;
    const bool sparse = variable->class_type == MAT_C_SPARSE;
    const bool function = variable->class_type == MAT_C_FUNCTION;
    out_.notes.emplace_back(fmt::format("{} is not read: it is {}", one_line(name, kNameShown),
                                        sparse     ? "sparse (save full(…))"
                                        : function ? "a function"
                                                   : "a string or an object (save it as char, or as a structure)"));
  }

 private:
  static matvar_t* to_mutable(const matvar_t* variable) { return const_cast<matvar_t*>(variable); }  // NOLINT: C

  static std::uint64_t elements(const matvar_t* variable) {
    std::uint64_t count = 1;
    for (int i = 0; i < variable->rank; ++i) {
      const std::uint64_t size = variable->dims[i];
      if (size != 0 && count > UINT64_MAX / 16 / size) return UINT64_MAX / 16;
      count *= size;
    }
    return count;
  }

  void spend(std::uint64_t count, std::uint64_t each_bytes) {
    if (count > left_bytes_ / each_bytes) refuse("the file claims more numbers than it can hold");
    left_bytes_ -= count * each_bytes;
  }

  [[noreturn]] void refuse(const std::string& problem) const {
    throw InputError(problem, out_.path, "is it damaged? Save it again");
  }

  static MatVariable described(const std::string& name, const matvar_t* variable) {
    MatVariable out{.name = name};
    for (int i = 0; i < variable->rank; ++i) out.shape.push_back(variable->dims[i]);
    return out;
  }

  void add_numbers(const std::string& name, const matvar_t* variable) {
    if (variable->rank < 1 || static_cast<std::size_t>(variable->rank) > kMaxMatDimensions) return;
    MatVariable out = described(name, variable);
    const std::uint64_t count = elements(variable);
    const std::uint64_t stored =
        static_cast<std::uint64_t>(variable->nbytes) / static_cast<std::uint64_t>(std::max(variable->data_size, 1));
    if (count == 0) return;
    if (variable->data == nullptr || stored < count) refuse(one_line(name, kNameShown) + " cannot be read");
    bool known = true;
    if (variable->isComplex != 0) {
      const auto* const parts = static_cast<const mat_complex_split_t*>(variable->data);
      if (parts->Re == nullptr || parts->Im == nullptr) refuse(one_line(name, kNameShown) + " cannot be read");
      known = to_doubles(variable->data_type, parts->Re, count, out.real) &&
              to_doubles(variable->data_type, parts->Im, count, out.imaginary);
    } else {
      known = to_doubles(variable->data_type, variable->data, count, out.real);
    }
    if (known) out_.variables.push_back(std::move(out));
  }

  void add_text(const std::string& name, const matvar_t* variable) {
    MatVariable out = described(name, variable);
    out.is_text = true;
    const std::uint64_t count = elements(variable);
    const bool wide = variable->data_type == MAT_T_UINT16 || variable->data_type == MAT_T_UTF16;
    const std::size_t each = wide ? 2 : 1;
    if (variable->data != nullptr && variable->nbytes >= count * each) {
      const auto* const bytes = static_cast<const char*>(variable->data);
      for (std::uint64_t i = 0; i < count; ++i) out.text += bytes[i * each];  // the low byte: units are ASCII
    }
    out_.variables.push_back(std::move(out));
  }

  void add_structure(const std::string& name, const matvar_t* variable) {
    const std::size_t fields = Mat_VarGetNumberOfFields(to_mutable(variable));
    char* const* const names = Mat_VarGetStructFieldnames(variable);
    const auto* const values = static_cast<matvar_t* const*>(variable->data);
    const std::uint64_t count = elements(variable);
    if (names == nullptr || values == nullptr) return;
    for (std::size_t f = 0; f < fields; ++f) {
      std::vector<const matvar_t*> column;
      for (std::uint64_t e = 0; e < count; ++e) column.push_back(values[e * fields + f]);
      if (names[f] != nullptr) add_elements(name + "." + names[f], column, '(', ')');
    }
  }

  // Adds one field of several elements: as one matrix if the fields are vectors of equal length, else one by one.
  void add_elements(const std::string& name, const std::vector<const matvar_t*>& elements_of, char open, char close) {
    if (elements_of.empty()) return;
    if (elements_of.size() == 1) return add(name, elements_of.front());
    if (elements_of.size() > kMaxElements) refuse("more than 4096 elements in " + one_line(name, kNameShown));
    MatFile parts{.path = out_.path};
    Flattener within(parts, UINT64_MAX);
    bool alike = true;
    for (std::size_t e = 0; e < elements_of.size(); ++e) {
      within.add(fmt::format("{}{}{}{}", name, open, e + 1, close), elements_of[e]);
      alike = alike && parts.variables.size() == e + 1;
    }
    const auto same = [&](const MatVariable& v) {
      return !v.is_text && !v.is_complex() && v.size() == parts.variables.front().size();
    };
    if (alike && std::all_of(parts.variables.begin(), parts.variables.end(), same)) {
      const std::size_t rows = parts.variables.size(), length = parts.variables.front().size();
      MatVariable stacked{.name = name, .shape = {rows, length}};
      stacked.real.resize(rows * length);
      for (std::size_t i = 0; i < rows * length; ++i) stacked.real[i] = parts.variables[i % rows].real[i / rows];
      out_.variables.push_back(std::move(stacked));
    } else {
      for (MatVariable& part : parts.variables) out_.variables.push_back(std::move(part));
    }
    out_.notes.insert(out_.notes.end(), parts.notes.begin(), parts.notes.end());
    if (out_.variables.size() > kMaxVariables) refuse("more than 10000 variables");
  }

  MatFile& out_;
  std::uint64_t left_bytes_;
};

}  // namespace

std::string shape_name(const std::vector<std::size_t>& shape) { return fmt::format("{}", fmt::join(shape, "x")); }

MatFile read_mat_file(const std::string& path) {
  first_bytes(path, 1);  // refuses anything but a regular file
  MatFile out{.path = path};
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) out.bytes = static_cast<std::uint64_t>(status.st_size);
  const hdf5::Lock lock;  // level 7.3 is HDF5; the lock also guards matio's global state
  if (is_hdf5(path)) hdf5::require_self_contained(path);
  Mat_LogInitFunc("percuss", ignore_log);
  const std::unique_ptr<mat_t, CloseMat> file(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  if (!file) throw InputError("the MAT file cannot be read", path, "is it damaged? Save it again");
  if (Mat_GetVersion(file.get()) == MAT_FT_MAT5) {
    require_complete_mat(path, MatLevel::v5);
    require_stored_numbers(path);
  }
  if (Mat_GetVersion(file.get()) == MAT_FT_MAT4) require_complete_mat(path, MatLevel::v4);
  Flattener flatten(out, claim_limit_bytes(out.bytes));
  while (true) {
    const std::unique_ptr<matvar_t, FreeMat> variable(Mat_VarReadNextInfo(file.get()));
    if (!variable) break;
    const std::string name = variable->name == nullptr ? "" : variable->name;
    flatten.check_claim(variable.get());
    const bool readable = is_number_class(variable->class_type) || variable->class_type == MAT_C_CHAR ||
                          variable->class_type == MAT_C_STRUCT || variable->class_type == MAT_C_CELL;
    if (readable && Mat_VarReadDataAll(file.get(), variable.get()) != 0)
      throw InputError(one_line(name, kNameShown) + " cannot be read", path, "is it damaged? Save it again");
    flatten.add(name, variable.get());
  }
  return out;
}

const MatVariable* find_variable(const MatFile& file, std::string_view name) {
  const std::string wanted = lower_case(name);
  for (const MatVariable& variable : file.variables) {
    if (lower_case(variable.name) == wanted) return &variable;
  }
  return nullptr;
}

}  // namespace percuss::acquire
