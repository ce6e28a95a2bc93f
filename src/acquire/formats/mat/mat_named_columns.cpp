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
#include "acquire/formats/mat/mat_description.hpp"
#include "acquire/formats/mat/mat_matrix_lines.hpp"
#include "acquire/formats/mat/mat_rate.hpp"
#include "core/io/csv_header.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::acquire {
namespace {

constexpr std::array<std::string_view, 13> kNameLists{
    "name",         "names",       "label",       "labels",       "channel", "channels", "channelname",
    "channelnames", "signalnames", "columnnames", "columnlabels", "header",  "headers"};
constexpr std::array<std::string_view, 4> kUnitLists{"unit", "units", "channelunits", "signalunits"};

// The rows of a char array, which MATLAB fills with blanks to one length.
std::vector<std::string> rows_of(const MatVariable& variable) {
  const std::size_t rows = variable.shape.size() == 2 ? variable.shape[0] : 0;
  if (rows < 2 || variable.text.size() != rows * variable.shape[1]) return {};
  std::vector<std::string> out(rows);
  for (std::size_t i = 0; i < variable.text.size(); ++i) out[i % rows] += variable.text[i];
  for (std::string& row : out) row = std::string(trimmed(row));
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
    texts.emplace_back(trimmed(variable.text));
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
    if (!may_be_signal(variable) || variable.shape.size() != 2) continue;
    const auto [shorter, longer] = std::minmax(variable.shape[0], variable.shape[1]);
    if (shorter == longer || (shorter != names && shorter + variable.columns_taken != names)) continue;
    if (found != nullptr) return nullptr;
    found = &variable;
  }
  return found;
}

// Whether the options name the matrix or one of its columns, "data(:,2)".
bool is_named(const MatVariable& matrix, const ReadOptions& options) {
  std::vector<std::string> names = options.accel_channels;
  names.push_back(options.force_channel);
  for (const ChannelSetup& entry : options.setup) names.push_back(entry.name);
  const std::string own = lower_case(matrix.name);
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return lower_case(name.substr(0, name.find("(:,"))) == own; });
}

}  // namespace

void split_named_columns(MatFile& file, const ReadOptions& options) {
  if (std::any_of(file.variables.begin(), file.variables.end(), [](const MatVariable& v) { return v.is_complex(); }))
    return;
  const std::vector<std::string> names = list_named(file, kNameLists);
  if (!are_names_of_channels(names, file)) return;
  MatVariable* const matrix = matrix_with(file, names.size());
  if (matrix == nullptr || is_named(*matrix, options)) return;
  const std::vector<std::string> units = list_named(file, kUnitLists);
  const MatrixLines lines(*matrix);
  const std::size_t columns = lines.columns(), named_times = names.size() - columns;
  std::vector<MatVariable> split;
  for (std::size_t c = 0; c < columns; ++c) {
    const std::string& name = names[c + named_times];
    std::vector<double> samples = lines.column(matrix->real, c);
    split.push_back({.name = name, .shape = {samples.size(), 1}, .real = std::move(samples)});
    if (units.size() != names.size() || units[c + named_times].empty()) continue;
    const std::string& unit = units[c + named_times];
    split.push_back({.name = name + "_unit", .shape = {1, unit.size()}, .text = unit, .is_text = true});
  }
  file.variables.erase(file.variables.begin() + (matrix - file.variables.data()));
  std::move(split.begin(), split.end(), std::back_inserter(file.variables));
}

}  // namespace percuss::acquire
