#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/analysis_flags.hpp"
#include "commands/commands.hpp"
#include "commands/record/channel_list.hpp"
#include "commands/record/record_flags.hpp"

namespace percuss::tools {
namespace {

// "hits", "output", … of the options on the command line.
std::vector<std::string> given_options(const Command& command) {
  std::vector<std::string> names;
  for (const char* heading : {"", kReadingHeading}) {
    for (const std::string& word : command.given(heading)) {
      const std::size_t first = word.find_first_not_of('-');
      names.push_back(word.substr(first, word.find('=') - first));
    }
  }
  return names;
}

void describe_record(Command& command) {
  command.about(
      "Records blows of a hammer from a device, one row per blow, and says after each whether it counts, and otherwise "
      "what to do. Goes from point to point of a geometry. Rejected blows stay in the file, marked. Every sample from "
      "shortly before the first blow on goes to a journal beside the file as it arrives; after a kill or a loss of "
      "power, --resume goes on. Keys on a terminal: space pauses, u undoes the last accepted blow, r repeats the "
      "point, n goes to the next point that lacks blows, g to a point by its number, q finishes and writes what is "
      "there. Without a terminal, it runs until every point has its blows. Exit code 0: every point has its blows, the "
      "goal of --until is met, or q was pressed; 4: no blow counts; 6: the device or a signal ended the session early; "
      "the file holds what was recorded, and --resume goes on.");
  command.example("percuss record -o test.h5 --device sim:aluminium-bat --fast",
                  "Try it with a simulated bat, faster than real time");
  command.example(
      "percuss record -o test.h5 --device sim:aluminium-bat --fast --force --hits 10 --until \"hoop1<0.2Hz\"",
      "Stop early, once the first hoop mode is known to 0.2 Hz");
  command.example(
      "percuss record -o test.h5 --device sim:aluminium-bat --fast --force --band 60:3200 --report test.html",
      "Write the report at the end, and reject blows that do not reach the end of the band");
}

void add_recording_options(Command& command, RecordFlags& flags) {
  command.value("-o,--output", flags.output, "Write the record to this file; its kind: .h5, .hdf5").type("FILE");
  command
      .value(
          "--device", flags.device,
          "Record from this device: a name that percuss devices lists, sim:SPEC (simulated), file:RECORD (replayed), "
          "stdin: (WAV from a pipe, or stdin:raw:s24:51200:2); list: print them")
      .type("NAME");
  command.value("--hits", flags.hits, "Record this many accepted blows at each point")
      .type("N")
      .above_zero()
      .show_default();
  command
      .list("--channels", flags.channel_list,
            "Record only these channels of the device, in this order: numbers from 1 or ranges, such as 1,3-5")
      .type("N,...")
      .add_check(kChannelsRequirement, names_channels);
  command.value("--fs", flags.fs_Hz, "Choose the sampling rate (default: the device's own)").type("HZ").above_zero();
  add_setup_option(command, flags.read);
}

void add_blow_options(Command& command, RecordFlags& flags) {
  command.value("--trigger", flags.trigger_N, "Take a force above this level for a blow (default: from the noise)")
      .type("NEWTON")
      .above_zero();
  command
      .value("--pretrigger", flags.pretrigger_s,
             "Keep this time before the peak of a blow (default: 128 samples, 5 ms or twice its rise, whichever is "
             "longest)")
      .type("S")
      .not_negative();
  command
      .value("--length", flags.length_s,
             "Keep this time of each blow (default: until the decay of the first blow has ended)")
      .type("S")
      .above_zero();
}

void add_guidance_options(Command& command, RecordFlags& flags) {
  command
      .value("--geometry", flags.geometry,
             "Guide from point to point of this file, a CSV as percuss survey --example prints it")
      .type("FILE");
  command.value("--roving", flags.roving, "Choose what moves from point to point")
      .one_of({"hammer", "sensor"})
      .show_default();
  command
      .value("--band", flags.band,
             "Analyse this band, and reject blows that do not reach its end (default: what the force reaches)")
      .type("LO:HI");
  add_object_option(command, flags.object);
  command
      .value("--until", flags.until,
             "Stop at a point before --hits blows when frequencies are known this well: \"hoop1<0.05Hz\", "
             "\"bending 2 < 0.1 %, mode 3<0.2Hz\"")
      .type("GOALS");
}

void add_session_options(Command& command, RecordFlags& flags) {
  command.value("--report", flags.report, "Write the report of the test at the end (.html or .pdf)").type("FILE");
  command
      .value("--resume", flags.resume,
             "Go on with the interrupted session that was recording this file (or name its journal), with its options; "
             "contradicting ones are refused")
      .type("FILE");
  command.flag("--fast", flags.fast, "Do not wait for real time: for sim: and file: only");
  command.flag("--json", flags.json, "Print the analysis as one JSON document; guidance goes to standard error");
  command.flag("--force", flags.force, "Overwrite existing files");
  command.flag("--quiet", flags.quiet, "Print no lines and ring no bell");
}

}  // namespace

void add_record(CommandLine& line) {
  auto flags = line.values<RecordFlags>();
  auto declared = std::make_shared<std::optional<Command>>();
  Command command =
      line.command("record", "Record a hammer test with guidance: each blow is graded at once", [flags, declared] {
        flags->given = given_options(**declared);
        return run_record(*flags);
      });
  describe_record(command);
  add_recording_options(command, *flags);
  add_blow_options(command, *flags);
  add_guidance_options(command, *flags);
  add_session_options(command, *flags);
  *declared = command;
}

}  // namespace percuss::tools
