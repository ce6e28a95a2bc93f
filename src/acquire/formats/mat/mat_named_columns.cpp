#include "acquire/formats/mat/mat_named_columns.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "acquire/channels/column_words.hpp"
#include "acquire/formats/mat/mat_rate.hpp"
#include "core/io/csv_header.hpp"

namespace percuss::acquire {
namespace {

constexpr std::array<std::string_view, 13> kNameLists{
    "name",         "names",       "label",       "labels",       "channel", "channels", "channelname",
    "channelnames", "signalnames", "columnnames", "columnlabels", "header",  "headers"};
constexpr std::array<std::string_view, 4> kUnitLists{"unit", "units", "channelunits", "signalunits"};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

// The rows of a char array, which MATLAB fills with blanks to one length.
std::vector<std::string> rows_of(const MatVariable& variable) {
  const std::size_t rows = variable.shape.size() == 2 ? variable.shape[0] : 0;
  if (rows < 2 || variable.text.size() != rows * variable.shape[1]) return {};
  std::vector<std::string> out(rows);
  for (std::size_t i = 0; i < variable.text.size(); ++i) out[i % rows] += variable.text[i];
  for (std::string& row : out) row = trimmed(row);
  return out;
}

// The first list of such a name: the texts of cells "names{1}", "names{2}", …, or the rows of a char array.
std::vector<std::string> list_named(const MatFile& file, std::span<const std::string_view> words) {
  std::vector<std::string> texts;
  std::string list_name;
  for (const MatVariable& variable : file.variables) {
    if (!variable.is_text) continue;
    const std::string name = variable.name.substr(0, variable.name.find('{'));
    if (!is_one_of(bare_name(field_name(name)), words) || (!list_name.empty() && name != list_name)) continue;
    if (name == variable.name) {
      texts = rows_of(variable);
      if (!texts.empty()) return texts;
      continue;
    }
    list_name = name;
    texts.push_back(trimmed(variable.text));
  }
  return texts;
}

bool are_names_of_channels(const std::vector<std::string>& names, const MatFile& file) {
  const std::set<std::string> distinct(names.begin(), names.end());
  const auto is_taken = [&](const std::string& name) { return name.empty() || find_variable(file, name) != nullptr; };
  return names.size() > 1 && distinct.size() == names.size() && std::none_of(names.begin(), names.end(), is_taken) &&
         std::any_of(names.begin(), names.end(), [](const std::string& name) { return quantity_named(name); });
}

// The only matrix of real numbers with a column (or row) for each name. The list may also name the times, which
// split_abscissas has taken out.
MatVariable* matrix_with(MatFile& file, std::size_t names) {
  MatVariable* found = nullptr;
  for (MatVariable& variable : file.variables) {
    if (variable.is_text || variable.shape.size() != 2) continue;
    const auto [shorter, longer] = std::minmax(variable.shape[0], variable.shape[1]);
    if (shorter == longer || (shorter != names && shorter + variable.columns_taken != names)) continue;
    if (found != nullptr) return nullptr;
    found = &variable;
  }
  return found;
}

std::vector<double> column_of(const MatVariable& matrix, std::size_t column) {
  const bool across = matrix.shape[1] > matrix.shape[0];
  const std::size_t count = std::max(matrix.shape[0], matrix.shape[1]), columns = matrix.size() / count;
  std::vector<double> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = matrix.real[across ? i * columns + column : column * count + i];
  return out;
}

}  // namespace

void split_named_columns(MatFile& file, const ReadOptions& options) {
  const auto is_column = [](const std::string& name) { return name.find("(:,") != std::string::npos; };
  if (is_column(options.force_channel) ||
      std::any_of(options.accel_channels.begin(), options.accel_channels.end(), is_column))
    return;
  if (std::any_of(file.variables.begin(), file.variables.end(), [](const MatVariable& v) { return v.is_complex(); }))
    return;
  const std::vector<std::string> names = list_named(file, kNameLists);
  if (!are_names_of_channels(names, file)) return;
  MatVariable* const matrix = matrix_with(file, names.size());
  if (matrix == nullptr) return;
  const std::vector<std::string> units = list_named(file, kUnitLists);
  const std::size_t columns = std::min(matrix->shape[0], matrix->shape[1]), named_times = names.size() - columns;
  std::vector<MatVariable> split;
  for (std::size_t c = 0; c < columns; ++c) {
    const std::string& name = names[c + named_times];
    std::vector<double> samples = column_of(*matrix, c);
    split.push_back({.name = name, .shape = {samples.size(), 1}, .real = std::move(samples)});
    if (units.size() != names.size() || units[c + named_times].empty()) continue;
    const std::string& unit = units[c + named_times];
    split.push_back({.name = name + "_unit", .shape = {1, unit.size()}, .text = unit, .is_text = true});
  }
  file.variables.erase(file.variables.begin() + (matrix - file.variables.data()));
  std::move(split.begin(), split.end(), std::back_inserter(file.variables));
}

}  // namespace percuss::acquire
