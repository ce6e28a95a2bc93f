#pragma once
#include <string>
#include <vector>

#include "batch/manifest.hpp"
#include "batch/record_rows.hpp"
#include "cli/analysis_flags.hpp"
#include "cli/read_flags.hpp"

namespace percuss::tools {

/// The options of percuss analyze that change the results of a record.
struct BatchOptions {
  ReadFlags read;
  AnalysisFlags analysis;
};

void add_batch_options(Command& command, BatchOptions& options);

/// Stores the given options in the header of the manifest. `command` is the argument of add_batch_options;
/// `options.read.paths` are the records. Throws UsageError and InputError as percuss analyze does.
void store_batch_options(const Command& command, const BatchOptions& options, batch::BatchHeader& head);

/// Reads the options from a manifest. Throws InputError with the path of the manifest if they are invalid.
batch::RowOptions row_options(const batch::Manifest& manifest, bool trust_input);

}  // namespace percuss::tools
