#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "acquire/open_measurement.hpp"
#include "acquire/write_record.hpp"
#include "cell.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::stress {
namespace {

/// A fit ends when its next step would be below a hundredth of a standard deviation. Each of two fits with different
/// rounding may end that far from the optimum, on opposite sides.
constexpr double kSame = 0.02;

/// The expected effect of a change on the modes: factors of frequency and residues, and the new order of channels.
struct Change {
  double freq = 1, residue = 1;
  std::map<std::size_t, std::size_t> channel{};
  double tolerance = kSame;  // standard deviations; 0: every bit
};

void compare(const CommandResult& before, const CommandResult& after, const Change& change, Result& result) {
  const auto expect = [&](double a, double b, double std, const char* what, std::size_t m) {
    const double off = std::abs(a - b);
    if (!(off <= change.tolerance * std)) {
      result.failures.push_back(
          fmt::format("{} of mode {} is {:.12g}, was {:.12g}: {:.2g} standard deviations", what, m, b, a, off / std));
    }
  };
  if (before.exit_code != 0 || after.exit_code != 0)
    result.failures.push_back("refused: " + before.message + after.message);
  if (before.modes.size() != after.modes.size() || before.modes.empty())
    result.failures.push_back(fmt::format("{} modes, were {}", after.modes.size(), before.modes.size()));
  if (!result.failures.empty()) return;
  for (std::size_t m = 0; m < before.modes.size(); ++m) {
    const identify::Mode& a = before.modes[m];
    const identify::Mode& b = after.modes[m];
    expect(change.freq * a.pole.freq_Hz, b.pole.freq_Hz, change.freq * a.freq_std_Hz, "frequency", m);
    expect(a.pole.damping_ratio, b.pole.damping_ratio, a.damping_std, "damping ratio", m);
    for (std::size_t r = 0; r < a.residues.size(); ++r) {
      const identify::Residue& was = a.residues[r];
      const auto moved = change.channel.find(was.channel);
      const identify::Residue& is = b.residues[moved == change.channel.end() ? r : moved->second];
      const double std = std::abs(change.residue) * std::hypot(was.std, was.relative_std * std::abs(was.value));
      expect(0, std::abs(is.value - change.residue * was.value), std, "residue", m);
    }
  }
}

synth::SynthSpec spec_of(std::uint64_t run) {
  synth::SynthSpec spec = two_modes();
  spec.seed = 7000 + run;
  spec.noise = {.force = 1e-4, .accel = 1e-3};
  return spec;
}

using Altered = std::function<acquire::Record(const acquire::Record&)>;

Check invariant(const std::string& name, const Change& change, const Altered& altered, double freq = 1) {
  Check check{.group = "invariance", .name = name, .runs = 2, .full_runs = 16};
  check.expectation = change.tolerance > 0 ? fmt::format("the same modes to {:g} standard deviations", change.tolerance)
                                           : "the same modes, every bit";
  check.run = [=](std::uint64_t run) {
    const synth::SynthSpec spec = spec_of(run);
    const synth::SyntheticTest test = synth::synthesise(spec, 1);
    pipeline::AnalysisOptions options = options_of(spec);
    const CommandResult before = analyse(test.record, options);
    options.band_Hz = std::pair{freq * spec.band_low_Hz, freq * spec.band_high_Hz};
    Result result;
    compare(before, analyse(altered(test.record), options), change, result);
    result.wanted = result.found = before.modes.size();
    return result;
  };
  return check;
}

Altered by(const std::function<void(Samples&)>& change) {
  return [change](const acquire::Record& record) {
    Samples samples = samples_of(record);
    change(samples);
    return record_of(std::move(samples), record);
  };
}

std::vector<Check> of_samples() {
  std::vector<Check> checks;
  for (const double force : {1e-3, -1.0, 4.4482216152605, 1e6}) {
    for (const double accel : {1.0, -1.0, 9.80665, 1e-6}) {
      checks.push_back(invariant(fmt::format("force × {:g}, response × {:g}", force, accel), {.residue = accel / force},
                                 by([=](Samples& samples) { scale(samples, force, accel); })));
    }
  }
  checks.push_back(invariant("hits in reverse order", {}, by([](Samples& samples) {
                               std::reverse(samples.force_N.begin(), samples.force_N.end());
                               std::reverse(samples.accel_mps2.begin(), samples.accel_mps2.end());
                             })));
  checks.push_back(invariant("channels in reverse order", {.channel = {{0, 1}, {1, 0}}}, by([](Samples& samples) {
                               for (auto& row : samples.accel_mps2) std::reverse(row.begin(), row.end());
                             })));
  for (const double times : {1e-3, 1e3}) {
    checks.push_back(invariant(fmt::format("sampling rate × {:g}", times), {.freq = times},
                               by([=](Samples& samples) { samples.fs_Hz *= times; }), times));
  }
  return checks;
}

/// The same hits at another time in their rows, without noise: every sample differs.
Check shifted(double samples) {
  Check check{.group = "invariance",
              .name = fmt::format("hits {:g} samples later", samples),
              .expectation = "the same modes to 1e-9 of the pole",
              .runs = 1,
              .full_runs = 4};
  check.run = [=](std::uint64_t run) {
    synth::SynthSpec spec = spec_of(run);
    spec.noise = {};
    const pipeline::AnalysisOptions options = options_of(spec);
    CommandResult before = analyse(synth::synthesise(spec, 1).record, options);
    spec.pretrigger_s += samples / spec.fs_Hz;
    const CommandResult after = analyse(synth::synthesise(spec, 1).record, options);
    for (identify::Mode& mode : before.modes) {
      mode.freq_std_Hz = kRoundingOfPole * mode.pole.freq_Hz;
      mode.damping_std = kRoundingOfPole;
      for (identify::Residue& residue : mode.residues) residue.std = 1e-7 * std::abs(residue.value);
    }
    Result result;
    compare(before, after, {.tolerance = 1}, result);
    result.wanted = result.found = before.modes.size();
    return result;
  };
  return check;
}

/// One file, or one file per hit, in each format of records except sound.
std::vector<Check> of_files() {
  std::vector<Check> checks;
  for (const char* extension : {".h5", ".mat", ".uff", ".csv"}) {
    checks.push_back(invariant(fmt::format("written to one {} file", extension), {.tolerance = 0},
                               [=](const acquire::Record& record) {
                                 const test::ScratchFolder folder;
                                 const std::string path = folder.file(std::string("all") + extension);
                                 acquire::write_record(path, record, false);
                                 return record_of(samples_of(acquire::open_record(path)), record);
                               }));
    checks.push_back(invariant(
        fmt::format("written to one {} file per hit", extension), {.tolerance = 0}, [=](const acquire::Record& record) {
          const test::ScratchFolder folder;
          std::vector<acquire::Record> parts;
          for (std::size_t row = 0; row < record.rows.size(); ++row) {
            Samples samples = samples_of(record);
            samples.force_N = {samples.force_N[row]};
            samples.accel_mps2 = {samples.accel_mps2[row]};
            const std::string path = folder.file(fmt::format("{}{}", row, extension));
            acquire::write_record(path, record_of(std::move(samples), record), false);
            parts.push_back(acquire::open_record(path));
          }
          return record_of(samples_of(acquire::join_records(std::move(parts), acquire::FileGrouping::hits)), record);
        }));
  }
  return checks;
}

}  // namespace

std::vector<Check> invariance_checks() {
  std::vector<Check> checks = of_samples();
  for (const double samples : {1.0, 37.0, 0.37}) checks.push_back(shifted(samples));
  for (Check& check : of_files()) checks.push_back(std::move(check));
  return checks;
}

}  // namespace percuss::stress
