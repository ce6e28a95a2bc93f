#pragma once
#include <cstdint>
#include <cstring>
#include <random>
#include <span>
#include <string>
#include <string_view>

namespace percuss::fuzz {

using Random = std::mt19937;

// Each function changes one part of an input's structure in place. It then corrects counts, lengths and checksums, and
// sometimes leaves one wrong on purpose. An input without the structure stays unchanged.

/// Lines of recipes: "set accel f8 2,1,16" (hdf5_target.cpp), "real force 40,3" (mat_target.cpp).
void mutate_hdf5_recipe(std::string& recipe, Random& random);
void mutate_mat_recipe(std::string& recipe, Random& random);
/// Data sets of a universal file, their lines and fields, and the length of binary ones.
void mutate_uff(std::string& bytes, Random& random);
/// Elements of a MAT file of level 5, also compressed ones: types, sizes, dimensions, classes, names, order.
void mutate_mat(std::string& bytes, Random& random);
/// Messages of the object headers of an HDF5 file: dataspaces, datatypes, layouts, filters, attributes, links.
void mutate_hdf5(std::string& bytes, Random& random);
/// Calls the mutator for the format of the bytes, if there is one.
void mutate_binary_formats(std::string& bytes, Random& random);

/// A random index below `count`; 0 if `count` is 0.
inline std::size_t below(Random& random, std::size_t count) { return count == 0 ? 0 : random() % count; }

template <class Item, std::size_t count>
const Item& one_of(const Item (&items)[count], Random& random) {
  return items[random() % count];
}

/// A number at the limits of types, sizes and formats, or a small one.
std::uint64_t unusual_number(Random& random);

/// Little-endian numbers in binary files. Beyond the end, the number read is 0, and nothing is written.
template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
  Number number{};
  if (at <= bytes.size() && sizeof number <= bytes.size() - at) std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}
template <class Number>
void set_number(std::string& bytes, std::size_t at, Number number) {
  if (at <= bytes.size() && sizeof number <= bytes.size() - at) std::memcpy(bytes.data() + at, &number, sizeof number);
}

}  // namespace percuss::fuzz
