#include <algorithm>

#include "acquire/formats/mat/mat_file.hpp"
#include "acquire/formats/mat/read_frf_mat.hpp"
#include "acquire/formats/mat/read_mat.hpp"
#include "recipe.hpp"
#include "targets.hpp"

namespace percuss::fuzz {
namespace {

// The variable of the recipe line
//   real NAME SHAPE [nan] | complex NAME SHAPE [nan] | number NAME VALUES | text NAME TEXT
acquire::MatVariable variable_of(const RecipeLine& line) {
  acquire::MatVariable out{.name = line.word(1), .shape = {}, .real = {}, .imaginary = {}, .text = {}};
  const std::string kind = line.word(0);
  if (kind == "text") {
    out.is_text = true;
    out.text = line.word(2);
    out.shape = {1, out.text.size()};
  } else if (kind == "number") {
    out.real = line.numbers(2);
    out.shape = {out.real.size(), 1};
  } else {
    std::size_t count = 1;
    for (const std::size_t size : line.sizes(2, kMaxElements)) {
      out.shape.push_back(count * size <= kMaxElements ? size : 1);
      count *= out.shape.back();
    }
    while (out.shape.size() < 2) out.shape.push_back(1);
    out.real = recipe_values(count, line.has("nan"));
    if (kind == "complex") out.imaginary = recipe_values(count, false);
  }
  return out;
}

}  // namespace

// Interprets the variables of a MAT file, which the recipe in `bytes` states.
void run_mat(std::string_view bytes) {
  acquire::MatFile file{.path = "fuzzed", .bytes = bytes.size(), .variables = {}, .notes = {}};
  for (const RecipeLine& line : recipe_lines(bytes)) file.variables.push_back(variable_of(line));
  const acquire::ReadOptions strict = strict_read_options();
  for (const acquire::ReadOptions& options : {acquire::ReadOptions{}, strict}) {
    accepted([&] {
      if (auto frfs = acquire::read_frf_mat(file, {.read = options, .kind = {}}))
        acquire::to_accelerances(std::move(*frfs), {});
    });
    accepted([&] { read_all(acquire::open_mat(file, options)); });
  }
}

}  // namespace percuss::fuzz
