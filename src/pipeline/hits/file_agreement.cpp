#include "pipeline/hits/file_agreement.hpp"

#include <algorithm>
#include <map>

namespace percuss::pipeline {
namespace {

constexpr double kMinExplained = 0.5;  // as for the warning hits_disagree

// Energies over the lines of one channel: of the responses, and of the part that the other files' H1 does not explain.
struct Energy {
  double response = 0, unexplained = 0;
};

using Members = std::vector<std::size_t>;  // hits

Energy compare(const Members& own, const Members& others, const std::vector<ComparedHit>& spectra,
               std::size_t channel) {
  Energy energy;
  for (std::size_t k = 0; k < spectra[own.front()].force.size(); ++k) {
    Complex cross;
    double power = 0;
    for (const std::size_t h : others) {
      cross += std::conj(spectra[h].force[k]) * spectra[h].accel[channel][k];
      power += std::norm(spectra[h].force[k]);
    }
    const Complex frf = power > 0 ? cross / power : Complex();
    for (const std::size_t h : own) {
      energy.response += std::norm(spectra[h].accel[channel][k]);
      energy.unexplained += std::norm(spectra[h].accel[channel][k] - frf * spectra[h].force[k]);
    }
  }
  return energy;
}

// A file of several hits which all are outliers among the hits, each with less than half of its energy explained.
std::optional<FileDisagreement> file_of_outliers(const acquire::Record& record, const std::vector<AnalysedHit>& hits) {
  constexpr std::size_t kMinHits = 2;  // one outlier is a bad hit
  struct Count {
    std::size_t hits = 0, outliers = 0;
    double explained = 0;
  };
  std::map<std::size_t, Count> files;
  for (const AnalysedHit& hit : hits) {
    Count& count = files[record.rows[hit.hit.row].file];
    ++count.hits;
    for (const acquire::Finding& finding : hit.hit.findings) {
      if (finding.code != acquire::FindingCode::outlier) continue;
      ++count.outliers;
      count.explained = std::max(count.explained, 1 - finding.value);
    }
  }
  for (const auto& [file, count] : files) {
    if (count.hits >= kMinHits && count.outliers == count.hits && count.explained < kMinExplained)
      return FileDisagreement{.file = file, .explained = count.explained};
  }
  return std::nullopt;
}

}  // namespace

std::optional<FileDisagreement> disagreeing_file(const acquire::Record& record, const std::vector<AnalysedHit>& hits,
                                                 const std::vector<ComparedHit>& spectra) {
  if (const auto outliers = file_of_outliers(record, hits)) return outliers;
  std::map<int, std::map<std::size_t, Members>> points;  // by point and file
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (hits[h].accepted && !spectra[h].force.empty())
      points[hits[h].point][record.rows[hits[h].hit.row].file].push_back(h);
  }
  std::map<std::size_t, Energy> files;
  for (const auto& [point, of_files] : points) {
    for (const auto& [file, own] : of_files) {
      Members others;
      for (const auto& [other, members] : of_files) {
        if (other != file) others.insert(others.end(), members.begin(), members.end());
      }
      for (std::size_t c = 0; !others.empty() && c < spectra[own.front()].accel.size(); ++c) {
        const Energy energy = compare(own, others, spectra, c);
        files[file].response += energy.response;
        files[file].unexplained += energy.unexplained;
      }
    }
  }
  std::optional<FileDisagreement> worst;
  for (const auto& [file, energy] : files) {
    const double explained = std::max(0.0, 1 - energy.unexplained / energy.response);
    if (energy.response > 0 && explained < (worst ? worst->explained : kMinExplained))
      worst = FileDisagreement{.file = file, .explained = explained};
  }
  return worst;
}

}  // namespace percuss::pipeline
