#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/json.hpp"
#include "support/json_schema.hpp"
#include "synth/read_spec.hpp"
#include "synth/synthesise.hpp"
#include "synth/truth_json.hpp"

namespace percuss::synth::synth_schema_test {

using nlohmann::json;
using test::schema_named;
using test::schema_violations;
using testing::IsEmpty;

TEST(SynthSchema, AcceptsEveryPresetAndTheExample) {
  const json schema = schema_named("synth");
  for (const SynthPreset& preset : synth_presets()) {
    EXPECT_THAT(schema_violations(test::json_ignoring_comments(preset.text), schema), IsEmpty()) << preset.name;
  }
  EXPECT_THAT(schema_violations(test::json_ignoring_comments(synth_example()), schema), IsEmpty());
}

TEST(SynthSchema, HasTheKeysOfTheReader) {
  // The example has every key, and the schema accepts it. Reader and schema both refuse an unknown key.
  const json schema = schema_named("synth");
  json document = test::json_ignoring_comments(synth_example());
  EXPECT_THAT(schema_violations(document, schema), IsEmpty());
  document["sampels"] = 3;
  EXPECT_EQ(schema_violations(document, schema).size(), 1U);
  EXPECT_ANY_THROW(parse_synth_spec(document.dump(), "test"));
}

TEST(SynthSchema, AcceptsTheTruthOfEveryPreset) {
  const json schema = schema_named("synth-truth");
  for (const SynthPreset& preset : synth_presets()) {
    SynthSpec spec = synth_preset(preset.name);
    if (spec.layout == SynthLayout::rows) spec.samples = 1024;
    EXPECT_THAT(schema_violations(test::parse_json(truth_json(synthesise(spec).truth)), schema), IsEmpty())
        << preset.name;
  }
}

}  // namespace percuss::synth::synth_schema_test
