#include <cstdio>
#include <cstdlib>

#include "acquire/formats/text/read_csv.hpp"
#include "acquire/formats/text/read_frf_text.hpp"
#include "acquire/formats/text/read_lvm.hpp"
#include "acquire/formats/uff/read_frf_uff.hpp"
#include "acquire/formats/uff/read_uff.hpp"
#include "acquire/formats/uff/uff_contents.hpp"
#include "targets.hpp"

namespace percuss::fuzz {
namespace {

using Open = acquire::Record (*)(const FileBytes&, const acquire::ReadOptions&);

void run_record(std::string_view bytes, Open open) {
  const FileBytes file = as_file(bytes);
  if (accepted([&] { read_all(open(file, {})); })) return;
  accepted([&] { read_all(open(file, strict_read_options())); });
}

void convert_if_found(std::optional<acquire::StoredFrfs> found) {
  if (found) acquire::to_accelerances(std::move(*found), {});
}

}  // namespace

void run_csv(std::string_view bytes) { run_record(bytes, acquire::open_csv); }

void run_lvm(std::string_view bytes) { run_record(bytes, acquire::open_lvm); }

namespace {

bool read_uff(const FileBytes& file) {
  return accepted([&] {
    const acquire::UffContents contents = acquire::read_uff_contents(file);
    accepted([&] { convert_if_found(acquire::read_frf_uff(file, contents, true)); });
    if (accepted([&] { read_all(acquire::open_uff(file, contents, {})); })) return;
    read_all(acquire::open_uff(file, contents, strict_read_options()));
  });
}

}  // namespace

// Reads the bytes from memory and as a lazy file. Both must be accepted, or both refused.
void run_uff(std::string_view bytes) {
  const MemfdFile file(bytes);
  if (read_uff(as_file(bytes)) != read_uff(lazy_input(file.path(), bytes.size()))) {
    std::fputs("the bytes in memory and the lazy file are not both accepted or both refused\n", stderr);
    std::abort();
  }
}

void run_frf_text(std::string_view bytes) {
  const FileBytes file = as_file(bytes);
  accepted([&] { convert_if_found(acquire::read_frf_text(file, false)); });
  accepted([&] { convert_if_found(acquire::read_frf_text(file, true)); });
}

}  // namespace percuss::fuzz
