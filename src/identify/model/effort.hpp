#pragma once

namespace percuss::identify {

/// The effort of an identification. The first figure is the run time of a whole analysis over the time of the bare
/// transforms of the same records in memory. The test has five hits and a close pair. The second figure is the error of
/// the frequencies over the Cramér–Rao bound.
enum class Effort {
  quick,     // each peak fitted over its own spectral lines, by two modes if one does not fit: 2.1 times, 2.0
  standard,  // … over more lines, and modes without a peak: 3.0 times, 1.7
  best,      // … and a fit of all modes together: 15 times, 1.0
};
const char* name_of(Effort effort);

}  // namespace percuss::identify
