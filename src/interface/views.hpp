// What the public classes see of results and of films; they print nothing.
#pragma once

#include <hdf5.h>

#include <memory>
#include <utility>

#include "film/contact_film.hpp"
#include "gearfilm/results.hpp"
#include "output/summary.hpp"
#include "parallel/petsc.hpp"

namespace gearfilm {

struct Results::Content {
  Summary summary = Summary::object();
};

struct Film::View {
  std::shared_ptr<const ContactFilm> film;  ///< owned with what it is part of, or borrowed
};

inline Film film_of(std::shared_ptr<const ContactFilm> film) {
  return Film(std::make_shared<const Film::View>(Film::View{std::move(film)}));
}

/// While it lives errors of PETSc and HDF5 are exceptions alone; neither prints.
class QuietErrors {
public:
  QuietErrors() {
    (void)H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    (void)H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    petsc_check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
  }
  ~QuietErrors() {
    (void)PetscPopErrorHandler();
    (void)H5Eset_auto2(H5E_DEFAULT, print_, data_);
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

}  // namespace gearfilm
