#include "acquire/formats/uff/uff_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/io/csv_dialect.hpp"
#include "core/io/lazy_file.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMaxPadding_bytes = 64;  // after binary data: zeros to an even number of values, line ends
constexpr std::size_t kBinaryHeaderLines = 11, kRecord7 = 6;
constexpr std::size_t kMinUnread_bytes = std::size_t{1} << 16U;  // shorter data are loaded at once
constexpr std::size_t kLookahead_bytes = 4096;                   // loaded after binary data, to find the delimiter
constexpr std::size_t kSpacingColumn = 20;                       // of record 7
constexpr std::size_t kMaxSets = 4'000'000;

bool is_delimiter(std::string_view line) {
  return line.substr(0, 6) == "    -1" && line.find_first_not_of(" \t\r", 6) == std::string_view::npos;
}

// The delimiter at the beginning of `rest`, perhaps after a line end.
bool delimiter_follows(std::string_view rest) {
  while (!rest.empty() && (rest.front() == '\r' || rest.front() == '\n')) rest.remove_prefix(1);
  return is_delimiter(take_uff_line(rest));
}

// Loads a lazy file before its bytes are used.
class LazyLoader {
 public:
  explicit LazyLoader(const FileBytes& file) : file_(file), end_(file.lazy ? 0 : file.size) {}

  bool is_needed() const { return end_ < file_.size; }
  void load_to(std::size_t end) {
    if (end <= end_) return;
    file_.lazy->load(end_, end);
    end_ = std::min(end, file_.size);
  }
  // Loads at least the line that begins at `first`. Searches each byte once.
  void load_line(std::size_t first) {
    constexpr std::size_t kStep_bytes = std::size_t{1} << 16U;
    std::size_t looked = first;
    while (is_needed() &&
           file_.view().substr(looked, end_ - std::min(end_, looked)).find('\n') == std::string_view::npos) {
      looked = std::max(looked, end_);
      load_to(end_ + kStep_bytes);
    }
  }
  // Skips the bytes before `first`, which are then never loaded.
  void skip_to(std::size_t first) { end_ = std::max(end_, first); }

 private:
  const FileBytes& file_;
  std::size_t end_;  // the bytes from here on are not loaded yet
};

class Splitter {
 public:
  explicit Splitter(const FileBytes& file) : file_(file), loader_(file), rest_(file.view()) {}

  std::vector<UffSet> split() {
    std::vector<UffSet> sets;
    while (next_delimiter()) {
      if (rest_.find_first_not_of(" \t\r\n\x1A\f") == std::string_view::npos) fail("a data set has no number", rest_);
      sets.push_back(take_set());
      if (sets.size() > kMaxSets) fail("more than four million data sets", rest_);
    }
    return sets;
  }

 private:
  [[noreturn]] void fail(const std::string& problem, std::string_view at) const {
    throw InputError(problem, uff_location(file_, at), "export the file again");
  }

  std::size_t offset() const { return static_cast<std::size_t>(rest_.data() - file_.view().data()); }

  std::string_view take_line() {
    if (loader_.is_needed()) loader_.load_line(offset());
    return take_uff_line(rest_);
  }

  // Skips lines between data sets; false at the end of the file.
  bool next_delimiter() {
    while (!rest_.empty()) {
      if (is_delimiter(take_line())) return true;
    }
    return false;
  }

  UffSet take_set() {
    const std::string_view start = rest_;
    const std::string_view line = take_line();
    UffFields fields(line);
    const auto number = fields.integer(6);
    if (!number || *number < 0 || *number > 1'000'000) fail("a data set's number cannot be read", start);
    UffSet set{.number = static_cast<int>(*number)};
    const std::string_view kind = fields.take(1);
    set.binary = kind == "b" || kind == "B";
    if (set.binary) {
      take_binary(set, fields, start);
    } else {
      take_text(set, start);
    }
    return set;
  }

  void take_text(UffSet& set, std::string_view start) {
    const std::string_view body = rest_;
    while (!rest_.empty()) {
      const std::string_view before = rest_;
      if (!is_delimiter(take_line())) continue;
      set.text = body.substr(0, body.size() - before.size());
      return;
    }
    fail(fmt::format("data set {} is not closed: the file ends within it", set.number), start);
  }

  void take_binary(UffSet& set, UffFields& fields, std::string_view start) {
    const auto order = fields.integer(6), format = fields.integer(6), lines = fields.integer(12),
               stated = fields.integer(12);
    if (!order || !format || !lines || !stated || *stated < 0 || *lines < 0 || *lines > 100'000)
      fail("the first line of a binary data set cannot be read", start);
    if (*format != 2) fail(fmt::format("floating-point format {}: only IEEE (2) is read", *format), start);
    if (*order != 1 && *order != 2) fail(fmt::format("byte order {}: neither 1 nor 2", *order), start);
    set.big_endian = *order == 2;
    const std::string_view body = rest_;
    std::string_view record7;
    const std::size_t count = set.number == 58 ? kBinaryHeaderLines : static_cast<std::size_t>(*lines);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string_view line = take_line();
      if (i == kRecord7) record7 = line;
    }
    set.text = body.substr(0, body.size() - rest_.size());
    const std::optional<std::uint64_t> claimed = set.number == 58 ? uff_data_bytes(record7) : std::nullopt;
    set.unread = claimed && loader_.is_needed() && stays_in_file(*claimed, record7);
    if (!set.unread && loader_.is_needed()) {
      loader_.load_to(offset() + std::max<std::uint64_t>(claimed.value_or(0), static_cast<std::uint64_t>(*stated)) +
                      kLookahead_bytes);
    }
    const std::size_t bytes = set.unread ? *claimed : length_of(claimed, static_cast<std::uint64_t>(*stated), start);
    set.data = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    while (!rest_.empty() && (rest_.front() == '\r' || rest_.front() == '\n')) rest_.remove_prefix(1);
    take_line();  // the delimiter
  }

  // Whether the data are long, evenly spaced and followed by a delimiter. If so, they are not loaded.
  bool stays_in_file(std::uint64_t bytes, std::string_view record7) {
    const auto even = UffFields(record7.substr(std::min<std::size_t>(kSpacingColumn, record7.size()))).integer(10);
    if (bytes < kMinUnread_bytes || bytes > rest_.size() || even != 1) return false;
    const std::size_t end = offset() + bytes;
    file_.lazy->load(end, end + kLookahead_bytes);
    if (!delimiter_follows(rest_.substr(bytes).substr(0, kLookahead_bytes))) return false;
    loader_.skip_to(end);
    return true;
  }

  // The length up to a delimiter: as record 7 states, as the first line states, or as record 7 states plus padding.
  std::size_t length_of(std::optional<std::uint64_t> claimed, std::uint64_t stated, std::string_view start) const {
    const auto ends = [&](std::uint64_t bytes) {
      return bytes <= rest_.size() && delimiter_follows(rest_.substr(bytes));
    };
    if (claimed && ends(*claimed)) return *claimed;
    if (ends(stated)) return stated;
    for (std::uint64_t more = 1; claimed && more <= kMaxPadding_bytes; ++more) {
      if (ends(*claimed + more)) return *claimed + more;
    }
    fail(fmt::format("no delimiter after the {} bytes of a binary data set", claimed.value_or(stated)), start);
  }

  const FileBytes& file_;
  LazyLoader loader_;
  std::string_view rest_;
};

}  // namespace

bool is_universal_file(std::string_view head) {
  head = without_byte_order_mark(head);
  while (!head.empty()) {
    const std::string_view line = take_uff_line(head);
    if (line.find_first_not_of(" \t") != std::string_view::npos) return is_delimiter(line);
  }
  return false;
}

std::string uff_location(const FileBytes& file, std::string_view at) {
  const std::string_view before = file.view().substr(0, static_cast<std::size_t>(at.data() - file.view().data()));
  return fmt::format("{}: line {}", input_name(file.path), std::count(before.begin(), before.end(), '\n') + 1);
}

std::vector<UffSet> split_uff(const FileBytes& file) { return Splitter(file).split(); }

}  // namespace percuss::acquire
