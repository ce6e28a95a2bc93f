#include "acquire/formats/mat/mat_abscissa.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "acquire/channels/role_guess.hpp"
#include "acquire/formats/mat/mat_description.hpp"
#include "acquire/formats/mat/mat_matrix_lines.hpp"
#include "acquire/formats/mat/mat_rate.hpp"
#include "core/io/csv_header.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMinRows = 16;      // a shorter matrix may be anything
constexpr std::size_t kMaxColumns = 256;  // of a matrix with an abscissa

bool is_frf_word(const std::string& name) {
  constexpr std::array<std::string_view, 9> kWords{"frf",         "h",        "h1",         "h2",       "hv",
                                                   "accelerance", "mobility", "receptance", "inertance"};
  return std::find(kWords.begin(), kWords.end(), lower_case(field_name(name))) != kWords.end();
}

bool counts_by_one(const std::vector<double>& x) { return std::abs(x[1] - x[0] - 1) < 1e-9; }

// The columns from `first` on, lines down.
std::vector<double> columns_from(const std::vector<double>& numbers, const MatrixLines& lines, std::size_t first) {
  std::vector<double> out;
  for (std::size_t c = first; c < lines.columns(); ++c) {
    const std::vector<double> column = lines.column(numbers, c);
    out.insert(out.end(), column.begin(), column.end());
  }
  return out;
}

// Removes the abscissa from `variable` and returns it; empty if there is none.
std::vector<double> take_abscissa(MatVariable& variable) {
  if (variable.is_text || variable.shape.size() != 2 || is_own_description(variable.name)) return {};
  const MatrixLines lines(variable);
  if (lines.count() < kMinRows || lines.columns() < 2 || lines.columns() > kMaxColumns) return {};
  std::vector<double> abscissa = lines.column(variable.real, 0);
  const bool frf = variable.is_complex() || (is_frf_word(variable.name) && lines.columns() == 3);
  if (!rises_evenly(abscissa) || (!frf && counts_by_one(abscissa))) return {};
  if (variable.is_complex()) {
    const std::vector<double> imaginary = lines.column(variable.imaginary, 0);
    if (std::any_of(imaginary.begin(), imaginary.end(), [](double x) { return x != 0; })) return {};
    variable.imaginary = columns_from(variable.imaginary, lines, 1);
  } else if (frf) {
    variable.imaginary = lines.column(variable.real, 2);
    variable.real = lines.column(variable.real, 1);
    variable.shape = {lines.count(), 1};
    return abscissa;
  }
  variable.real = columns_from(variable.real, lines, 1);
  variable.shape = {lines.count(), lines.columns() - 1};
  variable.columns_taken = 1;
  return abscissa;
}

}  // namespace

void split_abscissas(MatFile& file) {
  std::vector<MatVariable> abscissas;
  for (MatVariable& variable : file.variables) {
    std::vector<double> numbers = take_abscissa(variable);
    if (numbers.empty()) continue;
    const std::size_t count = numbers.size();
    abscissas.push_back({.name = variable.name + (variable.is_complex() ? ".f" : ".t"),
                         .shape = {count, 1},
                         .real = std::move(numbers),
                         .imaginary = {},
                         .text = {},
                         .is_abscissa = true});
  }
  std::move(abscissas.begin(), abscissas.end(), std::back_inserter(file.variables));
}

}  // namespace percuss::acquire
