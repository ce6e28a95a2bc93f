#pragma once
#include <fmt/format.h>

#include <string>
#include <vector>

namespace percuss::test {

/// A data set 58 by its specification, written without the code of percuss.
struct UffText {
  int type = 1;
  std::string response = "NONE", reference = "NONE";
  int response_node = 1, response_direction = 3, reference_node = 1, reference_direction = 3;
  int ordinate_type = 2;
  std::size_t values = 0;
  int spacing = 1;
  std::string x0 = "  0.00000E+00", dx = "  1.00000E-03", abscissa_unit = "s";
  int abscissa = 17, ordinate = 12, denominator = 0;
  std::string ordinate_unit = "NONE", denominator_unit = "NONE";
  std::string end = "\n";  // of lines

  std::string header() const {
    std::string out;
    for (int i = 0; i < 5; ++i) out += "NONE" + end;
    out += fmt::format("{:5}{:10}{:5}{:10} {:<10}{:10}{:4} {:<10}{:10}{:4}", type, 1, 0, 0, response, response_node,
                       response_direction, reference, reference_node, reference_direction) +
           end;
    out += fmt::format("{:10}{:10}{:10}{}{}  0.00000E+00", ordinate_type, values, spacing, x0, dx) + end;
    const auto axis = [&](int quantity, const std::string& unit) {
      return fmt::format("{:10}    0    0    0 {:<20} {:<20}", quantity, "NONE", unit) + end;
    };
    return out + axis(abscissa, abscissa_unit) + axis(ordinate, ordinate_unit) + axis(denominator, denominator_unit) +
           axis(0, "NONE");
  }
  /// The whole data set, with its numbers as lines of text.
  std::string text(const std::string& numbers) const {
    return "    -1" + end + "    58" + end + header() + numbers + "    -1" + end;
  }
  /// The whole data set, with its numbers as bytes. `stated` is the number of bytes that the first line states.
  std::string binary(const std::string& bytes, int byte_order, std::size_t stated) const {
    return "    -1" + end +
           fmt::format("    58b{:6}     2          11{:12}     0     0           0           0", byte_order, stated) +
           end + header() + bytes + "    -1" + end;
  }
};

/// The bytes of a number, in big-endian order if `big`.
template <class Number>
std::string number_bytes(Number number, bool big = false) {
  std::string out(reinterpret_cast<const char*>(&number), sizeof number);
  return big ? std::string(out.rbegin(), out.rend()) : out;
}

}  // namespace percuss::test
