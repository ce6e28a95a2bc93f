#pragma once

namespace percuss::identify {

/// The effort of an identification. docs/project/accuracy.md has the run time and the error of each.
enum class Effort {
  quick,     // each peak fitted over its own spectral lines, by two modes if one does not fit
  standard,  // as quick, over more spectral lines; also searches for modes without a peak, and fits all modes together
             // where satellites, frequency scatter or a misfit call for it
  best,      // as standard, but always fits all modes together
};
const char* name_of(Effort effort);

}  // namespace percuss::identify
