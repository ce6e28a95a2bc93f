#pragma once
#include <string>
#include <vector>

#include "batch/manifest.hpp"
#include "batch/record_rows.hpp"
#include "cli/analysis_flags.hpp"
#include "cli/read_flags.hpp"

namespace percuss::tools {

/// The options of percuss analyze on which a record's rows depend.
struct BatchOptions {
  ReadFlags read;
  AnalysisFlags analysis;
};

void add_batch_options(Command& command, BatchOptions& options);

/// What was given of them, as the manifest holds it. `command` is the one that add_batch_options was called for; in
/// `options.read.paths` are the records. Throws UsageError and InputError as percuss analyze does.
void store_batch_options(const Command& command, const BatchOptions& options, batch::BatchHeader& head);

/// The same back, from a manifest that may hold anything. errors  InputError naming the manifest.
batch::RowOptions row_options(const batch::Manifest& manifest, bool trust_input);

}  // namespace percuss::tools
