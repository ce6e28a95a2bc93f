#include "acquire/live/journal_format.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/io/json_text.hpp"

namespace percuss::acquire {
namespace {

static_assert(std::endian::native == std::endian::little, "journals are little-endian");

constexpr std::string_view kJournalMagic = "PERCUSSJ";
constexpr std::size_t kCrcOffset = 24;
constexpr const char* kRemedy = "the journal cannot be resumed; record anew";

template <class Number>
void put(std::string& bytes, std::size_t at, Number number) {
  std::memcpy(bytes.data() + at, &number, sizeof number);
}

template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

std::uint32_t crc_of(std::uint32_t crc, std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(crc, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));  // NOLINT: zlib's bytes
}

// `block` has room for the header before its payload.
void complete_block(std::string& block, const JournalBlockHeader& header) {
  put(block, 0, static_cast<std::uint32_t>(header.type));
  put(block, 4, static_cast<std::uint32_t>(block.size() - kBlockHeader_bytes));
  put(block, 8, header.first_frame);
  put(block, 16, header.frames);
  put(block, 20, header.flags);
  put(block, kCrcOffset, std::uint32_t{0});
  put(block, 28, std::uint32_t{0});
  put(block, kCrcOffset, crc_of(0, block));
}

// Whether a float holds the value without loss. A NaN stays a NaN.
bool is_float(double value) { return std::isnan(value) || static_cast<double>(static_cast<float>(value)) == value; }

}  // namespace

std::string journal_header() {
  std::string bytes(kJournalHeader_bytes, '\0');
  kJournalMagic.copy(bytes.data(), kJournalMagic.size());
  put(bytes, 8, kJournalVersion);
  return bytes;
}

std::optional<std::uint32_t> journal_version(std::string_view head) {
  if (head.size() < kJournalHeader_bytes || !head.starts_with(kJournalMagic)) return {};
  return number_at<std::uint32_t>(head, 8);
}

std::string journal_block(JournalBlockType type, std::string_view payload, std::uint64_t frame) {
  std::string block(kBlockHeader_bytes, '\0');
  block += payload;
  complete_block(block, {.type = type, .first_frame = frame});
  return block;
}

void make_sample_block(const SampleBlock& samples, std::size_t channels, std::string& out) {
  const bool narrow = std::all_of(samples.values.begin(), samples.values.end(), is_float);
  out.resize(kBlockHeader_bytes + samples.values.size() * (narrow ? sizeof(float) : sizeof(double)));
  char* to = out.data() + kBlockHeader_bytes;
  if (narrow) {
    for (const double value : samples.values) {
      const auto number = static_cast<float>(value);
      std::memcpy(to, &number, sizeof number);
      to += sizeof number;
    }
  } else {
    std::memcpy(to, samples.values.data(), samples.values.size() * sizeof(double));
  }
  complete_block(out, {.type = JournalBlockType::samples,
                       .first_frame = samples.first_frame,
                       .frames = static_cast<std::uint32_t>(samples.values.size() / channels),
                       .flags = (samples.overrun ? kBlockOverrun : 0U) | (narrow ? 0U : kBlockFloat64)});
}

std::optional<JournalBlockHeader> parse_block_header(std::string_view bytes) {
  if (bytes.size() < kBlockHeader_bytes) return {};
  JournalBlockHeader header;
  header.type = static_cast<JournalBlockType>(number_at<std::uint32_t>(bytes, 0));
  header.payload_bytes = number_at<std::uint32_t>(bytes, 4);
  header.first_frame = number_at<std::uint64_t>(bytes, 8);
  header.frames = number_at<std::uint32_t>(bytes, 16);
  header.flags = number_at<std::uint32_t>(bytes, 20);
  header.crc = number_at<std::uint32_t>(bytes, kCrcOffset);
  if (header.payload_bytes > kMaxBlockPayload_bytes) return {};
  return header;
}

bool block_is_whole(std::string_view header, std::string_view payload) {
  std::string without_crc(header.substr(0, kBlockHeader_bytes));
  const auto stored = number_at<std::uint32_t>(header, kCrcOffset);
  put(without_crc, kCrcOffset, std::uint32_t{0});
  return crc_of(crc_of(0, without_crc), payload) == stored;
}

std::vector<double> block_values(const JournalBlockHeader& header, std::string_view payload) {
  if ((header.flags & kBlockFloat64) != 0) {
    std::vector<double> values(payload.size() / sizeof(double));
    std::memcpy(values.data(), payload.data(), values.size() * sizeof(double));
    return values;
  }
  std::vector<double> values(payload.size() / sizeof(float));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<double>(number_at<float>(payload, i * sizeof(float)));
  return values;
}

std::string format_json(const StreamFormat& format) {
  const nlohmann::ordered_json json{{"device", format.device},
                                    {"fs_hz", format.fs_Hz},
                                    {"channels", format.channels},
                                    {"names", format.names},
                                    {"units", format.units},
                                    {"full_scale", format.full_scale},
                                    {"full_scales", format.full_scales}};
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

StreamFormat parse_format(const std::string& text, const std::string& where) {
  const auto json = parse_json<nlohmann::json>({.text = text, .where = where, .remedy = kRemedy, .max_depth = 2});
  StreamFormat format;
  try {
    format.device = json.at("device").get<std::string>();
    format.fs_Hz = json.at("fs_hz").get<double>();
    format.channels = json.at("channels").get<std::size_t>();
    format.names = json.at("names").get<std::vector<std::string>>();
    format.units = json.at("units").get<std::vector<std::string>>();
    format.full_scale = json.at("full_scale").get<double>();
    format.full_scales = json.at("full_scales").get<std::vector<double>>();
  } catch (const nlohmann::json::exception&) {
    throw InputError("a damaged description of the stream", where, kRemedy);
  }
  constexpr std::size_t kMaxChannels = 4096;
  const auto fits = [&](const auto& texts) { return texts.empty() || texts.size() == format.channels; };
  if (!(format.fs_Hz > 0) || !std::isfinite(format.fs_Hz) || format.channels == 0 || format.channels > kMaxChannels ||
      !fits(format.names) || !fits(format.units) || !fits(format.full_scales))
    throw InputError("a description of the stream that contradicts itself", where, kRemedy);
  return format;
}

}  // namespace percuss::acquire
