#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "acquire/csv_dialect.hpp"
#include "acquire/input_file.hpp"
#include "acquire/read_csv.hpp"
#include "acquire/read_hdf5.hpp"
#include "acquire/record.hpp"
#include "core/error.hpp"

namespace percuss {
namespace {

constexpr std::string_view kHdf5 = "\x89HDF\r\n\x1a\n";
constexpr std::uint64_t kLargestText_bytes = std::uint64_t{16} << 30U;
constexpr std::uint64_t kLargestPipe_bytes = std::uint64_t{4} << 30U;  // a pipe says nothing about its length
constexpr std::size_t kHead_bytes = std::size_t{1} << 16U;

struct Magic {
  std::string_view start, kind;
};

// What instruments also write, by its first bytes.
constexpr std::array kNotReadable = {
    Magic{"MATLAB ", "a MAT file"},
    Magic{"RIFF", "a WAV file"},
    Magic{"RF64", "an RF64 sound file"},
    Magic{"riff\x2E\x91\xCF\x11", "a W64 sound file"},
    Magic{"TDSm", "a TDMS file"},
    Magic{"PK\x03\x04", "a zip archive (xlsx and npz are such)"},
    Magic{"\xD0\xCF\x11\xE0", "an old Excel file"},
    Magic{"\x1F\x8B", "a gzip archive"},
    Magic{"\x93NUMPY", "a NumPy array"},
    Magic{"%PDF", "a PDF document"},
};

// Universal files start with a line of "    -1" (columns 1 to 6) and blanks.
bool is_universal_file(std::string_view head) {
  const auto line = take_line(head, '\n');
  return line.substr(0, 6) == "    -1" && line.find_first_not_of(' ', 6) == std::string_view::npos;
}

// A MAT file of level 4 starts with numbers: type (M, O, P, T as decimal digits, of which only these occur), rows,
// columns, 0 or 1 for complex, length of the first variable's name.
bool is_mat4(std::string_view head) {
  std::array<std::uint32_t, 5> words{};
  if (head.size() < sizeof words) return false;
  std::memcpy(words.data(), head.data(), sizeof words);
  const auto [type, rows, columns, complex, name] = words;
  const bool known_type = type <= 51 && type % 10 <= 2 && type / 10 <= 5;
  const std::size_t name_end = sizeof words + name - 1;
  return known_type && rows > 0 && columns > 0 && complex <= 1 && name >= 2 && name <= 64 && name_end < head.size() &&
         head[name_end] == '\0' && std::isalpha(static_cast<unsigned char>(head[sizeof words])) != 0;
}

void refuse_foreign(std::string_view head, const std::string& name) {
  const auto refuse = [&](std::string_view kind) {
    throw InputError(std::string(kind) + " is not readable yet", name, "save it as CSV or HDF5");
  };
  for (const auto& magic : kNotReadable) {
    if (head.substr(0, magic.start.size()) == magic.start) refuse(magic.kind);
  }
  if (is_mat4(head)) refuse("a MAT file of level 4");
  if (is_universal_file(head)) refuse("a universal file (UFF)");
}

}  // namespace

FileBytes read_text(const std::string& path) {
  if (path == "-") {
    const auto look = [](std::string_view head) {
      if (head.substr(0, kHdf5.size()) == kHdf5) {
        throw InputError("HDF5 cannot be read from a pipe, which has no places to jump to", input_name("-"),
                         "give the file's name");
      }
      refuse_foreign(head, input_name("-"));
      require_text(head, input_name("-"));
    };
    return read_input("-", kLargestPipe_bytes, look);
  }
  const std::string head = first_bytes(path, kHead_bytes);
  refuse_foreign(head, path);
  require_text(head, path);
  return read_input(path, kLargestText_bytes);
}

Record open_record(const std::string& path, const ReadOptions& options) {
  if (path != "-") {
    refuse_foreign(first_bytes(path, kHead_bytes), path);
    if (is_hdf5(path)) return open_hdf5(path, options);
  }
  return open_csv(read_text(path), options);
}

}  // namespace percuss
