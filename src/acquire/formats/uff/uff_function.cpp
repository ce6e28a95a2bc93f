#include "acquire/formats/uff/uff_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/error.hpp"
#include "core/io/lazy_file.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kInteger = 10, kShort = 5, kSingle = 13, kDouble = 20;  // columns

class FunctionParser {
 public:
  FunctionParser(const UffSet& set, const FileBytes& file) : set_(set), file_(file), rest_(set.text) {
    out_.at = set.text;
    out_.big_endian = set.big_endian;
  }

  UffFunction parse() {
    for (std::string& line : out_.id) line = next().text(80);
    record6(next());
    record7(next());
    out_.abscissa = axis(next());
    out_.ordinate = axis(next());
    out_.denominator = axis(next());
    next();  // the z axis is not used
    if (set_.binary) {
      if (set_.data.size() < *uff_data_bytes(record7_)) fail("fewer bytes than record 7 states");
      out_.bytes = set_.data;
      if (set_.unread) {
        out_.file = file_.lazy;
        out_.file_offset = static_cast<std::size_t>(set_.data.data() - file_.view().data());
      }
    } else {
      read_values();
    }
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError("data set 58: " + problem, uff_location(file_, line_.empty() ? rest_ : line_),
                     "export the file again");
  }

  UffFields next() {
    if (rest_.empty()) fail("it ends within its header");
    line_ = take_uff_line(rest_);
    return UffFields(line_);
  }

  int small_integer(UffFields& fields, std::size_t width, const char* what) const {
    const auto value = fields.integer(width);
    if (!value || std::abs(*value) > std::numeric_limits<int>::max()) fail(std::string("cannot read the ") + what);
    return static_cast<int>(*value);
  }

  UffDof place(UffFields& fields, const char* what) const {
    fields.take(1);
    UffDof out{.name = fields.text(kInteger)};
    out.node = small_integer(fields, kInteger, what);
    out.direction = small_integer(fields, 4, what);
    return out;
  }

  void record6(UffFields fields) {
    out_.type = small_integer(fields, kShort, "function type");
    small_integer(fields, kInteger, "function's number");
    out_.version = small_integer(fields, kShort, "version");
    out_.load_case = small_integer(fields, kInteger, "load case");
    out_.response = place(fields, "response's node and direction");
    out_.reference = place(fields, "reference's node and direction");
  }

  void record7(UffFields fields) {
    record7_ = line_;
    const int kind = small_integer(fields, kInteger, "type of ordinate");
    if (!uff_data_bytes(line_)) fail(fmt::format("ordinate type {} or number of values is not usable", kind));
    out_.single = kind == 2 || kind == 5;
    out_.complex = kind == 5 || kind == 6;
    out_.count = static_cast<std::size_t>(small_integer(fields, kInteger, "number of values"));
    out_.even = small_integer(fields, kInteger, "spacing") != 0;
    const auto x0 = fields.number(kSingle);
    const std::string_view dx = fields.take(kSingle);
    const auto step = UffFields(dx).number(kSingle);
    if (!x0 || !step) fail("cannot read the abscissa's start and step");
    out_.x0 = *x0;
    out_.dx = *step;
    out_.dx_text = std::string(dx);
  }

  UffAxis axis(UffFields fields) const {
    UffAxis out{.quantity = small_integer(fields, kInteger, "axis")};
    fields.take(3 * kShort);
    fields.take(1);
    out.label = fields.text(20);
    fields.take(1);
    out.unit = fields.text(20);
    return out;
  }

  // The widths of the columns of each line of numbers.
  std::vector<std::size_t> columns() const {
    if (out_.single) return {kSingle, kSingle, kSingle, kSingle, kSingle, kSingle};
    if (out_.even) return {kDouble, kDouble, kDouble, kDouble};
    if (out_.complex) return {kSingle, kDouble, kDouble};
    return {kSingle, kDouble, kSingle, kDouble};
  }

  void read_values() {
    const std::vector<std::size_t> widths = columns();
    const std::size_t wanted = out_.count * ((out_.even ? 0U : 1U) + (out_.complex ? 2U : 1U));
    // A full line of six numbers has at least 66 characters.
    if (wanted > rest_.size() / 11 + 6) fail("fewer numbers than record 7 states");
    out_.values.reserve(wanted);
    while (out_.values.size() < wanted) {
      if (rest_.empty()) fail(fmt::format("{} numbers where record 7 states {}", out_.values.size(), wanted));
      UffFields fields = next();
      for (const std::size_t width : widths) {
        if (out_.values.size() == wanted) break;
        if (fields.blank()) fail("a line of too few numbers");
        const auto value = fields.number(width);
        if (!value) fail("a text where a number should be");
        out_.values.push_back(*value);
      }
    }
  }

  const UffSet& set_;
  const FileBytes& file_;
  std::string_view rest_, line_, record7_;
  UffFunction out_;
};

template <class Word, class Number>
double decoded(const char* at, bool swap) {
  Word word = 0;
  std::memcpy(&word, at, sizeof word);
  if (swap) {
    if constexpr (sizeof(Word) == 4) {
      word = __builtin_bswap32(word);
    } else {
      word = __builtin_bswap64(word);
    }
  }
  return static_cast<double>(std::bit_cast<Number>(word));
}

}  // namespace

void UffFunction::read(std::size_t part, std::size_t first, std::span<double> out) const {
  assert(first + out.size() <= count && part < (complex ? 2U : 1U));
  const std::size_t parts = complex ? 2 : 1;
  if (bytes.empty()) {
    const std::size_t stride = parts + (even ? 0U : 1U), offset = stride - parts + part;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = values[(first + i) * stride + offset];
    return;
  }
  const std::size_t width = single ? 4 : 8, before = even ? 0 : 4, stride = before + parts * width;
  const std::size_t offset = first * stride;
  const bool as_in_memory =
      !single && stride == sizeof(double) && big_endian == (std::endian::native == std::endian::big);
  if (as_in_memory && file) {
    return file->copy(file_offset + offset, out.size_bytes(), reinterpret_cast<char*>(out.data()));
  }
  if (!file) return decode(bytes.data() + offset + before + part * width, stride, out);
  constexpr std::size_t kBlock_bytes = std::size_t{1} << 15U;
  std::array<char, kBlock_bytes> block;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled at once
  const std::size_t block_values = kBlock_bytes / stride;
  for (std::size_t done = 0; done < out.size(); done += block_values) {
    const std::span<double> chunk = out.subspan(done, std::min(block_values, out.size() - done));
    file->copy(file_offset + offset + done * stride, chunk.size() * stride, block.data());
    decode(block.data() + before + part * width, stride, chunk);
  }
}

// Decodes a number every `stride` bytes.
void UffFunction::decode(const char* from, std::size_t stride, std::span<double> out) const {
  const bool swap = big_endian != (std::endian::native == std::endian::big);
  for (double& value : out) {
    value = single ? decoded<std::uint32_t, float>(from, swap) : decoded<std::uint64_t, double>(from, swap);
    from += stride;
  }
}

double UffFunction::x(std::size_t i) const {
  if (even) return x0 + static_cast<double>(i) * dx;
  const std::size_t parts = complex ? 2 : 1;
  if (bytes.empty()) return values[i * (parts + 1)];
  const bool swap = big_endian != (std::endian::native == std::endian::big);
  return decoded<std::uint32_t, float>(bytes.data() + i * (4 + parts * (single ? 4U : 8U)), swap);
}

UffFunction parse_uff_function(const UffSet& set, const FileBytes& file) { return FunctionParser(set, file).parse(); }

}  // namespace percuss::acquire
