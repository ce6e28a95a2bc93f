#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "acquire/formats/uff/uff_function.hpp"
#include "acquire/formats/uff/uff_nodes.hpp"
#include "acquire/formats/uff/uff_trace_lines.hpp"

namespace percuss::acquire {

/// Data set 164: SI = stored / factor.
struct UffUnits {
  double length = 1, force = 1;
};

/// The content of a universal file, as far as percuss reads it.
struct UffContents {
  std::vector<UffFunction> functions;  // data sets 58
  std::optional<UffUnits> units;
  std::map<int, std::array<double, 3>> nodes_m;  // data sets 15 and 2411, in global coordinates
  std::map<int, std::optional<UffAxes>> axes;    // of nodes with other displacement systems than the global one
  std::size_t nodes_left_out = 0;                // in coordinate systems of data set 2420
  UffTraceLines connections;                     // data sets 82 and 2412
  std::map<int, std::size_t> sets;               // count of data sets by number
  std::size_t shapes = 0;                        // of sets 55 and 2414
};

/// errors  InputError with file and line: a set 15, 18, 58, 164 or 2411 does not follow its layout. Unreadable trace
/// lines are not an error (UffTraceLines::unreadable).
UffContents read_uff_contents(const FileBytes& file);

/// Messages about the content that is not used, such as "data sets not used: 773 (2), 2467 (1)" or "mode shapes: 3, not
/// used".
std::vector<Message> uff_notes(const UffContents& contents);

/// Coordinates [points][3]. Row i holds node i + `offset`, or three NaN if the file has no such node. Empty, with a
/// note, when the nodes are numbered too far apart.
std::vector<std::vector<double>> uff_geometry(const UffContents& contents, int offset, std::vector<Message>& notes);
/// The lines whose two nodes are in the file, by point = node − `offset`.
std::vector<TraceLine> uff_trace_lines(const UffContents& contents, int offset);
/// The faces whose corners are all in the file, by point.
std::vector<TraceFace> uff_trace_faces(const UffContents& contents, int offset);
/// Adds geometry, trace lines, trace faces and notes to `out`, a SignalTable or an FrfRecord.
template <class Destination>
void add_uff_geometry(const UffContents& contents, int offset, Destination& out) {
  out.geometry = uff_geometry(contents, offset, out.notes);
  if (out.geometry.empty()) return;
  out.trace_lines = uff_trace_lines(contents, offset);
  out.trace_faces = uff_trace_faces(contents, offset);
}

/// The statements of percuss in a function's fifth line ("percuss; node = point + 1; dx = 3.90625e-05"), fourth line
/// ("averages = 5; angle_deg = 90; ") and second line ("estimator = H1").
struct UffAnnotation {
  bool by_percuss = false;
  bool continuous = false;
  int node_offset = 0;
  std::size_t averages = 0;
  std::optional<double> dx, angle_deg, position_m, decay_per_s;
  std::string estimator;  // of an FRF
};
UffAnnotation uff_annotation(const UffFunction& function);

/// Which step was taken for a rounded one, and how far the true step may be from it, relative. Empty without doubt.
struct UffStepNote {
  std::string text;
  double largest_error = 0;
};

/// The step of an even abscissa, in its unit, before it was rounded to 13 columns. If percuss stated the step in the
/// fifth line and it agrees with the text, the result is this step. Otherwise the result is one of the steps that round
/// to the same text:
///   for time, the step with the roundest inverse (the sampling rate);
///   for frequency, the roundest step, or the step with the roundest inverse (the duration) if that has fewer digits.
/// Sets `note` when a step found by roundness differs from the text.
/// to_SI  s or Hz per unit of the abscissa, for the note
double uff_step(const UffFunction& function, bool frequency, double to_SI, UffStepNote& note);

}  // namespace percuss::acquire
