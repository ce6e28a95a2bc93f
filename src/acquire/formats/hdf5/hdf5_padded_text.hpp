#pragma once

namespace percuss::acquire::hdf5 {

/// During its lifetime, the library converts texts of fixed length with all their characters, whatever their padding.
/// The library's own conversion to a null-terminated text drops the last character of a text that fills its length:
/// matio reads the null-padded class "double", as h5py writes it, as "doubl". Needs a Lock during its lifetime.
class PaddedTextConversion {
 public:
  PaddedTextConversion();
  ~PaddedTextConversion();
  PaddedTextConversion(const PaddedTextConversion&) = delete;
  PaddedTextConversion& operator=(const PaddedTextConversion&) = delete;
};

}  // namespace percuss::acquire::hdf5
