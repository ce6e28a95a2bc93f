#include "acquire/formats/mat/mat_guess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "acquire/channels/column_words.hpp"
#include "acquire/channels/csv_columns.hpp"
#include "acquire/formats/mat/mat_description.hpp"
#include "acquire/formats/mat/mat_rate.hpp"
#include "core/io/csv_header.hpp"

namespace percuss::acquire {
namespace {

// Signals that may be the force or an acceleration, with the names that the options accept.
struct Candidates {
  std::vector<CsvColumn> signals;
  std::vector<std::span<const double>> samples;
  std::vector<std::vector<double>> own;  // samples that are not contiguous in their variable

  void add(std::string name, std::string unit, std::span<const double> of) {
    signals.push_back({.index = signals.size(), .name = std::move(name), .base = "", .unit = std::move(unit)});
    samples.push_back(of);
  }
};

bool names_spectrum(const std::string& name) {
  constexpr std::array<std::string_view, 4> kWords{"freq", "frf", "hf_", "phase"};
  const std::string lower = lower_case(name);
  return is_other_spectrum(lower) || has_one_of(lower, kWords);
}

Candidates longest_vectors(const MatFile& file, const std::vector<std::size_t>& index) {
  std::vector<const MatVariable*> vectors;
  std::size_t longest = 0;
  for (const std::size_t v : index) {
    const MatVariable& variable = file.variables[v];
    if (variable.is_complex() || !is_mat_vector(variable) || names_spectrum(variable.name)) continue;
    if (rises_evenly(variable.real)) continue;
    vectors.push_back(&variable);
    longest = std::max(longest, variable.size());
  }
  Candidates out;
  for (const MatVariable* variable : vectors) {
    if (variable->size() == longest) out.add(variable->name, unit_in(file, variable->name), variable->real);
  }
  return out;
}

// Matrices of one shape, such as the fields of a struct array: one signal each, with the hits along the shorter side.
Candidates alike_matrices(const MatFile& file, const std::vector<std::size_t>& index) {
  const MatVariable* largest = nullptr;
  const auto is_matrix = [](const MatVariable& variable) {
    return !variable.is_complex() && !variable.is_text && variable.shape.size() == 2 && variable.shape[0] > 1 &&
           variable.shape[1] > 1 && !names_spectrum(variable.name);
  };
  for (const std::size_t v : index) {
    const MatVariable& variable = file.variables[v];
    if (is_matrix(variable) && (largest == nullptr || variable.size() > largest->size())) largest = &variable;
  }
  Candidates out;
  if (largest == nullptr) return out;
  const std::size_t rows = largest->shape[0], columns = largest->shape[1];
  const std::size_t count = std::max(rows, columns), step = rows < columns ? rows : 1;
  for (const std::size_t v : index) {
    const MatVariable& variable = file.variables[v];
    if (!is_matrix(variable) || variable.shape != largest->shape) continue;
    std::vector<double> first(count);
    for (std::size_t i = 0; i < count; ++i) first[i] = variable.real[i * step];
    out.own.push_back(std::move(first));
    out.add(variable.name, unit_in(file, variable.name), {});
  }
  for (std::size_t i = 0; i < out.own.size(); ++i) out.samples[i] = out.own[i];
  return out;
}

Candidates columns_of_matrix(const MatFile& file, const std::vector<std::size_t>& index) {
  Candidates out;
  for (const std::size_t v : index) {
    const MatVariable& variable = file.variables[v];
    const auto& shape = variable.shape;
    if (variable.is_complex() || shape.size() != 2 || shape[1] < 2 || shape[1] > kMaxGuessedSignals ||
        shape[0] < shape[1])
      continue;
    for (std::size_t c = 0; c < shape[1]; ++c) {
      const auto column = std::span<const double>(variable.real).subspan(c * shape[0], shape[0]);
      if (rises_evenly(column)) continue;
      out.add(fmt::format("{}(:,{})", variable.name, variable.columns_taken + c + 1), "", column);
    }
    break;
  }
  return out;
}

}  // namespace

RoleGuess guess_mat_roles(const MatFile& file, const std::vector<std::size_t>& index, const CsvColumns& known,
                          const ReadOptions& options) {
  Candidates found = longest_vectors(file, index);
  if (found.signals.size() < 2) found = alike_matrices(file, index);
  if (found.signals.size() < 2) found = columns_of_matrix(file, index);
  CsvColumns force{.force = known.force, .has_force = known.has_force};
  const auto is_force = [&](const CsvColumn& signal) { return signal.name == known.force.name; };
  const auto at = std::find_if(found.signals.begin(), found.signals.end(), is_force);
  force.force.index = static_cast<std::size_t>(at - found.signals.begin());  // past the end: it is none of these
  const auto read = [&](std::size_t signal, std::size_t max_samples) {
    const std::span<const double> samples = found.samples[signal];
    const auto some = samples.first(std::min(samples.size(), max_samples));
    return std::vector<double>(some.begin(), some.end());
  };
  return guess_roles(found.signals, force, options, read, [](const CsvColumn& signal) { return signal.name; });
}

}  // namespace percuss::acquire
