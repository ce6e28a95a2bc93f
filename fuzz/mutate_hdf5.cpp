#include <algorithm>
#include <vector>

#include "mutators.hpp"

namespace percuss::fuzz {
namespace {

// Types of messages in object headers, from the "HDF5 File Format Specification".
enum MessageType : std::uint16_t {
  kDataspace = 1,
  kLinkInfo = 2,
  kDatatype = 3,
  kFillValue = 5,
  kLink = 6,
  kExternalFiles = 7,
  kLayout = 8,
  kFilters = 11,
  kAttribute = 12,
  kContinuation = 16,
  kSymbolTable = 17,
  kAttributeInfo = 21
};

// A message of an object header: its type; the positions in the file of its type, of its size and of its contents; and
// the size of its contents.
struct Message {
  std::uint16_t type = 0;
  std::size_t type_at = 0, size_at = 0, at = 0, size = 0;
};

// Bytes first … end − 1 of the file.
struct ByteRange {
  std::size_t first = 0, end = 0;
};

struct Structure {
  std::vector<Message> messages;
  // A checksum follows each: the superblock, and the first chunk of each object header of version 2.
  std::vector<ByteRange> checked;
  std::vector<std::size_t> entries;  // of symbol tables
};

std::uint32_t rotated(std::uint32_t word, unsigned by) { return (word << by) | (word >> (32U - by)); }

// Jenkins' lookup3, the checksum of HDF5.
std::uint32_t checksum(std::string_view bytes) {
  const auto word = [&](std::size_t at) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i)
      out |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return out;
  };
  std::uint32_t a = 0xDEADBEEFU + static_cast<std::uint32_t>(bytes.size()), b = a, c = a;
  while (bytes.size() > 12) {
    a += word(0), b += word(4), c += word(8);
    a -= c, a ^= rotated(c, 4), c += b;
    b -= a, b ^= rotated(a, 6), a += c;
    c -= b, c ^= rotated(b, 8), b += a;
    a -= c, a ^= rotated(c, 16), c += b;
    b -= a, b ^= rotated(a, 19), a += c;
    c -= b, c ^= rotated(b, 4), b += a;
    bytes.remove_prefix(12);
  }
  if (bytes.empty()) return c;
  a += word(0), b += word(4), c += word(8);
  c ^= b, c -= rotated(b, 14);
  a ^= c, a -= rotated(c, 11);
  b ^= a, b -= rotated(a, 25);
  c ^= b, c -= rotated(b, 16);
  a ^= c, a -= rotated(c, 4);
  b ^= a, b -= rotated(a, 14);
  c ^= b, c -= rotated(b, 24);
  return c;
}

void add_header_v1(std::string_view bytes, std::size_t at, Structure& out) {
  constexpr std::size_t kPrefix = 16, kMessageHead = 8, kMaxMessages = 64;
  if (at >= bytes.size() || bytes[at] != 1) return;
  std::vector<ByteRange> blocks{{at + kPrefix, at + kPrefix + number_at<std::uint32_t>(bytes, at + 8)}};
  std::size_t found = 0;
  for (std::size_t block = 0; block < blocks.size() && block < 8; ++block) {
    const std::size_t end = std::min(blocks[block].end, bytes.size());
    for (std::size_t m = blocks[block].first; m + kMessageHead <= end && found < kMaxMessages; ++found) {
      const std::size_t size = number_at<std::uint16_t>(bytes, m + 2);
      out.messages.push_back({number_at<std::uint16_t>(bytes, m), m, m + 2, m + kMessageHead, size});
      if (out.messages.back().type == kContinuation) {
        const auto next = number_at<std::uint64_t>(bytes, m + 8), length = number_at<std::uint64_t>(bytes, m + 16);
        if (next < bytes.size() && length < bytes.size()) blocks.push_back({next, next + length});
      }
      m += kMessageHead + size;
    }
  }
}

void add_header_v2(std::string_view bytes, std::size_t at, Structure& out) {
  const unsigned flags = number_at<std::uint8_t>(bytes, at + 5);
  std::size_t m = at + 6 + ((flags & 32U) != 0 ? 16 : 0) + ((flags & 16U) != 0 ? 4 : 0);
  const std::size_t width = std::size_t{1} << (flags & 3U), head = (flags & 4U) != 0 ? 6 : 4;
  const std::uint64_t mask = width == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * width)) - 1;
  const std::uint64_t length = number_at<std::uint64_t>(bytes, m) & mask;
  m += width;
  if (length > bytes.size() || m + length + 4 > bytes.size()) return;
  const std::size_t end = m + length;
  out.checked.push_back({at, end});
  while (m + head <= end) {
    const std::size_t size = number_at<std::uint16_t>(bytes, m + 1);
    out.messages.push_back({number_at<std::uint8_t>(bytes, m), m, m + 1, m + head, size});
    m += head + size;
  }
}

Structure structure_of(std::string_view bytes) {
  constexpr std::size_t kRootHeader = 64, kEntryBytes = 40, kMaxEntries = 64;
  Structure out;
  const unsigned version = number_at<std::uint8_t>(bytes, 8);
  if (version < 2) add_header_v1(bytes, number_at<std::uint64_t>(bytes, kRootHeader), out);
  if (version >= 2) out.checked.push_back({0, 44});
  for (std::size_t at = bytes.find("SNOD"); at != std::string_view::npos; at = bytes.find("SNOD", at + 4)) {
    for (std::size_t i = 0; i < std::min<std::size_t>(number_at<std::uint16_t>(bytes, at + 6), kMaxEntries); ++i) {
      out.entries.push_back(at + 8 + kEntryBytes * i);
      add_header_v1(bytes, number_at<std::uint64_t>(bytes, out.entries.back() + 8), out);
    }
  }
  for (std::size_t at = bytes.find("OHDR"); at != std::string_view::npos; at = bytes.find("OHDR", at + 4))
    add_header_v2(bytes, at, out);
  return out;
}

// Changes one field of a message. The message's type decides which field it may be: most are sizes or addresses.
void change_message(std::string& bytes, const Message& message, Random& random) {
  const auto odd = unusual_number(random);
  const std::size_t at = message.at;
  switch (message.type) {
    case kDataspace:
      if (random() % 4 == 0) return set_number(bytes, at + 1, static_cast<std::uint8_t>(random() % 34));  // dimensions
      return set_number(bytes, at + (number_at<std::uint8_t>(bytes, at) == 1 ? 8 : 4) + 8 * (random() % 3), odd);
    case kDatatype:
      if (random() % 2 == 0)
        return set_number(bytes, at, static_cast<std::uint8_t>((random() % 4) << 4U | random() % 11));
      return set_number(bytes, at + 4, static_cast<std::uint32_t>(odd));  // size of an element
    case kLayout:
      if (random() % 4 == 0) return set_number(bytes, at + 1, static_cast<std::uint8_t>(random() % 4));  // class
      return set_number(bytes, at + 2 + (random() % 4) * 4, odd);
    case kFilters:
      return set_number(bytes, at + 8 + 2 * (random() % 6), static_cast<std::uint16_t>(random() % 7));
    case kAttribute:
      return set_number(bytes, at + 2 + 2 * (random() % 3), static_cast<std::uint16_t>(odd));
    default:
      if (message.size >= 8) set_number(bytes, at + random() % (message.size - 7), odd);
  }
}

}  // namespace

void mutate_hdf5(std::string& bytes, Random& random) {
  static constexpr std::uint16_t kTypes[] = {
      0,       kDataspace, kLinkInfo,  kDatatype,     kFillValue,   kLink,         kExternalFiles,
      kLayout, kFilters,   kAttribute, kContinuation, kSymbolTable, kAttributeInfo};
  const Structure found = structure_of(bytes);
  const auto action = random() % 8;
  if (action == 0 && !found.entries.empty()) {
    // An entry: the name, the header, or the kind (2: a soft link).
    const std::size_t entry = found.entries[below(random, found.entries.size())];
    const std::size_t other = found.entries[below(random, found.entries.size())];
    if (random() % 2 == 0) return set_number(bytes, entry + 16, static_cast<std::uint32_t>(random() % 4));
    return set_number(bytes, entry + 8 * (random() % 2), number_at<std::uint64_t>(bytes, other + 8 * (random() % 2)));
  }
  if (found.messages.empty()) return;
  const Message& message = found.messages[below(random, found.messages.size())];
  if (action == 1) {
    const std::uint16_t type = one_of(kTypes, random);
    message.size_at - message.type_at == 2 ? set_number(bytes, message.type_at, type)
                                           : set_number(bytes, message.type_at, static_cast<std::uint8_t>(type));
  } else if (action == 2) {
    set_number(bytes, message.size_at, static_cast<std::uint16_t>(unusual_number(random)));
  } else if (action == 3) {  // the contents of another message
    const Message& other = found.messages[below(random, found.messages.size())];
    const std::size_t count = std::min(message.size, other.size);
    if (other.at + count <= bytes.size() && message.at + count <= bytes.size())
      bytes.replace(message.at, count, bytes.substr(other.at, count));
  } else {
    change_message(bytes, message, random);
  }
  for (const ByteRange& block : found.checked) {
    if (random() % 16 != 0 && block.end <= bytes.size())
      set_number(bytes, block.end, checksum(std::string_view(bytes).substr(block.first, block.end - block.first)));
  }
}

}  // namespace percuss::fuzz
