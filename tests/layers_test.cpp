#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace percuss::layers_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::array<std::string_view, 12> kFloors{"core",  "acquire",  "frf",    "identify", "model", "metrics",
                                                   "synth", "pipeline", "report", "batch",    "tools", "python"};

struct Include {
  std::string name;    // what stands between the quotes or brackets
  bool quoted = true;  // "ours", not <theirs>
};

struct Source {
  std::string path;   // from the top of the sources: "src/core/fft.cpp"
  std::string floor;  // "core"
  bool header = false;
  std::vector<Include> includes;
  std::vector<std::string> types;  // those defined at namespace scope
};

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return text.substr(std::min(first, text.size()));
}

/// What follows `word` and blanks after it at the start of `text`; nothing when it does not start so.
std::optional<std::string_view> after(std::string_view word, std::string_view text) {
  if (!text.starts_with(word)) return {};
  return without_blanks(text.substr(word.size()));
}

std::optional<Include> include_in(std::string_view line) {
  const auto directive = after("#", without_blanks(line));
  const auto name = directive ? after("include", *directive) : std::nullopt;
  if (!name || name->size() < 2) return {};
  return Include{.name = std::string(name->substr(1, name->find_first_of("\">", 1) - 1)),
                 .quoted = name->front() == '"'};
}

// Definitions at namespace scope start in column 1, as the layout of the sources demands.
std::optional<std::string> type_in(std::string_view line) {
  if (line.find('{') == std::string_view::npos) return {};
  for (const std::string_view kind : {"struct ", "class ", "enum class "}) {
    if (const auto name = after(kind, line)) return std::string(name->substr(0, name->find_first_of(" :{")));
  }
  return {};
}

void read_source(std::istream& text, Source& source) {
  for (std::string line; std::getline(text, line);) {
    if (auto include = include_in(line)) source.includes.push_back(std::move(*include));
    if (auto type = type_in(line)) source.types.push_back(std::move(*type));
  }
}

/// "core" of src/core/math/fft.cpp, "tools" of tools/cli/output.cpp.
std::string layer_of(const fs::path& path) {
  auto part = path.begin();
  if (*part == "src") ++part;
  return part->string();
}

std::vector<Source> sources() {
  const fs::path top = PERCUSS_SOURCE_DIR;
  std::vector<Source> out;
  for (const char* folder : {"src", "tools", "python"}) {
    for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
      const fs::path path = fs::relative(entry.path(), top);
      if (path.extension() != ".hpp" && path.extension() != ".cpp") continue;
      Source source{.path = path.string(), .floor = layer_of(path), .header = path.extension() == ".hpp"};
      std::ifstream text(entry.path());
      read_source(text, source);
      out.push_back(std::move(source));
    }
  }
  return out;
}

std::ptrdiff_t height(std::string_view floor) {
  return std::find(kFloors.begin(), kFloors.end(), floor) - kFloors.begin();
}

/// The includes of `source` that name a floor above its own, or no floor at all ("fft.hpp" for "core/fft.hpp").
std::vector<std::string> wrong_floors(const Source& source) {
  std::vector<std::string> out;
  for (const auto& include : source.includes) {
    if (!include.quoted) continue;
    const std::size_t slash = include.name.find('/');
    // The files of the tool and of the module, which is made of it, name each other plainly.
    const bool beside = slash == std::string::npos && height(source.floor) >= height("tools");
    if (!beside && height(include.name.substr(0, slash)) > height(source.floor)) {
      out.push_back(source.path + " includes " + include.name);
    }
  }
  return out;
}

/// The includes of a header of the library that are neither the standard library's, nor Eigen's, nor our own.
std::vector<std::string> third_parties(const Source& source) {
  std::vector<std::string> out;
  for (const auto& [name, quoted] : source.includes) {
    const bool standard = name.find_first_of("./") == std::string::npos;
    if (!quoted && !standard && !name.starts_with("Eigen/")) out.push_back(source.path + " includes " + name);
  }
  return out;
}

TEST(Floors, AreTheFoldersThatExist) {
  for (const auto& source : sources()) EXPECT_LT(height(source.floor), std::ssize(kFloors)) << source.path;
}

TEST(Floors, IncludeOnlyWhatLiesBelow) {
  std::vector<std::string> wrong;
  for (const auto& source : sources()) {
    for (auto& sentence : wrong_floors(source)) wrong.push_back(std::move(sentence));
  }
  EXPECT_THAT(wrong, IsEmpty());
}

TEST(Floors, KeepThirdPartiesOutOfHeaders) {
  std::vector<std::string> wrong;
  for (const auto& source : sources()) {
    if (!source.header || height(source.floor) >= height("tools"))
      continue;  // the parser and Python are their own affair
    for (auto& sentence : third_parties(source)) wrong.push_back(std::move(sentence));
  }
  EXPECT_THAT(wrong, IsEmpty());
}

TEST(Floors, IncludeFftwInOneFile) {
  std::vector<std::string> files;
  for (const auto& source : sources()) {
    for (const auto& include : source.includes) {
      if (include.name == "fftw3.h") files.push_back(source.path);
    }
  }
  EXPECT_THAT(files, ElementsAre("src/core/math/fft.cpp"));
}

// Two types of one name in one namespace are one type to the linker, whatever they hold.
TEST(Floors, NameEachTypeOnce) {
  std::map<std::string, std::string> home;
  std::vector<std::string> twice;
  for (const auto& source : sources()) {
    if (!source.header) continue;
    for (const auto& type : source.types) {
      const auto [known, fresh] = home.emplace(type, source.path);
      if (!fresh) twice.push_back(type + " in " + known->second + " and " + source.path);
    }
  }
  EXPECT_GT(home.size(), 0U);
  EXPECT_THAT(twice, IsEmpty());
}

// The checks above pass on an empty list too, so they are shown to see what they are for.
TEST(Floors, AreSeenToBeBroken) {
  Source source{.path = "src/frf/x.hpp", .floor = "frf", .header = true};
  std::istringstream text(
      "#pragma once\n#include <vector>\n #  include <hdf5.h>\n#include \"core/fft.hpp\"\n#include \"x.hpp\"\n"
      "#include \"report/json.hpp\"\n// #include \"model/beam.hpp\"\n"
      "struct A {\nclass B;\n  struct Inner {};\n};\nenum class C : int { x };\n");
  read_source(text, source);
  EXPECT_THAT(wrong_floors(source),
              ElementsAre("src/frf/x.hpp includes x.hpp", "src/frf/x.hpp includes report/json.hpp"));
  EXPECT_THAT(third_parties(source), ElementsAre("src/frf/x.hpp includes hdf5.h"));
  EXPECT_THAT(source.types, ElementsAre("A", "C"));
}

}  // namespace percuss::layers_test
