#include "acquire/record/contiguous_samples.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>

#include "acquire/record/sample_limits.hpp"
#include "core/error.hpp"
#include "core/io/read_at.hpp"
#include "core/parallel/per_thread.hpp"

namespace percuss::acquire {
namespace {

// Numbers at a time: 128 KiB stay in the cache while they are scaled.
constexpr std::size_t kPiece = std::size_t{1} << 14U;

class OpenFile {
 public:
  explicit OpenFile(std::string path)
      : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_RDONLY | O_CLOEXEC)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (good()) ::close(descriptor_);
  }
  bool good() const { return descriptor_ >= 0; }
  // Throws when the file was truncated after it was opened. A library could read the missing part as zeros.
  void read(void* to, std::size_t bytes, std::uint64_t offset) const {
    const ReadResult got = read_at(descriptor_, offset, to, bytes);
    if (got.error != 0 && is_machine_fault(got.error))
      throw_system_error("reading failed", got.error, path_, "check the disk");
    if (got.bytes < bytes)
      throw InputError("the file changed during reading", path_, "copy the file again, then read it again");
  }

 private:
  std::string path_;
  int descriptor_;
};

// Multiplies all values. False when a product is not a plausible sample.
bool scale(std::span<double> values, double factor) {
  Eigen::Map<Eigen::ArrayXd> all(values.data(), static_cast<Eigen::Index>(values.size()));
  if (factor != 1) all *= factor;
  if (all.abs().sum() <= kMaxSample) return true;  // no number exceeds the sum of all
  return std::all_of(values.begin(), values.end(), [](double value) { return std::abs(value) <= kMaxSample; });
}

template <class Stored>
void read_piece(const OpenFile& file, std::uint64_t offset, std::span<double> out) {
  if constexpr (std::is_same_v<Stored, double>) {
    file.read(out.data(), out.size_bytes(), offset);
  } else {
    static const PerThread<std::vector<Stored>> buffers;
    std::vector<Stored>& stored = buffers.local();
    stored.resize(out.size());
    file.read(stored.data(), stored.size() * sizeof(Stored), offset);
    std::copy(stored.begin(), stored.end(), out.begin());
  }
}

// Reads and scales samples. False when one is not plausible.
bool read_samples(const OpenFile& file, const ContiguousSignal& signal, std::size_t row, std::size_t first,
                  std::span<double> out) {
  const std::uint64_t start = signal.offset_bytes + row * signal.row_step_bytes + first * signal.number_bytes;
  for (std::size_t done = 0; done < out.size(); done += kPiece) {
    const auto piece = out.subspan(done, std::min(kPiece, out.size() - done));
    const std::uint64_t offset = start + done * signal.number_bytes;
    if (signal.number_bytes == sizeof(float)) {
      read_piece<float>(file, offset, piece);
    } else {
      read_piece<double>(file, offset, piece);
    }
    if (!scale(piece, signal.to_SI)) return false;
  }
  return true;
}

}  // namespace

Record with_contiguous_readers(Record record) {
  const bool known = record.contiguous.size() == record.accel.size() + 1 && record.files.size() == 1;
  if (!known || std::endian::native != std::endian::little) return record;
  const auto file = std::make_shared<const OpenFile>(record.files.front().path);
  if (!file->good()) return record;
  if (record.has_force) {
    record.read_force_N = [file, signal = record.contiguous.front(), other = record.read_force_N](
                              std::size_t row, std::size_t first, std::span<double> out) {
      if (!read_samples(*file, signal, row, first, out)) other(row, first, out);
    };
  }
  record.read_accel_mps2 = [file, signals = record.contiguous, other = record.read_accel_mps2](
                               std::size_t row, std::size_t channel, std::size_t first, std::span<double> out) {
    if (!read_samples(*file, signals[channel + 1], row, first, out)) other(row, channel, first, out);
  };
  return record;
}

}  // namespace percuss::acquire
