#pragma once
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::test {

/// percuss record with simulated devices, in an empty folder.
struct RecordBench {
  ScratchFolder folder;
  ProcessOutcome run(const std::vector<std::string>& arguments) const {
    return run_percuss(arguments, {.folder = folder.path()});
  }
  ProcessOutcome record(const std::string& device, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"record", "-o", "t.h5", "--device", device, "--fast"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  std::string bytes(const std::string& name) const { return bytes_of(folder.file(name)); }
  bool has(const std::string& name) const { return std::filesystem::exists(folder.file(name)); }
  std::vector<acquire::RowMark> marks() const {
    std::vector<acquire::RowMark> out;
    for (const auto& row : acquire::open_hdf5(folder.file("t.h5"), {}).rows) out.push_back(row.mark);
    return out;
  }
  /// Runs a shell line in the folder, with percuss on the path; returns its exit code.
  int shell(const std::string& line) const {
    const std::string programs = std::filesystem::path(PERCUSS_EXECUTABLE).parent_path();
    const std::string command =
        "cd '" + folder.path() + "' && PATH='" + programs + "':$PATH && { " + line + "\n} </dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  /// Begins a command, whose output goes to the files out and err. Runs `act` as soon as the shell command `condition`
  /// (such as kHasBegun) succeeds, but after ten seconds in any case. Returns the command's exit code.
  int run_and_act(const std::string& command, const std::string& condition, const std::string& act) const {
    return shell(command + " >out 2>err &\nfor i in $(seq 500); do " + condition + " && break; sleep 0.02; done\n" +
                 act + "\nwait $!");
  }
  static constexpr const char* kHasBegun = "[ -e t.h5.journal ]";
};

}  // namespace percuss::test
