#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "batch/sha256_file.hpp"
#include "cli/option_error.hpp"
#include "commands/record/record_flags.hpp"
#include "commands/record/record_paths.hpp"
#include "core/error.hpp"

namespace percuss::tools {
namespace {

using Json = nlohmann::ordered_json;

// Calls visit(key, member) for every option that belongs to the session.
template <class Flags, class Visit>
void each_setting(Flags& flags, Visit&& visit) {
  visit("device", flags.device);
  visit("hits", flags.hits);
  visit("channels", flags.channels);
  visit("fs", flags.fs_Hz);
  visit("trigger", flags.trigger_N);
  visit("pretrigger", flags.pretrigger_s);
  visit("length", flags.length_s);
  visit("geometry", flags.geometry);
  visit("roving", flags.roving);
  visit("band", flags.band);
  visit("object", flags.object);
  visit("until", flags.until);
  visit("report", flags.report);
  visit("setup", flags.read.setup_path);
  visit("fast", flags.fast);
  visit("date", flags.date);
}

// Files that a resumed session reads again, and the keys of their checksums.
template <class Visit>
void each_file(const RecordFlags& flags, Visit&& visit) {
  if (!flags.geometry.empty()) visit("geometry", "geometry_sha256", flags.geometry);
  if (!flags.read.setup_path.empty()) visit("setup", "setup_sha256", flags.read.setup_path);
}

struct Write {
  Json& out;
  template <class Value>
  void operator()(const char* key, const Value& value) const {
    out[key] = value;
  }
  void operator()(const char* key, const std::optional<double>& value) const {
    if (value) out[key] = *value;
  }
};

struct Read {
  const nlohmann::json& in;
  const RecordFlags& typed;
  const SessionPaths& paths;

  template <class Value>
  void operator()(const char* key, Value& value) const {
    if (!keep_typed(key, in.at(key), value)) value = in.at(key).get<Value>();
  }
  // A file may be named by another path than in the session.
  void operator()(const char* key, std::string& value) const {
    if (!in.contains(key)) return;  // an option that is newer than the session
    const auto stored = in.at(key).get<std::string>();
    const std::string option = key, sha256 = in.value(option + "_sha256", "");
    const std::string here = option == "device"                          ? paths.find_device(stored)
                             : option == "geometry" || option == "setup" ? paths.find(stored, sha256)
                             : option == "report"                        ? paths.target(stored)
                                                                         : stored;
    if (!typed.is_given(key)) {
      value = here;
      return;
    }
    if (option == "device" && names_same_device(value, here)) return;
    if (!sha256.empty() && !value.empty() && batch::sha256_of_record(value) == sha256) return;
    keep_typed(key, in.at(key), value);
  }
  void operator()(const char* key, std::optional<double>& value) const {
    const nlohmann::json stored = in.contains(key) ? in.at(key) : nlohmann::json();
    if (keep_typed(key, stored, value ? nlohmann::json(*value) : nlohmann::json())) return;
    if (!stored.is_null()) value = stored.get<double>();
  }

 private:
  // Whether the command line gives the option. Its value must equal the stored one, except for --report and --fast.
  bool keep_typed(const std::string& key, const nlohmann::json& stored, const nlohmann::json& value) const {
    if (!typed.is_given(key)) return false;
    if (stored == value || key == "report" || key == "fast") return true;
    const bool absent = stored.empty() || stored == "";
    throw OptionError({key},
                      absent ? "contradicts the session, which began without it"
                             : "contradicts the session, which began with " + one_line(stored.dump(), 60),
                      "leave it out: a resumed session keeps its options");
  }
};

}  // namespace

std::string settings_json(const RecordFlags& flags) {
  Json out{{"event", "settings"}, {"frame", 0}};
  std::error_code ignored;
  out["folder"] = std::filesystem::current_path(ignored).string();  // relative paths begin there
  each_setting(flags, Write{out});
  each_file(flags, [&](const char* /*option*/, const char* key, const std::string& path) {
    out[key] = batch::sha256_of_record(path);
  });
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_settings(const std::string& event) { return event.starts_with(R"({"event":"settings")"); }

void restore_settings(const std::string& event, const std::string& where, RecordFlags& flags) {
  try {
    const auto in = nlohmann::json::parse(event);
    const RecordFlags typed = flags;
    const SessionPaths paths(in.value("folder", ""), where);
    each_setting(flags, Read{in, typed, paths});
    flags.session_report = paths.target(in.at("report").get<std::string>());
    each_file(flags, [&](const char* option, const char* key, const std::string& path) {
      if (std::error_code ignored; !std::filesystem::exists(path, ignored))
        throw InputError("a file of the session is missing", path, "state where it is now", {option});
      if (!in.contains(key) || in.at(key) == batch::sha256_of_record(path)) return;  // older journals have no checksums
      throw InputError("the file has changed since the session began", path, "restore it, and resume again", {option});
    });
  } catch (const nlohmann::json::exception&) {
    throw InputError("the options of the session cannot be read", where, "record it again, with the options");
  }
}

std::string journal_of(const std::string& output) { return output + ".journal"; }

}  // namespace percuss::tools
