#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "acquire/write_record.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "commands/commands.hpp"
#include "core/budget.hpp"
#include "core/error.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/input_file.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"
#include "synth/truth_json.hpp"

namespace percuss::tools {
namespace {

namespace fs = std::filesystem;

struct SynthFlags {
  std::string spec;
  std::vector<std::string> outputs;
  std::optional<std::uint64_t> seed;
  std::size_t threads = 0;
  bool force = false, list = false, example = false, json = false;
  bool quiet = false;    // accepted as by other commands; this one prints neither progress nor warnings
  Host* host = nullptr;  // receives the test in place of standard output
};

synth::SynthSpec spec_named(const std::string& name) {
  std::error_code ignored;
  if (name != "-" && !fs::exists(name, ignored) && name.find('/') == std::string::npos)
    return synth::synth_preset(name);
  const auto bytes = read_input(name, synth::kMaxSpec_bytes + 1);
  return synth::parse_synth_spec(bytes.view(), input_name(name));
}

std::string truth_path(const std::string& output) { return fs::path(output).replace_extension(".truth.json").string(); }

/// Checks the output paths before anything is computed.
void check_outputs(const SynthFlags& flags) {
  std::set<std::string> paths;
  for (const std::string& output : flags.outputs) {
    const std::string kind = extension_of(output);
    const auto& known = acquire::record_extensions();
    if (std::find(known.begin(), known.end(), kind) == known.end()) {
      throw OptionError({}, fmt::format("unknown kind of output '{}'", output),
                        fmt::format("name a file that ends in {}", fmt::join(known, ", ")));
    }
    if (!paths.insert(output).second)
      throw OptionError({}, fmt::format("'{}' is to be written twice", output), "name each file once");
    paths.insert(truth_path(output));
  }
  for (const std::string& path : paths) require_output_path(path, flags.force);
}

void write_outputs(const SynthFlags& flags, const synth::SyntheticTest& test, const std::string& truth) {
  std::set<std::string> truths;
  OutputGroup outputs;
  for (const std::string& output : flags.outputs) {
    acquire::write_record(output, test.record, flags.force);
    truths.insert(truth_path(output));
  }
  for (const std::string& path : truths) write_file(path, truth, flags.force);
  outputs.commit();
}

void print_summary(const SynthFlags& flags, const synth::Truth& truth, const acquire::Record& record) {
  const synth::SynthSpec& spec = truth.spec;
  std::cout << fmt::format("{}: {} {} of {} samples at {:g} Hz, {} acceleration channels\n", one_line(spec.name),
                           record.rows.size(), record.rows.size() == 1 ? "row" : "rows", spec.samples, spec.fs_Hz,
                           spec.sensors.size());
  for (const synth::SynthMode& m : spec.modes) {
    std::cout << fmt::format("{:>10.3f} Hz  {:>7.4f} %  {} {}\n", m.freq_Hz, 100 * m.damping_ratio,
                             m.type == synth::SynthModeType::bending ? "bending" : "hoop", m.order);
  }
  for (std::size_t h = 0; h < truth.hits.size(); ++h) {
    if (truth.hits[h].flag != "good") std::cout << fmt::format("  hit {}: {}\n", h + 1, truth.hits[h].flag);
  }
  for (const std::string& output : flags.outputs)
    std::cout << fmt::format("{}, truth in {}\n", one_line(output, 400), one_line(truth_path(output), 400));
}

std::string presets_text(bool json) {
  std::string text;
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const synth::SynthPreset& preset : synth::synth_presets()) {
    const synth::SynthSpec spec = synth::synth_preset(preset.name);
    all.push_back({{"name", preset.name}, {"description", spec.description}});
    text += fmt::format("{:<16} {}\n", preset.name, spec.description);
  }
  if (!json) return text;
  return nlohmann::ordered_json{{"schema", "percuss/synth-presets/1"}, {"presets", all}}.dump(1, ' ') + "\n";
}

void give_to_host(const SynthFlags& flags, const std::shared_ptr<const synth::SyntheticTest>& test,
                  const std::string& truth) {
  CommandResult& outcome = flags.host->outcome;
  outcome.document = truth;
  outcome.synthetic = test;
  outcome.save = [flags, test, truth](const SaveRequest& request) {
    SynthFlags file_flags = flags;
    file_flags.outputs = {request.path};
    file_flags.force = request.force;
    file_flags.host = nullptr;
    check_outputs(file_flags);
    write_outputs(file_flags, *test, truth);
  };
}

int run_synth(const SynthFlags& flags) {
  if (flags.list || flags.example) {
    const std::string text =
        (flags.list ? presets_text(flags.json) : "") + std::string(flags.example ? synth::synth_example() : "");
    print({.host = flags.host}, text);
    return kOk;
  }
  if (flags.spec.empty())
    throw OptionError({}, "no spec is given", "name a JSON file, a preset, or - for standard input", {"synth.list"});
  if (flags.outputs.empty() && !flags.json)
    throw OptionError({}, "no output is given", "name a file that ends in .h5 or .csv", {"output"});
  check_outputs(flags);
  synth::SynthSpec spec = spec_named(flags.spec);
  spec.seed = flags.seed.value_or(spec.seed);
  BudgetMeter unlimited(Budget{}, "synth");  // lets a host interrupt
  const BudgetScope scope(unlimited);
  const auto made = std::make_shared<const synth::SyntheticTest>(synth::synthesise(spec, flags.threads));
  const synth::SyntheticTest& test = *made;
  const std::string truth = synth::truth_json(test.truth);
  write_outputs(flags, test, truth);
  if (flags.host != nullptr) {
    give_to_host(flags, made, truth);
  } else if (flags.json) {
    std::cout << truth;
  } else {
    print_summary(flags, test.truth, test.record);
  }
  return kOk;
}

}  // namespace

void add_synth(CommandLine& line) {
  auto flags = line.values<SynthFlags>();
  Command command = line.command("synth", "Make synthetic test records with exactly known truth",
                                 [flags] { return run_synth(*flags); });
  flags->host = command.host();
  command.about(
      "Makes hammer tests of structures with exactly known modes, with noise and the faults of real tests, for "
      "learning and for tests of software. Each record that is written has its truth beside it, as JSON. "
      "docs/guides/synth.md describes the spec.");
  command.example("percuss synth --list", "List the presets");
  command.example("percuss synth composite-bat -o composite.h5",
                  "Write a preset as a record, with its truth in composite.truth.json");
  command.example("percuss synth --example > spec.json; percuss synth spec.json --seed 7 -o bat.csv",
                  "Print an example spec, and make a record from it");
  std::vector<std::string> presets;
  for (const synth::SynthPreset& preset : synth::synth_presets()) presets.emplace_back(preset.name);
  command.argument("SPEC", flags->spec, "JSON file or name of a preset; - is standard input").suggest(presets);
  command
      .repeatable("-o,--output", flags->outputs,
                  "Write this record: .h5, .hdf5, .csv, .mat, .uff, .unv, .wav, .rf64, .w64 (repeatable); the truth "
                  "goes to the same name with .truth.json")
      .type("FILE");
  command.value("--seed", flags->seed, "Use this seed for noise and hits, in place of the spec's").type("N");
  command.value("--threads", flags->threads, "Use this many threads (0: all; the samples are the same)").type("N");
  command.flag("--force", flags->force, "Overwrite existing files");
  command.flag("--list", flags->list, "List the presets");
  command.flag("--example", flags->example, "Print an example spec with every key and comments");
  command.flag("--json", flags->json, "Print the truth (with --list: the presets) as one JSON document");
  command.flag("--quiet", flags->quiet, "Print no progress and no warnings");
}

}  // namespace percuss::tools
