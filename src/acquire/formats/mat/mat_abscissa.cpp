#include "acquire/formats/mat/mat_abscissa.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "acquire/channels/role_guess.hpp"
#include "acquire/formats/mat/mat_description.hpp"
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

// The numbers of a matrix with its columns in sequence, whether the lines run down or across.
struct MatrixRows {
  std::size_t count = 0, columns = 0;
  bool across = false;

  std::size_t at(std::size_t line, std::size_t column) const {
    return across ? line * columns + column : column * count + line;
  }
};

std::vector<double> column_of(const std::vector<double>& numbers, const MatrixRows& lines, std::size_t column) {
  std::vector<double> out(lines.count);
  for (std::size_t i = 0; i < lines.count; ++i) out[i] = numbers[lines.at(i, column)];
  return out;
}

bool counts_by_one(const std::vector<double>& x) { return std::abs(x[1] - x[0] - 1) < 1e-9; }

// The columns from `first` on, lines down.
std::vector<double> columns_from(const std::vector<double>& numbers, const MatrixRows& lines, std::size_t first) {
  std::vector<double> out;
  for (std::size_t c = first; c < lines.columns; ++c) {
    const std::vector<double> column = column_of(numbers, lines, c);
    out.insert(out.end(), column.begin(), column.end());
  }
  return out;
}

// The abscissa, which leaves `variable`; nothing where it has none.
std::vector<double> take_abscissa(MatVariable& variable) {
  if (variable.is_text || variable.shape.size() != 2 || is_own_description(variable.name)) return {};
  const bool across = variable.shape[1] > variable.shape[0];
  const MatrixRows lines{
      .count = variable.shape[across ? 1 : 0], .columns = variable.shape[across ? 0 : 1], .across = across};
  if (lines.count < kMinRows || lines.columns < 2 || lines.columns > kMaxColumns) return {};
  std::vector<double> abscissa = column_of(variable.real, lines, 0);
  const bool frf = variable.is_complex() || (is_frf_word(variable.name) && lines.columns == 3);
  if (!rises_evenly(abscissa) || (!frf && counts_by_one(abscissa))) return {};
  if (variable.is_complex()) {
    const std::vector<double> imaginary = column_of(variable.imaginary, lines, 0);
    if (std::any_of(imaginary.begin(), imaginary.end(), [](double x) { return x != 0; })) return {};
    variable.imaginary = columns_from(variable.imaginary, lines, 1);
  } else if (frf) {
    variable.imaginary = column_of(variable.real, lines, 2);
    variable.real = column_of(variable.real, lines, 1);
    variable.shape = {lines.count, 1};
    return abscissa;
  }
  variable.real = columns_from(variable.real, lines, 1);
  variable.shape = {lines.count, lines.columns - 1};
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
