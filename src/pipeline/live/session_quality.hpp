#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/classify/classify.hpp"
#include "pipeline/analysis.hpp"
#include "pipeline/analysis_options.hpp"

namespace percuss::pipeline {

/// A mode of the blows accepted so far.
struct LiveMode {
  identify::ModeType type = identify::ModeType::unknown;
  int order = 0;
  double freq_Hz = 0, freq_std_Hz = 0, damping_ratio = 0, damping_std = 0;
  double falling_std_Hz = 0;  // the part of freq_std_Hz that falls as 1/√n: noise and scatter between hits
};

/// "hoop 1", or "mode 3" by `index`, counted from 0.
std::string name_of(const LiveMode& mode, std::size_t index);

/// What makes the results of a test wrong, as its warning states it.
struct SessionProblem {
  std::string code, text;
};

/// What the test is worth so far.
struct SessionQuality {
  std::size_t blows = 0;
  std::vector<LiveMode> modes{};      // ascending
  std::optional<double> coherence{};  // median over the spectral lines, of the FRF where it is lowest
  /// What makes the results wrong, with the remedy: a reversed hammer, exchanged channels, a wrong angle.
  std::vector<SessionProblem> problems{};
};

/// What an analysis of `blows` accepted blows shows. No modes where it is impossible.
SessionQuality quality_of(const Analysis& analysis, std::size_t blows);
/// Analyses a session's rows, of which those without a mark count. Hits have the numbers of the finished file. No modes
/// where the analysis is impossible.
SessionQuality session_quality(acquire::Record record, const AnalysisOptions& options);

/// The further blows that bring the mode's ± to `target_Hz`, when its falling part falls as 1/√n; nothing where no
/// number does. 0: it is there.
std::optional<std::size_t> further_blows(const LiveMode& mode, std::size_t blows, double target_Hz);

}  // namespace percuss::pipeline
