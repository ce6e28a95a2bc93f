#pragma once
/// One test from record to named modes. Each accessor runs the stages that it needs and keeps their results.
///
/// @code
/// #include <iostream>
/// #include <percuss/analysis.hpp>
/// #include <percuss/synth.hpp>
/// #include <percuss/write.hpp>
///
/// int main(int argc, char** argv) {
///   const percuss::Record record =
///       argc > 1 ? percuss::open_record(argv[1]) : percuss::synthesise_preset("composite-bat").record;
///   const percuss::Analysis analysis(record, {.band_Hz = percuss::Band{60, 3200}});
///   if (!analysis.possible()) return 1;  // hits() says why
///   for (const percuss::Mode& mode : analysis.modes())
///     std::cout << mode.freq_Hz << " ± " << mode.freq_std_Hz << " Hz\n";
///   for (const percuss::Warning& warning : analysis.warnings()) std::cout << warning.message << '\n';
///   percuss::write("report.html", analysis, {.overwrite = true});
/// }
/// @endcode
#include <percuss/budget.hpp>
#include <percuss/frf.hpp>
#include <percuss/hits.hpp>
#include <percuss/modes.hpp>
#include <percuss/record.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace percuss {

namespace api {
struct AnalysisData;
}

/// quick: finds modes that show a peak. standard: also finds modes without a peak. best: fits all modes together, to
/// the Cramér–Rao bound.
enum class Effort { quick, standard, best };

/// Bending and hoop are types of a tube's modes. automatic: a tube where the sensors' angles are stated, or where the
/// modes fit two sensors at 0° and 90°. other: modes are numbered only.
enum class ObjectKind { automatic, tube, other };

struct AnalysisOptions {
  std::optional<Band> band_Hz{};  // default: the range that the hammer excited; for an FrfSet: its range
  Effort effort = Effort::best;
  Estimator estimator = Estimator::h1;  // of frfs(); modes are fitted to H1
  HitOptions hits{};
  std::optional<std::size_t> modes{};  // report this many, the clearest ones
  std::vector<double> start_Hz{};      // list modes near these frequencies and no others
  double exponential = 0;              // exponential window that falls to this fraction at a hit's end; 0: none. For an
                                       // FrfSet: the window with which it was computed, over records of 1/spacing
  std::vector<double> delay_s{};       // delays of the accelerations to take out; one for all or one per channel
  bool auto_delay = false;             // take out the delays that the phases of the modes show, in place of delay_s
  double overlay_dB = 1;               // FRFs that differ by no more at a peak count as overlaid
  ObjectKind object = ObjectKind::automatic;
  std::size_t threads = 0;         // 0: all; the result is the same
  std::optional<Budget> budget{};  // default: default_budget() of the input's files
};

/// Optional parts of the document of Analysis::json().
struct JsonOptions {
  bool per_hit = false;        // every mode, fitted to each hit alone
  bool stabilisation = false;  // the poles of all model orders
};

/// Copies share the results. One thread at a time may call the accessors of an analysis and of its copies.
/// errors  InputError, of the constructors: options that contradict each other, several runs (see Record::runs), no
///         acceleration.
///         InputError, of the accessors: the file cannot be read; no hit can be used (where possible() is false).
///         BudgetSpent, of the accessors: they take more than the options' budget.
class Analysis {
 public:
  explicit Analysis(const Record& record, const AnalysisOptions& options = {});
  explicit Analysis(const FrfSet& frfs, const AnalysisOptions& options = {});

  /// False when no hit can be used: there are no FRFs and modes then.
  bool possible() const;
  /// Hits, graded by their force, their responses and their agreement. Empty for an analysis of FRFs.
  std::vector<Hit> hits() const;
  Band band_Hz() const;
  /// Averaged FRFs within the band, as accelerances.
  FrfSet frfs() const;
  /// The numbers of the points that have FRFs, ascending.
  std::vector<int> points() const;
  /// Modes within the band, ascending in frequency.
  std::vector<Mode> modes() const;
  /// Bending or hoop, one per mode.
  std::vector<ModeClassification> classifications() const;
  /// Every mode, fitted to each accepted hit alone. A mode that a hit does not show has no entry for it.
  std::vector<ModeOfHit> modes_per_hit() const;
  /// Computes hits, FRFs and modes, and returns the warnings about them.
  std::vector<Warning> warnings() const;

  /// The document percuss/analysis/1, as `percuss analyze --json` prints it.
  std::string json(const JsonOptions& options = {}) const;
  /// Tables for people, as `percuss analyze` prints them.
  std::string text(std::size_t width = 100) const;

  explicit Analysis(std::shared_ptr<const api::AnalysisData> data) : data_(std::move(data)) {}
  const api::AnalysisData& data() const { return *data_; }

 private:
  std::shared_ptr<const api::AnalysisData> data_;
};

}  // namespace percuss
