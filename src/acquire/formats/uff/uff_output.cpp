#include "acquire/formats/uff/uff_output.hpp"

#include <fmt/format.h>

#include <bit>

#include "core/io/csv_header.hpp"

namespace percuss::acquire {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

constexpr const char* kDelimiter = "    -1\n";
constexpr std::size_t kHeaderLines = 11;

// Text for a field of fixed width: ASCII only, at most `width` characters. Other programs divide lines by bytes.
std::string ascii(std::string_view text, std::size_t width) {
  std::string out;
  for (const char c : text) {
    if (out.size() == width) break;
    out += static_cast<unsigned char>(c) >= 0x20 && static_cast<unsigned char>(c) < 0x7f ? c : '?';
  }
  return out.empty() ? "NONE" : out;
}

std::string dof_text(const UffDof& dof) {
  return fmt::format(" {:<10}{:10}{:4}", ascii(dof.name, 10), dof.node, dof.direction);
}

std::string axis_text(const UffAxis& axis) {
  return fmt::format("{:10}{:5}{:5}{:5} {:<20} {:<20}\n", axis.quantity, 0, 0, 0, ascii(axis.label, 20),
                     ascii(axis.unit, 20));
}

std::string header_text(const UffFunction& f) {
  std::string out;
  for (const std::string& line : f.id) out += ascii(line, 80) + '\n';
  out += fmt::format("{:5}{:10}{:5}{:10}{}{}\n", f.type, 0, f.version, f.load_case, dof_text(f.response),
                     dof_text(f.reference));
  out +=
      fmt::format("{:10}{:10}{:10}{}{}{}\n", f.complex ? 6 : 4, f.count, 1, uff_e13(f.x0), uff_e13(f.dx), uff_e13(0));
  return out + axis_text(f.abscissa) + axis_text(f.ordinate) + axis_text(f.denominator) + axis_text({});
}

}  // namespace

std::string uff_e13(double value) { return fmt::format("{:13.5E}", value); }
// Twelve decimals leave room for a sign and for an exponent of three digits.
std::string uff_e20(double value) { return fmt::format("{:20.12E}", value); }
std::string uff_d25(double value) {
  std::string out = fmt::format("{:25.16E}", value);
  out[out.find('E')] = 'D';
  return out;
}

UffOutput::UffOutput(const std::string& path, bool force, UffData data) : file_(path, force), data_(data) {}

void UffOutput::set(int number, std::string_view lines) {
  file_.write(kDelimiter + fmt::format("{:6}\n", number));
  file_.write(lines);
  file_.write(kDelimiter);
}

void UffOutput::header() {
  // Name, description, program; dates and versions are empty.
  set(151, "percuss\nNONE\npercuss\nNONE\nNONE\npercuss\nNONE\n");
  set(164, fmt::format("{:10}{:<20}{:10}\n{}{}{}\n{}\n", 1, "SI: Meter (newton)", 2, uff_d25(1), uff_d25(1), uff_d25(1),
                       uff_d25(273.15)));
}

void UffOutput::begin(const UffFunction& description) {
  const std::size_t bytes = description.count * (description.complex ? 16U : 8U);
  file_.write(kDelimiter);
  if (data_ == UffData::binary) {
    file_.write(fmt::format("{:6}b{:6}{:6}{:12}{:12}{:6}{:6}{:12}{:12}\n", 58, 1, 2, kHeaderLines, bytes, 0, 0, 0, 0));
  } else {
    file_.write("    58\n");
  }
  file_.write(header_text(description));
}

void UffOutput::append(std::span<const double> values, bool last) {
  if (data_ == UffData::binary) {
    file_.write({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
    return;
  }
  std::string text;
  constexpr std::size_t kPerLine = 4;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += uff_e20(values[i]);
    if (i % kPerLine == kPerLine - 1 || (last && i + 1 == values.size())) text += '\n';
  }
  file_.write(text);
}

void UffOutput::end() { file_.write(kDelimiter); }

void UffOutput::function(const UffFunction& description, std::span<const double> values) {
  function_of(description, values.size(), [&](std::size_t first, std::span<double> out) {
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  });
}

}  // namespace percuss::acquire
