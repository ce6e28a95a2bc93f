#include "report/text/digest.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <vector>

namespace percuss::report {
namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// The value of each base64 character; 64 for other characters.
constexpr std::array<std::uint8_t, 256> kNumbers = [] {
  std::array<std::uint8_t, 256> numbers{};
  for (std::uint8_t& number : numbers) number = 64;
  for (std::size_t i = 0; i < kLetters.size(); ++i)
    numbers.at(static_cast<unsigned char>(kLetters[i])) = static_cast<std::uint8_t>(i);
  return numbers;
}();

void require(bool done) {
  if (!done) throw std::runtime_error("no SHA-256 in the system's OpenSSL");
}

}  // namespace

struct Digest::Impl {
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context{EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

Digest::Digest() : impl_(std::make_unique<Impl>()) {
  require(impl_->context != nullptr && EVP_DigestInit_ex(impl_->context.get(), EVP_sha256(), nullptr) == 1);
}

Digest::~Digest() = default;

void Digest::add(std::string_view bytes) {
  require(EVP_DigestUpdate(impl_->context.get(), bytes.data(), bytes.size()) == 1);
}

Sha256 Digest::result() {
  Sha256 out{};
  require(EVP_DigestFinal_ex(impl_->context.get(), out.data(), nullptr) == 1);
  return out;
}

Sha256 sha256(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.result();
}

std::string sha256_of_file(const std::string& path) {
  constexpr std::size_t kPiece_bytes = std::size_t{1} << 20U;
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  Digest digest;
  std::vector<char> piece(kPiece_bytes);
  while (file.read(piece.data(), kPiece_bytes) || file.gcount() > 0)
    digest.add({piece.data(), static_cast<std::size_t>(file.gcount())});
  return file.bad() ? std::string() : hexadecimal(digest.result());
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) { return fmt::format("{:02x}", fmt::join(bytes, "")); }

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t b = 0; b < 3; ++b) word = word << 8U | (b < have ? bytes[i + b] : 0U);
    for (std::size_t c = 0; c < 4; ++c) out += c <= have ? kLetters[word >> (18 - 6 * c) & 63U] : '=';
  }
  return out;
}

std::string from_base64(std::string_view text) {
  if (text.size() % 4 != 0) throw std::out_of_range("no base64");
  std::string out;
  out.reserve(text.size() / 4 * 3);
  while (!text.empty()) {
    const bool last = text.size() == 4;
    const std::size_t letters = !last || text[3] != '=' ? 4 : text[2] != '=' ? 3 : 2;
    std::uint32_t word = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const std::uint8_t number = c < letters ? kNumbers.at(static_cast<unsigned char>(text[c])) : std::uint8_t{0};
      if (number > 63) throw std::out_of_range("no base64");
      word = word << 6U | number;
    }
    for (std::size_t b = 0; b + 1 < letters; ++b) out += static_cast<char>(word >> (16 - 8 * b) & 0xFFU);
    text.remove_prefix(4);
  }
  return out;
}

}  // namespace percuss::report
