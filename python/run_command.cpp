#include "run_command.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string_view>

#include "cli/open_files.hpp"
#include "cli/output.hpp"
#include "cli/read_flags.hpp"
#include "cli/shell_argument.hpp"
#include "commands/commands.hpp"
#include "report/text/version.hpp"

namespace percuss::python {
namespace {

using Json = nlohmann::ordered_json;
using namespace tools;

// A command of Python only, since its results are not text.
constexpr std::string_view kRead = "read";

// Opens files without reading their samples.
void add_read(CommandLine& line, Host& host) {
  auto flags = line.values<ReadFlags>();
  Command command =
      line.command("read", "Open records or FRFs; read the description now and the samples on demand", [flags, &host] {
        Measurements opened = open_measurements(*flags);
        for (acquire::Record& record : opened.records) {
          host.outcome.opened.emplace_back(std::move(record));
        }
        for (acquire::FrfRecord& frfs : opened.frfs) host.outcome.opened.emplace_back(std::move(frfs));
        return static_cast<int>(kOk);
      });
  add_read_flags(command, *flags);
}

std::string command_line_of(const std::vector<std::string>& words, const Host& host) {
  std::string line = "percuss";
  for (const std::string& word : words) line += ' ' + shell_quoted_argument(with_display_names(&host, word));
  return line;
}

Json json_of(const DeclaredOption& option) {
  return {{"name", option.name()},
          {"value", option.value},
          {"help", option.help},
          {"group", option.group},
          {"initial", option.initial},
          {"choices", option.choices},
          {"requirement", option.requirement},
          {"required", option.required},
          {"repeatable", option.repeatable},
          {"list", option.list}};
}

Json json_of(const DeclaredCommand& command) {
  Json arguments = Json::array(), options = Json::array(), examples = Json::array();
  for (const DeclaredOption& argument : command.arguments) arguments.push_back(json_of(argument));
  for (const DeclaredOption& option : command.options) options.push_back(json_of(option));
  for (const DeclaredExample& example : command.examples)
    examples.push_back({{"line", example.line}, {"meaning", example.meaning}});
  return {{"name", command.name},   {"summary", command.summary}, {"about", command.about},
          {"arguments", arguments}, {"options", options},         {"examples", examples}};
}

// A declared command line. Declaring one takes longer than running many of the commands.
struct Session {
  Host host;
  CommandLine line{"percuss", "", report::version(), &host};

  explicit Session(const std::string& first_word) {
    if (first_word == kRead) {
      add_read(line, host);
    } else {
      add_commands(line, first_word);
    }
  }
};

// Idle sessions by the first word of their command.
class SessionPool {
 public:
  std::unique_ptr<Session> acquire_session(const std::string& first_word) {
    {
      const std::scoped_lock lock(mutex_);
      auto& idle = idle_[first_word];
      if (!idle.empty()) {
        auto session = std::move(idle.back());
        idle.pop_back();
        return session;
      }
    }
    return std::make_unique<Session>(first_word);
  }
  void release(const std::string& first_word, std::unique_ptr<Session> session) {
    constexpr std::size_t kMaxIdle = 8;  // per command
    session->host = {};
    const std::scoped_lock lock(mutex_);
    auto& idle = idle_[first_word];
    if (idle.size() < kMaxIdle) idle.push_back(std::move(session));
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::vector<std::unique_ptr<Session>>> idle_;
};

SessionPool& session_pool() {
  static SessionPool pool;
  return pool;
}

}  // namespace

RunResult run_command(const std::vector<std::string>& arguments, std::vector<InMemoryInput> inputs,
                      const std::map<std::string, std::string>& names) {
  const std::string first = arguments.empty() ? std::string() : arguments.front();
  auto session = session_pool().acquire_session(first);  // an exception drops the session, which may be half parsed
  session->host.names = {names.begin(), names.end()};
  session->host.equivalent_command = command_line_of(arguments, session->host);
  session->host.inputs = std::move(inputs);
  std::vector<const char*> argv{"percuss"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  RunResult result;
  result.code = session->line.run(static_cast<int>(argv.size()), argv.data());
  result.outcome = std::move(session->host.outcome);
  session_pool().release(first, std::move(session));
  return result;
}

std::string declared_commands() {
  Host host;
  CommandLine line("percuss", "", report::version(), &host);
  add_commands(line, "");
  add_read(line, host);
  Json commands = Json::array();
  for (const DeclaredCommand& command : line.declaration().commands) {
    if (!command.is_group) commands.push_back(json_of(command));
  }
  return Json{{"commands", commands}}.dump();
}

}  // namespace percuss::python
