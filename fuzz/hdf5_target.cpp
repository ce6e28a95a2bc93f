#include <hdf5.h>

#include <map>
#include <numeric>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "acquire/formats/hdf5/read_frf_hdf5.hpp"
#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "recipe.hpp"
#include "targets.hpp"

namespace percuss::fuzz {
namespace {

using acquire::hdf5::Handle;

constexpr std::size_t kMaxSize = std::size_t{1} << 40U;

Handle complex_type() {
  Handle type(H5Tcreate(H5T_COMPOUND, 2 * sizeof(double)));
  H5Tinsert(type.get(), "r", 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(type.get(), "i", sizeof(double), H5T_NATIVE_DOUBLE);
  return type;
}

Handle type_named(const std::string& name) {
  static const std::map<std::string, hid_t> kTypes{
      {"f4", H5T_IEEE_F32LE}, {"f8", H5T_IEEE_F64LE}, {">f8", H5T_IEEE_F64BE}, {"i1", H5T_STD_I8LE},
      {"i2", H5T_STD_I16LE},  {"i4", H5T_STD_I32LE},  {">i8", H5T_STD_I64BE},  {"u2", H5T_STD_U16LE}};
  if (name == "complex") return complex_type();
  if (name == "text") return Handle(H5Tcopy(H5T_C_S1));
  const auto found = kTypes.find(name);
  return Handle(H5Tcopy(found != kTypes.end() ? found->second : H5T_IEEE_F64LE));
}

Handle space_of(const std::vector<std::size_t>& shape) {
  const std::vector<hsize_t> sizes(shape.begin(), shape.end());
  return Handle(sizes.empty() ? H5Screate(H5S_SCALAR)
                              : H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr));
}

// Adds a data set for the recipe line
//   set NAME TYPE SHAPE [chunk] [gzip] [nan] [claimed]
// A claimed set has a size but no values.
void add_set(hid_t file, const RecipeLine& line) {
  const std::vector<std::size_t> shape = line.sizes(3, kMaxSize);
  std::size_t count = 1;
  bool small = shape.size() < 8;
  for (const std::size_t size : shape) {
    small = small && size <= kMaxElements && count * size <= kMaxElements;
    count *= small ? size : 1;
  }
  const Handle type = type_named(line.word(2)), space = space_of(shape), creation(H5Pcreate(H5P_DATASET_CREATE));
  if ((line.has("chunk") || line.has("gzip")) && !shape.empty()) {
    std::vector<hsize_t> chunk(shape.size(), 1);
    chunk.back() = std::min<hsize_t>(8, std::max<std::size_t>(1, shape.back()));
    H5Pset_chunk(creation.get(), static_cast<int>(chunk.size()), chunk.data());
    if (line.has("gzip")) H5Pset_deflate(creation.get(), 1);
  }
  const Handle set(
      H5Dcreate2(file, line.word(1).c_str(), type.get(), space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT));
  if (!set || !small || line.has("claimed")) return;
  const std::vector<double> values = recipe_values(2 * count, line.has("nan"));
  const Handle memory = line.word(2) == "complex" ? complex_type() : Handle(H5Tcopy(H5T_NATIVE_DOUBLE));
  H5Dwrite(set.get(), memory.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
}

// Adds an attribute for the recipe line
//   number OBJECT NAME VALUES | text OBJECT NAME TEXT
void add_attribute(hid_t file, const RecipeLine& line) {
  const bool text = line.word(0) == "text";
  const std::vector<double> values = line.numbers(3);
  const std::string letters = line.word(3) + ' ';
  const Handle type(H5Tcopy(text ? H5T_C_S1 : H5T_NATIVE_DOUBLE));
  if (text) H5Tset_size(type.get(), letters.size());
  const Handle space = space_of(text || values.size() == 1 ? std::vector<std::size_t>{} : std::vector{values.size()});
  const Handle attribute(H5Acreate_by_name(file, line.word(1).c_str(), line.word(2).c_str(), type.get(), space.get(),
                                           H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  if (!attribute || (!text && values.empty())) return;
  H5Awrite(attribute.get(), type.get(), text ? static_cast<const void*>(letters.data()) : values.data());
}

void write_hdf5_from_recipe(const std::string& path, std::string_view recipe) {
  const Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  for (const RecipeLine& line : recipe_lines(recipe)) {
    const std::string kind = line.word(0);
    if (kind == "set") add_set(file.get(), line);
    if (kind == "number" || kind == "text") add_attribute(file.get(), line);
    if (kind == "group")
      Handle(H5Gcreate2(file.get(), line.word(1).c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)).close();
    if (kind == "soft")
      H5Lcreate_soft(line.word(2).c_str(), file.get(), line.word(1).c_str(), H5P_DEFAULT, H5P_DEFAULT);
    if (kind == "external") {
      H5Lcreate_external(line.word(2).c_str(), "/x", file.get(), line.word(1).c_str(), H5P_DEFAULT, H5P_DEFAULT);
    }
  }
}

}  // namespace

// Reads a well-formed HDF5 file whose data sets and attributes the recipe in `bytes` states.
void run_hdf5(std::string_view bytes) {
  const MemfdFile file("");
  {
    const acquire::hdf5::Lock lock;
    write_hdf5_from_recipe(file.path(), bytes);
  }
  accepted([&] {
    if (auto frfs = acquire::read_frf_hdf5(file.path())) acquire::to_accelerances(std::move(*frfs), {});
  });
  for (const acquire::ReadOptions& options : {acquire::ReadOptions{}, acquire::ReadOptions{.fs_Hz = 1000}})
    accepted([&] { read_all(acquire::open_hdf5(file.path(), options)); });
}

}  // namespace percuss::fuzz
