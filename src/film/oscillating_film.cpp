#include "film/oscillating_film.hpp"

#include "film/smoother.hpp"

namespace gearfilm {

struct OscillatingFilm::Work {
  explicit Work(Discretisation& on)
      : deformation(on.prepare_deformation<double>()),
        linear(on.grid()),
        smoother(make_smoother<std::complex<double>>(on.grid(), on.halo(), deformation)),
        change(on.grid()),
        deformed(on.grid()),
        rows(on.grid()),
        part(on.grid()),
        deformed_part(on.grid()) {}

  const Deformation<double>& deformation;
  FilmStencil<std::complex<double>> linear;
  std::unique_ptr<Smoother<std::complex<double>>> smoother;
  Field<std::complex<double>> change, deformed, rows;
  Field<double> part, deformed_part;  ///< real or imaginary
};

namespace {

void load_parts(std::span<const double> parts, Field<std::complex<double>>& values) {
  const double *real = parts.data(), *imaginary = real + parts.size() / 2;
  for (int i = 0; i < values.nx(); ++i) {
    std::complex<double>* line = values.row(i);
    for (int j = 0; j < values.y_count(); ++j) line[j] = {*real++, *imaginary++};
  }
}

void store_parts(const Field<std::complex<double>>& values, std::span<double> parts) {
  double *real = parts.data(), *imaginary = real + parts.size() / 2;
  for (int i = 0; i < values.nx(); ++i) {
    const std::complex<double>* line = values.row(i);
    for (int j = 0; j < values.y_count(); ++j) {
      *real++ = line[j].real();
      *imaginary++ = line[j].imag();
    }
  }
}

}  // namespace

OscillatingFilm::OscillatingFilm(Discretisation& discretisation)
    : discretisation_(discretisation), work_(std::make_unique<Work>(discretisation)) {}

OscillatingFilm::~OscillatingFilm() = default;

void OscillatingFilm::update(const FilmState& state, std::complex<double> s) {
  linearise(discretisation_.equation(), s, state, work_->linear);
  work_->smoother->factor(work_->linear, state, s, SmootherFactors::of_this_state);
}

void OscillatingFilm::multiply(std::span<const double> change, std::span<double> rows) {
  Work& work = *work_;
  const std::size_t size = change.size() / 2;
  load_parts(change, work.change);
  for (const bool imaginary : {false, true}) {
    work.part.load(change.subspan(imaginary ? size : 0, size));
    work.deformation.apply(work.part, work.deformed_part);
    for (int i = 0; i < work.deformed.nx(); ++i) {
      std::complex<double>* whole = work.deformed.row(i);
      const double* part = work.deformed_part.row(i);
      for (int j = 0; j < work.deformed.y_count(); ++j) {
        whole[j] = imaginary ? std::complex<double>(whole[j].real(), part[j]) : std::complex<double>(part[j], 0.0);
      }
    }
  }
  discretisation_.halo().exchange(work.change, work.deformed);
  apply_stencil(work.linear, work.change, work.deformed, work.rows);
  store_parts(work.rows, rows);
}

void OscillatingFilm::displacement_column(std::span<double> column) {
  Work& work = *work_;
  gearfilm::displacement_column(work.linear, work.rows);
  store_parts(work.rows, column);
}

void OscillatingFilm::relax(std::span<const double> rows, std::span<double> change) {
  Work& work = *work_;
  load_parts(rows, work.rows);
  work.change.fill(0.0);
  work.smoother->relax(work.rows, work.change);
  store_parts(work.change, change);
}

}  // namespace gearfilm
