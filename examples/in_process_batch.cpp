// Analyses many records in one process, on all threads. A record that cannot be analysed does not end the batch.
//
//   in_process_batch [RECORD...]
//
// Without records, it synthesises eight tests of one bat with different hits and noise.
#include <percuss/batch.hpp>
#include <percuss/synth.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  const percuss::BatchOptions options{
      .analysis = {.band_Hz = percuss::Band{60, 3200}, .effort = percuss::Effort::standard},
      .on_result = [](const percuss::BatchResult& done) { std::fprintf(stderr, "%s\n", done.source.c_str()); }};
  std::vector<percuss::BatchResult> results;
  if (argc > 1) {
    results = percuss::analyze_batch(std::vector<std::string>(argv + 1, argv + argc), options);
  } else {
    std::vector<percuss::Record> records;
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
      records.push_back(percuss::synthesise_preset("wood-bat", {.seed = seed}).record);
    results = percuss::analyze_batch(records, options);
  }

  // The first mode of every record, then mean and scatter over the records.
  std::vector<double> first_Hz;
  for (const percuss::BatchResult& result : results) {
    if (result.error) {
      std::printf("%zu: %s\n", result.index, result.error->written(percuss::option_field).c_str());
    } else if (!result.modes.empty()) {
      const percuss::Mode& mode = result.modes.front();
      std::printf("%zu: %zu modes, the first at %.5f ± %.5f Hz\n", result.index, result.modes.size(), mode.freq_Hz,
                  mode.freq_std_Hz);
      first_Hz.push_back(mode.freq_Hz);
    }
  }
  if (first_Hz.size() < 2) return first_Hz.empty() ? 1 : 0;
  const auto count = static_cast<double>(first_Hz.size());
  double mean_Hz = 0, sum = 0;
  for (const double freq_Hz : first_Hz) mean_Hz += freq_Hz / count;
  for (const double freq_Hz : first_Hz) sum += (freq_Hz - mean_Hz) * (freq_Hz - mean_Hz);
  std::printf("mean %.5f Hz, scatter %.5f Hz\n", mean_Hz, std::sqrt(sum / (count - 1)));
  return 0;
}
