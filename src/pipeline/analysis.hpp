#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "acquire/record/frf_record.hpp"
#include "acquire/record/record.hpp"
#include "core/budget.hpp"
#include "core/lazy.hpp"
#include "core/trace.hpp"
#include "identify/classify/three_waves.hpp"
#include "identify/hits/hit_frfs.hpp"
#include "identify/model/frf_synthesis.hpp"
#include "identify/start/unmodelled_peaks.hpp"
#include "identify/started_modes.hpp"
#include "pipeline/analysis_options.hpp"
#include "pipeline/channels/channel_findings.hpp"
#include "pipeline/hits/analysed_hit.hpp"
#include "pipeline/hits/file_agreement.hpp"
#include "pipeline/hits/hit_gaps.hpp"
#include "pipeline/hits/hit_spectra.hpp"
#include "pipeline/source/source.hpp"
#include "pipeline/stages/earlier_ringing.hpp"
#include "pipeline/stages/fit_quality.hpp"
#include "pipeline/stages/hit_modes.hpp"
#include "pipeline/stages/hit_residues.hpp"
#include "pipeline/stages/mode_stages.hpp"
#include "pipeline/warnings/channel_mode_warnings.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// The analysis of one test, from hits to named modes. Each result is computed when first demanded, and kept. Inputs
/// are immutable: other options need another Analysis. An accessor runs the stages that it needs and no others; trace()
/// lists the stages that ran. An accessor throws BudgetSpent when the stages take more than the options' budget. Not
/// for use by several threads at once.
class Analysis {
 public:
  /// errors  InputError: no acceleration channel.
  Analysis(acquire::Record record, AnalysisOptions options);
  /// A test of which only the FRFs are known: no hits, no force.
  /// options.exponential_end is the window with which they were computed, over records of 1/df.
  /// errors  InputError: options that need a time record; a window other than the one that the FRFs state.
  Analysis(acquire::FrfRecord frfs, AnalysisOptions options);

  /// The record. For FRFs that were given: their files, channels and geometry, without rows.
  const acquire::Record& record() const { return source_->record(); }
  const AnalysisOptions& options() const { return options_; }
  /// The FRFs that were given in place of a record; nullptr for a record.
  const acquire::FrfRecord* given_frfs() const { return source_->frfs(); }
  Trace& trace() const { return trace_; }
  /// The budget of the stages. Further computations on this analysis count in it, too.
  BudgetMeter& budget() const { return budget_; }
  /// Numbers of the measured points.
  std::set<int> points() const { return source_->points(); }

  /// The names of the points for tables, messages and pages.
  const PointNames& point_names() const;

  /// The delays taken out of the channels: stated in the options, or established by the phases of the modes.
  const std::vector<ChannelDelay>& corrected_delays() const;
  /// The record with predictions in the place of missing samples (acquire::gaps_of).
  const ClosedGaps& closed_gaps() const;
  /// The record of closed_gaps() without corrected_delays(). Every result follows from it.
  const acquire::Record& aligned_record() const;

  /// Hits graded by their force alone: reads nothing else. Element i is hit i + 1 in tables and messages.
  const std::vector<AnalysedHit>& force_hits() const;
  /// Hits graded by their responses as well, and by the agreement of the hits of a point.
  const std::vector<AnalysedHit>& hits() const;
  /// The file whose responses the FRFs of the other files do not explain: the files hold several structures or points.
  /// Nothing where the files agree, and for one file.
  std::optional<FileDisagreement> file_disagreement() const;
  /// False when no hit can be used: then no FRFs and no modes exist.
  bool possible() const;

  /// The band of the options, or else the source's default.
  std::pair<double, double> band_Hz() const;
  /// Spectral lines of the FRFs: the whole band, and a margin for modes just outside it, extended past strong modes
  /// just beyond it (end_past_modes). The margin ends at 1.2 times the bandwidth of the force at the latest, and at
  /// 0.44 of the sampling rate. Reads the responses.
  const acquire::LineRange& lines() const;
  /// The time that the transforms use, if they leave out the end of the hits because no spectral line of the band still
  /// decays there. Nothing if they use all samples, if the user stated a length, and for FRFs that were given.
  std::optional<DecayCut> decay_cut() const;
  /// Decay rate σ of the exponential window; 0 without a window.
  double window_decay_per_s() const;
  /// The lines() within the band.
  acquire::LineRange band_lines() const;
  /// The points of frfs(), ascending.
  std::vector<int> frf_points() const;
  /// Averaged FRFs over lines(), [points × channels], point by point, with the estimator of the options.
  const std::vector<acquire::PointFrf>& frfs() const;
  /// The FRFs to which the modes are fitted, points ascending by number: H1 of the accepted hits; once modes() is
  /// known, without the drift of a survey.
  const identify::FrfDataset& fitted_frfs() const;
  /// Modes within the band, ascending.
  const std::vector<identify::Mode>& modes() const;
  /// All modes of the fit within the band, ascending: modes(), and the modes that the user's choice leaves out.
  std::vector<identify::Mode> fitted_modes() const;
  /// Computes modes() and frfs() in the order that takes less time.
  void compute_modes_and_frfs() const;
  const std::vector<identify::ModeClassification>& classifications() const;
  /// The accelerometers of record(), without the angles of dead ones, which tell no mode type (silences()).
  /// Computes modes().
  std::vector<acquire::SignalInfo> typing_accel() const;
  /// Whether modes() are all modes that were found, so that their orders can be counted. False if the user chose the
  /// modes.
  bool modes_are_complete() const;
  /// Modes that the hammer excited below the band, ascending: modes in the margin of lines(), and lower modes fitted to
  /// a few hits. Empty without modes in the band, or without a stated band.
  const std::vector<identify::Mode>& modes_below() const;
  /// The numbers of bending and of hoop modes of a tube among modes_below(), classified by two sensors.
  const identify::LowerOrders& lower_orders() const;
  /// fitted_frfs() computed from fitted_modes(), over band_lines().
  const std::vector<identify::SynthesisedFrf>& synthesis() const;
  /// How well fitted_modes() explain each FRF, over band_lines(), and the FRFs around each of modes().
  const FitQuality& fit() const;
  /// Peaks of fitted_frfs() that no mode models, the largest first; some lie just beyond the band.
  const std::vector<identify::UnmodelledPeak>& unexplained_peaks() const;
  /// Poles within the band that are stable in a section of it, and whose resonance no mode describes. Empty if the user
  /// chose the modes.
  const std::vector<identify::Pole>& unmodelled_poles() const;
  /// Delays, clocks and scales of the channels, as far as the modes show them.
  const ChannelFindings& channel_findings() const;
  /// Each mode fitted to each accepted hit alone: repeatability, drift, dependence on the force.
  const std::vector<HitMode>& modes_per_hit() const;
  /// The residues of modes() in each hit, [modes][hits]. Not kept: each call computes them. Points are indices into
  /// frf_points(), hits into hits(). Empty for FRFs that were given, and for fewer than two hits that can be compared.
  std::vector<std::vector<ModeInHit>> residues_per_hit() const;
  /// The stabilisation diagram of fitted_frfs(), poles within the band. The modes do not need it.
  const identify::Stabilisation& stabilisation() const;
  /// Warnings about the results computed so far, most serious first. Computes the hits' grades by force, if need be. If
  /// modes() are computed, it also computes channel_findings(), unexplained_peaks() and unmodelled_poles().
  std::vector<Warning> warnings() const;

 private:
  // The lines of the transforms: lines(), and for a record also those up to the highest possible end (LineChoice).
  const LineChoice& line_choice() const;
  TransformOptions transform_options(const acquire::LineRange& lines) const;
  // force_hits(), with the gate of the force that explains the responses better.
  const std::vector<AnalysedHit>& gated_hits() const;
  // The responses over lines(), and lines() itself: its end depends on the responses (end_past_modes).
  struct ReadSpectra {
    acquire::LineRange lines;
    HitResponses responses;
  };
  const ReadSpectra& read_spectra() const;
  const HitResponses& responses() const;
  const std::vector<frf::Spectrum>& force_spectra() const;
  TestSpectra measured_spectra() const;
  // The ringing of earlier blows that the responses hold. Needs the modes where the structure may ring at a hit.
  const std::vector<EarlierRinging>& earlier_ringing() const;
  // measured_spectra() without the earlier ringing.
  TestSpectra spectra() const;
  // H1 of the accepted hits, as measured.
  const identify::FrfDataset& averaged_frfs() const;
  identify::IdentifyOptions all_modes() const;
  std::vector<identify::ModeClassification> types_below() const;  // of modes_below(), as modes of a tube
  identify::LowerTubeModes modes_of_lower_orders() const;
  // Fits the modes again with the time before the blow, where given FRFs show it (time_before_blow_s).
  void allow_for_blow_time(std::vector<identify::Mode>& found) const;
  // Adds the modes of the starting frequencies that name no mode found (identify::with_started_modes).
  void add_started_modes(std::vector<identify::Mode>& found) const;
  // Fits the modes again, to FRFs without the drift that they have in common, if they have one.
  void remove_drift(const TestSpectra& from, const std::function<const identify::HitFrfs&()>& hits,
                    std::vector<identify::Mode>& found) const;
  std::vector<identify::Mode> margin_modes_below() const;  // of margin_modes_
  // If starting frequencies are stated, moves the modes that none of them names to unlisted_modes_.
  void keep_started_modes(std::vector<identify::Mode>& modes) const;
  std::vector<AnalysedHit> compute_hits() const;
  const std::vector<identify::ModeClassification>& types() const;
  std::vector<Silence> silent_channels() const;  // silences() of modes()
  const std::vector<Eigen::VectorXcd>& modal_sums() const;
  struct HitEvidence;  // of warnings()
  HitEvidence hit_evidence() const;
  std::vector<Tone> known_tones() const;  // of the responses; none before they are known
  std::vector<Warning> warnings_of_hits(const HitEvidence& evidence) const;
  std::vector<Warning> warnings_of_channels(const HitEvidence& evidence) const;
  std::vector<Warning> warnings_of_modes(const HitEvidence& evidence) const;

  std::shared_ptr<const Source> source_;
  AnalysisOptions options_;
  mutable Trace trace_;
  mutable BudgetMeter budget_;
  Lazy<std::vector<ChannelDelay>> corrected_delays_;
  Lazy<ClosedGaps> closed_gaps_;
  Lazy<acquire::Record> aligned_record_;
  // Results refer neither to the analysis nor to each other.
  Lazy<std::vector<AnalysedHit>> force_hits_, gated_hits_, hits_;
  Lazy<LineChoice> line_choice_;
  Lazy<ReadSpectra> read_spectra_;
  Lazy<HitResponses> settled_responses_;
  Lazy<std::vector<frf::Spectrum>> force_spectra_;
  // The FRFs and modes with which earlier_ringing() searched. Set where it found no ringing: averaged_frfs_ and modes_
  // then begin with them.
  struct FirstModes {
    identify::FrfDataset frfs;
    std::vector<identify::Mode> modes;
  };
  mutable std::optional<FirstModes> first_modes_;
  Lazy<std::vector<EarlierRinging>> earlier_ringing_;
  Lazy<std::vector<acquire::PointFrf>> frfs_;
  Lazy<identify::FrfDataset> averaged_frfs_;
  // averaged_frfs_ without the drift of the hits, or with the time of the blow; set by modes()
  mutable std::optional<identify::FrfDataset> refined_frfs_;
  mutable std::optional<double> before_blow_s_;  // time_before_blow_s(); set with modes_
  Lazy<std::vector<identify::Mode>> modes_;
  mutable std::vector<identify::Mode> margin_modes_;            // below and above the band; set with modes_
  mutable std::vector<identify::Mode> band_modes_;              // all within the band, if modes_ holds a part of them
  mutable std::vector<identify::Mode> unlisted_modes_;          // within the band, named by no starting frequency
  mutable std::vector<identify::RefusedStart> refused_starts_;  // set with modes_
  mutable std::vector<identify::JoinedModes> joined_modes_;     // by starting frequencies; set with modes_
  // The end of the lines towards which the residual of misfitting modes grows; set with modes_
  mutable std::optional<double> residual_end_Hz_;
  // unmodelled_poles of all modes, where the search around unmodelled resonances added no mode; set with modes_
  mutable std::optional<std::vector<identify::Pole>> searched_poles_;
  Lazy<std::vector<identify::Mode>> modes_below_;
  Lazy<std::vector<identify::ModeClassification>> types_;  // their orders leave out lower_orders()
  Lazy<identify::LowerOrders> lower_orders_;
  Lazy<std::vector<identify::ModeClassification>> classifications_;
  Lazy<std::vector<Eigen::VectorXcd>> modal_sums_;
  Lazy<std::vector<identify::SynthesisedFrf>> synthesis_;
  Lazy<FitQuality> fit_;
  Lazy<std::vector<identify::UnmodelledPeak>> unexplained_peaks_;
  Lazy<std::vector<identify::Pole>> unmodelled_poles_;
  Lazy<ChannelFindings> channel_findings_;
  Lazy<std::vector<HitMode>> modes_per_hit_;
  Lazy<identify::Stabilisation> stabilisation_;
  Lazy<PointNames> point_names_;
};

}  // namespace percuss::pipeline
