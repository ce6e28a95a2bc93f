#include "commands/batch/batch_commands.hpp"

#include "commands/commands.hpp"

namespace percuss::tools {

void add_batch(CommandLine& line) {
  line.group("batch", "Analyse many records, on one machine or as shards on a cluster");
  add_batch_plan(line);
  add_batch_run(line);
  add_batch_status(line);
  add_batch_merge(line);
  add_batch_submit(line);
}

}  // namespace percuss::tools
