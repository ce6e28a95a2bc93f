#include "report/csv/modes_csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "identify/shapes/mode_shapes.hpp"

namespace percuss::report {

std::string modes_csv(const std::vector<NumberedAnalysis>& tests) {
  std::string out = tests.size() > 1 ? "test," : "";
  out +=
      "mode,frequency_hz,frequency_std_hz,damping_ratio,damping_ratio_std,family,order,point,channel,residue_re,"
      "residue_im,residue_std\n";
  auto end = std::back_inserter(out);
  for (const NumberedAnalysis& test : tests) {
    if (!test.analysis->possible()) continue;
    const auto& modes = test.analysis->modes();
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const identify::Mode& mode = modes[m];
      const identify::ModeClassification& found = test.analysis->classifications()[m];
      for (const identify::Residue& residue : mode.residues) {
        if (tests.size() > 1) fmt::format_to(end, "{},", test.run);
        fmt::format_to(end, "{},{},{},{},{},{},{},{},{},{},{},{}\n", m, mode.pole.freq_Hz, mode.freq_std_Hz,
                       mode.pole.damping_ratio, mode.damping_std, name_of(found.family),
                       found.order > 0 ? fmt::format("{}", found.order) : "", residue.point, residue.channel,
                       residue.value.real(), residue.value.imag(), identify::total_std(residue));
      }
    }
  }
  return out;
}

}  // namespace percuss::report
