#include "acquire/channels/channel_setup.hpp"
#include "acquire/formats/sound/sound_calibration.hpp"
#include "acquire/geometry/geometry.hpp"
#include "core/io/number_table.hpp"
#include "metrics/protocol/abi_log.hpp"
#include "metrics/protocol/session.hpp"
#include "metrics/study/study_join.hpp"
#include "metrics/study/study_table.hpp"
#include "report/json/read_document.hpp"
#include "synth/read_spec.hpp"
#include "targets.hpp"

namespace percuss::fuzz {

void run_sound_calibration(std::string_view bytes) {
  accepted([&] {
    const SoundCalibration first = parse_calibration(bytes, "fuzzed");
    const std::string text = calibration_text(first);
    if (calibration_text(parse_calibration(text, "again")) != text) std::abort();
  });
}

void run_channel_setup(std::string_view bytes) {
  accepted([&] { parse_channel_setup(bytes, "fuzzed"); });
}

void run_synth_spec(std::string_view bytes) {
  accepted([&] { parse_synth_spec(bytes, "fuzzed"); });
}

void run_bats(std::string_view bytes) {
  accepted([&] { parse_session(bytes, "fuzzed"); });
  accepted([&] { parse_abi_log(bytes, "fuzzed"); });
  accepted([&] {
    StudyRows rows;
    rows.add(bytes, "fuzzed");
    std::vector<StudyBat> bats = rows.bats();
    anonymise_bats(bats);
    study_table_csv(bats);
  });
}

void run_tables(std::string_view bytes) {
  accepted([&] {
    Geometry geometry = parse_geometry(bytes, "fuzzed");
    tube_from_coordinates(geometry);
  });
  accepted([&] { parse_number_table(bytes, "fuzzed", {.columns = 2, .max_rows = 100, .remedy = "give two"}); });
}

void run_document(std::string_view bytes) {
  accepted([&] { parse_documents(bytes, "fuzzed"); });
  accepted([&] { parse_study_curve(bytes, "fuzzed"); });
}

}  // namespace percuss::fuzz
