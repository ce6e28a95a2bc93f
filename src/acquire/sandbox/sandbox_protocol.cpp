#include "acquire/sandbox/sandbox_protocol.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <new>
#include <utility>

#include "acquire/channels/csv_columns.hpp"
#include "acquire/sandbox/serialization.hpp"
#include "core/error.hpp"

namespace percuss::acquire {
namespace {

bool send_outcome(int descriptor, SandboxOutcome outcome, const std::string& payload) {
  const std::array<std::uint64_t, 2> head{static_cast<std::uint64_t>(outcome), payload.size()};
  return send_bytes(descriptor, head.data(), sizeof head) && send_bytes(descriptor, payload.data(), payload.size());
}

std::string serialized_ambiguous_columns(const AmbiguousColumns& error) {
  Serializer out;
  out.put(std::string_view(error.what()));
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
  return out.bytes();
}

}  // namespace

bool send_bytes(int descriptor, const void* from, std::size_t bytes) {
  const auto* at = static_cast<const char*>(from);
  while (bytes > 0) {
    const auto sent = ::write(descriptor, at, bytes);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += sent;
    bytes -= static_cast<std::size_t>(sent);
  }
  return true;
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

void throw_ambiguous_columns(const std::string& payload) {
  Deserializer in(payload);
  CsvHeader header{.named = true, .text = false};
  const std::string message = in.text(), format = in.text();
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
  AmbiguousColumns error(InputError::with_message(message), header);
  error.format = format;
  throw error;
}

bool run_and_send_outcome(int descriptor, const std::function<std::string()>& work) {
  try {
    return send_outcome(descriptor, SandboxOutcome::good, work());
  } catch (const AmbiguousColumns& error) {
    return send_outcome(descriptor, SandboxOutcome::ambiguous, serialized_ambiguous_columns(error));
  } catch (const InputError& error) {
    return send_outcome(descriptor, SandboxOutcome::input_error, error.what());
  } catch (const std::bad_alloc&) {
    return send_outcome(descriptor, SandboxOutcome::no_memory, "");
  } catch (const std::exception& error) {
    return send_outcome(descriptor, SandboxOutcome::other, error.what());
  }
}

}  // namespace percuss::acquire
