#include "elasticity/dense_y_convolution.hpp"

#include "grid/halo.hpp"

namespace gearfilm {
namespace {

#ifdef __AVX2__
constexpr int most_rows = 40;
#else
constexpr int most_rows = 24;  // FFTW has wider vectors than the compiler is allowed
#endif
constexpr int most_spectra = 10000;  // wave numbers of all rows, each of which has a row of the matrix
constexpr int piece_bytes = 12288;   // messages that wait in memory that is shared until they are received
constexpr int tag = 1;

/// How many rows are summed side by side where a process has `rows` of them: 24, 32 or 40, which fill vectors, and
/// whose sums stay in registers. The number that leaves fewest places empty in the last block; of equal ones the
/// largest.
int width_for(int rows) {
  const auto empty = [rows](int width) { return (width - rows % width) % width; };
  return std::min({40, 32, 24}, [&](int a, int b) { return empty(a) < empty(b); });
}

/// sums += matrix times each of `several` columns of rows; sums are [column][real, imaginary][row].
template <int width, std::size_t several, class Real>
void add_rows(const Real* __restrict matrix, const std::array<const std::complex<Real>*, several>& rows, int count,
              Real* __restrict sums) {
  Real parts[2 * several][width];
  for (std::size_t n = 0; n < 2 * several; ++n) std::copy_n(sums + n * width, width, parts[n]);
  for (int l = 0; l < count; ++l, matrix += width) {
    for (std::size_t column = 0; column < several; ++column) {
      const Real* in = reinterpret_cast<const Real*>(rows[column] + l);
      const Real re = in[0], im = in[1];
      for (int j = 0; j < width; ++j) {
        parts[2 * column][j] += matrix[j] * re;
        parts[2 * column + 1][j] += matrix[j] * im;
      }
    }
  }
  for (std::size_t n = 0; n < 2 * several; ++n) std::copy_n(parts[n], width, sums + n * width);
}

/// Adds the products of a matrix with columns of rows to their sums, side by side as many as `width`: 24, 32 or 40.
template <std::size_t several, class Real>
void add_rows(int width, const Real* matrix, const std::array<const std::complex<Real>*, several>& rows, int count,
              Real* sums) {
  switch (width) {
    case 24:
      return add_rows<24>(matrix, rows, count, sums);
    case 32:
      return add_rows<32>(matrix, rows, count, sums);
    default:
      return add_rows<40>(matrix, rows, count, sums);
  }
}

}  // namespace

template <class Real>
bool DenseYConvolution<Real>::serve(int waves, int rows) {
  return rows <= most_rows && waves * rows <= most_spectra;
}

template <class Real>
int DenseYConvolution<Real>::pieces(int waves, int rows) {
  const int bytes = waves * rows * static_cast<int>(sizeof(Complex));
  return (bytes + piece_bytes - 1) / piece_bytes;
}

template <class Real>
DenseYConvolution<Real>::DenseYConvolution(const Grid& grid, const XSpectra<Real>& spectra)
    : comm_(grid.comm()),
      rank_(grid.rank()),
      waves_(spectra.waves()),
      sources_(grid.row_axis().inner({0, grid.rows()}).end),
      width_(width_for(grid.y_count())),
      blocks_((grid.y_count() + width_ - 1) / width_),
      y_ranges_(grid.y_ranges().begin(), grid.y_ranges().end()),
      pieces_(pieces(waves_, (grid.rows() + grid.processes() - 1) / grid.processes())),
      matrix_(static_cast<std::size_t>(waves_) * blocks_ * sources_ * width_),
      spectra_(static_cast<std::size_t>(waves_) * grid.rows()),
      sums_(static_cast<std::size_t>(std::max(waves_, 2)) * sums_size()),
      result_(grid.y_count()) {
  std::fill_n(matrix_.data(), static_cast<std::size_t>(waves_) * blocks_ * sources_ * width_, Real(0));
}

template <class Real>
DenseYConvolution<Real>::DenseYConvolution(const Grid& grid, const Influence& kernel, XSpectra<Real>& spectra)
    : DenseYConvolution(grid, spectra) {
  fill_matrix(grid.row_axis(), kernel, spectra);
}

template <class Real>
DenseYConvolution<Real>::DenseYConvolution(const Grid& grid, const RowInfluence& kernel, XSpectra<Real>& spectra)
    : DenseYConvolution(grid, spectra) {
  fill_matrix(kernel, spectra);
}

template <class Real>
void DenseYConvolution<Real>::fill_matrix(const RowAxis& rows, const Influence& kernel, XSpectra<Real>& spectra) {
  const int distances = 2 * sources_ + 1, own = spectra.own_rows(), begin = y_ranges_[rank_];
  const Real scale = Real(1.0 / spectra.length());
  std::vector<Real> transforms(static_cast<std::size_t>(waves_) * distances);  // [wave number][distance]
  const auto transform = [&](int k, int distance) -> Real& {
    return transforms[static_cast<std::size_t>(k) * distances + distance];
  };
  for (int first = 0; first < distances; first += own) {
    spectra.transform_even([&](int i, int j) { return first + j < distances ? kernel(i, first + j) : 0.0; });
    for (int k = 0; k < waves_; ++k) {
      spectra.separate(k, result_.data());
      for (int j = 0; j < own && first + j < distances; ++j) transform(k, first + j) = scale * result_[j].real();
    }
  }
  for (int k = 0; k < waves_; ++k) {
    for (int l = 0; l < sources_; ++l) {
      for (int j = 0; j < own; ++j) {
        entry(k, l, j) = transform(k, std::abs(begin + j - l));
        if (const auto distance = rows.distance_to_image(begin + j, l)) entry(k, l, j) += transform(k, *distance);
      }
    }
  }
}

template <class Real>
void DenseYConvolution<Real>::fill_matrix(const RowInfluence& kernel, XSpectra<Real>& spectra) {
  const int begin = y_ranges_[rank_];
  const Real scale = Real(1.0 / spectra.length());
  for (int l = 0; l < sources_; ++l) {
    spectra.transform_even([&](int i, int j) { return kernel(i, begin + j, l); });
    for (int k = 0; k < waves_; ++k) {
      spectra.separate(k, result_.data());
      for (int j = 0; j < spectra.own_rows(); ++j) entry(k, l, j) = scale * result_[j].real();
    }
  }
}

template <class Real>
void DenseYConvolution<Real>::add(int k, int process, const Complex* rows, Real* sums) const {
  const int first = y_ranges_[process], count = std::min(rows_of(process), sources_ - first);
  for (int block = 0; block < blocks_; ++block, sums += 2 * width_) {
    const Real* matrix = block_at(k, block) + static_cast<std::size_t>(first) * width_;
    add_rows(width_, matrix, std::array{rows}, count, sums);
  }
}

template <class Real>
void DenseYConvolution<Real>::store(const Real* sums, int columns, Complex* rows) const {
  const int count = static_cast<int>(result_.size());
  for (int first = 0; first < count; first += width_, sums += 2 * columns * width_) {
    for (int j = 0; j < std::min(width_, count - first); ++j) rows[first + j] = {sums[j], sums[width_ + j]};
  }
}

template <class Real>
void DenseYConvolution<Real>::apply_alone(XSpectra<Real>& spectra) {
  for (int k = 0; k < waves_; ++k) {
    spectra.separate(k, result_.data());
    multiply<1>(k, {result_.data()});
    spectra.combine(k, result_.data());
  }
}

template <class Real>
template <std::size_t several>
void DenseYConvolution<Real>::multiply(int k, const std::array<Complex*, several>& rows) {
  std::array<const Complex*, several> sources{};
  std::ranges::copy(rows, sources.begin());
  std::fill_n(sums_.data(), several * sums_size(), Real(0));
  Real* sums = sums_.data();
  for (int block = 0; block < blocks_; ++block, sums += 2 * several * width_) {
    add_rows(width_, block_at(k, block), sources, sources_, sums);
  }
  for (std::size_t n = 0; n < several; ++n) store(sums_.data() + 2 * n * width_, several, rows[n]);
}

template <class Real>
void DenseYConvolution<Real>::apply(FieldPairSpectra<Real>& spectra) {
  for (int k = 0; k < waves_; ++k) {
    const int mirrored = (spectra.length() - k) % spectra.length();
    if (mirrored == k) {
      multiply<1>(k, {spectra.rows(k)});
    } else {
      multiply<2>(k, {spectra.rows(k), spectra.rows(mirrored)});
    }
  }
}

template <class Real>
void DenseYConvolution<Real>::apply(XSpectra<Real>& spectra) {
  if (processes() == 1) return apply_alone(spectra);
  received_.clear();
  sent_.clear();
  const auto numbers = [&](int piece, int process) {
    return 2 * (first_wave(piece + 1) - first_wave(piece)) * rows_of(process);
  };
  const auto with_others = [&](auto work) {
    for (int p = 0; p < processes(); ++p) {
      if (p != rank_) work(p);
    }
  };
  for (int piece = 0; piece < pieces_; ++piece) {
    with_others([&](int p) {
      MPI_Irecv(spectrum(p, first_wave(piece)), numbers(piece, p), mpi_type<Real>(), p, tag, comm_,
                &received_.emplace_back());
    });
  }
  for (int piece = 0; piece < pieces_; ++piece) {
    for (int k = first_wave(piece); k < first_wave(piece + 1); ++k) spectra.separate(k, spectrum(rank_, k));
    with_others([&](int p) {
      MPI_Isend(spectrum(rank_, first_wave(piece)), numbers(piece, rank_), mpi_type<Real>(), p, tag, comm_,
                &sent_.emplace_back());
    });
  }
  std::fill_n(sums_.data(), static_cast<std::size_t>(waves_) * sums_size(), Real(0));
  for (int k = 0; k < waves_; ++k) add(k, rank_, spectrum(rank_, k), sums_at(k));
  for (int piece = 0; piece < pieces_; ++piece) {
    MPI_Waitall(processes() - 1, received_.data() + piece * (processes() - 1), MPI_STATUSES_IGNORE);
    for (int k = first_wave(piece); k < first_wave(piece + 1); ++k) {
      with_others([&](int p) { add(k, p, spectrum(p, k), sums_at(k)); });
      store(sums_at(k), 1, result_.data());
      spectra.combine(k, result_.data());
    }
  }
  MPI_Waitall(static_cast<int>(sent_.size()), sent_.data(), MPI_STATUSES_IGNORE);
}

template class DenseYConvolution<float>;
template class DenseYConvolution<double>;

}  // namespace gearfilm
