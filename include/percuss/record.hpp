#pragma once
/// Records: force and acceleration over time, from a file or from arrays.
///
/// Opening a record reads its description only; samples are read when something asks for them. Units are SI: N, m/s²,
/// Hz, s, m, rad. Rows, channels and samples count from 0.
///
/// @code
/// #include <iostream>
/// #include <percuss/record.hpp>
/// #include <vector>
///
/// int main() {
///   // Two hits at 1 kHz. A file: percuss::open_record("bat.h5", {.unit = "g"})
///   const std::vector<double> force_N{0, 0, 80, 160, 80, 0, 0, 0}, accel_mps2{0, 0, 1, 5, 9, 4, -6, -2};
///   const percuss::Record record = percuss::record_from_arrays(
///       {.fs_Hz = 1000, .force_N = {force_N, force_N}, .accel_mps2 = {{accel_mps2}, {accel_mps2}}});
///   const percuss::RecordDescription about = record.description();
///   std::cout << about.rows.size() << " rows at " << about.fs_Hz << " Hz\n";
///   std::cout << "largest force " << record.force_N(0).at(3) << " N\n";
/// }
/// @endcode
#include <percuss/error.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace percuss {

namespace api {
struct RecordData;
}

/// One measured signal.
struct Channel {
  std::string name;
  std::string unit{};                  // as stored in the file; the library's numbers are SI
  std::optional<double> angle_rad{};   // of the sensor, around the barrel
  std::optional<double> position_m{};  // of the sensor, from the barrel's end
};

/// One stretch of continuously sampled time.
struct RecordRow {
  std::size_t samples = 0;
  std::string path{};  // of its file; empty for arrays
  int point = 0;       // the point that was hit
  int run = 0;         // the number of the repeated test
};

struct RecordDescription {
  std::vector<std::string> paths;
  std::string format;  // "HDF5", "CSV"
  double fs_Hz = 0;
  bool has_force = true;
  Channel force;
  std::vector<Channel> accel;
  std::vector<RecordRow> rows;
  bool continuous = false;     // each row may hold several hits; a single row always may
  std::vector<Message> notes;  // assumptions, and parts that could not be read
};

/// How several files form one test: as hits, or as one point each. Automatic means hits.
enum class FileGrouping { automatic, hits, points };

enum class FrfKind { accelerance, mobility, receptance };

/// The user's statements about a file. Each overrides what the file states, unless its comment says otherwise.
struct ReadOptions {
  std::optional<double> fs_Hz{};
  std::string fs_variable{};                        // the variable of a MAT file that holds the rate
  std::optional<double> df_Hz{};                    // spacing of FRFs, for files that lack it or round it
  std::string force_channel{};                      // name of the column, or number, counted from 1
  std::vector<std::string> accel_channel{};         // likewise, in the order wanted
  std::string force_unit{};                         // of the stored forces: "lbf", "V"
  std::string unit{};                               // of the stored accelerations: "g", "cm/s2", "V"
  std::vector<double> force_scale{};                // N per stored unit; one for all files or one per file
  std::vector<double> accel_scale{};                // m/s² per stored unit; one for all or one per channel
  std::optional<double> force_sensitivity_VpN{};    // for forces stored in volts
  std::vector<double> accel_sensitivity_Vpmps2{};   // for accelerations in volts; one for all or one per channel
  std::vector<double> pressure_sensitivity_VpPa{};  // for microphones in volts, in a test without force; one or several
  std::vector<double> angle_rad{}, position_m{};    // per acceleration channel
  std::string setup{};                              // path of a channel set-up, JSON
  std::optional<FrfKind> frf_kind{};                // of a file of FRFs
  std::optional<std::size_t> averages{};            // of every FRF of a file, at least 1; the file must not contradict
  FileGrouping files = FileGrouping::automatic;
  bool force_optional = false;  // accept a file without force, for deflections
  bool trust_input = false;     // read MAT, HDF5 and sound files in this process, not in a sandbox
};

/// Force and acceleration as arrays.
/// shapes  force_N [rows][samples], accel_mps2 [rows][channels][samples]. point is empty or has [rows].
struct RecordArrays {
  double fs_Hz = 0;
  std::vector<std::vector<double>> force_N{};  // empty: no force was recorded
  std::vector<std::vector<std::vector<double>>> accel_mps2{};
  std::vector<int> point{};                       // the point that each row hits, from 0; empty: one point
  std::vector<double> angle_rad{}, position_m{};  // per acceleration channel; empty: not known
  bool continuous = false;                        // each row may hold several hits; a single row always may
};

/// A recorded test. Copies are cheap and share the samples. Several threads may read at once.
class Record {
 public:
  RecordDescription description() const;
  double fs_Hz() const;
  std::size_t rows() const;
  std::size_t channels() const;

  /// Samples of a row's force in N (zeros where no force was recorded), and of a row's acceleration in m/s².
  /// errors  InputError: no such row, channel or sample; the file cannot be read.
  std::vector<double> force_N(std::size_t row) const;
  std::vector<double> accel_mps2(std::size_t row, std::size_t channel) const;
  /// Reads the samples first … first + count − 1 into `out`; units and errors as above.
  void read_force_N(std::size_t row, std::size_t first, std::size_t count, double* out) const;
  void read_accel_mps2(std::size_t row, std::size_t channel, std::size_t first, std::size_t count, double* out) const;

  /// The repeated tests (runs) in this record, each as a record. One run gives this record.
  std::vector<Record> runs() const;

  explicit Record(std::shared_ptr<const api::RecordData> data) : data_(std::move(data)) {}
  const api::RecordData& data() const { return *data_; }

 private:
  std::shared_ptr<const api::RecordData> data_;
};

/// Opens a record of any format that percuss reads; docs/reference/formats.md lists them. errors  InputError
Record open_record(const std::string& path, const ReadOptions& options = {});
/// Several files as one test. errors  InputError: rates or channels differ.
Record open_record(const std::vector<std::string>& paths, const ReadOptions& options = {});

/// errors  InputError: shapes that do not agree, no samples, a rate that is not above 0, a sample that is not finite.
Record record_from_arrays(RecordArrays arrays);

}  // namespace percuss
