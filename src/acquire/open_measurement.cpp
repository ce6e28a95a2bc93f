#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/formats/mat/read_mat.hpp"
#include "acquire/formats/sound/read_sound.hpp"
#include "acquire/formats/sound/sound_file.hpp"
#include "acquire/formats/text/read_csv.hpp"
#include "acquire/formats/text/read_lvm.hpp"
#include "acquire/formats/uff/read_uff.hpp"
#include "acquire/record/contiguous_samples.hpp"
#include "acquire/record/record.hpp"
#include "acquire/sandbox/sandbox_record.hpp"
#include "core/error.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {
namespace {

constexpr std::string_view kHdf5 = "\x89HDF\r\n\x1a\n";
constexpr std::uint64_t kLargestText_bytes = std::uint64_t{16} << 30U;
constexpr std::uint64_t kLargestPipe_bytes = std::uint64_t{4} << 30U;  // a pipe says nothing about its length
constexpr std::size_t kOpenHead_bytes = std::size_t{1} << 16U;

struct Magic {
  std::string_view start, kind;
};

// What instruments also write, by its first bytes.
constexpr std::array kNotReadable = {
    Magic{"TDSm", "a TDMS file"},
    Magic{"PK\x03\x04", "a zip archive (xlsx and npz are such)"},
    Magic{"\xD0\xCF\x11\xE0", "an old Excel file"},
    Magic{"\x1F\x8B", "a gzip archive"},
    Magic{"\x93NUMPY", "a NumPy array"},
    Magic{"%PDF", "a PDF document"},
};

void refuse_foreign(std::string_view head, const std::string& name) {
  const auto refuse = [&](std::string_view kind) {
    throw InputError(std::string(kind) + " is not readable yet", name, "save it as CSV or HDF5");
  };
  for (const auto& magic : kNotReadable) {
    if (head.substr(0, magic.start.size()) == magic.start) refuse(magic.kind);
  }
}

}  // namespace

FileBytes read_text(const std::string& path) {
  if (path == "-") {
    const auto look = [](std::string_view head) {
      if (head.substr(0, kHdf5.size()) == kHdf5) {
        throw InputError("HDF5 cannot be read from a pipe, which has no places to jump to", input_name("-"),
                         "give the file's name");
      }
      if (is_mat(head)) throw InputError("a MAT file cannot be read from a pipe", input_name("-"), "give its name");
      if (is_sound(head)) throw InputError("a sound file cannot be read from a pipe", input_name("-"), "give its name");
      refuse_foreign(head, input_name("-"));
      if (!is_universal_file(head)) require_text(head, input_name("-"));
    };
    return read_input("-", kLargestPipe_bytes, look);
  }
  const std::string head = first_bytes(path, kOpenHead_bytes);
  refuse_foreign(head, path);
  if (is_universal_file(head)) return lazy_input(path, kLargestText_bytes);
  require_text(head, path);
  return read_input(path, kLargestText_bytes);
}

Record open_text(const FileBytes& bytes, const ReadOptions& options) {
  if (is_universal_file(bytes.view())) return open_uff(bytes, options);
  if (is_lvm(bytes.view())) return open_lvm(bytes, options);
  return open_csv(bytes, options);
}

Record open_record(const std::string& path, const ReadOptions& options) {
  if (path != "-") {
    const std::string head = first_bytes(path, kOpenHead_bytes);
    if (options.sandboxed && (is_mat(head) || is_sound(head) || is_hdf5(path))) {
      ReadOptions within = options;
      within.sandboxed = false;
      return open_in_sandbox(path, [&] { return open_record(path, within); });
    }
    if (is_mat(head)) return open_mat(read_mat_file(path), options);
    if (is_sound(head)) return open_sound(path, options);
    if (is_hdf5(path)) return with_contiguous_readers(open_hdf5(path, options));
  }
  return open_text(read_text(path), options);
}

}  // namespace percuss::acquire
