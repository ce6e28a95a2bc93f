#include "acquire/format_registry.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "acquire/formats/hdf5/hdf5_format.hpp"
#include "acquire/formats/mat/mat_format.hpp"
#include "acquire/formats/sound/sound_format.hpp"
#include "acquire/formats/text/csv_layout.hpp"
#include "acquire/formats/text/text_formats.hpp"
#include "acquire/formats/uff/uff_format.hpp"

namespace percuss::acquire {
namespace {

constexpr std::array<const FileFormat*, 6> kFormats{&kHdf5Format,  &kMatFormat, &kUffFormat,
                                                    &kSoundFormat, &kLvmFormat, &kTextFormat};

constexpr std::size_t kMaxProse_bytes = std::size_t{64} << 10U;

template <class Writes>
std::vector<std::string> extensions_where(const Writes& writes) {
  std::vector<std::string> out;
  for (const FileFormat* format : kFormats) {
    if (writes(*format)) out.insert(out.end(), format->written.begin(), format->written.end());
  }
  return out;
}

bool contains(std::span<const std::string_view> extensions, const std::string& extension) {
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

}  // namespace

std::span<const FileFormat* const> file_formats() { return kFormats; }

const FileFormat& detected_format(const FileHead& head) {
  return **std::find_if(kFormats.begin(), kFormats.end() - 1,
                        [&](const FileFormat* format) { return format->detect(head); });
}

const FileFormat* written_format(const std::string& path) {
  const std::string extension = file_extension(path);
  const auto* const found = std::find_if(
      kFormats.begin(), kFormats.end(), [&](const FileFormat* format) { return contains(format->written, extension); });
  return found != kFormats.end() ? *found : nullptr;
}

const std::vector<std::string>& record_extensions() {
  static const auto kExtensions =
      extensions_where([](const FileFormat& format) { return format.write_record != nullptr; });
  return kExtensions;
}

const std::vector<std::string>& frf_extensions() {
  static const auto kExtensions =
      extensions_where([](const FileFormat& format) { return format.write_frfs != nullptr; });
  return kExtensions;
}

bool writes_hdf5(const std::string& path) { return written_format(path) == &kHdf5Format; }

bool has_known_extension(const std::string& path) {
  const std::string extension = file_extension(path);
  return std::any_of(kFormats.begin(), kFormats.end(),
                     [&](const FileFormat* format) { return contains(format->extensions, extension); });
}

bool is_text_without_numbers(const std::string& path) {
  if (!contains(kTextFormat.extensions, file_extension(path))) return false;
  try {
    const std::string head = first_bytes(path, kMaxProse_bytes + 1);
    if (head.size() > kMaxProse_bytes || &detected_format({path, head}) != &kTextFormat) return false;
    layout_of_text({.path = path, .data = {std::shared_ptr<void>(), head.data()}, .size = head.size()},
                   CsvContent::frf);
  } catch (const NoNumbers&) {
    return true;
  } catch (const InputError&) {  // whoever opens the file reports it
  }
  return false;
}

}  // namespace percuss::acquire
