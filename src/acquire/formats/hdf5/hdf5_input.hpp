#pragma once
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "acquire/formats/hdf5/hdf5_handle.hpp"

namespace percuss::acquire::hdf5 {

// The caller holds a Lock.

/// An untrusted file, open for reading. Each error message names the path.
/// errors  InputError: it cannot be opened, is not HDF5, is truncated or damaged.
class InputHdf5 {
 public:
  explicit InputHdf5(std::string path);

  const std::string& path() const { return path_; }
  std::uint64_t bytes() const { return bytes_; }
  Id id() const { return file_.get(); }

  /// Whether the root group has a link of this name, or this path without links to other files.
  bool has(const std::string& name) const;
  /// Names in the root group, in order, at most `limit` of them.
  std::vector<std::string> names(std::size_t limit) const;
  /// Paths of the links to other objects than groups, without the first slash, at most `limit` of them. Enters groups
  /// by hard links only, and stops after 10 000 links.
  std::vector<std::string> data_paths(std::size_t limit) const;
  /// "path: /name", the place in a message.
  std::string where(const std::string& name) const { return path_ + ": /" + name; }

 private:
  std::string path_;
  std::uint64_t bytes_ = 0;
  Handle file_;
};

/// The required elements of a data set: integers and floats, or complex numbers: compounds of two numbers named r and
/// i (as h5py writes them), re and im, or real and imag.
enum class Elements { real, complex };

/// A numeric data set, by its name in the root group or its path, checked to lie within its file before any sample is
/// read. errors  InputError: links to other files, groups, other types than integers and IEEE floats, sizes that the
/// file cannot hold, compression other than gzip.
class InputDataSet {
 public:
  InputDataSet(const InputHdf5& file, const std::string& name, Elements elements = Elements::real);

  /// Number of elements along each dimension; empty for a scalar.
  const std::vector<std::size_t>& shape() const { return shape_; }
  std::size_t elements() const { return elements_; }
  Id id() const { return set_.get(); }
  /// "path: /name", the place in a message.
  const std::string& where() const { return where_; }

  /// The place of the numbers in the file, when they are contiguous in C order and little-endian IEEE floats.
  struct ContiguousStorage {
    std::uint64_t offset_bytes, number_bytes;
  };
  std::optional<ContiguousStorage> contiguous() const;

  /// Elements first … first + out.size() − 1 along the last dimension, at index `at` of the others. InputError when
  /// they cannot be decoded.
  void read(std::span<const std::size_t> at, std::size_t first, std::span<double> out) const;
  /// The same for a set of complex numbers.
  void read(std::span<const std::size_t> at, std::size_t first, std::span<std::complex<double>> out) const;
  /// All elements, in C order; for small sets.
  std::vector<double> read_all() const;

 private:
  void open(const InputHdf5& file, const std::string& name);
  void check_type(Elements elements) const;
  void read_shape();
  void check_storage(const InputHdf5& file, const std::string& name);
  void check_chunks(const InputHdf5& file, const std::string& name, Id creation, std::uint64_t claim_limit);
  void read_as(Id memory_type, std::span<const std::size_t> at, std::size_t first, std::size_t count, void* out) const;
  [[noreturn]] void damaged() const;

  std::string where_;
  Handle set_;
  std::vector<std::size_t> shape_;
  std::size_t elements_ = 1, element_bytes_ = 0;
};

/// The numbers of an attribute, nothing when it is absent. InputError when it does not hold 1 … `limit` numbers.
std::optional<std::vector<double>> number_attribute(Id object, const std::string& name, const std::string& where,
                                                    std::size_t limit);

/// The text of an attribute, nothing when it is absent. InputError when it is not one text.
std::optional<std::string> text_attribute(Id object, const std::string& name, const std::string& where);

/// The date that an attribute of the object states: "date", "timestamp", "start_time", …; empty without one.
std::string date_attribute(Id object);

}  // namespace percuss::acquire::hdf5
