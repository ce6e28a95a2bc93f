#pragma once
#include <complex>

namespace percuss {
inline namespace core {

// Products and quotients for finite numbers. The operators of std::complex also handle infinities. This takes ten times
// the work and keeps loops from being vectorised.

inline std::complex<double> times(std::complex<double> a, std::complex<double> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// conj(a)·b
inline std::complex<double> conj_times(std::complex<double> a, std::complex<double> b) {
  return {a.real() * b.real() + a.imag() * b.imag(), a.real() * b.imag() - a.imag() * b.real()};
}

inline std::complex<double> inverse(std::complex<double> a) { return std::conj(a) * (1 / std::norm(a)); }

}  // namespace core
}  // namespace percuss
