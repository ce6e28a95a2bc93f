#pragma once
#include <hdf5.h>

#include <string>
#include <vector>

namespace percuss::test {

struct Hdf5Storage {
  hid_t type = H5T_NATIVE_DOUBLE;  // type in the file
  std::vector<hsize_t> chunk;      // empty: contiguous
  int gzip = -1;                   // level, −1 for none
  bool written = true;             // false: the data set is declared only
};

/// Writes valid and invalid HDF5 files directly with the HDF5 library.
///   Hdf5Builder(path).numbers("", "fs", {1000}).ramp("force", {2, 8}).ramp("accel", {2, 1, 8});
class Hdf5Builder {
 public:
  explicit Hdf5Builder(const std::string& path);
  ~Hdf5Builder();
  Hdf5Builder(const Hdf5Builder&) = delete;
  Hdf5Builder& operator=(const Hdf5Builder&) = delete;

  /// A data set whose element i in C order is ramp_value(i).
  Hdf5Builder& ramp(const std::string& name, const std::vector<hsize_t>& shape, const Hdf5Storage& storage = {});
  Hdf5Builder& values(const std::string& name, const std::vector<hsize_t>& shape, const std::vector<double>& values,
                      const Hdf5Storage& storage = {});
  /// Attributes of `object` ("" is the root). A single number becomes a scalar. A `fixed` text has a fixed length and
  /// trailing blanks; other texts have a variable length.
  Hdf5Builder& numbers(const std::string& object, const std::string& name, const std::vector<double>& values);
  Hdf5Builder& text(const std::string& object, const std::string& name, const std::string& text, bool fixed = false);
  hid_t id() const { return file_; }

 private:
  hid_t file_;
};

/// `index` modulo 64, minus 20: a number that is exact in float32 and int16.
double ramp_value(std::size_t index);

}  // namespace percuss::test
