#pragma once
#include <complex>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "acquire/formats/hdf5/hdf5_handle.hpp"
#include "core/io/atomic_file.hpp"

namespace percuss::acquire::hdf5 {

/// complex128 is a compound {r, i} of two float64, as h5py reads and writes complex numbers.
enum class Stored { float64, int32, complex128 };

/// An HDF5 file that appears whole under its name, or not at all. Equal calls give equal bytes: no time stamps,
/// little-endian numbers. Each member locks the library for its own duration.
/// errors  InputError from every member: the file exists (without `force`) or cannot be written.
class OutputHdf5 {
 public:
  OutputHdf5(const std::string& path, bool force);
  ~OutputHdf5();
  OutputHdf5(const OutputHdf5&) = delete;
  OutputHdf5& operator=(const OutputHdf5&) = delete;

  /// Creates a group, such as "bat-1/run-0", and its parents. Names of sets in it begin with its name.
  void create_group(const std::string& name);
  void create_set(const std::string& name, std::span<const std::size_t> shape, Stored type = Stored::float64);
  /// Elements first … first + values.size() − 1 along the last dimension, at index `at` of the others.
  void write(const std::string& set, std::span<const std::size_t> at, std::size_t first,
             std::span<const double> values);
  void write(const std::string& set, std::span<const std::size_t> at, std::size_t first,
             std::span<const std::complex<double>> values);
  /// Attributes of a set or group, or of the root for an empty name. One number is stored as a scalar unless `array` is
  /// set.
  void set_numbers(const std::string& set, const std::string& name, std::span<const double> values, bool array);
  void set_text(const std::string& set, const std::string& name, const std::string& text);
  /// Closes the sets and groups made so far: open objects cost memory.
  void close_sets();
  /// Moves the file to its place. Call it once, last.
  void commit();

 private:
  Id object(const std::string& set) const;
  void write_as(Id memory_type, const std::string& set, std::span<const std::size_t> at, std::size_t first,
                std::size_t count, const void* values);
  void check(bool done) const;

  std::string path_;
  AtomicFile atomic_file_;
  Handle file_;
  std::map<std::string, Handle> sets_;
};

}  // namespace percuss::acquire::hdf5
