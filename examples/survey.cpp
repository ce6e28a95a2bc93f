// Mode shapes from a test of many points: which modes are alike (MAC), how many waves they have around a tube.
//
//   survey [RECORD GEOMETRY.csv [SHAPES.csv]]
//
// Without RECORD it makes the test of a barrel that is struck at 24 points; that record holds its geometry.
#include <percuss/error.hpp>
#include <percuss/survey.hpp>
#include <percuss/synth.hpp>
#include <percuss/write.hpp>

#include <cstdio>

int main(int argc, char** argv) try {
  const percuss::Record record =
      argc > 1 ? percuss::open_record(argv[1]) : percuss::synthesise_preset("roving-barrel").record;
  percuss::SurveyOptions options{.analysis = {.band_Hz = percuss::Band{60, 3200}}};
  if (argc > 2) options.geometry = percuss::read_geometry(argv[2]);
  const percuss::Survey survey(record, options);
  if (!survey.analysis().possible()) return 1;

  const auto modes = survey.modes();
  const auto shapes = survey.shapes();
  const auto tubes = survey.tubes();
  for (std::size_t m = 0; m < modes.size(); ++m) {
    std::printf("%9.3f Hz at %zu places, collinearity %.3f", modes[m].freq_Hz, shapes[m].places.size(), shapes[m].mpc);
    if (tubes[m]) std::printf(", %d waves around", tubes[m]->order);
    std::printf("\n");
  }

  // Off the diagonal, a MAC near 1 means that two modes have the same shape.
  for (const auto& row : survey.macs()) {
    for (const percuss::Mac& mac : row) std::printf("%6.3f", mac.value);
    std::printf("\n");
  }
  if (argc > 3) percuss::write(argv[3], survey, {.overwrite = true});
  return 0;
} catch (const percuss::InputError& error) {
  std::fprintf(stderr, "%s\n", error.written(percuss::option_field).c_str());
  return 3;
}
