#include "batch/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <charconv>
#include <optional>
#include <set>
#include <utility>

#include "batch/line_reader.hpp"
#include "core/error.hpp"
#include "core/io/write_all.hpp"
#include "report/text/digest.hpp"

namespace percuss::batch {
namespace {

constexpr std::size_t kLongestLine_bytes = std::size_t{1} << 30U;  // holds the FRFs of a survey
constexpr std::size_t kDigits = 16;                                // of the digest, in hexadecimal
constexpr char kBetweenRows = '\t';                                // rows do not contain it: JSON escapes it
constexpr std::string_view kBegun = "begun ", kDone = "done ", kOpen = "open ", kAgain = "again ";

std::string digits_of(std::string_view rows) { return report::hexadecimal(report::sha256(rows)).substr(0, kDigits); }

std::optional<std::size_t> take_number(std::string_view& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

// The record of a line "again INDEX".
std::optional<std::size_t> reopened_record(std::string_view line) {
  if (!line.starts_with(kAgain)) return std::nullopt;
  line.remove_prefix(kAgain.size());
  return take_number(line);
}

struct CompletedLine {
  std::size_t index = 0;
  bool failed = false;
  std::string_view rows;
};

// "done INDEX 0|1 DIGEST ROWS".
std::optional<CompletedLine> completed_line(std::string_view line) {
  if (!line.starts_with(kDone)) return std::nullopt;
  line.remove_prefix(kDone.size());
  const auto index = take_number(line);
  if (!index || line.size() < 4 + kDigits || line[0] != ' ' || line[2] != ' ' || line[3 + kDigits] != ' ')
    return std::nullopt;
  const std::string_view rows = line.substr(4 + kDigits);
  if (rows.empty() || line.substr(3, kDigits) != digits_of(rows)) return std::nullopt;
  return CompletedLine{.index = *index, .failed = line[1] == '1', .rows = rows};
}

[[noreturn]] void fail_to_write(const std::string& path, int error) {
  throw_system_error("cannot write", error, path, "free some space or choose another folder");
}

// Locks the file for this process. The lock ends with the process, and no child inherits it. False only if another
// process has the lock: a file system without locks is used without one.
bool lock_file(int descriptor) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  return ::fcntl(descriptor, F_SETLK, &whole) == 0 || (errno != EACCES && errno != EAGAIN);
}

}  // namespace

Journal::Journal(std::string path, const ShardLabel& label, ShardRange range, bool anew)
    : path_(std::move(path)), file_(PartFile::appended(path_)), range_(range), entries_(range.size()) {
  if (!lock_file(file_.descriptor()))
    throw InputError("another process analyses this shard", path_, "wait for it, or end it first");
  file_.require_own();
  load(label, anew);
}

void Journal::load(const ShardLabel& label, bool anew) {
  bool known = false;
  LineReader lines(file_.descriptor(), path_, kLongestLine_bytes);  // closing another descriptor would release the lock
  while (!anew && lines.next() && lines.ended()) {
    if (lines.number() == 1) {
      require_same_shard(parse_label(lines.line(), path_), label, path_);
      known = true;
    } else {
      take(lines.line(), lines.offset());
    }
    end_ = lines.end();
  }
  // A killed writer may leave an incomplete last line.
  remove_incomplete_line();
  if (!known) append(label_line(label) + "\n");
}

void Journal::take(std::string_view line, std::uint64_t offset) {
  const auto within = [&](std::size_t index) { return index >= range_.first && index < range_.end; };
  if (const auto again = reopened_record(line); again && within(*again)) discard(*again);
  const auto done = completed_line(line);
  if (!done || !within(done->index) || has(done->index)) return;
  entries_[done->index - range_.first] = {
      .offset = offset + static_cast<std::uint64_t>(done->rows.data() - line.data()),
      .bytes = done->rows.size(),
      .failed = done->failed};
  ++finished_;
  failed_ += done->failed ? 1U : 0U;
}

void Journal::discard(std::size_t index) {
  if (!has(index)) return;
  Entry& entry = entries_[index - range_.first];
  --finished_;
  failed_ -= entry.failed ? 1U : 0U;
  entry = {};
}

void Journal::remove_incomplete_line() {
  incomplete_ = ::ftruncate(file_.descriptor(), static_cast<off_t>(end_)) != 0;
  if (incomplete_) fail_to_write(path_, errno);
}

void Journal::append(const std::string& line) {
  if (incomplete_) remove_incomplete_line();
  if (!write_all(file_.descriptor(), line)) {
    const int error = errno;
    incomplete_ = ::ftruncate(file_.descriptor(), static_cast<off_t>(end_)) != 0;
    fail_to_write(path_, error);
  }
  end_ += line.size();
}

void Journal::begin(std::size_t index) {
  const std::scoped_lock lock(mutex_);
  append(fmt::format("{}{}\n", kBegun, index));
}

void Journal::finish(std::size_t index, bool failed, const std::vector<std::string>& lines) {
  assert(!lines.empty() && !has(index));
  std::string rows;
  for (const std::string& line : lines) rows += (rows.empty() ? "" : std::string(1, kBetweenRows)) + line;
  const std::string start = fmt::format("{}{} {} {} ", kDone, index, failed ? 1 : 0, digits_of(rows));
  const std::scoped_lock lock(mutex_);
  append(start + rows + "\n");
  entries_[index - range_.first] = {.offset = end_ - 1 - rows.size(), .bytes = rows.size(), .failed = failed};
  ++finished_;
  failed_ += failed ? 1U : 0U;
}

void Journal::leave_open(std::size_t index, const std::string& reason) {
  const std::scoped_lock lock(mutex_);
  try {
    append(fmt::format("{}{} {}\n", kOpen, index, one_line(reason, kMaxReason_bytes)));
  } catch (const MachineFault&) {
    // The disk has no room for the reason either. The record is open without it.
  }
}

void Journal::reopen(std::size_t index) {
  const std::scoped_lock lock(mutex_);
  append(fmt::format("{}{}\n", kAgain, index));
  discard(index);
}

std::string Journal::rows(std::size_t index) const {
  const Entry& entry = entries_[index - range_.first];
  std::string rows = bytes_at(file_.descriptor(), entry.offset, entry.bytes, path_);
  std::replace(rows.begin(), rows.end(), kBetweenRows, '\n');
  return rows + "\n";
}

void Journal::remove() { ::unlink(path_.c_str()); }

void remove_abandoned_journal(const std::string& path) {
  if (!PartFile::existing(path).present()) return;
  const PartFile file = PartFile::appended(path);
  if (!lock_file(file.descriptor())) return;  // its process removes it
  file.require_own();
  ::unlink(path.c_str());
}

JournalState journal_state(const std::string& path) {
  std::map<std::size_t, std::size_t> begun;  // how often each unfinished record was begun
  std::set<std::size_t> finished;
  JournalState state;
  const PartFile file = PartFile::existing(path);
  if (!file.present()) return state;
  LineReader lines(file.descriptor(), path, kLongestLine_bytes);
  while (lines.next() && lines.ended()) {
    std::string_view line = lines.line();
    if (const auto done = completed_line(line)) {
      finished.insert(done->index);
      begun.erase(done->index);
      state.open.erase(done->index);
    } else if (line.starts_with(kBegun)) {
      line.remove_prefix(kBegun.size());
      if (const auto index = take_number(line)) ++begun[*index];
    } else if (const auto again = reopened_record(line)) {
      finished.erase(*again);
    } else if (line.starts_with(kOpen)) {
      line.remove_prefix(kOpen.size());
      const auto index = take_number(line);
      if (!index || !line.starts_with(' ')) continue;
      begun.erase(*index);
      state.open[*index] = line.substr(1);
    }
  }
  state.finished = finished.size();
  for (const auto& [index, times] : begun) {
    if (times > 1) state.stuck.push_back(index);
  }
  return state;
}

}  // namespace percuss::batch
