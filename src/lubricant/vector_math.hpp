// exp, expm1, log, log1p, asinh and atan that a compiler may call for several values at once.
//
// libmvec of glibc 2.35 and later has vector versions of them for x86-64, accurate to 4 units in the last place, but
// its headers offer them only together with reassociation of sums, which would make results depend on the compiler.
// Declaring them here lets loops use them without that. Elsewhere the same code calls the plain functions.
#pragma once

#include <cmath>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 35)
extern "C" {
__attribute__((simd("notinbranch"))) double asinh(double) noexcept;
__attribute__((simd("notinbranch"))) double atan(double) noexcept;
__attribute__((simd("notinbranch"))) double exp(double) noexcept;
__attribute__((simd("notinbranch"))) double expm1(double) noexcept;
__attribute__((simd("notinbranch"))) double log(double) noexcept;
__attribute__((simd("notinbranch"))) double log1p(double) noexcept;
}
#endif
#endif
