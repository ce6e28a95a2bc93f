#include <zlib.h>

#include <algorithm>
#include <vector>

#include "mutators.hpp"

namespace percuss::fuzz {
namespace {

constexpr std::size_t kHeaderBytes = 128, kMaxInflated = std::size_t{1} << 20U;
constexpr std::uint32_t kInt8 = 1, kInt32 = 5, kUint32 = 6, kMatrix = 14, kCompressed = 15;

// An element of a MAT file of level 5: a tag with type and size, then data or further elements.
struct Element {
  std::uint32_t type = 0;
  bool small = false;  // tag and data in eight bytes
  std::string data{};
  std::vector<Element> parts{};
  std::int64_t size_error = 0;  // of the stated size
};

std::string inflated(std::string_view packed) {
  std::string out(kMaxInflated, '\0');
  uLongf size = out.size();
  const int end = ::uncompress(reinterpret_cast<Bytef*>(out.data()), &size,
                               reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  out.resize(end == Z_OK ? size : 0);
  return out;
}

std::string deflated(const std::string& plain) {
  uLongf size = ::compressBound(plain.size());
  std::string out(size, '\0');
  ::compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(plain.data()), plain.size(),
              1);
  out.resize(size);
  return out;
}

std::vector<Element> elements_of(std::string_view bytes, int depth) {
  constexpr std::size_t kMaxElements = 256;
  std::vector<Element> out;
  while (bytes.size() >= 8 && out.size() < kMaxElements) {
    Element element{.type = number_at<std::uint32_t>(bytes, 0)};
    std::size_t size = number_at<std::uint32_t>(bytes, 4), start = 8;
    if (element.type > 0xFFFF) {
      size = element.type >> 16U;
      element.type &= 0xFFFFU;
      element.small = true;
      start = 4;
    }
    size = std::min(size, bytes.size() - start);
    const std::string_view data = bytes.substr(start, size);
    if (depth > 0 && element.type == kMatrix) element.parts = elements_of(data, depth - 1);
    if (depth > 0 && element.type == kCompressed) element.parts = elements_of(inflated(data), depth - 1);
    if (element.parts.empty()) element.data = data;
    const bool padded = element.type != kCompressed && !element.small;
    bytes.remove_prefix(std::min(bytes.size(), element.small ? 8 : padded ? start + (size + 7) / 8 * 8 : start + size));
    out.push_back(std::move(element));
  }
  return out;
}

std::string bytes_of(const std::vector<Element>& elements);

std::string bytes_of(const Element& element) {
  std::string data = element.parts.empty() ? element.data : bytes_of(element.parts);
  if (element.type == kCompressed && !element.parts.empty()) data = deflated(data);
  const auto size = static_cast<std::uint32_t>(static_cast<std::int64_t>(data.size()) + element.size_error);
  std::string out(8, '\0');
  if (element.small && data.size() <= 4) {
    set_number(out, 0, element.type | (size << 16U));
    return out.replace(4, data.size(), data);
  }
  set_number(out, 0, element.type);
  set_number(out, 4, size);
  out += data;
  if (element.type != kCompressed) out.resize((out.size() + 7) / 8 * 8);
  return out;
}

std::string bytes_of(const std::vector<Element>& elements) {
  std::string out;
  for (const Element& element : elements) out += bytes_of(element);
  return out;
}

void collect(std::vector<Element>& elements, std::vector<std::vector<Element>*>& lists) {
  if (elements.empty()) return;
  lists.push_back(&elements);
  for (Element& element : elements) collect(element.parts, lists);
}

// Changes array flags, dimensions, a name or numbers, depending on the type of the element.
void change_data(Element& element, Random& random) {
  static constexpr const char* kNames[] = {"force", "accel",    "fs",   "frf", "frequency_hz", "dt", "time",
                                           "point", "geometry", "unit", "x"};
  const std::size_t words = element.data.size() / 4;
  if (element.type == kUint32 && words == 2) {
    element.data[random() % 2] = static_cast<char>(random() % 20);  // class, or complex, global and logical
  } else if (element.type == kInt32) {
    if (random() % 4 == 0) element.data.resize(element.data.size() + (random() % 2 == 0 ? 4 : 0));
    set_number(element.data, 4 * below(random, words), static_cast<std::uint32_t>(unusual_number(random)));
  } else if (element.type == kInt8) {
    element.data = one_of(kNames, random);
  } else if (!element.data.empty()) {
    set_number(element.data, 8 * below(random, element.data.size() / 8), unusual_number(random));
  }
}

}  // namespace

void mutate_mat(std::string& bytes, Random& random) {
  constexpr int kDepth = 6;
  if (bytes.size() <= kHeaderBytes) return;
  std::vector<Element> all = elements_of(std::string_view(bytes).substr(kHeaderBytes), kDepth);
  std::vector<std::vector<Element>*> lists;
  collect(all, lists);
  if (lists.empty()) return;
  std::vector<Element>& list = *lists[below(random, lists.size())];
  const std::size_t at = below(random, list.size());
  Element& element = list[at];
  switch (random() % 9) {
    case 0:
      element.type = static_cast<std::uint32_t>(random() % 20);
      break;
    case 1:
      element.size_error =
          static_cast<std::int64_t>(unusual_number(random)) - static_cast<std::int64_t>(element.data.size());
      break;
    case 2:
      element.data.resize(below(random, 2 * element.data.size() + 9));
      break;
    case 3: {
      const Element twin = element;
      list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), twin);
      break;
    }
    case 4:
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 5:
      std::swap(element, list[below(random, list.size())]);
      break;
    case 6:  // packs an element
      if (element.type == kMatrix) element = Element{.type = kCompressed, .parts = {element}};
      break;
    default:
      change_data(element, random);
  }
  bytes = bytes.substr(0, kHeaderBytes) + bytes_of(all);
}

void mutate_binary_formats(std::string& bytes, Random& random) {
  if (bytes.starts_with("\x89HDF")) return mutate_hdf5(bytes, random);
  if (bytes.size() > kHeaderBytes && bytes.substr(126, 2) == "IM") mutate_mat(bytes, random);
}

}  // namespace percuss::fuzz
