#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Checks that the includes of every source respect the order of layers and folders that ARCHITECTURE.md describes.
namespace percuss::layers_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

using Level = std::vector<std::string_view>;

/// The folders of the sources, lowest level first. A folder may include itself and the folders of lower levels, but not
/// the others of its own level.
const std::vector<Level>& levels() {
  static const std::vector<Level> kLevels{
      {"core"},
      {"core/io", "core/parallel"},
      {"core/math"},
      {"acquire/record"},
      {"acquire/channels", "acquire/geometry"},
      {"acquire/formats/hdf5", "acquire/formats/sound", "acquire/formats/text", "acquire/formats/uff"},
      {"acquire/formats/mat"},  // MAT 7.3 is HDF5
      {"acquire/hits"},
      {"acquire/sandbox"},
      {"acquire"},
      {"acquire/live/sound_cards"},
      {"acquire/live"},  // replays records of any format
      {"frf"},
      {"identify/model"},
      {"identify/noise"},
      {"identify/fit"},
      {"identify/start"},
      {"identify/select"},
      {"identify/hits"},
      {"identify/decay"},
      {"identify/misfit"},
      {"identify/classify"},
      {"identify/shapes"},
      {"identify"},
      {"model/beam", "model/shell", "model/trampoline"},
      {"model/impact", "model/section"},
      {"model/bat"},
      {"metrics/protocol", "metrics/deflection"},
      {"metrics/study"},
      {"metrics"},
      {"synth"},
      {"pipeline/findings"},
      {"pipeline/hits"},
      {"pipeline/channels"},
      {"pipeline/stages"},
      {"pipeline/source"},
      {"pipeline/warnings"},
      {"pipeline"},
      {"pipeline/live", "pipeline/response"},
      {"report/text"},
      {"report/json"},
      {"report/svg"},
      {"report/csv", "report/gltf", "report/html"},
      {"report"},
      {"batch"},
      {"api"},  // include/percuss
      {"tools/cli/pdf", "tools/cli/terminal"},
      {"tools/cli"},
      {"tools/cli/completion"},
      {"tools/commands"},
      {"tools/commands/batch", "tools/commands/info", "tools/commands/model", "tools/commands/record"},
      {"tools"},
      {"python"},
  };
  return kLevels;
}

/// The first folder must not include the second one, whatever the order of the layers.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kForbidden{{
    {"acquire/hits", "acquire/formats"},       // hits are graded from samples, independent of the file format
    {"identify/select", "identify/classify"},  // modes are found before they are named
    {"model", "acquire"},                      // models read no files
    {"model", "identify"},                     // models do not use identified modes
}};

struct Include {
  std::string name;    // between the quotes or brackets
  bool quoted = true;  // "ours", not <third party>
};

struct Source {
  std::string path;    // from the top of the repository: "src/core/math/fft.cpp"
  std::string folder;  // "core/math"
  bool header = false;
  std::vector<Include> includes;
  std::vector<std::string> types;  // defined at namespace scope
};

std::string_view without_leading_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return text.substr(std::min(first, text.size()));
}

/// The rest of `text` after `word` and blanks; nothing when `text` does not start with `word`.
std::optional<std::string_view> after(std::string_view word, std::string_view text) {
  if (!text.starts_with(word)) return {};
  return without_leading_blanks(text.substr(word.size()));
}

std::optional<Include> include_in(std::string_view line) {
  const auto directive = after("#", without_leading_blanks(line));
  const auto name = directive ? after("include", *directive) : std::nullopt;
  if (!name || name->size() < 2) return {};
  return Include{.name = std::string(name->substr(1, name->find_first_of("\">", 1) - 1)),
                 .quoted = name->front() == '"'};
}

// A definition at namespace scope starts in column 1, because clang-format does not indent namespaces.
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

/// "core/math" of src/core/math/fft.cpp, "tools/cli" of tools/cli/output.cpp.
std::string folder_of(const fs::path& path) {
  const std::string parent = path.parent_path().generic_string();
  return parent.starts_with("src/") ? parent.substr(4) : parent;
}

const std::vector<Source>& sources() {
  static const std::vector<Source> kSources = [] {
    const fs::path top = PERCUSS_SOURCE_DIR;
    std::vector<Source> out;
    for (const char* root : {"src", "tools", "python"}) {
      for (const auto& entry : fs::recursive_directory_iterator(top / root)) {
        const fs::path path = fs::relative(entry.path(), top);
        if (path.extension() != ".hpp" && path.extension() != ".cpp") continue;
        Source source{.path = path.generic_string(), .folder = folder_of(path), .header = path.extension() == ".hpp"};
        std::ifstream text(entry.path());
        read_source(text, source);
        out.push_back(std::move(source));
      }
    }
    return out;
  }();
  return kSources;
}

std::optional<std::size_t> level_of(std::string_view folder) {
  for (std::size_t i = 0; i < levels().size(); ++i) {
    if (std::find(levels()[i].begin(), levels()[i].end(), folder) != levels()[i].end()) return i;
  }
  return {};
}

bool within(std::string_view folder, std::string_view parent) {
  return folder == parent || (folder.starts_with(parent) && folder[parent.size()] == '/');
}

/// The folder that an include names. The tool's files are named relative to tools/ ("cli/output.hpp"), the Python
/// module's files without a folder.
std::string included_folder(const Source& source, const std::string& name) {
  std::string named = fs::path(name).parent_path().generic_string();
  if (level_of(named)) return named;
  if (within(source.folder, "python") && named.empty()) {
    return fs::exists(fs::path(PERCUSS_SOURCE_DIR) / "python" / name) ? "python" : "tools";
  }
  return named.empty() ? "tools" : "tools/" + named;
}

/// A sentence about the rule that an include breaks, or nothing.
std::optional<std::string> broken_rule(const std::string& from, const std::string& to) {
  if (from == to) return {};
  for (const auto& [folder, target] : kForbidden) {
    if (within(from, folder) && within(to, target))
      return std::string(folder) + " must not include " + std::string(target);
  }
  const auto own = level_of(from), other = level_of(to);
  if (!other) return to + " is missing in levels()";
  if (*other < *own) return {};
  if (*other == *own) return from + " and " + to + " are of one level and must not include each other";
  return to + " is above " + from + " in the order of layers";
}

std::vector<std::string> broken_rules(const Source& source) {
  std::vector<std::string> out;
  for (const Include& include : source.includes) {
    if (!include.quoted || include.name.starts_with("percuss/")) continue;
    if (const auto rule = broken_rule(source.folder, included_folder(source, include.name)))
      out.push_back(source.path + " includes " + include.name + ": " + *rule);
  }
  return out;
}

/// The third-party includes of a header of the library, except the standard library, Eigen and
/// nlohmann/json_fwd.hpp.
std::vector<std::string> third_parties(const Source& source) {
  std::vector<std::string> out;
  for (const auto& [name, quoted] : source.includes) {
    const bool standard = name.find_first_of("./") == std::string::npos;
    const bool names_only = name == "nlohmann/json_fwd.hpp";  // only forward-declares its types
    if (!quoted && !standard && !names_only && !name.starts_with("Eigen/") && !name.starts_with("percuss/"))
      out.push_back(source.path + " includes " + name);
  }
  return out;
}

bool is_in_library(const Source& source) { return !within(source.folder, "tools") && !within(source.folder, "python"); }

TEST(Layers, ListEveryFolder) {
  for (const auto& source : sources()) EXPECT_TRUE(level_of(source.folder)) << source.path;
}

TEST(Layers, ListOnlyExistingFolders) {
  std::set<std::string> folders;
  for (const auto& source : sources()) folders.insert(source.folder);
  for (const Level& level : levels()) {
    for (const std::string_view folder : level) EXPECT_TRUE(folders.contains(std::string(folder))) << folder;
  }
}

TEST(Layers, AreIncludedFromAboveOnly) {
  std::vector<std::string> wrong;
  for (const auto& source : sources()) {
    for (auto& sentence : broken_rules(source)) wrong.push_back(std::move(sentence));
  }
  EXPECT_THAT(wrong, IsEmpty());
}

TEST(Layers, KeepThirdPartiesOutOfHeaders) {
  std::vector<std::string> wrong;
  for (const auto& source : sources()) {
    if (!source.header || !is_in_library(source)) continue;
    for (auto& sentence : third_parties(source)) wrong.push_back(std::move(sentence));
  }
  EXPECT_THAT(wrong, IsEmpty());
}

TEST(Layers, IncludeFftwInOneFile) {
  std::vector<std::string> files;
  for (const auto& source : sources()) {
    for (const auto& include : source.includes) {
      if (include.name == "fftw3.h") files.push_back(source.path);
    }
  }
  EXPECT_THAT(files, ElementsAre("src/core/math/fft.cpp"));
}

// A layer is a namespace. Two types of one name in it violate the one-definition rule, which the linker does not
// report.
TEST(Layers, DefineEachTypeNameOnce) {
  std::map<std::string, std::string> path_of;
  std::vector<std::string> twice;
  for (const auto& source : sources()) {
    if (!source.header) continue;
    const std::string layer = source.folder.substr(0, source.folder.find('/')) + "::";
    for (const auto& type : source.types) {
      const auto [known, fresh] = path_of.emplace(layer + type, source.path);
      if (!fresh) twice.push_back(known->first + " in " + known->second + " and " + source.path);
    }
  }
  EXPECT_GT(path_of.size(), 0U);
  EXPECT_THAT(twice, IsEmpty());
}

/// A unit is x.hpp with x.cpp.
TEST(Folders, HoldAtMost25Units) {
  std::map<std::string, std::set<std::string>> units;
  for (const auto& source : sources()) units[source.folder].insert(fs::path(source.path).stem().string());
  for (const auto& [folder, names] : units) EXPECT_LE(names.size(), 25U) << folder;
}

TEST(Folders, OfTestsMirrorTheSources) {
  std::set<std::string> folders{"commands",       "commands/batch",  "commands/info", "commands/inputs",
                                "commands/model", "commands/record", "docs",          "hostile",
                                "stress",         "support"};
  for (const auto& source : sources()) {
    for (std::string folder = source.folder; !folder.empty(); folder = fs::path(folder).parent_path().generic_string())
      folders.insert(folder);
  }
  const fs::path tests = fs::path(PERCUSS_SOURCE_DIR) / "tests";
  for (const auto& entry : fs::recursive_directory_iterator(tests)) {
    if (!entry.path().filename().string().ends_with("_test.cpp")) continue;
    const std::string folder = fs::relative(entry.path().parent_path(), tests).generic_string();
    EXPECT_TRUE(folder == "." || folders.contains(folder)) << entry.path();
  }
}

// The checks of includes would also pass if no include were recognised. This test shows that broken rules are found.
TEST(Layers, ReportBrokenRules) {
  Source source{.path = "src/frf/x.hpp", .folder = "frf", .header = true};
  std::istringstream text(
      "#pragma once\n#include <vector>\n #  include <hdf5.h>\n#include \"core/math/fft.hpp\"\n#include \"x.hpp\"\n"
      "#include \"report/json/x.hpp\"\n// #include \"model/beam/beam.hpp\"\n"
      "struct A {\nclass B;\n  struct Inner {};\n};\nenum class C : int { x };\n");
  read_source(text, source);
  EXPECT_THAT(broken_rules(source),
              ElementsAre("src/frf/x.hpp includes x.hpp: tools is above frf in the order of layers",
                          "src/frf/x.hpp includes report/json/x.hpp: report/json is above frf in the order of layers"));
  EXPECT_THAT(third_parties(source), ElementsAre("src/frf/x.hpp includes hdf5.h"));
  EXPECT_THAT(source.types, ElementsAre("A", "C"));
  EXPECT_EQ(broken_rule("acquire/hits", "acquire/formats/text"), "acquire/hits must not include acquire/formats");
  EXPECT_EQ(broken_rule("acquire/formats/uff", "acquire/formats/text"),
            "acquire/formats/uff and acquire/formats/text are of one level and must not include each other");
  EXPECT_EQ(broken_rule("frf", "core/math"), std::nullopt);
}

}  // namespace percuss::layers_test
