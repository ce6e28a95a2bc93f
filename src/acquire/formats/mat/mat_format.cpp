#include "acquire/formats/mat/mat_format.hpp"

#include <array>

#include "acquire/formats/mat/mat_abscissa.hpp"
#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/formats/mat/mat_named_columns.hpp"
#include "acquire/formats/mat/read_frf_mat.hpp"
#include "acquire/formats/mat/read_mat.hpp"
#include "acquire/formats/mat/write_frf_mat.hpp"
#include "acquire/formats/mat/write_mat.hpp"
#include "acquire/record/record_losses.hpp"

namespace percuss::acquire {
namespace {

constexpr std::array<std::string_view, 1> kMatExtensions{".mat"};

// Removes the options that read_frf_mat has applied: the names of variables, and the sampling rate.
FrfReadOptions without_applied_options(FrfReadOptions options) {
  options.read.fs_Hz.reset();
  options.read.fs_variable.clear();
  std::erase_if(options.read.accel_channels, [](const std::string& name) {
    return name.find_first_not_of("0123456789") != std::string::npos && !name.starts_with("accel");
  });
  return options;
}

Measurement open_mat_file(const FormatInput& input, const FrfReadOptions& options, Content content) {
  MatFile file = read_mat_file(input.path);
  split_abscissas(file);
  split_named_columns(file, options.read);
  if (content == Content::record_or_frfs) {
    if (auto frfs = read_frf_mat(file, options))
      return to_accelerances(std::move(*frfs), without_applied_options(options));
  }
  return open_mat(std::move(file), options.read);
}

std::vector<std::string> mat_losses(const std::string& /*path*/, const Record& record) {
  std::vector<std::string> losses;
  add_lost_quantities(record, losses);
  add_lost_names(record, losses);
  return losses;
}

}  // namespace

const FileFormat kMatFormat{.name = "MAT",
                            .extensions = kMatExtensions,
                            .written = kMatExtensions,
                            .sandboxed = true,
                            .names_variables = true,
                            .detect = [](const FileHead& head) { return is_mat(head.bytes); },
                            .open = open_mat_file,
                            .write_record = write_mat,
                            .write_frfs = write_frf_record_mat,
                            .record_losses = mat_losses,
                            .keeps_faces = true};

}  // namespace percuss::acquire
