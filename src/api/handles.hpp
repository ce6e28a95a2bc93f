#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "percuss/analysis.hpp"
#include "percuss/deflection.hpp"
#include "percuss/error.hpp"
#include "percuss/survey.hpp"
#include "pipeline/analysis.hpp"
#include "pipeline/impact_test.hpp"
#include "pipeline/survey.hpp"

// The data behind the public classes, and conversions between public and internal data that several files use.
namespace percuss::api {

struct RecordData {
  acquire::Record record;
};

struct FrfData {
  acquire::FrfRecord record;  // accelerances for every `kind`
  FrfKind kind = FrfKind::accelerance;
  std::vector<double> freq_Hz;
  std::vector<Frf> frfs;  // converted to `kind`
};

struct AnalysisData {
  pipeline::Analysis analysis;
};

struct SurveyData {
  std::shared_ptr<const AnalysisData> analysis;
  pipeline::Survey survey;  // refers to `analysis`
};

struct DeflectionData {
  std::shared_ptr<const AnalysisData> analysis;
  pipeline::ImpactTest test;
};

Record make_record(acquire::Record record);
FrfSet make_frf_set(acquire::FrfRecord record, FrfKind kind);

/// errors  InputError: the set-up file cannot be read.
acquire::ReadOptions read_options(const ReadOptions& options);
/// As above, with the statements about FRFs. errors  InputError: 0 averages.
acquire::FrfReadOptions frf_read_options(const ReadOptions& options);
acquire::FrfKind frf_kind(FrfKind kind);
FrfKind public_kind(acquire::FrfKind kind);

/// errors  InputError: an option is out of range, or options contradict each other.
pipeline::AnalysisOptions analysis_options(const AnalysisOptions& options);
/// The record of one test. errors  InputError: several runs.
acquire::Record record_of_one_run(const Record& record);

Channel channel_of(const acquire::SignalInfo& signal);
Severity severity_of(warnings::Severity severity);
std::vector<Hit> hits_of(const std::vector<pipeline::AnalysedHit>& hits);
std::vector<Mode> modes_of(const std::vector<identify::Mode>& modes);
std::vector<ModeClassification> classifications_of(const std::vector<identify::ModeClassification>& classifications);
std::vector<Warning> warnings_of(const std::vector<warnings::Warning>& warnings);

/// Computes hits, modes and FRFs, and returns the survey. Its warnings are about the results computed so far.
const pipeline::Survey& computed(const Survey& survey);

/// errors  InputError that names the field, unless `value` is finite and above 0.
void require_above_zero(double value, const char* field, std::vector<OptionId> options = {});

}  // namespace percuss::api
