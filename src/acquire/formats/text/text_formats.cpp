#include "acquire/formats/text/text_formats.hpp"

#include <algorithm>
#include <array>

#include "acquire/channels/stored_frfs.hpp"
#include "acquire/formats/text/read_csv.hpp"
#include "acquire/formats/text/read_frf_text.hpp"
#include "acquire/formats/text/read_lvm.hpp"
#include "acquire/formats/text/text_check.hpp"
#include "acquire/formats/text/write_csv.hpp"
#include "acquire/formats/text/write_frf_csv.hpp"
#include "acquire/record/record_losses.hpp"
#include "core/io/atomic_file.hpp"

namespace percuss::acquire {
namespace {

constexpr std::uint64_t kMaxText_bytes = std::uint64_t{16} << 30U;
constexpr std::array<std::string_view, 1> kLvmExtensions{".lvm"};
constexpr std::array<std::string_view, 5> kTextExtensions{".csv", ".tsv", ".txt", ".dat", ".asc"};

GrowthCheck check_lines(const std::string& path) { return LineLengthCheck(input_name(path)); }

FileBytes text_of(const FormatInput& input) {
  return input.stream != nullptr ? *input.stream
                                 : read_input(input.path, kMaxText_bytes, {}, check_lines(input.path), kSplitRecord);
}

void check_text(const FileHead& head) { require_text(head.bytes, input_name(head.path)); }

Measurement open_lvm_file(const FormatInput& input, const FrfReadOptions& options, Content /*content*/) {
  return open_lvm(text_of(input), options.read);
}

Measurement open_text_file(const FormatInput& input, const FrfReadOptions& options, Content content) {
  const FileBytes text = text_of(input);
  if (content == Content::record) return open_csv(text, options.read);
  if (auto frfs = read_frf_text(text, options.kind.has_value())) return to_accelerances(std::move(*frfs), options);
  return open_csv(text, options.read);
}

std::vector<std::string> frf_csv_losses(const FrfRecord& record) {
  std::vector<std::string> losses;
  if (std::any_of(record.accel.begin(), record.accel.end(), [](const SignalInfo& one) { return one.position_m; }))
    losses.emplace_back("the sensors' positions");
  return losses;
}

void write_frf_csv_file(const std::string& path, const FrfRecord& record, FrfKind kind, bool force) {
  write_file(path, frf_record_csv(record, kind), force);
}

std::vector<std::string> csv_losses(const std::string& /*path*/, const Record& record) {
  std::vector<std::string> losses;
  if (!record.geometry.empty()) losses.emplace_back("the geometry");
  add_lost_lines(record.trace_lines, 0, losses);
  add_lost_places(record, losses);
  if (record.continuous && record.rows.size() > 1) losses.emplace_back("that every row may hold several hits");
  add_lost_names(record, losses);
  return losses;
}

}  // namespace

const FileFormat kLvmFormat{.name = "LabVIEW",
                            .extensions = kLvmExtensions,
                            .detect = [](const FileHead& head) { return is_lvm(head.bytes); },
                            .check = check_text,
                            .growth_check = check_lines,
                            .open = open_lvm_file};

const FileFormat kTextFormat{.name = "text",
                             .extensions = kTextExtensions,
                             .written = std::span(kTextExtensions).first(1),
                             .detect = [](const FileHead& /*head*/) { return true; },
                             .check = check_text,
                             .growth_check = check_lines,
                             .open = open_text_file,
                             .write_record = write_record_csv,
                             .write_frfs = write_frf_csv_file,
                             .record_losses = csv_losses,
                             .frf_losses = frf_csv_losses};

}  // namespace percuss::acquire
