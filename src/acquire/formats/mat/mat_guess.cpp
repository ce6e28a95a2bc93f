#include "acquire/formats/mat/mat_guess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "acquire/formats/mat/mat_description.hpp"
#include "acquire/formats/mat/mat_rate.hpp"
#include "core/io/csv_header.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMostGuessed = 64;  // more than a command line should list

// Signals that may be the force or an acceleration, as the options name them.
struct Candidates {
  std::vector<CsvColumn> signals;
  std::vector<std::pair<const double*, std::size_t>> samples;

  void add(std::string name, std::string unit, const double* first, std::size_t count) {
    signals.push_back({.index = signals.size(), .name = std::move(name), .base = "", .unit = std::move(unit)});
    samples.emplace_back(first, count);
  }
};

bool names_spectrum(const std::string& name) {
  constexpr std::array<std::string_view, 8> kWords{"psd", "spec", "freq", "corr", "coh", "frf", "hf_", "phase"};
  const std::string lower = lower_case(name);
  return std::any_of(kWords.begin(), kWords.end(),
                     [&](std::string_view word) { return lower.find(word) != std::string::npos; });
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
    if (variable->size() == longest)
      out.add(variable->name, unit_in(file, variable->name), variable->real.data(), longest);
  }
  return out;
}

Candidates columns_of_matrix(const MatFile& file, const std::vector<std::size_t>& index) {
  Candidates out;
  for (const std::size_t v : index) {
    const MatVariable& variable = file.variables[v];
    const auto& shape = variable.shape;
    if (variable.is_complex() || shape.size() != 2 || shape[1] < 2 || shape[1] > kMostGuessed || shape[0] < shape[1])
      continue;
    for (std::size_t c = 0; c < shape[1]; ++c) {
      const double* const first = variable.real.data() + c * shape[0];
      if (rises_evenly({first, shape[0]})) continue;
      out.add(fmt::format("{}(:,{})", variable.name, variable.columns_taken + c + 1), "", first, shape[0]);
    }
    break;
  }
  return out;
}

}  // namespace

RoleGuess guess_mat_roles(const MatFile& file, const std::vector<std::size_t>& index) {
  Candidates found = longest_vectors(file, index);
  if (found.signals.size() < 2) found = columns_of_matrix(file, index);
  const auto read = [&](std::size_t signal, std::size_t most) {
    const auto& [first, count] = found.samples[signal];
    return std::vector<double>(first, first + std::min(count, most));
  };
  return guess_roles(found.signals, read, [](const CsvColumn& signal) { return signal.name; });
}

}  // namespace percuss::acquire
