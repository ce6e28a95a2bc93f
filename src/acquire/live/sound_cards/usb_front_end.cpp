#include "acquire/live/sound_cards/usb_front_end.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>

namespace percuss::acquire {
namespace {

constexpr std::array<std::string_view, 4> kFrontEndModels = {"485B", "333D", "633A", "SDC0"};
constexpr double kFullScaleCounts = 8388608;  // 2^23
constexpr std::size_t kModelLength = 6, kSerialLength = 6, kDateLength = 6;

// Removes `count` digits from the front of `text` and returns their value; nothing if they are not all digits.
std::optional<int> take_digits(std::string_view& text, std::size_t count) {
  if (text.size() < count) return {};
  int value = 0;
  const char* const end = text.data() + count;
  const auto parsed = std::from_chars(text.data(), end, value);
  if (parsed.ec != std::errc{} || parsed.ptr != end || value < 0) return {};
  text.remove_prefix(count);
  return value;
}

}  // namespace

std::optional<UsbFrontEnd> parse_front_end(std::string_view product) {
  std::size_t at = std::string_view::npos;
  for (const std::string_view model : kFrontEndModels) at = std::min(at, product.find(model));
  if (at == std::string_view::npos) return {};
  product.remove_prefix(at);
  if (product.size() < kModelLength + 2 + kSerialLength) return {};
  UsbFrontEnd found{.model = std::string(product.substr(0, kModelLength))};
  const char kind = product[kModelLength + 1];
  if (kind < '1' || kind > '3') return {};
  found.unit = kind == '1' ? "m/s^2" : "V";
  found.serial = std::string(product.substr(kModelLength + 2, kSerialLength));
  product.remove_prefix(kModelLength + 2 + kSerialLength);
  const std::size_t digits = kind == '1' ? 5 : 7;
  const double count_reference = kind == '3' ? 0.05 : 1;  // the counts are per 50 mV, per V or per m/s²
  for (double& full_scale : found.full_scales) {
    const auto counts = take_digits(product, digits);
    if (!counts || *counts == 0) return {};
    full_scale = kFullScaleCounts / *counts * count_reference;
  }
  const std::string date(product.substr(0, kDateLength));
  if (!take_digits(product, kDateLength)) return {};
  found.calibrated = "20" + date.substr(0, 2) + "-" + date.substr(2, 2) + "-" + date.substr(4, 2);
  return found;
}

// The card's link "device" names the USB interface, whose parent is the USB device.
std::optional<UsbFrontEnd> front_end_of_card(int card, const std::string& sysfs) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path device =
      fs::canonical(fs::path(sysfs) / "class/sound" / ("card" + std::to_string(card)) / "device", error);
  if (error) return {};
  std::ifstream file(device.parent_path() / "product");
  constexpr std::size_t kMaxProduct = 200;
  std::string product(kMaxProduct, '\0');
  file.read(product.data(), static_cast<std::streamsize>(product.size()));
  product.resize(static_cast<std::size_t>(file.gcount()));
  return parse_front_end(product);
}

std::optional<int> card_in_name(std::string_view name) {
  const std::size_t at = name.rfind("(hw:");
  if (at == std::string_view::npos) return {};
  int card = 0;
  const auto parsed = std::from_chars(name.data() + at + 4, name.data() + name.size(), card);
  if (parsed.ec != std::errc{} || card < 0) return {};
  return card;
}

}  // namespace percuss::acquire
