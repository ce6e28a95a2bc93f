#include "acquire/open_measurement.hpp"

#include <string_view>
#include <utility>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/format_registry.hpp"
#include "acquire/sandbox/fork_server.hpp"
#include "acquire/sandbox/sandbox_measurement.hpp"
#include "core/error.hpp"
#include "core/io/spooled_file.hpp"

namespace percuss::acquire {
namespace {

constexpr std::uint64_t kMaxPipe_bytes = std::uint64_t{4} << 30U;  // a pipe does not state its length
constexpr std::size_t kHead_bytes = std::size_t{1} << 16U;

void refuse_variable_name(const FrfReadOptions& options, const std::string& path) {
  if (options.read.fs_variable.empty()) return;
  throw InputError("the sampling rate is not a number: " + one_line(options.read.fs_variable, 40), input_name(path),
                   "state it in Hz (in MAT files it may be a variable)", {"fs"});
}

Measurement open_file(const std::string& path, const FrfReadOptions& options, Content content);

// Opens the bytes of a pipe as a temporary file, for libraries that read files only. The file is unlinked on return; a
// reader that still needs it keeps it open.
Measurement open_spooled(std::string_view bytes, const FrfReadOptions& options, Content content) {
  const SpooledFile file(bytes);
  const auto named = [&](const InputError& error) {
    std::string where = error.where();
    if (const std::size_t at = where.find(file.path()); at != std::string::npos)
      where.replace(at, file.path().size(), input_name("-"));
    return InputError(error.problem(), where, error.remedy(), error.options());
  };
  try {
    Measurement opened = open_file(file.path(), options, content);
    std::visit([](auto& one) { one.files.front().path = "-"; }, opened);
    return opened;
  } catch (const AmbiguousColumns& error) {
    AmbiguousColumns renamed = error;
    static_cast<InputError&>(renamed) = named(error);
    throw renamed;
  } catch (const MachineFault&) {
    throw;
  } catch (const InputError& error) {
    throw named(error);
  }
}

// Reads all of a pipe, unless its first bytes show that it cannot be read.
Measurement open_standard_input(const FrfReadOptions& options, Content content) {
  GrowthCheck check_growth;
  const auto check_head = [&](std::string_view bytes) {
    const FileHead head{"-", bytes};
    const FileFormat& format = detected_format(head);
    if (!format.names_variables) refuse_variable_name(options, "-");
    if (format.check != nullptr) format.check(head);
    if (format.growth_check != nullptr) check_growth = format.growth_check("-");
  };
  const auto check_text = [&](std::string_view text) {
    if (check_growth) check_growth(text);
  };
  const FileBytes stream = read_input("-", kMaxPipe_bytes, check_head, check_text, kSplitRecord);
  const FileFormat& format = detected_format({"-", stream.view()});
  return format.sandboxed ? open_spooled(stream.view(), options, content)
                          : format.open({"-", &stream}, options, content);
}

Measurement open_file(const std::string& path, const FrfReadOptions& options, Content content) {
  const std::string bytes = first_bytes(path, kHead_bytes);
  const FileHead head{path, bytes};
  const FileFormat& format = detected_format(head);
  if (!format.names_variables) refuse_variable_name(options, path);
  if (format.check != nullptr) format.check(head);
  const auto open = [&] { return format.open({path}, options, content); };
  return options.read.sandboxed && format.sandboxed ? open_in_sandbox(path, open) : open();
}

Measurement open_content(const std::string& path, const FrfReadOptions& options, Content content) {
  return path == "-" ? open_standard_input(options, content) : open_file(path, options, content);
}

}  // namespace

Measurement open_measurement(const std::string& path, const FrfReadOptions& options) {
  return open_content(path, options, Content::record_or_frfs);
}

Record open_record(const std::string& path, const ReadOptions& options) {
  Measurement opened = open_content(path, {.read = options, .kind = {}}, Content::record);
  if (auto* record = std::get_if<Record>(&opened)) return std::move(*record);
  throw InputError("the file holds FRFs, not a time record", path, "give force and acceleration");
}

bool needs_sandbox(const std::string& path) {
  const std::string bytes = first_bytes(path, kHead_bytes);
  return detected_format({path, bytes}).sandboxed;
}

std::shared_ptr<ForkServer> measurement_fork_server(const FrfReadOptions& options) {
  FrfReadOptions in_child = options;
  in_child.read.sandboxed = false;  // the child is the sandbox
  return std::make_shared<ForkServer>(
      [in_child](const std::string& path) { return measurement_service(open_measurement(path, in_child)); });
}

Measurement open_measurement_forked(const std::shared_ptr<ForkServer>& fork_server, const std::string& path,
                                    const FrfReadOptions& options) {
  if (fork_server->lost() || !needs_sandbox(path)) return open_measurement(path, options);
  try {
    return sandboxed_measurement(std::make_shared<SandboxProcess>(path, fork_server));
  } catch (const InputError&) {
    if (!fork_server->lost()) throw;
  }
  return open_measurement(path, options);
}

}  // namespace percuss::acquire
