#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/open_measurement.hpp"
#include "acquire/record/frf_record.hpp"
#include "core/error.hpp"
#include "support/scratch_folder.hpp"
#include "targets.hpp"

// One file of every format, cut off after every byte: it is rejected, or the remaining samples are unchanged.
namespace percuss::truncation_test {

using test::bytes_of;

const std::string kCorpus = PERCUSS_SOURCE_DIR "/fuzz/corpus/";

/// All samples: the forces and accelerations of all rows.
std::vector<std::vector<double>> samples_of(const acquire::Record& record) {
  std::vector<std::vector<double>> out;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    std::vector<double> signal(record.rows[row].samples);
    record.read_force_N(row, 0, signal);
    out.push_back(signal);
    for (std::size_t channel = 0; channel < record.accel.size(); ++channel) {
      record.read_accel_mps2(row, channel, 0, signal);
      out.push_back(signal);
    }
  }
  return out;
}

std::vector<std::vector<Complex>> frfs_of(const acquire::FrfRecord& record) {
  std::vector<std::vector<Complex>> out;
  for (const acquire::PointFrf& frf : record.frfs) out.push_back(frf.frf.value);
  return out;
}

/// Whether `whole` begins with `part`, except for the last `uncertain` numbers of it: a text may be cut within a
/// number.
template <class Number>
bool begins(const std::vector<Number>& part, const std::vector<Number>& whole, std::size_t uncertain) {
  const std::size_t certain = part.size() - std::min(part.size(), uncertain);
  return part.size() <= whole.size() &&
         std::equal(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(certain), whole.begin());
}

struct Cut {
  const char* file;
  std::size_t uncertain;  // numbers at the end of a signal that a cut may change
  acquire::ReadOptions options = {};
};

class Truncation : public testing::TestWithParam<Cut> {
 protected:
  test::ScratchFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(, Truncation,
                         testing::Values(Cut{"csv/record.csv", 1}, Cut{"csv/decimal-comma.csv", 1},
                                         Cut{"lvm/one.lvm", 1}, Cut{"uff/record.uff", 0}, Cut{"uff/text.unv", 0},
                                         Cut{"uff/frf.uff", 0}, Cut{"frf_text/frf.csv", 1}, Cut{"foreign/record.h5", 0},
                                         Cut{"foreign/record.mat", 0}, Cut{"foreign/record.wav", 0},
                                         Cut{"foreign/record.rf64", 0},
                                         Cut{"foreign/record.w64", 0, {.force_channel = "1"}}),
                         [](const auto& one) {
                           std::string name = one.param.file;
                           for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                           return name;
                         });

TEST_P(Truncation, KeepsTheSamplesOrIsRejected) {
  const std::string bytes = bytes_of(kCorpus + GetParam().file), path = folder_.file("cut");
  const acquire::FrfReadOptions options{.read = GetParam().options, .kind = {}};
  test::write_bytes(path, bytes);
  const auto whole = acquire::open_measurement(path, options);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    test::write_bytes(path, bytes.substr(0, size));
    try {
      const auto cut = acquire::open_measurement(path, options);
      ASSERT_EQ(cut.index(), whole.index()) << size;
      if (const auto* record = std::get_if<acquire::Record>(&cut)) {
        const auto parts = samples_of(*record), all = samples_of(std::get<acquire::Record>(whole));
        ASSERT_LE(parts.size(), all.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
          ASSERT_TRUE(begins(parts[i], all[i], GetParam().uncertain))
              << "signal " << i << " after " << size << " bytes";
      } else {
        const auto parts = frfs_of(std::get<acquire::FrfRecord>(cut)),
                   all = frfs_of(std::get<acquire::FrfRecord>(whole));
        ASSERT_LE(parts.size(), all.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
          ASSERT_TRUE(begins(parts[i], all[i], GetParam().uncertain)) << "FRF " << i << " after " << size << " bytes";
      }
    } catch (const InputError& refusal) {
      fuzz::require_clean(refusal);
    }
  }
}

}  // namespace percuss::truncation_test
