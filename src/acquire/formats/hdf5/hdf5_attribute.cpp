#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "acquire/record/stated_date.hpp"
#include "core/error.hpp"

namespace percuss::acquire::hdf5 {
namespace {

constexpr std::size_t kMaxText_bytes = 4096;  // longer texts are not units

// The attribute; invalid when the object does not have it.
Handle open_attribute(hid_t object, const std::string& name, const std::string& where) {
  if (H5Aexists(object, name.c_str()) == 0) return Handle();
  Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT));
  if (!attribute) throw InputError("damaged attribute " + name, where, "write the file anew");
  return attribute;
}

std::size_t element_count(const Handle& attribute) {
  const Handle space(H5Aget_space(attribute.get()));
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

// Text as stored, without the padding of its type.
std::string unpadded(const char* text, std::size_t bytes) {
  std::string out(text, strnlen(text, bytes));
  while (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

std::optional<std::string> read_variable_text(const Handle& attribute, const Handle& type) {
  char* text = nullptr;
  if (H5Aread(attribute.get(), type.get(), static_cast<void*>(&text)) < 0 || text == nullptr) return std::nullopt;
  std::string out = unpadded(text, kMaxText_bytes);
  H5free_memory(text);
  return out;
}

std::optional<std::string> read_fixed_text(const Handle& attribute, const Handle& type) {
  std::array<char, kMaxText_bytes> text{};
  if (H5Tget_size(type.get()) > text.size() || H5Aread(attribute.get(), type.get(), text.data()) < 0)
    return std::nullopt;
  return unpadded(text.data(), H5Tget_size(type.get()));
}

}  // namespace

std::optional<std::vector<double>> number_attribute(hid_t object, const std::string& name, const std::string& where,
                                                    std::size_t limit) {
  const Handle attribute = open_attribute(object, name, where);
  if (!attribute) return std::nullopt;
  const Handle type(H5Aget_type(attribute.get()));
  const H5T_class_t kind = H5Tget_class(type.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) {
    throw InputError("attribute " + name + " is not a number", where, "store it as float64");
  }
  const std::size_t count = element_count(attribute);
  if (count < 1 || count > limit) {
    throw InputError("attribute " + name + " holds " + std::to_string(count) + " numbers", where,
                     limit == 1 ? "store one" : "store one per channel");
  }
  std::vector<double> values(count);
  if (H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, values.data()) < 0) {
    throw InputError("damaged attribute " + name, where, "write the file anew");
  }
  return values;
}

std::optional<std::string> text_attribute(hid_t object, const std::string& name, const std::string& where) {
  const Handle attribute = open_attribute(object, name, where);
  if (!attribute) return std::nullopt;
  const Handle type(H5Aget_type(attribute.get()));
  const bool one_text = H5Tget_class(type.get()) == H5T_STRING && element_count(attribute) == 1;
  std::optional<std::string> text;
  if (one_text) {
    text = H5Tis_variable_str(type.get()) > 0 ? read_variable_text(attribute, type) : read_fixed_text(attribute, type);
  }
  if (!text) throw InputError("attribute " + name + " is not a text", where, "store one string, such as \"m/s^2\"");
  return text;
}

std::string date_attribute(Id object) {
  for (const char* name : {"date", "Date", "datetime", "DateTime", "timestamp", "Timestamp", "start_time"}) {
    try {
      const std::string date = plausible_date(text_attribute(object, name, name).value_or(""));
      if (!date.empty()) return date;
    } catch (const InputError&) {  // another program may use the name for a number
      continue;
    }
  }
  return "";
}

}  // namespace percuss::acquire::hdf5
