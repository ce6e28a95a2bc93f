#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::report {

/// The buffer of a glTF file with its accessors and views. Each `add` returns the accessor's index.
class GlbBuffer {
 public:
  using Json = nlohmann::ordered_json;

  /// Vectors with their least and largest components, as positions must have.
  std::size_t add_vectors(std::span<const std::array<double, 3>> vectors);
  /// RGBA colours as bytes.
  std::size_t add_colours(std::span<const std::array<std::uint8_t, 4>> colours);
  std::size_t add_indices(std::span<const std::size_t> indices);
  /// Scalars with their least and largest value, as times must have.
  std::size_t add_scalars(std::span<const double> values);

  /// The whole file: `document` completed with the buffer's parts, then the buffer.
  std::string file(const Json& document) const;

 private:
  enum class Target { none, vertices = 34962, indices = 34963 };
  std::size_t add(std::string_view bytes, std::size_t count, int component_type, const char* type, Target target,
                  const Json& more);

  std::vector<std::string> accessors_, views_;  // as JSON
  std::string bytes_;
};

}  // namespace percuss::report
