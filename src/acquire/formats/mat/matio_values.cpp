#include "acquire/formats/mat/matio_values.hpp"

#include <matio.h>

#include <algorithm>

namespace percuss::acquire::matio {
namespace {

template <class Stored>
void append_as_double(std::vector<double>& out, const void* data, std::size_t count) {
  const auto* values = static_cast<const Stored*>(data);
  out.reserve(count);
  for (std::size_t i = 0; i < count; ++i) out.push_back(static_cast<double>(values[i]));
}

}  // namespace

bool to_doubles(const matvar_t* variable, const void* data, std::size_t count, std::vector<double>& out) {
  switch (variable->data_type) {
    case MAT_T_DOUBLE:
      return append_as_double<double>(out, data, count), true;
    case MAT_T_SINGLE:
      return append_as_double<float>(out, data, count), true;
    case MAT_T_INT8:
      return append_as_double<std::int8_t>(out, data, count), true;
    case MAT_T_UINT8:
      return append_as_double<std::uint8_t>(out, data, count), true;
    case MAT_T_INT16:
      return append_as_double<std::int16_t>(out, data, count), true;
    case MAT_T_UINT16:
      return append_as_double<std::uint16_t>(out, data, count), true;
    case MAT_T_INT32:
      return append_as_double<std::int32_t>(out, data, count), true;
    case MAT_T_UINT32:
      return append_as_double<std::uint32_t>(out, data, count), true;
    case MAT_T_INT64:
      return append_as_double<std::int64_t>(out, data, count), true;
    case MAT_T_UINT64:
      return append_as_double<std::uint64_t>(out, data, count), true;
    default:
      return false;
  }
}

bool holds_numbers(const matvar_t* variable) {
  return variable->class_type >= MAT_C_DOUBLE && variable->class_type <= MAT_C_UINT64;
}

std::uint64_t element_count(const matvar_t* variable) {
  std::uint64_t count = 1;
  for (int i = 0; i < variable->rank; ++i) {
    const std::uint64_t size = variable->dims[i];
    if (size != 0 && count > UINT64_MAX / 16 / size) return UINT64_MAX / 16;
    count *= size;
  }
  return count;
}

std::size_t field_count(const matvar_t* structure) {
  return Mat_VarGetNumberOfFields(const_cast<matvar_t*>(structure));  // NOLINT: C
}

std::string text_of(const matvar_t* variable) {
  const std::uint64_t count = element_count(variable);
  const bool wide = variable->data_type == MAT_T_UINT16 || variable->data_type == MAT_T_UTF16;
  const std::size_t each = wide ? 2 : 1;
  std::string out;
  if (variable->data == nullptr || variable->nbytes < count * each) return out;
  const auto* const bytes = static_cast<const char*>(variable->data);
  for (std::uint64_t i = 0; i < count; ++i) out += bytes[i * each];  // the low byte: units are ASCII
  return out;
}

std::vector<MatField> fields_of(const matvar_t* structure) {
  const std::size_t count = field_count(structure);
  char* const* const names = Mat_VarGetStructFieldnames(structure);
  const auto* const values = static_cast<matvar_t* const*>(structure->data);
  std::vector<MatField> fields;
  if (names == nullptr || values == nullptr) return fields;
  for (std::size_t f = 0; f < count; ++f) {
    if (names[f] == nullptr) continue;
    MatField& field = fields.emplace_back(MatField{.name = names[f], .values = {}});
    for (std::uint64_t e = 0; e < element_count(structure); ++e) field.values.push_back(values[e * count + f]);
  }
  return fields;
}

std::vector<MatField> fields_of_cells(const std::vector<const matvar_t*>& cells) {
  std::vector<MatField> all;
  for (const matvar_t* cell : cells) {
    const bool one =
        cell != nullptr && cell->dims != nullptr && cell->class_type == MAT_C_STRUCT && element_count(cell) == 1;
    const std::vector<MatField> fields = one ? fields_of(cell) : std::vector<MatField>{};
    const auto same = [](const MatField& a, const MatField& b) { return a.name == b.name; };
    if (all.empty()) {
      all = fields;
    } else if (std::equal(all.begin(), all.end(), fields.begin(), fields.end(), same)) {
      for (std::size_t f = 0; f < all.size(); ++f) all[f].values.push_back(fields[f].values.front());
    } else {
      return {};
    }
    if (all.empty()) return {};
  }
  return all;
}

}  // namespace percuss::acquire::matio
