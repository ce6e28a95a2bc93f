#include "acquire/formats/hdf5/hdf5_rate.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "acquire/channels/signal_overrides.hpp"
#include "acquire/record/sampling_rate.hpp"
#include "core/error.hpp"

namespace percuss::acquire::hdf5 {
namespace {

// The rate in the file's attribute fs, if it is usable.
std::optional<double> own_rate_Hz(const InputHdf5& file) {
  try {
    if (const auto own = number_attribute(file.id(), "fs", file.path(), 1)) return own->front();
  } catch (const InputError&) {
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

double read_rate_Hz(const InputHdf5& file, const InputDataSet* force, const InputDataSet& accel,
                    const ReadOptions& options, std::vector<Message>& notes) {
  if (options.fs_Hz) {
    if (const auto own_Hz = own_rate_Hz(file)) note_other_rate("the file", *own_Hz, *options.fs_Hz, notes);
    return checked_rate_Hz(*options.fs_Hz, "the rate stated");
  }
  std::vector<std::pair<Id, std::string>> places{{file.id(), file.path() + ": attribute fs"},
                                                 {accel.id(), accel.where() + " attribute fs"}};
  if (force != nullptr) places.insert(places.begin() + 1, {force->id(), force->where() + " attribute fs"});
  std::optional<double> found_Hz;
  for (const auto& [object, where] : places) {
    const auto values = number_attribute(object, "fs", where, 1);
    if (!values) continue;
    const double fs_Hz = checked_rate_Hz(values->front(), where);
    if (found_Hz && *found_Hz != fs_Hz) {
      throw InputError(fmt::format("two sampling rates: {} and {} Hz", *found_Hz, fs_Hz), where, "state the right one",
                       {"fs"});
    }
    found_Hz = fs_Hz;
  }
  if (found_Hz) return *found_Hz;
  throw InputError("no sampling rate: attribute fs is missing", file.path(), "store it, or state the rate, in Hz",
                   {"fs"});
}

void convert_missing_times(const InputHdf5& file, Record& record) {
  const auto own_Hz = own_rate_Hz(file);
  for (RecordFault& fault : record.faults) {
    if (own_Hz && fault.kind == FaultKind::missing_samples) fault.time_s *= *own_Hz / record.fs_Hz;
  }
}

}  // namespace percuss::acquire::hdf5
