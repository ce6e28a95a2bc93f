#include "acquire/formats/uff/uff_format.hpp"

#include <algorithm>
#include <array>

#include "acquire/channels/stored_frfs.hpp"
#include "acquire/formats/uff/read_frf_uff.hpp"
#include "acquire/formats/uff/read_uff.hpp"
#include "acquire/formats/uff/write_frf_uff.hpp"
#include "acquire/formats/uff/write_uff.hpp"
#include "acquire/record/record_losses.hpp"

namespace percuss::acquire {
namespace {

constexpr std::uint64_t kMaxUff_bytes = std::uint64_t{16} << 30U;
constexpr std::array<std::string_view, 4> kUffExtensions{".uff", ".unv", ".uf", ".bunv"};

Measurement open_uff_file(const FormatInput& input, const FrfReadOptions& options, Content content) {
  const FileBytes file = input.stream != nullptr ? *input.stream : lazy_input(input.path, kMaxUff_bytes);
  UffContents contents = read_uff_contents(file);
  if (content == Content::record_or_frfs) {
    if (auto frfs = read_frf_uff(file, contents, options.kind.has_value()))
      return to_accelerances(std::move(*frfs), options);
  }
  return open_uff(file, std::move(contents), options.read);
}

// Adds the parts of the drawing that a universal file cannot hold as nodes, trace lines or elements. AnyRecord is
// Record or FrfRecord.
template <class AnyRecord>
void add_lost_drawing(const AnyRecord& record, std::vector<std::string>& losses) {
  if (!record.geometry.empty() && record.geometry.front().size() != 3)
    losses.emplace_back("the geometry (positions and angles instead of coordinates)");
  add_lost_lines(record.trace_lines, uff_drawable_lines(record.geometry, record.trace_lines).size(), losses);
  const std::size_t faces = uff_drawable_faces(record.geometry, record.trace_faces).size();
  if (faces < record.trace_faces.size()) {
    losses.emplace_back(faces == 0 ? "the faces between points"
                                   : "faces without three or four corners, or with a corner without coordinates");
  }
}

std::vector<std::string> uff_losses(const std::string& /*path*/, const Record& record) {
  std::vector<std::string> losses;
  add_lost_drawing(record, losses);
  add_lost_names(record, losses);
  return losses;
}

// A reader computes standard deviations from the coherence and the number of averages, if both are known.
std::vector<std::string> uff_frf_losses(const FrfRecord& record) {
  std::vector<std::string> losses;
  const bool no_std = std::any_of(record.frfs.begin(), record.frfs.end(), [](const PointFrf& one) {
    return !one.frf.std.empty() && (one.frf.coherence.empty() || one.frf.averages < 2);
  });
  if (no_std) losses.emplace_back("the standard deviations");
  add_lost_drawing(record, losses);
  return losses;
}

}  // namespace

const FileFormat kUffFormat{
    .name = "UFF",
    .extensions = kUffExtensions,
    .written = std::span(kUffExtensions).first(2),
    .detect = [](const FileHead& head) { return is_universal_file(head.bytes); },
    .open = open_uff_file,
    .write_record = [](const std::string& path, const Record& record, bool force) { write_uff(path, record, force); },
    .write_frfs = [](const std::string& path, const FrfRecord& record, FrfKind kind,
                     bool force) { write_frf_record_uff(path, record, kind, force); },
    .record_losses = uff_losses,
    .frf_losses = uff_frf_losses,
    .keeps_faces = true,
    .keeps_frf_geometry = true};

}  // namespace percuss::acquire
