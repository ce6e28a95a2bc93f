#pragma once
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace percuss {
inline namespace core {

using Complex = std::complex<double>;

/// Discrete Fourier transform of a real sequence, one-sided, unscaled:
///   X[k] = Σ_n x[n] exp(−2πj k n / N),  k = 0 … N/2                            (1)
/// shapes  x [N]; result [N/2 + 1].
/// Plans are FFTW_ESTIMATE and kept per length: equal input gives equal bytes. Several threads may call at the same
/// time.
/// theory (2.1)
std::vector<Complex> real_dft(std::span<const double> x);

/// Plans transforms of n >= 1 values, which takes some ms. Call it before a parallel loop, so that threads do not wait
/// for the plan.
void plan_real_dft(std::size_t n);

/// As real_dft(x), for a length of which a process transforms few sequences. A length that is a power of two, up to
/// 32768, needs no plan: planning would take longer than several such transforms.
std::vector<Complex> real_dft_once(std::span<const double> x);

/// As real_dft(x), into the caller's storage; x.size() >= 1, out.size() == x.size()/2 + 1.
void real_dft(std::span<const double> x, std::span<Complex> out);

/// As real_dft(x), into memory of the calling thread. The next call on this thread overwrites the result. For callers
/// that keep only a part of the lines.
std::span<const Complex> real_dft_in_scratch(std::span<const double> x);

/// The inverse of (1), with the factor 1/N: the sequence of `samples` values with the one-sided transform `lines`.
std::vector<double> inverse_real_dft(std::span<const Complex> lines, std::size_t samples);

/// The largest length <= n with no prime factors other than 2, 3, 5 and 7 (n >= 1).
std::size_t fast_length_at_most(std::size_t n);

/// The smallest such length >= n.
std::size_t fast_length_at_least(std::size_t n);

}  // namespace core
}  // namespace percuss
