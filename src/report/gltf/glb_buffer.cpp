#include "report/gltf/glb_buffer.hpp"

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

namespace percuss::report {
namespace {

constexpr int kUnsignedByte = 5121, kUnsignedInt = 5125, kFloat = 5126;

void append_u32(std::string& out, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) out += static_cast<char>((value >> shift) & 0xFFU);
}

// Appends a number as a 32-bit float and returns the stored value.
float append_float(std::string& out, double value) {
  const auto stored = static_cast<float>(value);
  append_u32(out, std::bit_cast<std::uint32_t>(stored));
  return stored;
}

void pad(std::string& out, char filler) { out.append((4 - out.size() % 4) % 4, filler); }

void append_chunk(std::string& out, std::string_view kind, const std::string& bytes) {
  append_u32(out, static_cast<std::uint32_t>(bytes.size()));
  out += kind;
  out += bytes;
}

}  // namespace

std::size_t GlbBuffer::add(std::string_view bytes, std::size_t count, int component_type, const char* type,
                           Target target, const Json& more) {
  Json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
  if (target != Target::none) view["target"] = static_cast<int>(target);
  Json accessor{{"bufferView", views_.size()}, {"componentType", component_type}, {"count", count}, {"type", type}};
  accessor.update(more);
  views_.push_back(view.dump());
  accessors_.push_back(accessor.dump());
  bytes_ += bytes;
  pad(bytes_, '\0');
  return accessors_.size() - 1;
}

std::size_t GlbBuffer::add_vectors(std::span<const std::array<double, 3>> vectors) {
  std::string bytes;
  std::array<float, 3> low{}, high{};
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const float stored = append_float(bytes, vectors[i].at(k));
      low.at(k) = i == 0 ? stored : std::min(low.at(k), stored);
      high.at(k) = i == 0 ? stored : std::max(high.at(k), stored);
    }
  }
  return add(bytes, vectors.size(), kFloat, "VEC3", Target::vertices, {{"min", low}, {"max", high}});
}

std::size_t GlbBuffer::add_colours(std::span<const std::array<std::uint8_t, 4>> colours) {
  std::string bytes;
  for (const auto& colour : colours) {
    for (const std::uint8_t part : colour) bytes += static_cast<char>(part);
  }
  return add(bytes, colours.size(), kUnsignedByte, "VEC4", Target::vertices, {{"normalized", true}});
}

std::size_t GlbBuffer::add_indices(std::span<const std::size_t> indices) {
  std::string bytes;
  for (const std::size_t index : indices) append_u32(bytes, static_cast<std::uint32_t>(index));
  return add(bytes, indices.size(), kUnsignedInt, "SCALAR", Target::indices, Json::object());
}

std::size_t GlbBuffer::add_scalars(std::span<const double> values) {
  std::string bytes;
  for (const double value : values) append_float(bytes, value);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return add(bytes, values.size(), kFloat, "SCALAR", Target::none,
             {{"min", {static_cast<float>(*low)}}, {"max", {static_cast<float>(*high)}}});
}

std::string GlbBuffer::file(const Json& document) const {
  constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2;  // "glTF"
  Json whole = document;
  for (const std::string& text : accessors_) whole["accessors"].push_back(Json::parse(text));
  for (const std::string& text : views_) whole["bufferViews"].push_back(Json::parse(text));
  whole["buffers"] = Json::array({Json{{"byteLength", bytes_.size()}}});
  std::string json = whole.dump(-1, ' ', true);
  pad(json, ' ');
  std::string out;
  append_u32(out, kMagic);
  append_u32(out, kVersion);
  append_u32(out, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + bytes_.size()));
  append_chunk(out, "JSON", json);
  append_chunk(out, std::string_view("BIN\0", 4), bytes_);
  return out;
}

}  // namespace percuss::report
