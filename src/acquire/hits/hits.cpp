#include "acquire/hits/hits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "acquire/hits/ac_coupling.hpp"
#include "acquire/hits/contact_gate.hpp"
#include "acquire/hits/flat_top.hpp"
#include "acquire/hits/force_clipping.hpp"
#include "acquire/hits/force_grade.hpp"
#include "acquire/hits/further_force.hpp"
#include "acquire/hits/pulse_shape.hpp"
#include "acquire/hits/time_selection.hpp"
#include "acquire/hits/trigger_scan.hpp"
#include "core/error.hpp"
#include "core/parallel/parallel.hpp"

namespace percuss::acquire {
namespace {

constexpr double kSecondScan_s = 0.25;  // second contacts follow within some tens of milliseconds
constexpr std::size_t kMinRead = 256;   // samples: longer than any gate, and than kSecondScan_s at rates below 1 kHz

std::size_t samples_to_scan(double fs_Hz) { return static_cast<std::size_t>(kSecondScan_s * fs_Hz) + 1; }

// The samples read after a pulse. At low rates its ringing lasts longer than the search for second contacts.
std::size_t samples_to_read(double fs_Hz) { return std::max(samples_to_scan(fs_Hz), kMinRead); }

std::vector<double> force_between(const Record& record, std::size_t row, std::size_t first, std::size_t last,
                                  double baseline) {
  std::vector<double> x(last - first);
  record.read_force_N(row, first, x);
  for (double& value : x) value -= baseline;
  return x;
}

// The force around a hit, with the baseline removed.
struct ForceAround {
  std::span<const double> all;
  std::size_t scanned_samples = 0;  // further contacts are sought in these first samples of `all`
  std::size_t offset = 0;           // where the hit begins in `all`
  std::size_t peak = 0;             // the hit's largest sample, from its beginning
};

void measure_and_grade_pulse(Hit& hit, const ForceAround& force, double fs_Hz, const HitOptions& options) {
  const auto x = force.all.subspan(force.offset);
  const std::size_t offset = force.offset, peak = force.peak;
  const PulseShape pulse = shape_of_pulse(x, peak);
  hit.peak = hit.first + peak;
  hit.peak_N = x[peak];
  hit.onset_s = (static_cast<double>(hit.first) + pulse.rise) / fs_Hz;
  hit.pulse_s = std::max(pulse.fall - pulse.rise, 1.0) / fs_Hz;
  const Gate gate = gate_around(x, pulse, hit.noise_N);
  if (!options.gate_force) hit.ungated_N.assign(x.begin(), x.end());
  hit.bandwidth_Hz = bandwidth_Hz(x.subspan(gate.first, gate.end - gate.first), fs_Hz);
  const auto scanned = force.all.first(std::min(force.all.size(), force.scanned_samples));
  const Gate gate_in_all{.first = gate.first + offset, .end = std::min(gate.end + offset, scanned.size())};
  const FurtherForce further =
      further_force(scanned, shape_of_pulse(scanned, offset + peak), gate_in_all, hit.noise_N,
                    {.max_tail = std::max(kMinRead, static_cast<std::size_t>(kLongestPulse_s * fs_Hz))});
  gate_force(hit, x, gate, further, offset);
  hit.coupling_Hz = ac_coupling_Hz(hit, x, fs_Hz);
  grade_pulse(hit, x, pulse, gate.first == 0);
  grade_second_pulse(hit, further.contacts, fs_Hz);
  grade_lasting_force(hit, x, peak, fs_Hz);
}

Hit unmeasured_hit(std::size_t row, const SampleRange& range, const TriggerScan& trigger_scan) {
  return {.row = row,
          .first = range.first,
          .samples = range.last - range.first,
          .noise_N = trigger_scan.noise_N,
          .baseline_N = trigger_scan.baseline_N};
}

Hit hit_without_pulse(std::size_t row, const SampleRange& part, const TriggerScan& trigger_scan,
                      const HitOptions& options) {
  Hit hit = unmeasured_hit(row, part, trigger_scan);
  const double largest_N = std::abs(trigger_scan.largest_N);
  const double ratio = trigger_scan.noise_N > 0 ? largest_N / trigger_scan.noise_N : 0;
  if (largest_N >= trigger_scan.trigger_N && largest_N > kPulseToNoise * trigger_scan.noise_N) {
    hit.findings.push_back(
        {.code = FindingCode::no_pulse,
         .severity = Severity::reject,
         .value = ratio,
         .message =
             fmt::format("no hammer pulse: the force of {:.4g} N lasts longer than a hammer's contact; check the "
                         "hammer's cable and channel",
                         largest_N)});
    return hit;
  }
  const std::string remedy = options.trigger_N ? fmt::format("check the trigger level of {:.6g} N", *options.trigger_N)
                                               : "check the hammer's cable and channel";
  hit.findings.push_back(
      {.code = FindingCode::no_pulse,
       .severity = Severity::reject,
       .value = ratio,
       .message = fmt::format("no hammer pulse, the force stays within {:.2g} N of rest, {:.1f} times its noise; {}",
                              largest_N, ratio, remedy),
       .options = options.trigger_N ? std::vector<OptionId>{"trigger"} : std::vector<OptionId>{}});
  return hit;
}

// A contact in a row.
struct Contact {
  std::size_t peak = 0;        // sample of the row
  double size_N = 0;           // |force| there
  double length = 0;           // samples between its flanks
  std::size_t pretrigger = 0;  // samples before it
};

// Only a contact is a hit: a hump or drift of the force does not end the samples of the hit before it.
std::vector<Contact> contacts_of(const TriggerScan& scan, const Record& record, std::size_t row,
                                 const SampleRange& part, const HitOptions& options) {
  const auto reach = static_cast<std::size_t>(kLongestPulse_s * record.fs_Hz) + kLongestPulse_samples;
  std::vector<Contact> contacts;
  for (const std::size_t event : scan.events) {
    const std::size_t begin = std::max(part.first, event > reach ? event - reach : 0);
    const auto x = force_between(record, row, begin, std::min(part.last, event + reach + 1), scan.baseline_N);
    if (!is_hammer_pulse(x, event - begin, scan.noise_N, record.fs_Hz)) continue;
    const PulseShape shape = shape_of_pulse(x, event - begin);
    contacts.push_back({.peak = event,
                        .size_N = std::abs(x[event - begin]),
                        .length = shape.fall - shape.rise,
                        .pretrigger = pretrigger_samples(record, options, rise_samples(shape))});
  }
  return contacts;
}

// The end of the search for contacts after the row's largest. A later blow excites the response, too, so the search
// extends beyond it, however late it comes. A late spike, shorter than half the pulse, is no blow.
std::size_t end_of_scan(const TriggerScan& scan, const Record& record, std::size_t row, const SampleRange& part,
                        const HitOptions& options) {
  const std::size_t reach = samples_to_scan(record.fs_Hz);
  std::size_t end = scan.largest_end + reach;
  if (scan.events.empty() || scan.events.back() < end) return end;
  const std::vector<Contact> contacts = contacts_of(scan, record, row, part, options);
  const auto main = std::find_if(contacts.begin(), contacts.end(), [&](const Contact& contact) {
    return contact.peak >= scan.largest_first && contact.peak < scan.largest_end;
  });
  if (main == contacts.end()) return end;
  for (const Contact& contact : contacts) {
    const bool is_blow =
        contact.size_N >= kMaxSecondContact * scan.largest_N && contact.length >= kMaxSpikeLength * main->length;
    if (contact.peak >= end && is_blow) end = contact.peak + reach;
  }
  return end;
}

// The hit of one row, in a record with one hit per row.
Hit hit_of_row(const Record& record, std::size_t row, const HitOptions& options) {
  const SampleRange part = select_time_range(record, row, options);
  const TriggerScan trigger_scan =
      scan_for_triggers(record, row, {.trigger_N = options.trigger_N, .first = part.first, .last = part.last});
  Hit hit = unmeasured_hit(row, part, trigger_scan);
  if (options.trigger_N && trigger_scan.largest_N < *options.trigger_N)
    return hit_without_pulse(row, part, trigger_scan, options);
  const std::size_t scan_end = end_of_scan(trigger_scan, record, row, part, options);
  const std::size_t read_end = std::max(scan_end, trigger_scan.largest_end + samples_to_read(record.fs_Hz));
  const std::size_t end = options.gate_force ? std::min(part.last, read_end) : part.last;
  const auto x = force_between(record, row, part.first, end, trigger_scan.baseline_N);
  const auto at = [&](std::size_t sample) { return x.begin() + static_cast<std::ptrdiff_t>(sample - part.first); };
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = static_cast<std::size_t>(
      std::max_element(at(trigger_scan.largest_first), at(trigger_scan.largest_end), smaller) - x.begin());
  if (!is_hammer_pulse(x, largest, trigger_scan.noise_N, record.fs_Hz))
    return hit_without_pulse(row, part, trigger_scan, options);
  measure_and_grade_pulse(hit, {.all = x, .scanned_samples = scan_end - part.first, .offset = 0, .peak = largest},
                          record.fs_Hz, options);
  const auto length = selected_length(record, options);
  if (length) hit.samples = std::min(hit.samples, std::max(*length, largest + 1));  // the pulse stays inside
  return hit;
}

// The samples of contact c: from its pre-trigger to the pre-trigger of the next contact.
SampleRange range_of_contact(const std::vector<Contact>& contacts, std::size_t c, const SampleRange& part,
                             std::optional<std::size_t> length) {
  const auto begin = [&](const Contact& contact) {
    return contact.peak > contact.pretrigger + part.first ? contact.peak - contact.pretrigger : part.first;
  };
  const std::size_t own = begin(contacts[c]);
  const std::size_t first = c > 0 ? std::max(own, contacts[c - 1].peak + 1) : own;
  std::size_t last = c + 1 < contacts.size() ? begin(contacts[c + 1]) : part.last;
  if (length) last = std::min(last, first + *length);
  return {first, std::max(last, contacts[c].peak + 1)};
}

// The start of the search for a smaller hit before contact c. It leaves out the search range of the previous contact.
std::size_t scan_begin(const std::vector<Contact>& contacts, std::size_t c, const SampleRange& part,
                       std::size_t scan_samples) {
  const std::size_t free = c > 0 ? contacts[c - 1].peak + scan_samples : part.first;
  return std::max({part.first, free, contacts[c].peak > scan_samples ? contacts[c].peak - scan_samples : 0});
}

std::vector<Hit> hits_in_row(const Record& record, std::size_t row, const HitOptions& options) {
  const SampleRange part = select_time_range(record, row, options);
  const TriggerScan trigger_scan =
      scan_for_triggers(record, row, {.trigger_N = options.trigger_N, .first = part.first, .last = part.last});
  const std::vector<Contact> contacts = contacts_of(trigger_scan, record, row, part, options);
  const auto length = selected_length(record, options);
  std::vector<Hit> hits;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const SampleRange range = range_of_contact(contacts, c, part, length);
    const std::size_t scan_samples = samples_to_scan(record.fs_Hz);
    const std::size_t begin = std::min(range.first, scan_begin(contacts, c, part, scan_samples));
    const std::size_t end =
        options.gate_force ? std::min(range.last, contacts[c].peak + samples_to_read(record.fs_Hz)) : range.last;
    const auto all = force_between(record, row, begin, end, trigger_scan.baseline_N);
    const std::size_t peak = contacts[c].peak - range.first;
    Hit hit = unmeasured_hit(row, range, trigger_scan);
    const std::size_t offset = range.first - begin;
    measure_and_grade_pulse(
        hit, {.all = all, .scanned_samples = offset + peak + scan_samples, .offset = offset, .peak = peak},
        record.fs_Hz, options);
    hits.push_back(std::move(hit));
  }
  if (hits.empty()) hits.push_back(hit_without_pulse(row, part, trigger_scan, options));
  return hits;
}

// A blow that was rejected at the bench stays rejected.
void add_marks(std::vector<Hit>& hits, const Record& record) {
  for (Hit& hit : hits) {
    const RowMark mark = record.rows[hit.row].mark;
    if (mark == RowMark::none) continue;
    hit.findings.push_back({.code = FindingCode::rejected_live,
                            .severity = Severity::reject,
                            .value = static_cast<double>(static_cast<int>(mark)),
                            .message = fmt::format("rejected while it was recorded: {}", reason_of(mark))});
  }
}

}  // namespace

std::vector<Hit> find_hits(const Record& record, const HitOptions& options) {
  const bool search = record.continuous || record.rows.size() == 1;
  std::vector<std::vector<Hit>> of_row(record.rows.size());
  plan_bandwidths();
  parallel_for_cost(of_row.size(), record.rows.empty() ? 0 : record.rows.front().samples, [&](std::size_t row) {
    of_row[row] = search ? hits_in_row(record, row, options) : std::vector{hit_of_row(record, row, options)};
  });
  std::vector<Hit> hits;
  for (std::vector<Hit>& row : of_row)
    hits.insert(hits.end(), std::move_iterator(row.begin()), std::move_iterator(row.end()));
  grade_weak(hits);
  grade_force_clipping(hits, record);
  grade_flat_tops(hits);
  add_marks(hits, record);
  return hits;
}

}  // namespace percuss::acquire
