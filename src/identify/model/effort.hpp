#pragma once

namespace percuss::identify {

/// The effort of an identification. docs/project/accuracy.md has the run time and the error of each.
enum class Effort {
  quick,     // each peak fitted over its own spectral lines, by two modes if one does not fit
  standard,  // … over more lines, and modes without a peak
  best,      // … and a fit of all modes together
};
const char* name_of(Effort effort);

}  // namespace percuss::identify
