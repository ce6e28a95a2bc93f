#include "percuss/frf.hpp"
#include "acquire/record/channel_name.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "acquire/channels/stored_frfs.hpp"
#include "acquire/open_measurement.hpp"
#include "api/handles.hpp"
#include "core/error.hpp"
#include "report/frf_files.hpp"

namespace percuss {
namespace api {
namespace {

constexpr const char* kFrfArrays = "arrays of FRFs";

bool in_order(const Frf& a, const Frf& b) { return std::pair(a.point, a.channel) < std::pair(b.point, b.channel); }

void require_shape(const Frf& frf, std::size_t lines) {
  const auto fits = [&](std::size_t size) { return size == 0 || size == lines; };
  if (frf.value.size() != lines || !fits(frf.std.size()) || !fits(frf.coherence.size()))
    throw InputError("an FRF and the frequencies differ in length", kFrfArrays, "give one value per frequency");
}

// Throws InputError unless the sorted FRFs cover all channels of every point.
void require_all_channels(const std::vector<Frf>& frfs, std::size_t channels) {
  for (std::size_t i = 0; i < frfs.size(); ++i) {
    const bool begins = i % channels == 0, same_point = i > 0 && frfs[i].point == frfs[i - 1].point;
    const bool complete = frfs.size() % channels == 0 && frfs[i].channel == i % channels && begins != same_point;
    if (!complete) throw InputError("a point lacks a channel, or has it twice", kFrfArrays, "give each channel once");
  }
}

acquire::SignalInfo signal_of(const FrfArrays& arrays, std::size_t channel) {
  acquire::SignalInfo signal{.name = acquire::channel_name(channel)};
  if (!arrays.angle_rad.empty()) signal.angle_rad = arrays.angle_rad.at(channel);
  if (!arrays.position_m.empty()) signal.position_m = arrays.position_m.at(channel);
  return signal;
}

}  // namespace

acquire::FrfKind frf_kind(FrfKind kind) {
  if (kind == FrfKind::mobility) return acquire::FrfKind::mobility;
  return kind == FrfKind::receptance ? acquire::FrfKind::receptance : acquire::FrfKind::accelerance;
}

acquire::FrfReadOptions frf_read_options(const ReadOptions& options) {
  if (options.averages &&
      !(*options.averages >= 1 && static_cast<double>(*options.averages) <= acquire::kMaxAverages)) {
    throw InputError("the number of averages is not possible", "ReadOptions::averages", "give 1 to 10^9", {"averages"});
  }
  acquire::FrfReadOptions out{.read = read_options(options), .kind = std::nullopt, .averages = options.averages};
  if (options.frf_kind) out.kind = frf_kind(*options.frf_kind);
  return out;
}

FrfKind public_kind(acquire::FrfKind kind) {
  if (kind == acquire::FrfKind::mobility) return FrfKind::mobility;
  return kind == acquire::FrfKind::receptance ? FrfKind::receptance : FrfKind::accelerance;
}

FrfSet make_frf_set(acquire::FrfRecord record, FrfKind kind) {
  FrfData data{.record = std::move(record), .kind = kind, .freq_Hz = {}, .frfs = {}};
  const acquire::LineRange& lines = data.record.lines;
  data.freq_Hz = acquire::frequencies_Hz(lines);
  for (const acquire::PointFrf& from : data.record.frfs) {
    acquire::Frf frf = kind == FrfKind::accelerance
                           ? from.frf
                           : acquire::converted(from.frf, lines, frf_kind(kind), data.record.decay_per_s);
    data.frfs.push_back({.point = from.point,
                         .channel = from.channel,
                         .value = std::move(frf.value),
                         .std = std::move(frf.std),
                         .coherence = std::move(frf.coherence),
                         .averages = frf.averages});
  }
  return FrfSet(std::make_shared<const FrfData>(std::move(data)));
}

}  // namespace api

FrfKind FrfSet::kind() const { return data_->kind; }
std::string FrfSet::unit() const { return acquire::unit_of(api::frf_kind(data_->kind)); }
std::string FrfSet::estimator() const { return data_->record.estimator; }
const std::vector<double>& FrfSet::freq_Hz() const { return data_->freq_Hz; }
const std::vector<Frf>& FrfSet::frfs() const { return data_->frfs; }

std::vector<Channel> FrfSet::channels() const {
  std::vector<Channel> out;
  for (const acquire::SignalInfo& signal : data_->record.accel) out.push_back(api::channel_of(signal));
  return out;
}

FrfSet FrfSet::converted(FrfKind kind) const { return api::make_frf_set(data_->record, kind); }

FrfSet estimate_frfs(const Record& record, const FrfOptions& options) {
  const pipeline::Analysis analysis(api::record_of_one_run(record),
                                    api::analysis_options({.band_Hz = options.band_Hz,
                                                           .estimator = options.estimator,
                                                           .hits = options.hits,
                                                           .exponential = options.exponential,
                                                           .threads = options.threads}));
  return api::make_frf_set(report::frf_record_of(analysis), FrfKind::accelerance);
}

FrfSet open_frfs(const std::string& path, const ReadOptions& options) {
  auto opened = acquire::open_measurement(path, api::frf_read_options(options));
  auto* const frfs = std::get_if<acquire::FrfRecord>(&opened);
  if (frfs == nullptr) throw InputError("the file holds a time record, not FRFs", path, "use open_record");
  const FrfKind kind = api::public_kind(frfs->kind);
  return api::make_frf_set(std::move(*frfs), kind);
}

FrfSet frfs_from_arrays(const FrfArrays& arrays) {
  std::vector<Frf> frfs = arrays.frfs;
  if (frfs.empty()) throw InputError("no FRF", api::kFrfArrays, "give one or more");
  std::stable_sort(frfs.begin(), frfs.end(), api::in_order);
  const std::size_t channels = 1 + std::max_element(frfs.begin(), frfs.end(), [](const Frf& a, const Frf& b) {
                                     return a.channel < b.channel;
                                   })->channel;
  api::require_all_channels(frfs, channels);
  for (const std::vector<double>* places : {&arrays.angle_rad, &arrays.position_m}) {
    if (!places->empty() && places->size() != channels)
      throw InputError("places and channels differ in number", api::kFrfArrays, "give one place per channel");
  }
  acquire::StoredFrfs stored;
  stored.record.format = "arrays";
  stored.record.kind = api::frf_kind(arrays.kind);
  stored.kind = stored.record.kind;
  stored.set_lines(acquire::frequency_lines(arrays.freq_Hz, 1, api::kFrfArrays));
  for (std::size_t c = 0; c < channels; ++c) stored.record.accel.push_back(api::signal_of(arrays, c));
  for (Frf& frf : frfs) {
    api::require_shape(frf, arrays.freq_Hz.size());
    stored.frfs.push_back({.point = frf.point,
                           .channel = frf.channel,
                           .value = std::move(frf.value),
                           .std = std::move(frf.std),
                           .coherence = std::move(frf.coherence),
                           .averages = frf.averages});
  }
  return api::make_frf_set(acquire::to_accelerances(std::move(stored), {}), arrays.kind);
}

}  // namespace percuss
