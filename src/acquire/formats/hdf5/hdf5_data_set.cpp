#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <optional>

#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "acquire/record/sample_limits.hpp"
#include "core/error.hpp"

namespace percuss::acquire::hdf5 {
namespace {

// A library call that gets an invalid identifier from a failed call fails too. So only the last call of a chain is
// checked.

constexpr std::size_t kDefaultCache_bytes = std::size_t{1} << 20, kMaxCache_bytes = std::size_t{64} << 20;
constexpr std::uint64_t kMaxCountedChunks = 200'000;  // more are not counted: counting walks an index
constexpr int kMaxDimensions = 3;
const char* const kWriteAnew = "copy the file again or write it anew";

// The object that `name` leads to within this file; invalid when there is none.
Handle open_object(hid_t file, const std::string& name) {
  const Handle access = access_within_file();
  return Handle(H5Oopen(file, name.c_str(), access.get()));
}

Handle open_set(hid_t file, const std::string& name, std::size_t cache_bytes) {
  const Handle access(H5Pcreate(H5P_DATASET_ACCESS));
  refuse_other_files(access.get());
  H5Pset_chunk_cache(access.get(), H5D_CHUNK_CACHE_NSLOTS_DEFAULT, cache_bytes, H5D_CHUNK_CACHE_W0_DEFAULT);
  return Handle(H5Dopen2(file, name.c_str(), access.get()));
}

bool is_link_to_other_file(hid_t file, const std::string& name) {
  const Handle access = access_within_file();
  H5L_info_t info{};
  return H5Lget_info(file, name.c_str(), &info, access.get()) >= 0 && info.type == H5L_TYPE_EXTERNAL;
}

bool is_plain_number(hid_t type) {
  const std::array known{H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_IEEE_F64BE, H5T_IEEE_F32BE, H5T_STD_I8LE,
                         H5T_STD_I16LE,  H5T_STD_I32LE,  H5T_STD_I64LE,  H5T_STD_U8LE,   H5T_STD_U16LE,
                         H5T_STD_U32LE,  H5T_STD_U64LE,  H5T_STD_I8BE,   H5T_STD_I16BE,  H5T_STD_I32BE,
                         H5T_STD_I64BE,  H5T_STD_U8BE,   H5T_STD_U16BE,  H5T_STD_U32BE,  H5T_STD_U64BE};
  return std::any_of(known.begin(), known.end(), [type](hid_t one) { return H5Tequal(type, one) > 0; });
}

// Copies the name of a member and frees the library's text.
std::string member_name(hid_t type, unsigned member) {
  char* const name = H5Tget_member_name(type, member);
  std::string copy = name == nullptr ? "" : name;
  H5free_memory(name);
  return copy;
}

// The names of the members of a complex number: r and i, re and im, or real and imag.
std::optional<std::array<std::string, 2>> complex_members(hid_t type) {
  if (H5Tget_class(type) != H5T_COMPOUND || H5Tget_nmembers(type) != 2) return std::nullopt;
  std::array<std::string, 2> names;
  for (unsigned i = 0; i < 2; ++i) {
    const Handle member(H5Tget_member_type(type, i));
    if (!is_plain_number(member.get())) return std::nullopt;
    names.at(i) = member_name(type, i);
  }
  const bool known = (names[0] == "r" && names[1] == "i") || (names[0] == "re" && names[1] == "im") ||
                     (names[0] == "real" && names[1] == "imag");
  return known ? std::optional(names) : std::nullopt;
}

std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  constexpr auto kMax = std::numeric_limits<std::uint64_t>::max();
  return b != 0 && a > kMax / b ? kMax : a * b;
}

void check_filters(hid_t creation, const std::string& where) {
  for (unsigned i = 0; i < static_cast<unsigned>(H5Pget_nfilters(creation)); ++i) {
    unsigned flags = 0, config = 0;
    std::size_t values = 0;
    std::array<char, 80> name{};
    const H5Z_filter_t filter =
        H5Pget_filter2(creation, i, &flags, &values, nullptr, name.size() - 1, name.data(), &config);
    if (filter == H5Z_FILTER_DEFLATE || filter == H5Z_FILTER_SHUFFLE || filter == H5Z_FILTER_FLETCHER32) continue;
    throw InputError("compressed with filter " + std::to_string(filter) + " (" + name.data() + ")", where,
                     "store it uncompressed or with gzip");
  }
}

}  // namespace

InputDataSet::InputDataSet(const InputHdf5& file, const std::string& name, Elements elements)
    : where_(file.where(name)) {
  open(file, name);
  read_shape();
  check_type(elements);
  check_storage(file, name);
}

void InputDataSet::open(const InputHdf5& file, const std::string& name) {
  const char* const remedy = "store the samples in this file";
  if (is_link_to_other_file(file.id(), name)) throw InputError("link to another file", where_, remedy);
  Handle object = open_object(file.id(), name);
  if (!object) throw InputError("damaged, or a link that leads nowhere in this file", where_, remedy);
  if (H5Iget_type(object.get()) != H5I_DATASET) throw InputError("not a data set", where_, "store an array of numbers");
  set_ = std::move(object);
}

void InputDataSet::check_type(Elements elements) const {
  const Handle type(H5Dget_type(set_.get()));
  if (elements == Elements::complex) {
    if (complex_members(type.get())) return;
    throw InputError(
        "not an array of complex numbers", where_,
        "store compounds of two floats r and i (as h5py does with complex128), re and im, or real and imag");
  }
  if (!is_plain_number(type.get())) {
    throw InputError("not an array of integers or floats of 32 or 64 bits", where_, "store float32 or float64");
  }
}

void InputDataSet::read_shape() {
  const Handle space(H5Dget_space(set_.get()));
  const int dimensions = H5Sget_simple_extent_ndims(space.get());
  if (dimensions < 0) damaged();
  if (dimensions > kMaxDimensions) {
    throw InputError("has " + std::to_string(dimensions) + " dimensions", where_, "store three or fewer");
  }
  std::array<hsize_t, kMaxDimensions> extent{};
  H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr);
  shape_.assign(extent.begin(), extent.begin() + dimensions);
  const Handle type(H5Dget_type(set_.get()));
  element_bytes_ = H5Tget_size(type.get());
  const bool empty = H5Sget_simple_extent_type(space.get()) == H5S_NULL;
  elements_ = empty ? 0 : 1;
  for (const std::size_t size : shape_) elements_ = times(elements_, size);
}

void InputDataSet::check_storage(const InputHdf5& file, const std::string& name) {
  const std::uint64_t file_bytes = file.bytes();
  const Handle creation(H5Dget_create_plist(set_.get()));
  if (!creation) damaged();
  const H5D_layout_t layout = H5Pget_layout(creation.get());
  if (layout == H5D_VIRTUAL || H5Pget_external_count(creation.get()) != 0) {
    throw InputError("its samples are in other files", where_, "store them in this file");
  }
  const std::uint64_t claimed = times(elements_, element_bytes_);
  const std::uint64_t decoded = times(elements_, std::max(element_bytes_, sizeof(double)));
  const std::uint64_t claim_limit = claim_limit_bytes(file_bytes);
  const bool compressed = H5Pget_nfilters(creation.get()) > 0;
  const std::uint64_t stored = H5Dget_storage_size(set_.get());
  if (compressed ? decoded > claim_limit || (stored == 0 && claimed > 0) : claimed > stored || claimed > file_bytes) {
    throw InputError("claims " + std::to_string(claimed) + " bytes, the file holds " +
                         std::to_string(compressed ? file_bytes : std::min(stored, file_bytes)),
                     where_, kWriteAnew);
  }

  if (layout == H5D_CONTIGUOUS && claimed > 0 && H5Dget_offset(set_.get()) > file_bytes - claimed) {
    throw InputError("its samples lie beyond the end of the file", where_, kWriteAnew);
  }
  if (layout == H5D_CHUNKED) check_chunks(file, name, creation.get(), claim_limit);
}

void InputDataSet::check_chunks(const InputHdf5& file, const std::string& name, hid_t creation,
                                std::uint64_t claim_limit) {
  check_filters(creation, where_);
  std::array<hsize_t, kMaxDimensions> chunk{};
  if (H5Pget_chunk(creation, kMaxDimensions, chunk.data()) != static_cast<int>(shape_.size())) damaged();
  std::uint64_t chunk_bytes = element_bytes_, expected = 1;
  for (std::size_t d = 0; d < shape_.size(); ++d) {
    if (chunk[d] == 0) damaged();
    chunk_bytes = times(chunk_bytes, chunk[d]);
    expected = times(expected, (shape_[d] + chunk[d] - 1) / chunk[d]);
  }
  if (chunk_bytes > claim_limit) throw InputError("claims chunks larger than the file", where_, kWriteAnew);
  hsize_t present = 0;
  const Handle space(H5Dget_space(set_.get()));  // HDF5 1.10.8 refuses H5S_ALL here
  if (expected <= kMaxCountedChunks && H5Dget_num_chunks(set_.get(), space.get(), &present) < 0) damaged();
  if (expected <= kMaxCountedChunks && present < expected) {
    throw InputError("holds " + std::to_string(present) + " of its " + std::to_string(expected) + " chunks", where_,
                     "record it again: it was never completed");
  }
  if (chunk_bytes <= kDefaultCache_bytes || chunk_bytes > kMaxCache_bytes) return;
  // A chunk larger than the cache would be decompressed again for each of its rows.
  set_.close();
  set_ = open_set(file.id(), name, chunk_bytes);
  if (!set_) damaged();
}

std::optional<InputDataSet::ContiguousStorage> InputDataSet::contiguous() const {
  const Handle creation(H5Dget_create_plist(set_.get())), type(H5Dget_type(set_.get()));
  if (H5Pget_layout(creation.get()) != H5D_CONTIGUOUS) return std::nullopt;
  const bool known = H5Tequal(type.get(), H5T_IEEE_F64LE) > 0 || H5Tequal(type.get(), H5T_IEEE_F32LE) > 0;
  const haddr_t offset = H5Dget_offset(set_.get());
  return known && offset != HADDR_UNDEF ? std::optional(ContiguousStorage{offset, element_bytes_}) : std::nullopt;
}

void InputDataSet::read(std::span<const std::size_t> at, std::size_t first, std::span<double> out) const {
  read_as(H5T_NATIVE_DOUBLE, at, first, out.size(), out.data());
}

void InputDataSet::read(std::span<const std::size_t> at, std::size_t first, std::span<std::complex<double>> out) const {
  const Handle stored(H5Dget_type(set_.get()));
  const auto members = complex_members(stored.get());
  if (!members) damaged();
  const Handle type(H5Tcreate(H5T_COMPOUND, sizeof(std::complex<double>)));
  H5Tinsert(type.get(), (*members)[0].c_str(), 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(type.get(), (*members)[1].c_str(), sizeof(double), H5T_NATIVE_DOUBLE);
  read_as(type.get(), at, first, out.size(), out.data());
}

void InputDataSet::read_as(hid_t memory_type, std::span<const std::size_t> at, std::size_t first,
                           std::size_t count_last, void* out) const {
  assert(at.size() + 1 == shape_.size());
  std::array<hsize_t, kMaxDimensions> start{}, count{};
  for (std::size_t d = 0; d < at.size(); ++d) {
    start[d] = at[d];
    count[d] = 1;
  }
  start[at.size()] = first;
  count[at.size()] = count_last;
  const hsize_t length = count_last;
  const Handle file_space(H5Dget_space(set_.get()));
  const Handle memory_space(H5Screate_simple(1, &length, nullptr));
  if (H5Sselect_hyperslab(file_space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) < 0 ||
      H5Dread(set_.get(), memory_type, memory_space.get(), file_space.get(), H5P_DEFAULT, out) < 0) {
    damaged();
  }
}

std::vector<double> InputDataSet::read_all() const {
  std::vector<double> values(elements_);
  if (values.empty()) return values;
  if (H5Dread(set_.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) damaged();
  return values;
}

void InputDataSet::damaged() const { throw InputError("cannot be read: damaged", where_, kWriteAnew); }

}  // namespace percuss::acquire::hdf5
