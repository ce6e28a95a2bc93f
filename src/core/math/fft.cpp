#include "core/math/fft.hpp"

#include <fftw3.h>
#include <gsl/gsl_fft_real.h>

#include <bit>
#include <cassert>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <shared_mutex>

#include "core/library_call.hpp"
#include "core/parallel/per_thread.hpp"

namespace percuss {
inline namespace core {
namespace {

fftw_complex* as_fftw(Complex* p) { return reinterpret_cast<fftw_complex*>(p); }

// Memory that is aligned for FFTW and grows as needed.
class Scratch {
 public:
  std::span<Complex> first(std::size_t lines) {
    if (room_ < lines) {
      room_ = 0;
      values_.reset(reinterpret_cast<Complex*>(fftw_alloc_complex(lines)));
      if (!values_) throw std::bad_alloc();
      room_ = lines;
    }
    return {values_.get(), lines};
  }

 private:
  std::unique_ptr<Complex, decltype(&fftw_free)> values_{nullptr, fftw_free};
  std::size_t room_ = 0;
};

// An upper estimate of the memory that FFTW allocates while it plans, or executes, a transform of n values.
std::size_t plan_bytes(std::size_t n) { return 64 * n + (std::size_t{1} << 18U); }

struct Buffers {
  explicit Buffers(std::size_t n) : real(fftw_alloc_real(n)), complex(fftw_alloc_complex(n / 2 + 1)) {}
  bool allocated() const { return real != nullptr && complex != nullptr; }
  Buffers(const Buffers&) = delete;
  Buffers& operator=(const Buffers&) = delete;
  ~Buffers() {
    fftw_free(real);
    fftw_free(complex);
  }
  double* real;
  fftw_complex* complex;
};

// Plans of one kind, kept until the process ends. FFTW's execution is thread-safe, its planner is not. A request for an
// existing plan does not wait for a plan in the making.
class Plans {
 public:
  using Make = fftw_plan (*)(std::size_t, const Buffers&);
  explicit Plans(Make function) : make_(function) {}

  fftw_plan get(std::size_t n) {
    if (fftw_plan plan = made(n)) return plan;
    static std::mutex planner;
    const std::scoped_lock lock(planner);
    if (fftw_plan plan = made(n)) return plan;
    fftw_plan plan = make(n);
    const std::scoped_lock write(mutex_);
    return plans_[n] = plan;
  }

 private:
  fftw_plan made(std::size_t n) {
    const std::shared_lock lock(mutex_);
    const auto at = plans_.find(n);
    return at == plans_.end() ? nullptr : at->second;
  }

  // FFTW ends the program when memory runs out within its planner.
  fftw_plan make(std::size_t n) const {
    const Buffers buffers(n);
    if (!buffers.allocated()) throw std::bad_alloc();
    const LibraryCall call(plan_bytes(n));
    fftw_plan plan = make_(n, buffers);
    if (plan == nullptr) throw std::bad_alloc();
    return plan;
  }

  Make make_;
  std::shared_mutex mutex_;
  std::map<std::size_t, fftw_plan> plans_;
};

// std::vector guarantees only 16-byte alignment, and plans assume no more. UNALIGNED would disable vector instructions.
fftw_plan forward_plan(std::size_t n) {
  static auto& plans = *new Plans([](std::size_t length, const Buffers& buffers) {
    return fftw_plan_dft_r2c_1d(static_cast<int>(length), buffers.real, buffers.complex,
                                FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  });
  return plans.get(n);
}

fftw_plan inverse_plan(std::size_t n) {
  static auto& plans = *new Plans([](std::size_t length, const Buffers& buffers) {
    return fftw_plan_dft_c2r_1d(static_cast<int>(length), buffers.complex, buffers.real, FFTW_ESTIMATE);
  });
  return plans.get(n);
}

bool is_fast_length(std::size_t length) {
  for (const std::size_t prime : {2U, 3U, 5U, 7U}) {
    while (length % prime == 0 && length > 0) length /= prime;
  }
  return length == 1;
}

}  // namespace

void plan_real_dft(std::size_t n) { forward_plan(n); }

void real_dft(std::span<const double> x, std::span<Complex> out) {
  assert(!x.empty() && out.size() == x.size() / 2 + 1);
  fftw_plan plan = forward_plan(x.size());
  auto* in = const_cast<double*>(x.data());  // PRESERVE_INPUT: read only
  const LibraryCall call(plan_bytes(x.size()));
  if (fftw_alignment_of(in) == 0 && fftw_alignment_of(reinterpret_cast<double*>(out.data())) == 0) {
    fftw_execute_dft_r2c(plan, in, as_fftw(out.data()));
    return;
  }
  const std::vector<double> aligned(x.begin(), x.end());
  std::vector<Complex> result(out.size());
  fftw_execute_dft_r2c(plan, const_cast<double*>(aligned.data()), as_fftw(result.data()));
  std::copy(result.begin(), result.end(), out.begin());
}

std::vector<Complex> real_dft_once(std::span<const double> x) {
  constexpr std::size_t kMaxUnplanned = std::size_t{1} << 15U;
  const std::size_t n = x.size();
  if (!std::has_single_bit(n) || n < 2 || n > kMaxUnplanned) return real_dft(x);
  std::vector<double> parts(x.begin(), x.end());  // then real parts in ascending, imaginary parts in descending order
  gsl_fft_real_radix2_transform(parts.data(), 1, n);
  std::vector<Complex> out(n / 2 + 1);
  out.front() = parts.front();
  for (std::size_t k = 1; k < n / 2; ++k) out[k] = {parts[k], parts[n - k]};
  out.back() = parts[n / 2];
  return out;
}

std::vector<Complex> real_dft(std::span<const double> x) {
  std::vector<Complex> out(x.size() / 2 + 1);
  real_dft(x, out);
  return out;
}

std::span<const Complex> real_dft_in_scratch(std::span<const double> x) {
  static const PerThread<Scratch> scratches;
  const std::span<Complex> out = scratches.local().first(x.size() / 2 + 1);
  real_dft(x, out);
  return out;
}

std::vector<double> inverse_real_dft(std::span<const Complex> lines, std::size_t samples) {
  assert(samples >= 1 && lines.size() == samples / 2 + 1);
  std::vector<Complex> scratch(lines.begin(), lines.end());  // the c2r transform destroys its input
  std::vector<double> out(samples);
  fftw_plan plan = inverse_plan(samples);
  const LibraryCall call(plan_bytes(samples));
  fftw_execute_dft_c2r(plan, as_fftw(scratch.data()), out.data());
  for (double& value : out) value /= static_cast<double>(samples);
  return out;
}

std::size_t fast_length_at_most(std::size_t n) {
  while (n > 1 && !is_fast_length(n)) --n;
  return n;
}

std::size_t fast_length_at_least(std::size_t n) {
  while (!is_fast_length(n)) ++n;
  return n;
}

}  // namespace core
}  // namespace percuss
