// The unit of all speeds: one zero-padded double-precision FFTW convolution on a grid, on one core.
#pragma once

namespace gearfilm {

/// Median time of one convolution [s]: copy in, two-dimensional real transform, product, inverse, copy out; by the
/// fastest of three measured plans. A plain use of FFTW, kept as it is so that speeds can be compared between versions.
double convolution_time(int nx, int ny);

}  // namespace gearfilm
