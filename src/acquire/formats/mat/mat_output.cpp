#include "acquire/formats/mat/mat_output.hpp"

#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

// Codes of the format for types of elements and classes of arrays.
constexpr std::uint32_t kInt8 = 1, kUint16 = 4, kInt32 = 5, kUint32 = 6, kDouble = 9, kMatrix = 14;
constexpr unsigned kCharClass = 4, kDoubleClass = 6, kComplexFlag = 0x800;
constexpr std::uint64_t kMaxVariable_bytes = std::uint64_t{1} << 31U;
constexpr std::size_t kTag_bytes = 8;

std::size_t padded(std::size_t bytes) { return (bytes + 7) / 8 * 8; }

void put32(std::string& text, std::uint64_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  text.append(reinterpret_cast<const char*>(&word), sizeof word);
}

void put_tag(std::string& text, std::uint32_t type, std::uint64_t bytes) {
  put32(text, type);
  put32(text, bytes);
}

void pad(std::string& text) { text.append(padded(text.size()) - text.size(), '\0'); }

}  // namespace

MatOutput::MatOutput(const std::string& path, bool force) : path_(path), file_(path, force) {
  std::string head = "MATLAB 5.0 MAT-file, written by percuss";
  head.resize(116, ' ');
  head.append(8, '\0');  // subsystem data: none
  head += std::string("\x00\x01IM", 4);
  file_.write(head);
}

void MatOutput::write_header(std::string_view name, std::span<const std::size_t> shape, unsigned kind, bool complex,
                             std::size_t data_bytes) {
  std::string body;
  put_tag(body, kUint32, 8);
  put32(body, kind | (complex ? kComplexFlag : 0U));
  put32(body, 0);
  put_tag(body, kInt32, 4 * shape.size());
  for (const std::size_t size : shape) put32(body, size);
  pad(body);
  put_tag(body, kInt8, name.size());
  body += name;
  pad(body);
  const std::uint64_t bytes = body.size() + (complex ? 2U : 1U) * (kTag_bytes + padded(data_bytes));
  if (bytes >= kMaxVariable_bytes) {
    throw InputError("variable " + std::string(name) + " does not fit a MAT file of level 5 (2 GiB)", path_,
                     "write HDF5, or fewer hits to a file");
  }
  std::string tag;
  put_tag(tag, kMatrix, bytes);
  file_.write(tag + body);
}

void MatOutput::begin(std::string_view name, std::span<const std::size_t> shape, bool complex) {
  assert(left_ == 0 && !imaginary_to_come_ && shape.size() > 1);
  part_ = 1;
  for (const std::size_t size : shape) part_ *= size;
  write_header(name, shape, kDoubleClass, complex, part_ * sizeof(double));
  imaginary_to_come_ = complex;
  left_ = part_;
  std::string tag;
  put_tag(tag, kDouble, part_ * sizeof(double));
  file_.write(tag);
}

void MatOutput::append(std::span<const double> values) {
  assert(values.size() <= left_);
  file_.write({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  left_ -= values.size();
  if (left_ > 0 || !imaginary_to_come_) return;
  imaginary_to_come_ = false;
  left_ = part_;
  std::string tag;
  put_tag(tag, kDouble, part_ * sizeof(double));
  file_.write(tag);
}

void MatOutput::number(std::string_view name, double value) { numbers(name, std::span(&value, 1)); }

void MatOutput::numbers(std::string_view name, std::span<const double> values) {
  begin(name, std::array<std::size_t, 2>{1, values.size()});
  append(values);
}

void MatOutput::text(std::string_view name, std::string_view ascii) {
  write_header(name, std::array<std::size_t, 2>{1, ascii.size()}, kCharClass, false, 2 * ascii.size());
  std::string data;
  put_tag(data, kUint16, 2 * ascii.size());
  for (const char c : ascii) data += {c, '\0'};
  pad(data);
  file_.write(data);
}

}  // namespace percuss::acquire
