#include "acquire/channels/channel_setup.hpp"
#include "acquire/geometry/geometry.hpp"
#include "core/io/number_table.hpp"
#include "metrics/protocol/abi_log.hpp"
#include "metrics/protocol/session.hpp"
#include "metrics/study/study_files.hpp"
#include "metrics/study/study_table.hpp"
#include "report/json/read_document.hpp"
#include "synth/read_spec.hpp"
#include "targets.hpp"

namespace percuss::fuzz {

void run_channel_setup(std::string_view bytes) {
  accepted([&] { acquire::parse_channel_setup(bytes, "fuzzed"); });
}

void run_synth_spec(std::string_view bytes) {
  accepted([&] { synth::parse_synth_spec(bytes, "fuzzed"); });
}

void run_bats(std::string_view bytes) {
  accepted([&] { metrics::parse_session(bytes, "fuzzed"); });
  accepted([&] { metrics::parse_abi_log(bytes, "fuzzed"); });
  accepted([&] {
    metrics::StudyRows rows;
    rows.add(bytes, "fuzzed");
    std::vector<metrics::StudyBat> bats = rows.bats();
    metrics::anonymise_bats(bats);
    metrics::study_table_csv(bats);
  });
}

void run_tables(std::string_view bytes) {
  accepted([&] {
    acquire::Geometry geometry = acquire::parse_geometry(bytes, "fuzzed");
    acquire::tube_from_coordinates(geometry);
  });
  accepted([&] { parse_number_table(bytes, "fuzzed", {.columns = 2, .max_rows = 100, .remedy = "give two"}); });
}

void run_document(std::string_view bytes) {
  accepted([&] { report::parse_documents(bytes, "fuzzed"); });
  accepted([&] { metrics::parse_study_curve(bytes, "fuzzed"); });
}

}  // namespace percuss::fuzz
