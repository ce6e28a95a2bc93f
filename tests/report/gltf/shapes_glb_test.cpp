#include "report/gltf/shapes_glb.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>

namespace percuss::report::shapes_glb_test {

using nlohmann::json;
using testing::ElementsAre;

constexpr double kSinglePrecision = 1e-6;

// A reader written from the specification of glTF 2.0, without the code of percuss.
struct Glb {
  json document;
  std::string buffer;

  explicit Glb(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(bytes, 4), 2U);
    EXPECT_EQ(word(bytes, 8), bytes.size());
    const std::uint32_t json_size = word(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    EXPECT_EQ(json_size % 4, 0U);
    document = json::parse(bytes.substr(20, json_size));
    const std::size_t at = 20 + json_size;
    EXPECT_EQ(bytes.substr(at + 4, 4), std::string("BIN\0", 4));
    buffer = bytes.substr(at + 8);
    EXPECT_EQ(word(bytes, at), buffer.size());
    EXPECT_EQ(document["buffers"][0]["byteLength"], buffer.size());
  }
  static std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t out = 0;
    for (unsigned i = 0; i < 4; ++i) out |= std::uint32_t{static_cast<unsigned char>(bytes.at(at + i))} << (8 * i);
    return out;
  }
  // The numbers of an accessor of floats or of 32-bit indices.
  std::vector<double> numbers(const json& index) const {
    const json& accessor = document["accessors"].at(index.get<std::size_t>());
    const json& view = document["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    const std::size_t parts = accessor["type"] == "VEC3" ? 3 : 1;
    std::vector<double> out;
    for (std::size_t i = 0; i < parts * accessor["count"].get<std::size_t>(); ++i) {
      const std::uint32_t bits = word(buffer, view["byteOffset"].get<std::size_t>() + 4 * i);
      out.push_back(accessor["componentType"] == 5126 ? static_cast<double>(std::bit_cast<float>(bits))
                                                      : static_cast<double>(bits));
    }
    EXPECT_EQ(view["byteLength"], 4 * out.size());
    return out;
  }
};

Wireframe plate() {
  Wireframe frame;
  frame.mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  frame.mesh.lines = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  frame.mesh.faces = {{0, 1, 2, 3}};
  frame.mesh.normals.assign(4, {0, 0, 1});
  for (const Complex turn : {Complex(1, 0), Complex(0.6, 0.8)}) {
    WireframeMode mode{.name = "mode", .freq_Hz = 100, .damping_ratio = 0.01, .mpc = 1, .moves = {}};
    for (const double value : {1.0, -1.0, 0.5, 0.0}) mode.moves.push_back({0, 0, value * turn});
    frame.modes.push_back(mode);
  }
  return frame;
}

TEST(ShapesGlb, HasANodeAndAnAnimationPerMode) {
  const Glb glb(frame_glb(plate()));
  EXPECT_EQ(glb.document["asset"]["version"], "2.0");
  ASSERT_EQ(glb.document["animations"].size(), 2U);
  const json& root = glb.document["nodes"][0];
  EXPECT_EQ(root["children"].size(), 4U) << "two for each mode: the deflected structure, and its lines at rest";
  for (const json& animation : glb.document["animations"]) {
    const json& target = animation["channels"][0]["target"];
    EXPECT_EQ(target["path"], "weights");
    const json& node = glb.document["nodes"].at(target["node"].get<std::size_t>());
    EXPECT_EQ(node["name"], "mode, 100 Hz");
    EXPECT_EQ(node["extras"]["frequency_hz"], 100);
    EXPECT_EQ(node["extras"]["damping_ratio"], 0.01);
  }
}

// At each key, rest + Σ weight · target is rest + scale · Re(φ e^{jωt}).
TEST(ShapesGlb, MovesAsTheComplexMode) {
  const Wireframe frame = plate();
  const Glb glb(frame_glb(frame));
  for (std::size_t m = 0; m < 2; ++m) {
    const json& sampler = glb.document["animations"][m]["samplers"][0];
    const auto times = glb.numbers(sampler["input"]), weights = glb.numbers(sampler["output"]);
    ASSERT_EQ(weights.size(), 2 * times.size());
    const std::size_t node = glb.document["animations"][m]["channels"][0]["target"]["node"];
    const double scale = glb.document["nodes"][node]["extras"]["displacement_scale"];
    EXPECT_GT(scale, 0);
    const json& mesh = glb.document["meshes"].at(glb.document["nodes"][node]["mesh"].get<std::size_t>());
    const json& surface = mesh["primitives"][0];
    EXPECT_EQ(surface["mode"], 4) << "triangles";
    const auto cosine = glb.numbers(surface["targets"][0]["POSITION"]);
    const auto sine = glb.numbers(surface["targets"][1]["POSITION"]);
    for (std::size_t k = 0; k < times.size(); ++k) {
      const Complex phase = std::polar(1.0, 2 * std::numbers::pi * times[k] / times.back());
      for (std::size_t i = 0; i < 4; ++i) {
        const double drawn = weights[2 * k] * cosine[3 * i + 2] + weights[2 * k + 1] * sine[3 * i + 2];
        EXPECT_NEAR(drawn, scale * (frame.modes[m].moves[i][2] * phase).real(), kSinglePrecision);
      }
    }
  }
}

TEST(ShapesGlb, KeepsPlacesLinesAndFaces) {
  const Glb glb(frame_glb(plate()));
  const json& primitives = glb.document["meshes"][1]["primitives"];
  EXPECT_THAT(glb.numbers(primitives[0]["attributes"]["POSITION"]), ElementsAre(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0));
  EXPECT_THAT(glb.numbers(primitives[0]["indices"]), ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_EQ(primitives[1]["mode"], 1) << "lines";
  EXPECT_THAT(glb.numbers(primitives[1]["indices"]), ElementsAre(0, 1, 1, 2, 2, 3, 3, 0));
  for (const json& accessor : glb.document["accessors"]) EXPECT_GT(accessor["count"], 0);
  const json& position = glb.document["accessors"].at(primitives[0]["attributes"]["POSITION"].get<std::size_t>());
  EXPECT_EQ(position["max"], json({1, 1, 0}));
}

TEST(ShapesGlb, DrawsPointsWithoutLines) {
  Wireframe frame = plate();
  frame.mesh.lines.clear();
  frame.mesh.faces.clear();
  const Glb glb(frame_glb(frame));
  EXPECT_EQ(glb.document["meshes"][1]["primitives"][0]["mode"], 0);
  EXPECT_EQ(frame_glb(frame), frame_glb(frame));
}

}  // namespace percuss::report::shapes_glb_test
