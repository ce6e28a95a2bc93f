#include "acquire/formats/mat/mat_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "acquire/channels/column_words.hpp"
#include "acquire/formats/mat/mat_rate.hpp"
#include "acquire/record/trace_faces.hpp"
#include "core/error.hpp"
#include "core/io/csv_header.hpp"

namespace percuss::acquire {

bool is_own_description(const std::string& name) {
  constexpr std::array<std::string_view, 10> kNames{"point",     "run",        "geometry",   "trace_lines",
                                                    "angle_deg", "position_m", "continuous", "fs",
                                                    "frf_std",   "trace_faces"};
  return is_one_of(lower_case(field_name(name)), kNames);
}

bool may_be_signal(const MatVariable& variable) {
  return !variable.is_text && !variable.is_abscissa && variable.size() > 1 && !is_own_description(variable.name);
}

std::string unit_in(const MatFile& file, const std::string& name) {
  const std::string base(field_name(name)), parent = name.substr(0, name.size() - base.size());
  for (const MatVariable& variable : file.variables) {
    if (!variable.is_text) continue;
    const std::string stated = bare_name(variable.name);
    for (const char* word : {"unit", "units", "unitstr"}) {
      const bool beside = stated == bare_name(name) + word || stated == word + bare_name(name);
      const bool listed = stated == bare_name(parent) + word + "." + bare_name(base);
      const bool field = !parent.empty() && stated == bare_name(parent) + word;
      if (beside || listed || field) return variable.text;
    }
  }
  return {};
}

void refuse_spectral_densities(const MatFile& file) {
  for (const MatVariable& variable : file.variables) {
    const std::string name = lower_case(field_name(variable.name));
    const bool density = name.starts_with("psd") || name.starts_with("pxx") || name.starts_with("pyy");
    if (!density || variable.is_text || variable.size() < 2) continue;
    throw InputError(one_line(variable.name, 40) + " is a power spectral density (PSD), neither a record nor an FRF",
                     file.path, "save the force and the accelerations over time, or complex FRFs");
  }
}

const MatVariable* description_variable(const MatFile& file, std::string_view name, std::string_view beside) {
  if (const MatVariable* const top = find_variable(file, name)) return top;
  const std::string parent(beside.substr(0, beside.size() - field_name(beside).size()));
  if (const MatVariable* const near = find_variable(file, parent + std::string(name))) return near;
  const MatVariable* only = nullptr;
  for (const MatVariable& variable : file.variables) {
    if (lower_case(field_name(variable.name)) != name) continue;
    if (only != nullptr) return nullptr;
    only = &variable;
  }
  return only;
}

std::vector<std::optional<double>> per_channel(const MatFile& file, const char* name, std::size_t count,
                                               std::string_view beside) {
  std::vector<std::optional<double>> out(count);
  const MatVariable* const given = description_variable(file, name, beside);
  if (given == nullptr || given->size() != count || given->is_complex()) return out;
  for (std::size_t c = 0; c < count; ++c) {
    if (std::isfinite(given->real[c])) out[c] = given->real[c];
  }
  return out;
}

std::vector<int> numbers_of_hits(const MatFile& file, const char* name, std::size_t rows, std::string_view beside,
                                 std::vector<Message>& notes) {
  std::vector<int> out(rows);
  const MatVariable* const given = description_variable(file, name, beside);
  if (given == nullptr || given->is_text) return out;
  const auto is_whole = [](double x) { return std::abs(x) <= std::numeric_limits<int>::max() && std::rint(x) == x; };
  const bool whole = !given->is_complex() && std::all_of(given->real.begin(), given->real.end(), is_whole);
  const bool is_field = given->name.find('.') != std::string::npos;
  const bool for_all = is_field && given->size() == 1;
  if (whole && (given->size() == rows || for_all)) {
    for (std::size_t row = 0; row < rows; ++row) out[row] = static_cast<int>(given->real[for_all ? 0 : row]);
    return out;
  }
  const std::size_t parent = given->name.size() - field_name(given->name).size();
  const bool is_beside = parent == beside.size() - field_name(beside).size() &&
                         lower_case(given->name.substr(0, parent)) == lower_case(beside.substr(0, parent));
  if (is_field && !is_beside) {
    notes.emplace_back(
        fmt::format("{} is not used: it is not one whole number for each of {} hits", one_line(given->name, 40), rows));
    return out;
  }
  throw InputError(fmt::format("not one whole number for each of {} hits", rows),
                   file.path + ": " + one_line(given->name, 40), "store one per hit");
}

namespace {

const MatVariable* described_matrix(const MatFile& file, const char* name, std::string_view beside) {
  const MatVariable* const found = description_variable(file, name, beside);
  const bool real = found != nullptr && !found->is_text && !found->is_complex();
  return real && found->shape.size() == 2 ? found : nullptr;
}

std::vector<TraceLine> trace_lines_in(const MatFile& file, std::size_t points, std::string_view beside) {
  const MatVariable* const given = described_matrix(file, "trace_lines", beside);
  if (given == nullptr || given->shape[1] != 2) return {};
  std::vector<double> numbers;
  const std::size_t lines = given->shape[0];
  for (std::size_t i = 0; i < lines; ++i) numbers.insert(numbers.end(), {given->real[i], given->real[lines + i]});
  return trace_lines_of(numbers, points, file.path + ": trace_lines");
}

std::vector<TraceFace> trace_faces_in(const MatFile& file, std::size_t points, std::string_view beside) {
  const MatVariable* const given = described_matrix(file, "trace_faces", beside);
  if (given == nullptr) return {};
  const std::size_t faces = given->shape[0];
  FaceTable table{.width = given->shape[1]};
  for (std::size_t i = 0; i < given->size(); ++i)
    table.numbers.push_back(given->real[i / table.width + i % table.width * faces]);
  return trace_faces_of(table, points, file.path + ": trace_faces");
}

}  // namespace

std::vector<std::vector<double>> geometry_in(const MatFile& file, std::string_view beside) {
  const MatVariable* const given = described_matrix(file, "geometry", beside);
  if (given == nullptr || given->shape[1] < 2 || given->shape[1] > 3) return {};
  std::vector<std::vector<double>> out(given->shape[0]);
  for (std::size_t i = 0; i < given->size(); ++i) out[i % out.size()].push_back(given->real[i]);
  return out;
}

void take_connections(const MatFile& file, SignalTable& table, std::string_view beside) {
  try {
    table.trace_lines = trace_lines_in(file, table.geometry.size(), beside);
  } catch (const InputError& error) {
    table.notes.emplace_back("trace_lines is not used: " + error.problem());
  }
  try {
    table.trace_faces = trace_faces_in(file, table.geometry.size(), beside);
  } catch (const InputError& error) {
    table.notes.emplace_back("trace_faces is not used: " + error.problem());
  }
}

std::size_t stated_hits(const MatFile& file, std::string_view beside) {
  for (const char* name : {"point", "run"}) {
    const MatVariable* const given = description_variable(file, name, beside);
    if (given != nullptr && !given->is_text) return given->size();
  }
  return 0;
}

}  // namespace percuss::acquire
