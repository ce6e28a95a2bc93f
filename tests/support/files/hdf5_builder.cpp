#include "support/files/hdf5_builder.hpp"

#include <stdexcept>

namespace percuss::test {
namespace {

hid_t checked(hid_t id) {
  if (id < 0) throw std::runtime_error("test file cannot be written");
  return id;
}

}  // namespace

Hdf5Builder::Hdf5Builder(const std::string& path)
    : file_(checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT))) {}

Hdf5Builder::~Hdf5Builder() { H5Fclose(file_); }

Hdf5Builder& Hdf5Builder::ramp(const std::string& name, const std::vector<hsize_t>& shape, const Hdf5Storage& storage) {
  std::size_t count = storage.written ? 1 : 0;
  for (const hsize_t size : shape) count *= size;
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = ramp_value(i);
  return values(name, shape, all, storage);
}

Hdf5Builder& Hdf5Builder::values(const std::string& name, const std::vector<hsize_t>& shape,
                                 const std::vector<double>& values, const Hdf5Storage& storage) {
  const hid_t space = checked(shape.empty() ? H5Screate(H5S_SCALAR)
                                            : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  if (!storage.chunk.empty()) {
    H5Pset_chunk(creation, static_cast<int>(storage.chunk.size()), storage.chunk.data());
    if (storage.gzip >= 0) H5Pset_deflate(creation, static_cast<unsigned>(storage.gzip));
  }
  const hid_t set = checked(H5Dcreate2(file_, name.c_str(), storage.type, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  if (storage.written && !values.empty()) {
    checked(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  }
  H5Dclose(set);
  H5Pclose(creation);
  H5Sclose(space);
  return *this;
}

Hdf5Builder& Hdf5Builder::numbers(const std::string& object, const std::string& name,
                                  const std::vector<double>& values) {
  const hsize_t count = values.size();
  const hid_t space = values.size() == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr);
  const hid_t attribute = checked(H5Acreate_by_name(file_, ("/" + object).c_str(), name.c_str(), H5T_NATIVE_DOUBLE,
                                                    space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, values.data());
  H5Aclose(attribute);
  H5Sclose(space);
  return *this;
}

Hdf5Builder& Hdf5Builder::text(const std::string& object, const std::string& name, const std::string& text,
                               bool fixed) {
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, fixed ? text.size() + 3 : H5T_VARIABLE);
  if (fixed) H5Tset_strpad(type, H5T_STR_SPACEPAD);
  const hid_t attribute = checked(H5Acreate_by_name(file_, ("/" + object).c_str(), name.c_str(), type, space,
                                                    H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  const std::string padded = text + "   ";
  const char* const bytes = fixed ? padded.c_str() : text.c_str();
  H5Awrite(attribute, type, fixed ? static_cast<const void*>(bytes) : static_cast<const void*>(&bytes));
  H5Aclose(attribute);
  H5Tclose(type);
  H5Sclose(space);
  return *this;
}

double ramp_value(std::size_t index) { return static_cast<double>(index % 64) - 20; }

}  // namespace percuss::test
