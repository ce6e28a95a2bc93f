#include "acquire/formats/hdf5/hdf5_padded_text.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cstring>

#include "acquire/formats/hdf5/hdf5_handle.hpp"

namespace percuss::acquire::hdf5 {
namespace {

constexpr const char* kConversionName = "percuss padded text";

bool is_fixed_text(hid_t type) { return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0; }

// Characters of a stored text without the padding of its type.
std::size_t length_without_padding(const char* stored, std::size_t bytes, H5T_str_t padding) {
  std::size_t length = strnlen(stored, bytes);
  while (padding == H5T_STR_SPACEPAD && length > 0 && stored[length - 1] == ' ') --length;
  return length;
}

// H5T_conv_t: converts `count` texts in place.
herr_t convert_text(hid_t from, hid_t to, H5T_cdata_t* state, std::size_t count, std::size_t stride,
                    std::size_t /*background_stride*/, void* buffer, void* /*background*/, hid_t /*transfer*/) {
  if (state->command == H5T_CONV_INIT) {
    state->need_bkg = H5T_BKG_NO;
    return is_fixed_text(from) && is_fixed_text(to) ? 0 : -1;
  }
  if (state->command != H5T_CONV_CONV) return 0;
  const std::size_t from_bytes = H5Tget_size(from), to_bytes = H5Tget_size(to);
  const H5T_str_t padding = H5Tget_strpad(from);
  const char fill = H5Tget_strpad(to) == H5T_STR_SPACEPAD ? ' ' : '\0';
  const std::size_t from_step = stride != 0 ? stride : from_bytes, to_step = stride != 0 ? stride : to_bytes;
  auto* const bytes = static_cast<char*>(buffer);
  for (std::size_t n = 0; n < count; ++n) {
    // Texts that grow are converted from the last to the first, so that none overwrites an unconverted one.
    const std::size_t i = to_step > from_step ? count - 1 - n : n;
    const char* const text = bytes + i * from_step;
    const std::size_t kept = std::min(length_without_padding(text, from_bytes, padding), to_bytes);
    char* const out = bytes + i * to_step;
    std::memmove(out, text, kept);
    std::fill(out + kept, out + to_bytes, fill);
  }
  return 0;
}

}  // namespace

PaddedTextConversion::PaddedTextConversion() {
  H5Tregister(H5T_PERS_SOFT, kConversionName, H5T_C_S1, H5T_C_S1, convert_text);
}

PaddedTextConversion::~PaddedTextConversion() { H5Tunregister(H5T_PERS_SOFT, kConversionName, -1, -1, convert_text); }

}  // namespace percuss::acquire::hdf5
