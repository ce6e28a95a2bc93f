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

/// The function of a hammer's force in newtons, at node 1.
inline const UffText kUffForce{.response = "hammer", .ordinate = 13, .ordinate_unit = "N"};

/// The bytes of a number, in big-endian order if `big`.
template <class Number>
std::string number_bytes(Number number, bool big = false) {
  std::string out(reinterpret_cast<const char*>(&number), sizeof number);
  return big ? std::string(out.rbegin(), out.rend()) : out;
}

/// A function of two numbers x and x + 1.
inline std::string uff_function(UffText set, double x) {
  set.values = 2;
  return set.text(fmt::format("{:13.5E}{:13.5E}\n", x, x + 1));
}

/// The header of an FRF with two complex lines, at 10 and 12 Hz.
inline UffText uff_frf_header(UffText set = {}) {
  set.type = 4;
  set.ordinate_type = 5;
  set.values = 2;
  set.abscissa = 18;
  set.denominator = 13;
  set.x0 = "  1.00000E+01";
  set.dx = "  2.00000E+00";
  return set;
}

/// An FRF of this header with the values (x, −x) and (2x, 0).
inline std::string uff_frf(const UffText& header, double x = 1) {
  return header.text(fmt::format("{:13.5E}{:13.5E}{:13.5E}{:13.5E}\n", x, -x, 2 * x, 0.0));
}

/// A data set 164. The factors convert metres and newtons to the units of the file: 1000 means millimetres.
inline std::string uff_units(double length, double force) {
  std::string numbers = fmt::format("{:25.17E}{:25.17E}{:25.17E}\n{:25.17E}\n", length, force, 1.0, 273.15);
  for (char& c : numbers) c = c == 'E' ? 'D' : c;
  return "    -1\n   164\n         9USER DEFINED                  2\n" + numbers + "    -1\n";
}

}  // namespace percuss::test
