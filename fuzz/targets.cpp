#include "targets.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace percuss::fuzz {

FileBytes as_file(std::string_view bytes) {
  const std::shared_ptr<char[]> copy(new char[bytes.size()]);
  std::copy(bytes.begin(), bytes.end(), copy.get());
  return {.path = "fuzzed", .data = {copy, copy.get()}, .size = bytes.size()};
}

MemfdFile::MemfdFile(std::string_view bytes) : descriptor_(::memfd_create("fuzzed", MFD_CLOEXEC)) {
  if (descriptor_ < 0 || ::write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    std::perror("cannot create the input file in memory");
    std::abort();
  }
}

MemfdFile::~MemfdFile() { ::close(descriptor_); }

std::string MemfdFile::path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

acquire::ReadOptions strict_read_options() {
  return {.fs_Hz = 1000, .force_channel = "1", .accel_channels = {"2"}, .force_scale = {2}, .accel_scale = {3}};
}

void read_all(const acquire::Record& record) {
  constexpr std::size_t kBlock = 1000;  // not a multiple of the readers' block sizes
  std::vector<double> block;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    for (std::size_t first = 0; first < record.rows[row].samples; first += kBlock) {
      block.resize(std::min(kBlock, record.rows[row].samples - first));
      record.read_force_N(row, first, block);
      for (std::size_t channel = 0; channel < record.accel.size(); ++channel)
        record.read_accel_mps2(row, channel, first, block);
    }
  }
}

void read_all(const std::variant<acquire::Record, acquire::FrfRecord>& measurement) {
  if (const auto* record = std::get_if<acquire::Record>(&measurement)) read_all(*record);
}

void require_clean(const std::exception& refusal) {
  constexpr std::size_t kLongest = 2000;
  const std::string_view message = refusal.what();
  const bool printable = std::none_of(message.begin(), message.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
  if (printable && !message.empty() && message.size() <= kLongest) return;
  std::fprintf(stderr, "error message is not one printable line of 1 to 2000 bytes: %s\n", refusal.what());
  std::abort();
}

}  // namespace percuss::fuzz
