#include "acquire/formats/hdf5/hdf5_format.hpp"

#include <array>

#include "acquire/channels/stored_frfs.hpp"
#include "acquire/formats/hdf5/read_frf_hdf5.hpp"
#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/formats/hdf5/write_frf_hdf5.hpp"
#include "acquire/formats/hdf5/write_hdf5.hpp"
#include "acquire/record/contiguous_samples.hpp"
#include "acquire/record/record_losses.hpp"

namespace percuss::acquire {
namespace {

constexpr std::array<std::string_view, 3> kHdf5Extensions{".h5", ".hdf5", ".hdf"};

// MAT 7.3 is HDF5 behind a block that begins with "MATLAB".
bool detect_hdf5(const FileHead& head) {
  if (head.path == "-") return head.bytes.starts_with(kHdf5Signature);
  return is_hdf5(head.path) && !head.bytes.starts_with("MATLAB ");
}

Measurement open_hdf5_file(const FormatInput& input, const FrfReadOptions& options, Content content) {
  if (content == Content::record_or_frfs) {
    if (auto frfs = read_frf_hdf5(input.path)) return to_accelerances(std::move(*frfs), options);
  }
  return with_contiguous_readers(open_hdf5(input.path, options.read));
}

std::vector<std::string> hdf5_losses(const std::string& /*path*/, const Record& record) {
  std::vector<std::string> losses;
  add_lost_quantities(record, losses);
  add_lost_names(record, losses);
  return losses;
}

}  // namespace

const FileFormat kHdf5Format{.name = "HDF5",
                             .extensions = kHdf5Extensions,
                             .written = std::span(kHdf5Extensions).first(2),
                             .sandboxed = true,
                             .detect = detect_hdf5,
                             .open = open_hdf5_file,
                             .write_record = write_hdf5,
                             .write_frfs = write_frf_record_hdf5,
                             .record_losses = hdf5_losses,
                             .keeps_marks = true,
                             .keeps_date = true,
                             .keeps_faces = true};

}  // namespace percuss::acquire
