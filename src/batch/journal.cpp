#include "batch/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <charconv>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "batch/line_reader.hpp"
#include "core/error.hpp"
#include "report/text/digest.hpp"

namespace percuss::batch {
namespace {

constexpr std::size_t kLongestLine_bytes = std::size_t{1} << 30U;  // holds the FRFs of a survey
constexpr std::size_t kDigits = 16;                                // of the digest, in hexadecimal
constexpr char kBetweenRows = '\t';                                // rows do not contain it: JSON escapes it
constexpr std::string_view kBegun = "begun ", kDone = "done ";

std::string digits_of(std::string_view rows) { return report::hexadecimal(report::sha256(rows)).substr(0, kDigits); }

std::optional<std::size_t> take_number(std::string_view& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
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

[[noreturn]] void fail_with_errno(const char* what, const std::string& path) {
  throw InputError(std::string(what) + ": " + std::generic_category().message(errno), path,
                   "free some space or choose another folder");
}

}  // namespace

Journal::Journal(std::string path, const ShardLabel& label, ShardRange range, bool anew)
    : path_(std::move(path)), range_(range), entries_(range.size()) {
  constexpr mode_t kMode = 0644;
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, kMode);
  if (descriptor_ < 0) fail_with_errno("cannot write", path_);
  try {
    lock();
    load(label, anew);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

Journal::~Journal() { ::close(descriptor_); }

// A lock of this process: it ends with the process, and no child inherits it.
void Journal::lock() const {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (::fcntl(descriptor_, F_SETLK, &whole) == 0 || (errno != EACCES && errno != EAGAIN)) return;
  throw InputError("another process analyses this shard", path_, "wait for it, or end it first");
}

void Journal::load(const ShardLabel& label, bool anew) {
  bool known = false;
  LineReader lines(descriptor_, path_, kLongestLine_bytes);  // closing another descriptor would release the lock
  while (!anew && lines.next() && lines.ended()) {
    if (lines.number() == 1) {
      require_same_shard(parse_label(lines.line(), path_), label, path_);
      known = true;
    } else {
      take(lines.line(), lines.offset());
    }
    end_ = lines.end();
  }
  // Removes the incomplete last line of a killed writer.
  if (::ftruncate(descriptor_, static_cast<off_t>(end_)) != 0) fail_with_errno("cannot write", path_);
  if (!known) append(label_line(label) + "\n");
}

void Journal::take(std::string_view line, std::uint64_t offset) {
  const auto done = completed_line(line);
  if (!done || done->index < range_.first || done->index >= range_.last || has(done->index)) return;
  entries_[done->index - range_.first] = {
      .offset = offset + static_cast<std::uint64_t>(done->rows.data() - line.data()), .bytes = done->rows.size()};
  ++finished_;
  failed_ += done->failed ? 1U : 0U;
}

void Journal::append(const std::string& line) {
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int error = errno;
      static_cast<void>(::ftruncate(descriptor_, static_cast<off_t>(end_)));  // removes the incomplete line
      errno = error;
      fail_with_errno("cannot write", path_);
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
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
  entries_[index - range_.first] = {.offset = end_ + start.size(), .bytes = rows.size()};
  append(start + rows + "\n");
  ++finished_;
  failed_ += failed ? 1U : 0U;
}

std::string Journal::rows(std::size_t index) const {
  const Entry& entry = entries_[index - range_.first];
  std::string rows = bytes_at(descriptor_, entry.offset, entry.bytes, path_);
  std::replace(rows.begin(), rows.end(), kBetweenRows, '\n');
  return rows + "\n";
}

void Journal::remove() { ::unlink(path_.c_str()); }

JournalState journal_state(const std::string& path) {
  std::map<std::size_t, std::size_t> begun;  // how often each unfinished record was begun
  JournalState state;
  LineReader lines(path, kLongestLine_bytes);
  while (lines.next() && lines.ended()) {
    std::string_view line = lines.line();
    if (const auto done = completed_line(line)) {
      ++state.finished;
      begun.erase(done->index);
    } else if (line.starts_with(kBegun)) {
      line.remove_prefix(kBegun.size());
      if (const auto index = take_number(line)) ++begun[*index];
    }
  }
  for (const auto& [index, times] : begun) {
    if (times > 1) state.stuck.push_back(index);
  }
  return state;
}

}  // namespace percuss::batch
