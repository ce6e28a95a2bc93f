#include "commands/batch/batch_options.hpp"

#include <algorithm>

#include "acquire/channels/channel_setup.hpp"
#include "cli/option_names.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "report/text/version.hpp"

namespace percuss::tools {
namespace {

constexpr std::uint64_t kMaxSetup_bytes = std::uint64_t{1} << 20U;
constexpr const char* kSetup = "--setup=";  // the manifest stores the text of the file, not its path

std::string head_place(const batch::Manifest& manifest) { return manifest.path() + ", line 1, options"; }

// Accepts only analysis and reading options. They stand under a heading; --help stands under none.
void require_known(const CommandLine& line, const batch::Manifest& manifest) {
  const DeclaredCommand& command = *find_command(line.declaration(), "analyze");
  for (const std::string& word : manifest.head().options) {
    const DeclaredOption* const option = find_option(command, word.substr(0, word.find('=')));
    if (option == nullptr || option->group.empty()) {
      throw InputError("there is no option " + one_line(word, 60), head_place(manifest),
                       "plan the batch with this version of percuss");
    }
  }
}

// Parses the stored options with the checks of the command line.
void parse_options(const batch::Manifest& manifest, BatchOptions& options) {
  CommandLine line("percuss", "", report::version());
  Command command = line.command("analyze", "", [] { return 0; });
  add_batch_options(command, options);
  require_known(line, manifest);
  std::vector<std::string> words{"percuss", "analyze"};
  words.insert(words.end(), manifest.head().options.begin(), manifest.head().options.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size());
  for (std::string& word : words) pointers.push_back(word.data());
  line.run(static_cast<int>(pointers.size()), pointers.data());
}

}  // namespace

void add_batch_options(Command& command, BatchOptions& options) {
  options.read.options.force_optional = true;  // as analyze, which fits free decays
  add_reading_options(command, options.read);
  add_analysis_options(command, options.analysis);
}

void store_batch_options(const Command& command, const BatchOptions& options, batch::BatchHeader& head) {
  // The results are not used: these calls reject invalid options.
  analysis_options(options.analysis);
  resolved_read_options(options.read);
  per_file_read_options(options.read);
  for (const char* heading : {kReadingHeading, kAnalysisHeading}) {
    for (std::string& word : command.given(heading)) head.options.push_back(std::move(word));
  }
  std::erase_if(head.options, [](const std::string& word) { return word.starts_with(kSetup); });
  if (!options.read.setup_path.empty())
    head.setup = std::string(read_input(options.read.setup_path, kMaxSetup_bytes).view());
}

batch::RowOptions row_options(const batch::Manifest& manifest, bool trust_input) {
  BatchOptions options;
  batch::RowOptions out{.frf = manifest.head().frf};
  try {
    parse_options(manifest, options);
    options.read.trust_input = trust_input;
    out.read = per_file_read_options(options.read);
    out.analysis = analysis_options(options.analysis);
  } catch (const UsageError& e) {
    throw InputError(e.what(), head_place(manifest), "plan the batch again");
  }
  out.write_option = flag_of;
  out.analysis.threads = 1;  // a batch runs its records in parallel, each on one thread
  if (!manifest.head().setup.empty())
    out.read.read.setup = acquire::parse_channel_setup(manifest.head().setup, manifest.path() + ", line 1, setup");
  return out;
}

}  // namespace percuss::tools
