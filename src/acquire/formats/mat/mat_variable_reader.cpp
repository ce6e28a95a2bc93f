#include "acquire/formats/mat/mat_variable_reader.hpp"

#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "acquire/channels/column_words.hpp"
#include "acquire/formats/mat/matio_values.hpp"
#include "core/error.hpp"
#include "core/io/csv_header.hpp"

namespace percuss::acquire {
namespace {

using matio::element_count;
using matio::field_count;
using matio::holds_numbers;

constexpr std::size_t kMaxVariables = 10'000, kMaxDepth = 8, kMaxElements = 4096;
constexpr std::size_t kMaxMatDimensions = 8;

// The texts of a field that names channels: they differ, and one of them names a force. Nothing for other fields; the
// elements are hits then.
std::vector<std::string> channel_names(const MatField& field) {
  constexpr std::array<std::string_view, 6> kNameFields{"name",     "label",       "channel",
                                                        "channame", "channelname", "signal"};
  std::string bare = lower_case(field.name);
  std::erase(bare, '_');
  if (field.values.size() < 2 || !is_one_of(bare, kNameFields)) return {};
  std::vector<std::string> names;
  bool has_force = false;
  for (const matvar_t* one : field.values) {
    const bool is_text = one != nullptr && one->dims != nullptr && one->class_type == MAT_C_CHAR;
    const std::string name = is_text ? matio::text_of(one) : "";
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return {};
    has_force = has_force || has_one_of(lower_case(name), kForceWords);
    names.push_back(name);
  }
  return has_force ? names : std::vector<std::string>{};
}

// Whether every element has samples in this field: an array of numbers, but no times.
bool holds_samples(const MatField& field) {
  const auto is_array = [](const matvar_t* one) {
    return one != nullptr && one->dims != nullptr && holds_numbers(one) && element_count(one) > 1;
  };
  return !is_one_of(lower_case(field.name), kTimeWords) &&
         std::all_of(field.values.begin(), field.values.end(), is_array);
}

// Stacks real arrays of equal size: matrices of one shape as [elements, shorter side, longer side], which is the layout
// of accelerations [hits, channels, samples]; vectors and matrices of other shapes as [elements, size].
MatVariable stacked(const std::string& name, const std::vector<MatVariable>& parts) {
  const std::size_t elements = parts.size(), length = parts.front().size();
  std::vector<std::size_t> sides = parts.front().shape;
  std::erase(sides, std::size_t{1});
  const bool alike =
      std::all_of(parts.begin(), parts.end(), [&](const MatVariable& v) { return v.shape == parts.front().shape; });
  const bool matrices = alike && sides.size() == 2;
  const bool turned = matrices && sides[0] > sides[1];
  MatVariable out{.name = name, .shape = {elements, length}};
  if (matrices) out.shape = {elements, std::min(sides[0], sides[1]), std::max(sides[0], sides[1])};
  out.real.reserve(elements * length);
  for (std::size_t i = 0; i < length; ++i) {
    const std::size_t from = turned ? i / sides[1] + i % sides[1] * sides[0] : i;
    for (const MatVariable& part : parts) out.real.push_back(part.real[from]);
  }
  return out;
}

MatVariable described(const std::string& name, const matvar_t* variable) {
  MatVariable out{.name = name};
  for (int i = 0; i < variable->rank; ++i) out.shape.push_back(variable->dims[i]);
  return out;
}

}  // namespace

void MatVariableReader::check_claim(const matvar_t* variable, std::size_t depth) {
  if (variable == nullptr || variable->dims == nullptr) return;
  if (depth > kMaxDepth) refuse("structures within structures more than 8 deep");
  const std::uint64_t count = element_count(variable);
  if (variable->class_type == MAT_C_STRUCT || variable->class_type == MAT_C_CELL) {
    const std::uint64_t fields = variable->class_type == MAT_C_CELL ? 1 : field_count(variable);
    if (fields == 0) return;
    const auto* const children = static_cast<matvar_t* const*>(variable->data);
    spend(count, fields * sizeof(matvar_t*));  // before the product count * fields, which may overflow
    for (std::uint64_t i = 0; children != nullptr && i < count * fields; ++i) check_claim(children[i], depth + 1);
    return;
  }
  const bool numbers = holds_numbers(variable);  // become doubles
  const std::uint64_t each_bytes = numbers ? sizeof(double) : static_cast<std::uint64_t>(variable->data_size);
  spend(count, std::max<std::uint64_t>(each_bytes, 1) * (variable->isComplex != 0 ? 2 : 1));
}

void MatVariableReader::add(const std::string& name, const matvar_t* variable) {
  if (variable == nullptr || variable->dims == nullptr) return;
  if (out_.variables.size() >= kMaxVariables) refuse("more than 10000 variables");
  if (holds_numbers(variable)) return add_numbers(name, variable);
  if (variable->class_type == MAT_C_CHAR) return add_text(name, variable);
  if (variable->class_type == MAT_C_STRUCT) return add_structure(name, variable);
  if (variable->class_type == MAT_C_CELL) {
    const auto* const data = static_cast<matvar_t* const*>(variable->data);
    if (data == nullptr) return;
    const std::vector<const matvar_t*> cells(data, data + element_count(variable));
    const std::vector<MatField> fields = cells.size() > 1 ? matio::fields_of_cells(cells) : std::vector<MatField>{};
    return fields.empty() ? add_elements(name, cells, '{', '}') : add_fields(name, fields);
  }
  if (variable->class_type == MAT_C_EMPTY) return;
  const bool sparse = variable->class_type == MAT_C_SPARSE;
  const bool function = variable->class_type == MAT_C_FUNCTION;
  skip(name, sparse     ? "it is sparse (save full(…))"
             : function ? "it is a function"
                        : "it is a string or an object (save it as char, or as a structure)");
}

bool MatVariableReader::reads(const matvar_t* variable) {
  const auto kind = variable->class_type;
  return holds_numbers(variable) || kind == MAT_C_CHAR || kind == MAT_C_STRUCT || kind == MAT_C_CELL;
}

void MatVariableReader::spend(std::uint64_t count, std::uint64_t each_bytes) {
  if (count > left_bytes_ / each_bytes) refuse("the file claims more numbers than it can hold");
  left_bytes_ -= count * each_bytes;
}

void MatVariableReader::skip(const std::string& name, const std::string& why) {
  out_.notes.emplace_back(fmt::format("{} is not read: {}", one_line(name, kNameShown), why));
}

void MatVariableReader::refuse(const std::string& problem) const {
  throw InputError(problem, out_.path, "is it damaged? Save it again");
}

void MatVariableReader::add_numbers(const std::string& name, const matvar_t* variable) {
  if (variable->rank < 1 || static_cast<std::size_t>(variable->rank) > kMaxMatDimensions)
    return skip(name, fmt::format("it has {} dimensions", variable->rank));
  MatVariable out = described(name, variable);
  const std::uint64_t count = element_count(variable);
  const std::uint64_t stored =
      static_cast<std::uint64_t>(variable->nbytes) / static_cast<std::uint64_t>(std::max(variable->data_size, 1));
  if (count == 0) return;
  if (variable->data == nullptr || stored < count) refuse(one_line(name, kNameShown) + " cannot be read");
  bool known = true;
  if (variable->isComplex != 0) {
    const auto* const parts = static_cast<const mat_complex_split_t*>(variable->data);
    if (parts->Re == nullptr || parts->Im == nullptr) refuse(one_line(name, kNameShown) + " cannot be read");
    known = matio::to_doubles(variable, parts->Re, count, out.real) &&
            matio::to_doubles(variable, parts->Im, count, out.imaginary);
  } else {
    known = matio::to_doubles(variable, variable->data, count, out.real);
  }
  if (!known) return skip(name, "its numbers have an unknown type (save it as double)");
  out_.variables.push_back(std::move(out));
}

void MatVariableReader::add_text(const std::string& name, const matvar_t* variable) {
  MatVariable out = described(name, variable);
  out.is_text = true;
  out.text = matio::text_of(variable);
  out_.variables.push_back(std::move(out));
}

void MatVariableReader::add_structure(const std::string& name, const matvar_t* variable) {
  add_fields(name, matio::fields_of(variable));
}

void MatVariableReader::add_fields(const std::string& name, const std::vector<MatField>& fields) {
  for (const MatField& field : fields) {
    const std::vector<std::string> channels = channel_names(field);
    if (!channels.empty() && channels.size() <= kMaxElements) return add_channels(channels, fields);
  }
  for (const MatField& field : fields) add_elements(name + "." + field.name, field.values, '(', ')');
}

void MatVariableReader::add_channels(const std::vector<std::string>& names, const std::vector<MatField>& fields) {
  const bool one_array = std::count_if(fields.begin(), fields.end(), holds_samples) == 1;
  for (const MatField& field : fields) {
    std::string suffix = "." + field.name;
    if (one_array && holds_samples(field)) suffix = "";
    if (one_array && lower_case(field.name).starts_with("unit")) suffix = "_unit";
    for (std::size_t e = 0; e < names.size(); ++e) add(names[e] + suffix, field.values[e]);
  }
}

void MatVariableReader::add_elements(const std::string& name, const std::vector<const matvar_t*>& elements_of,
                                     char open, char close) {
  if (elements_of.empty()) return;
  if (elements_of.size() == 1) return add(name, elements_of.front());
  if (elements_of.size() > kMaxElements) refuse("more than 4096 elements in " + one_line(name, kNameShown));
  MatFile parts{.path = out_.path};
  MatVariableReader within(parts, UINT64_MAX);
  bool alike = true;
  std::string suffix;  // what follows the element's number in the name: ".x" of "test(1).x"
  for (std::size_t e = 0; e < elements_of.size(); ++e) {
    const std::string element = fmt::format("{}{}{}{}", name, open, e + 1, close);
    within.add(element, elements_of[e]);
    alike = alike && parts.variables.size() == e + 1;
    if (!alike) continue;
    const std::string this_suffix = parts.variables.back().name.substr(element.size());
    if (e == 0) suffix = this_suffix;
    alike = this_suffix == suffix;
  }
  const auto same = [&](const MatVariable& v) {
    return !v.is_text && !v.is_complex() && v.size() == parts.variables.front().size();
  };
  if (alike && std::all_of(parts.variables.begin(), parts.variables.end(), same)) {
    out_.variables.push_back(stacked(name + suffix, parts.variables));
  } else {
    for (MatVariable& part : parts.variables) out_.variables.push_back(std::move(part));
  }
  out_.notes.insert(out_.notes.end(), parts.notes.begin(), parts.notes.end());
  if (out_.variables.size() > kMaxVariables) refuse("more than 10000 variables");
}

}  // namespace percuss::acquire
