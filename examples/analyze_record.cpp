// Analyses one hammer test: hits, modes with their standard deviations, bending or hoop, a report.
//
//   analyze_record [RECORD [REPORT.html]]
//
// Without RECORD it makes the test of a composite bat whose modes are known.
#include <percuss/analysis.hpp>
#include <percuss/error.hpp>
#include <percuss/synth.hpp>
#include <percuss/write.hpp>

#include <cstdio>

int main(int argc, char** argv) try {
  const percuss::Record record =
      argc > 1 ? percuss::open_record(argv[1]) : percuss::synthesise_preset("composite-bat").record;
  const percuss::Analysis analysis(record, {.band_Hz = percuss::Band{60, 3200}});

  // Findings explain why a hit is rejected; FRFs and modes use the accepted hits.
  for (const percuss::Hit& hit : analysis.hits()) {
    std::printf("hit %zu: %5.0f N, %s\n", hit.index + 1, hit.peak_force_N, hit.accepted ? "accepted" : "rejected");
    for (const percuss::Finding& finding : hit.findings) std::printf("  %s\n", finding.message.c_str());
  }
  if (!analysis.possible()) return 1;

  const auto types = analysis.classifications();
  for (const percuss::Mode& mode : analysis.modes()) {
    const percuss::ModeClassification& type = types[mode.index];
    std::printf("%10.4f ± %.4f Hz  %.4f %%  %s %d\n", mode.freq_Hz, mode.freq_std_Hz, 100 * mode.damping_ratio,
                percuss::name_of(type.type), type.order);
  }
  for (const percuss::Warning& warning : analysis.warnings()) std::printf("! %s\n", warning.message.c_str());

  if (argc > 2) percuss::write(argv[2], analysis, {.overwrite = true});
  return 0;
} catch (const percuss::InputError& error) {
  // The message names the options concerned as fields of the C++ options.
  std::fprintf(stderr, "%s\n", error.written(percuss::option_field).c_str());
  return 3;
}
