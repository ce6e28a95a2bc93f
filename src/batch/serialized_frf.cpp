#include "batch/serialized_frf.hpp"

#include <algorithm>
#include <stdexcept>

#include "acquire/sandbox/sandbox_record.hpp"
#include "acquire/sandbox/serialization.hpp"
#include "core/error.hpp"
#include "report/text/digest.hpp"

namespace percuss {
namespace {

void serialize_lines(Serializer& out, const LineRange& lines) {
  out.put(lines.fs_Hz);
  out.put(static_cast<std::uint64_t>(lines.samples));
  out.put(static_cast<std::uint64_t>(lines.first));
  out.put(static_cast<std::uint64_t>(lines.count));
}

LineRange deserialize_lines(Deserializer& in) {
  LineRange lines;
  lines.fs_Hz = in.get<double>();
  lines.samples = in.get<std::uint64_t>();
  lines.first = in.get<std::uint64_t>();
  lines.count = in.get<std::uint64_t>();
  return lines;
}

void serialize_frf(Serializer& out, const PointFrf& frf) {
  out.put(frf.point);
  out.put(static_cast<std::uint64_t>(frf.channel));
  out.put(static_cast<std::uint64_t>(frf.frf.averages));
  out.put_all(frf.frf.value);
  out.put_all(frf.frf.std);
  out.put_all(frf.frf.coherence);
}

PointFrf deserialize_frf(Deserializer& in) {
  PointFrf frf;
  frf.point = in.get<int>();
  frf.channel = in.get<std::uint64_t>();
  frf.frf.averages = in.get<std::uint64_t>();
  frf.frf.value = in.all<Complex>();
  frf.frf.std = in.all<double>();
  frf.frf.coherence = in.all<double>();
  return frf;
}

// Every FRF has the lines and a channel that there are.
bool fits(const FrfRecord& record) {
  const auto holds = [&](const auto& values) { return values.empty() || values.size() == record.lines.count; };
  return !record.frfs.empty() && std::all_of(record.frfs.begin(), record.frfs.end(), [&](const PointFrf& one) {
    return one.channel < record.accel.size() && one.frf.value.size() == record.lines.count && holds(one.frf.std) &&
           holds(one.frf.coherence);
  });
}

}  // namespace

std::string serialize_frfs(const FrfRecord& record) {
  Serializer out;
  serialize_lines(out, record.lines);
  out.put(record.estimator);
  out.put(record.decay_per_s);
  out.put(static_cast<std::uint64_t>(record.accel.size()));
  for (const SignalInfo& signal : record.accel) serialize_signal(out, signal);
  out.put(static_cast<std::uint64_t>(record.frfs.size()));
  for (const PointFrf& frf : record.frfs) serialize_frf(out, frf);
  return base64({reinterpret_cast<const std::uint8_t*>(out.bytes().data()), out.bytes().size()});
}

FrfRecord deserialize_frfs(std::string_view text, const std::string& where) {
  FrfRecord record;
  try {
    const std::string bytes = from_base64(text);
    Deserializer in(bytes);
    record.lines = deserialize_lines(in);
    record.estimator = in.text();
    record.decay_per_s = in.get<double>();
    for (std::size_t left = in.count(1); left > 0; --left) record.accel.push_back(deserialize_signal(in));
    for (std::size_t left = in.count(1); left > 0; --left) record.frfs.push_back(deserialize_frf(in));
    if (fits(record)) return record;
  } catch (const std::out_of_range&) {
  }
  throw InputError("these are no FRFs", where, "run the shard again with --force");
}

}  // namespace percuss
