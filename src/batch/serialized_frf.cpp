#include "batch/serialized_frf.hpp"

#include <algorithm>
#include <stdexcept>

#include "acquire/sandbox/sandbox_record.hpp"
#include "acquire/sandbox/serialization.hpp"
#include "core/error.hpp"
#include "report/text/digest.hpp"

namespace percuss::batch {
namespace {

void serialize_lines(acquire::Serializer& out, const acquire::LineRange& lines) {
  out.put(lines.fs_Hz);
  out.put(static_cast<std::uint64_t>(lines.samples));
  out.put(static_cast<std::uint64_t>(lines.first));
  out.put(static_cast<std::uint64_t>(lines.count));
}

acquire::LineRange deserialize_lines(acquire::Deserializer& in) {
  acquire::LineRange lines;
  lines.fs_Hz = in.get<double>();
  lines.samples = in.get<std::uint64_t>();
  lines.first = in.get<std::uint64_t>();
  lines.count = in.get<std::uint64_t>();
  return lines;
}

void serialize_frf(acquire::Serializer& out, const acquire::PointFrf& frf) {
  out.put(frf.point);
  out.put(static_cast<std::uint64_t>(frf.channel));
  out.put(static_cast<std::uint64_t>(frf.frf.averages));
  out.put_all(frf.frf.value);
  out.put_all(frf.frf.std);
  out.put_all(frf.frf.coherence);
}

acquire::PointFrf deserialize_frf(acquire::Deserializer& in) {
  acquire::PointFrf frf;
  frf.point = in.get<int>();
  frf.channel = in.get<std::uint64_t>();
  frf.frf.averages = in.get<std::uint64_t>();
  frf.frf.value = in.all<Complex>();
  frf.frf.std = in.all<double>();
  frf.frf.coherence = in.all<double>();
  return frf;
}

// Checks that every FRF has all lines and a known channel.
bool fits(const acquire::FrfRecord& record) {
  const auto holds = [&](const auto& values) { return values.empty() || values.size() == record.lines.count; };
  return !record.frfs.empty() && std::all_of(record.frfs.begin(), record.frfs.end(), [&](const acquire::PointFrf& one) {
    return one.channel < record.accel.size() && one.frf.value.size() == record.lines.count && holds(one.frf.std) &&
           holds(one.frf.coherence);
  });
}

}  // namespace

std::string serialize_frfs(const acquire::FrfRecord& record) {
  acquire::Serializer out;
  serialize_lines(out, record.lines);
  out.put(record.estimator);
  out.put(record.decay_per_s);
  out.put(static_cast<std::uint64_t>(record.accel.size()));
  for (const acquire::SignalInfo& signal : record.accel) acquire::serialize_signal(out, signal);
  out.put(static_cast<std::uint64_t>(record.frfs.size()));
  for (const acquire::PointFrf& frf : record.frfs) serialize_frf(out, frf);
  return report::base64({reinterpret_cast<const std::uint8_t*>(out.bytes().data()), out.bytes().size()});
}

acquire::FrfRecord deserialize_frfs(std::string_view text, const std::string& where) {
  acquire::FrfRecord record;
  try {
    const std::string bytes = report::from_base64(text);
    acquire::Deserializer in(bytes);
    record.lines = deserialize_lines(in);
    record.estimator = in.text();
    record.decay_per_s = in.get<double>();
    for (std::size_t left = in.count(1); left > 0; --left) record.accel.push_back(acquire::deserialize_signal(in));
    for (std::size_t left = in.count(1); left > 0; --left) record.frfs.push_back(deserialize_frf(in));
    if (fits(record)) return record;
  } catch (const std::out_of_range&) {
  }
  throw InputError("these are not FRFs", where, "run the shard again", {"batch.run.force"});
}

}  // namespace percuss::batch
