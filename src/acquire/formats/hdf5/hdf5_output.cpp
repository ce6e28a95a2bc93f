#include "acquire/formats/hdf5/hdf5_output.hpp"

#include <hdf5.h>

#include <cassert>

#include "core/error.hpp"
#include "core/library_call.hpp"

namespace percuss::acquire::hdf5 {
namespace {

constexpr std::size_t kWorkingMemory_bytes = std::size_t{4} << 20U;  // upper estimate for one call of the library

// Locks the library, and checks that memory for one call is available: HDF5 crashes when memory runs out while it
// writes.
struct WriteLock {
  Lock lock{};
  LibraryCall call{kWorkingMemory_bytes};
};

Handle complex_type(Id part) {
  Handle type(H5Tcreate(H5T_COMPOUND, 2 * H5Tget_size(part)));
  H5Tinsert(type.get(), "r", 0, part);
  H5Tinsert(type.get(), "i", H5Tget_size(part), part);
  return type;
}

Handle file_type(Stored type) {
  if (type == Stored::complex128) return complex_type(H5T_IEEE_F64LE);
  return Handle(H5Tcopy(type == Stored::int32 ? H5T_STD_I32LE : H5T_IEEE_F64LE));
}

}  // namespace

OutputHdf5::OutputHdf5(const std::string& path, bool force)
    : path_(path), atomic_file_(path, force, AtomicFile::Temporary::named) {
  const WriteLock lock;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_file_locking(access.get(), false, true);  // as for reading; no other process knows this file yet
  file_ = Handle(H5Fcreate(atomic_file_.temporary_path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()));
  check(static_cast<bool>(file_));
}

OutputHdf5::~OutputHdf5() {
  const Lock lock;
  const LibraryCall call;
  sets_.clear();
  file_.close();
}

void OutputHdf5::create_group(const std::string& name) {
  const WriteLock lock;
  const Handle links(H5Pcreate(H5P_LINK_CREATE)), creation(H5Pcreate(H5P_GROUP_CREATE));
  H5Pset_create_intermediate_group(links.get(), 1);
  H5Pset_obj_track_times(creation.get(), false);
  Handle group(H5Gcreate2(file_.get(), name.c_str(), links.get(), creation.get(), H5P_DEFAULT));
  check(static_cast<bool>(group));
  sets_[name] = std::move(group);
}

void OutputHdf5::create_set(const std::string& name, std::span<const std::size_t> shape, Stored type) {
  const WriteLock lock;
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr));
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(creation.get(), false);
  H5Pset_fill_time(creation.get(), H5D_FILL_TIME_NEVER);  // each element is written anyway
  const Handle stored = file_type(type);
  Handle set(
      H5Dcreate2(file_.get(), name.c_str(), stored.get(), space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT));
  check(static_cast<bool>(set));
  sets_[name] = std::move(set);
}

void OutputHdf5::write(const std::string& set, std::span<const std::size_t> at, std::size_t first,
                       std::span<const double> values) {
  write_as(H5T_NATIVE_DOUBLE, set, at, first, values.size(), values.data());
}

void OutputHdf5::write(const std::string& set, std::span<const std::size_t> at, std::size_t first,
                       std::span<const std::complex<double>> values) {
  const WriteLock lock;
  const Handle type = complex_type(H5T_NATIVE_DOUBLE);
  write_as(type.get(), set, at, first, values.size(), values.data());
}

void OutputHdf5::write_as(Id memory_type, const std::string& set, std::span<const std::size_t> at, std::size_t first,
                          std::size_t count, const void* values) {
  const WriteLock lock;
  std::vector<hsize_t> start(at.begin(), at.end()), counts(at.size(), 1);
  start.push_back(first);
  counts.push_back(count);
  const hsize_t length = count;
  const Handle file_space(H5Dget_space(object(set)));
  const Handle memory_space(H5Screate_simple(1, &length, nullptr));
  assert(static_cast<std::size_t>(H5Sget_simple_extent_ndims(file_space.get())) == start.size());
  check(H5Sselect_hyperslab(file_space.get(), H5S_SELECT_SET, start.data(), nullptr, counts.data(), nullptr) >= 0 &&
        H5Dwrite(object(set), memory_type, memory_space.get(), file_space.get(), H5P_DEFAULT, values) >= 0);
}

void OutputHdf5::set_numbers(const std::string& set, const std::string& name, std::span<const double> values,
                             bool array) {
  assert(array || values.size() == 1);
  const WriteLock lock;
  const hsize_t length = values.size();
  const Handle space(array ? H5Screate_simple(1, &length, nullptr) : H5Screate(H5S_SCALAR));
  const Handle attribute(H5Acreate2(object(set), name.c_str(), H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT));
  check(attribute && H5Awrite(attribute.get(), H5T_NATIVE_DOUBLE, values.data()) >= 0);
}

void OutputHdf5::set_text(const std::string& set, const std::string& name, const std::string& text) {
  const WriteLock lock;
  // Variable length: h5py and MATLAB show such a text as text, but a text of fixed length as bytes.
  const Handle type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), H5T_VARIABLE);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  const Handle space(H5Screate(H5S_SCALAR));
  const Handle attribute(H5Acreate2(object(set), name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
  const char* const bytes = text.c_str();
  check(attribute && H5Awrite(attribute.get(), type.get(), static_cast<const void*>(&bytes)) >= 0);
}

void OutputHdf5::close_sets() {
  const WriteLock lock;
  bool done = true;
  for (auto& [name, set] : sets_) done = set.close() && done;
  sets_.clear();
  check(done);
}

void OutputHdf5::commit() {
  {
    const WriteLock lock;
    const bool flushed = H5Fflush(file_.get(), H5F_SCOPE_LOCAL) >= 0;
    close_sets();
    check(file_.close() && flushed);
  }
  atomic_file_.commit();
}

hid_t OutputHdf5::object(const std::string& set) const { return set.empty() ? file_.get() : sets_.at(set).get(); }

void OutputHdf5::check(bool done) const {
  if (!done) throw InputError("cannot write HDF5", path_, "free some space or choose another folder");
}

}  // namespace percuss::acquire::hdf5
