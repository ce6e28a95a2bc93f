#include "acquire/sandbox/sandbox_protocol.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <stdexcept>
#include <utility>

#include "acquire/sandbox/sandbox_limits.hpp"
#include "core/io/write_all.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMaxOptions = 16, kMaxOption_bytes = 60;

bool send_outcome(int descriptor, SandboxOutcome outcome, const std::string& payload) {
  const SandboxOutcomeHead head{outcome, payload.size(), heap_growth_bytes()};
  return write_all(descriptor, {reinterpret_cast<const char*>(&head), sizeof head}) && write_all(descriptor, payload);
}

void serialize_error(Serializer& out, const InputError& error) {
  for (const std::string& field : {error.problem(), error.where(), error.remedy()}) out.put(field);
  serialize_options(out, error.options());
}

// The child may be compromised: an option's identifier reaches the user's terminal.
OptionId deserialize_option(Deserializer& in) {
  OptionId option = in.text();
  const bool valid = option.size() <= kMaxOption_bytes && std::all_of(option.begin(), option.end(), [](char c) {
                       return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
                     });
  if (!valid) throw std::out_of_range("not an option");
  return option;
}

template <class Error>
Error deserialize_error(Deserializer& in) {
  const std::string problem = in.text(), where = in.text(), remedy = in.text();
  return {problem, where, remedy, deserialize_options(in)};
}

std::string serialized_error(const InputError& error) {
  Serializer out;
  serialize_error(out, error);
  return out.bytes();
}

std::string serialized_ambiguous_columns(const AmbiguousColumns& error) {
  Serializer out;
  serialize_error(out, error);
  out.put(error.format);
  out.put(static_cast<std::uint64_t>(error.fs_Hz.has_value()));
  out.put(error.fs_Hz.value_or(0));
  out.put(static_cast<std::uint64_t>(error.columns.size()));
  for (const CsvColumn& column : error.columns) {
    out.put(static_cast<std::uint64_t>(column.index));
    out.put(column.name);
    out.put(column.base);
    out.put(column.unit);
    out.put(static_cast<std::uint64_t>(column.has_numbers));
  }
  out.put(error.guess.force);
  out.put(static_cast<std::uint64_t>(error.guess.accel.size()));
  for (const std::string& name : error.guess.accel) out.put(name);
  for (const bool known : {error.guess.rate_known, error.guess.in_volts, error.guess.force_in_volts,
                           error.guess.frf_table, error.roles_known})
    out.put(static_cast<std::uint64_t>(known));
  out.put(error.guess.assumed_rate_Hz);
  return out.bytes();
}

}  // namespace

void serialize_options(Serializer& out, const std::vector<OptionId>& options) {
  out.put(static_cast<std::uint64_t>(options.size()));
  for (const OptionId& option : options) out.put(option);
}

std::vector<OptionId> deserialize_options(Deserializer& in) {
  std::vector<OptionId> options(in.count(sizeof(std::uint64_t)));
  if (options.size() > kMaxOptions) throw std::out_of_range("too many options");
  for (OptionId& option : options) option = deserialize_option(in);
  return options;
}

bool receive_bytes(int descriptor, void* to, std::size_t bytes) {
  auto* at = static_cast<char*>(to);
  while (bytes > 0) {
    const auto got = ::read(descriptor, at, bytes);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    bytes -= static_cast<std::size_t>(got);
  }
  return true;
}

InputError deserialize_input_error(const std::string& payload) {
  Deserializer in(payload);
  return deserialize_error<InputError>(in);
}

MachineFault deserialize_machine_fault(const std::string& payload) {
  Deserializer in(payload);
  return deserialize_error<MachineFault>(in);
}

AmbiguousColumns deserialize_ambiguous_columns(const std::string& payload) {
  Deserializer in(payload);
  const auto problem = deserialize_error<InputError>(in);
  CsvHeader header{.named = true, .text = false};
  const std::string format = in.text();
  const bool has_rate = in.get<std::uint64_t>() != 0;
  const auto fs_Hz = in.get<double>();
  if (has_rate) header.fs_Hz = fs_Hz;
  const std::size_t columns = in.count(5 * sizeof(std::uint64_t));
  for (std::size_t i = 0; i < columns; ++i) {
    CsvColumn column{.index = in.get<std::uint64_t>()};
    column.name = in.text();
    column.base = in.text();
    column.unit = in.text();
    column.has_numbers = in.get<std::uint64_t>() != 0;
    header.columns.push_back(std::move(column));
  }
  AmbiguousColumns error(problem, header);
  error.format = format;
  error.guess.force = in.text();
  const std::size_t accels = in.count(sizeof(std::uint64_t));
  for (std::size_t i = 0; i < accels; ++i) error.guess.accel.push_back(in.text());
  for (bool* const known : {&error.guess.rate_known, &error.guess.in_volts, &error.guess.force_in_volts,
                            &error.guess.frf_table, &error.roles_known})
    *known = in.get<std::uint64_t>() != 0;
  error.guess.assumed_rate_Hz = in.get<double>();
  return error;
}

bool run_and_send_outcome(int descriptor, const std::function<std::string()>& work) {
  try {
    return send_outcome(descriptor, SandboxOutcome::good, work());
  } catch (const AmbiguousColumns& error) {
    return send_outcome(descriptor, SandboxOutcome::ambiguous_columns, serialized_ambiguous_columns(error));
  } catch (const MachineFault& error) {
    return send_outcome(descriptor, SandboxOutcome::machine_fault, serialized_error(error));
  } catch (const InputError& error) {
    return send_outcome(descriptor, SandboxOutcome::input_error, serialized_error(error));
  } catch (const std::bad_alloc&) {
    return send_outcome(descriptor, SandboxOutcome::no_memory, "");
  } catch (const std::exception& error) {
    return send_outcome(descriptor, SandboxOutcome::other_error, error.what());
  }
}

}  // namespace percuss::acquire
