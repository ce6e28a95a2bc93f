#include "acquire/formats/mat/mat_file.hpp"

#include <fmt/format.h>
#include <matio.h>
#include <sys/stat.h>

#include <cerrno>
#include <memory>
#include <new>
#include <optional>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "acquire/formats/hdf5/hdf5_padded_text.hpp"
#include "acquire/formats/hdf5/hdf5_self_contained.hpp"
#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/formats/mat/mat_completeness.hpp"
#include "acquire/formats/mat/mat_stored_numbers.hpp"
#include "acquire/formats/mat/mat_variable_reader.hpp"
#include "acquire/record/sample_limits.hpp"
#include "core/error.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {
namespace {

void ignore_log(int, char*) {}

// Without memory the library drops a variable or its name, and reports nothing. The C library then leaves ENOMEM.
template <class Call>
auto with_memory(const Call& call) {
  errno = 0;
  auto result = call();
  if (errno == ENOMEM) throw std::bad_alloc();
  return result;
}

struct CloseMat {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeMat {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};

}  // namespace

std::string shape_name(const std::vector<std::size_t>& shape) { return fmt::format("{}", fmt::join(shape, "x")); }

MatFile read_mat_file(const std::string& path) {
  first_bytes(path, 1);  // refuses anything but a regular file
  MatFile out{.path = path};
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) out.bytes = static_cast<std::uint64_t>(status.st_size);
  const hdf5::Lock lock;  // level 7.3 is HDF5; the lock also guards matio's global state
  const bool hdf5_inside = is_hdf5(path);
  if (hdf5_inside) hdf5::require_self_contained(path);
  Mat_LogInitFunc("percuss", ignore_log);
  std::optional<hdf5::PaddedTextConversion> padded_text;
  if (hdf5_inside) padded_text.emplace();
  const auto file =
      with_memory([&] { return std::unique_ptr<mat_t, CloseMat>(Mat_Open(path.c_str(), MAT_ACC_RDONLY)); });
  if (!file) throw InputError("the MAT file cannot be read", path, "is it damaged? Save it again");
  std::optional<std::size_t> stored;
  if (Mat_GetVersion(file.get()) == MAT_FT_MAT5) {
    stored = require_complete_mat(path, MatLevel::v5);
    require_stored_numbers(path);
  }
  if (Mat_GetVersion(file.get()) == MAT_FT_MAT4) stored = require_complete_mat(path, MatLevel::v4);
  MatVariableReader reader(out, claim_limit_bytes(out.bytes));
  std::size_t read = 0;
  while (true) {
    const auto variable =
        with_memory([&] { return std::unique_ptr<matvar_t, FreeMat>(Mat_VarReadNextInfo(file.get())); });
    if (!variable) break;
    const std::string name = variable->name == nullptr ? "" : variable->name;
    reader.check_claim(variable.get());
    const auto read_data = [&] { return Mat_VarReadDataAll(file.get(), variable.get()); };
    if (MatVariableReader::reads(variable.get()) && with_memory(read_data) != 0) {
      throw InputError(one_line(name, MatVariableReader::kNameShown) + " cannot be read", path,
                       "is it damaged? Save it again");
    }
    reader.add(name, variable.get());
    ++read;
  }
  // The library ends without an error at a variable that it cannot read.
  if (stored && read != *stored) {
    throw InputError(fmt::format("only {} of {} variables can be read", read, *stored), path,
                     "is it damaged? Save it again");
  }
  if (hdf5_inside && out.variables.empty() && out.notes.empty()) {
    throw InputError(
        "no array has the attribute MATLAB_class as a text of fixed length, which marks the arrays of a MAT file", path,
        "save it with MATLAB, Octave or SciPy, or as HDF5 without MATLAB's first 512 bytes");
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
