#include "skipped_work_study.hpp"

#include <functional>

#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "acquire/open_measurement.hpp"
#include "core/io/temporary_folder.hpp"
#include "pipeline/analysis.hpp"
#include "synth/synthesise.hpp"

namespace percuss::accuracy {
namespace {

constexpr double kFs_Hz = 25600;
constexpr std::pair<double, double> kBand_Hz{60, 3200}, kNarrow_Hz{60, 700};
constexpr std::size_t kHits = 10, kChannels = 8;

// Ten hits of one second with 0.1 % of noise. The modes depend on the number of channels: with eight, the slowest one
// decays to 0.1 % in 0.7 s.
synth::SynthSpec plain_test(std::size_t channels) {
  synth::SynthSpec spec = spread_structure(3, channels);
  spec.fs_Hz = kFs_Hz;
  spec.samples = static_cast<std::size_t>(kFs_Hz);
  spec.hits = kHits;
  spec.noise = {.force = 0, .accel = 0.001};
  return spec;
}

// The same hits in one long record, with silence after each decay.
synth::SynthSpec long_record(double seconds) {
  synth::SynthSpec spec = plain_test(2);
  spec.layout = synth::SynthLayout::continuous;
  spec.samples = static_cast<std::size_t>(seconds * kFs_Hz);
  return spec;
}

// Records in a temporary folder.
class Files {
 public:
  // Writes the record of a spec as HDF5 and returns its path.
  std::string write(const synth::SynthSpec& spec, const std::string& name) const {
    std::string path = folder_.file(name + ".h5");
    acquire::write_hdf5(path, synth::synthesise(spec).record, true);
    return path;
  }

 private:
  TemporaryFolder folder_{"percuss-accuracy"};
};

enum class Wanted { hits, frfs, modes };

// Opens the record and analyses it on one thread, up to the wanted result.
std::function<void()> analysis_task(const std::string& path, const pipeline::AnalysisOptions& options, Wanted wanted,
                                    const acquire::ReadOptions& reading = {}) {
  return [=] {
    pipeline::AnalysisOptions one = options;
    one.threads = 1;
    const pipeline::Analysis analysis(acquire::open_record(path, reading), one);
    if (wanted == Wanted::hits) analysis.force_hits();
    if (wanted == Wanted::frfs) analysis.frfs();
    if (wanted == Wanted::modes) analysis.classifications();
  };
}

}  // namespace

std::vector<Saving> study_skips(Extent extent, const TimingOptions& timing) {
  const Files files;
  const std::string many = files.write(plain_test(kChannels), "many"), two = files.write(plain_test(2), "two");
  const std::string row = files.write(long_record(extent == Extent::quick ? 10 : 60), "long");
  const pipeline::AnalysisOptions plain{.band_Hz = kBand_Hz}, narrow{.band_Hz = kNarrow_Hz};
  pipeline::AnalysisOptions ungated = plain, rejecting = plain, whole_rows = plain, quick = plain;
  ungated.hits.gate_force = false;
  for (std::size_t h = 2; h < kHits; ++h) rejecting.reject_hits.push_back(h);
  whole_rows.hits.length_s = 1e9;  // up to the next hit
  quick.modes.effort = identify::Effort::quick;
  acquire::ReadOptions one_channel;
  one_channel.accel_channels = {"1"};

  std::vector<Saving> savings;
  const auto compare = [&](const char* what, const char* when, const std::function<void()>& with,
                           const std::function<void()>& without) {
    const std::vector<double> best_s = best_interleaved_s({with, without}, timing);
    savings.push_back({.what = what, .when = when, .with_s = best_s[0], .without_s = best_s[1]});
  };
  using enum Wanted;
  compare("seven of eight channels", "`--accel-channel 1`: their bytes are not read", analysis_task(many, plain, frfs),
          analysis_task(many, plain, frfs, one_channel));
  compare("accelerations", "`--only hits`: their bytes are not read", analysis_task(many, plain, frfs),
          analysis_task(many, plain, hits));
  compare("modes", "`--only frf`: no section of the report needs them", analysis_task(two, plain, modes),
          analysis_task(two, plain, frfs));
  compare("the search for modes without a peak and the joint fit", "`--effort quick`", analysis_task(two, plain, modes),
          analysis_task(two, quick, modes));
  compare("lines outside a narrow band", "`--band 60:700`: not stored, not averaged, not fitted",
          analysis_task(two, plain, modes), analysis_task(two, narrow, modes));
  compare("eight of ten hits", "rejected: their accelerations are not read", analysis_task(two, plain, frfs),
          analysis_task(two, rejecting, frfs));
  compare("the force outside its pulse",
          "unless `--force-window off`: it is only noise, so the short pulse is transformed alone",
          analysis_task(two, ungated, frfs), analysis_task(two, plain, frfs));
  compare("silence and decayed tails of a long record", "always: only background follows a decay",
          analysis_task(row, whole_rows, modes), analysis_task(row, plain, modes));
  return savings;
}

}  // namespace percuss::accuracy
