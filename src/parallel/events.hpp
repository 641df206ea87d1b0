// The names under which -log_view reports the kernels of the film solver.
#pragma once

#include "parallel/petsc.hpp"

namespace gearfilm {

enum class Kernel {
  deformation,      ///< convolution of the pressure with the elastic half-space
  film_properties,  ///< density, viscosity and conductance of every node
  residual,         ///< Reynolds residual with cavitation
  linearise,        ///< stencil of the Jacobian
  jacobian_apply,   ///< Jacobian times vector, its convolution included
  smoother_factor,  ///< banded factors of all lines
  smoother_sweep,   ///< one distributive line relaxation
  transfer,         ///< restriction and prolongation
  count
};

/// Registers classes, events and stages with PETSc; once, after PetscInitialize.
void register_events();

/// Times a scope as one event.
class ScopedEvent {
public:
  explicit ScopedEvent(Kernel kernel);
  ~ScopedEvent();
  ScopedEvent(const ScopedEvent&) = delete;
  ScopedEvent& operator=(const ScopedEvent&) = delete;

private:
  PetscLogEvent event_;
};

/// Times a scope as a named stage of the run; stages of one name are one row of -log_view.
class ScopedStage {
public:
  explicit ScopedStage(const char* name);
  ~ScopedStage();
  ScopedStage(const ScopedStage&) = delete;
  ScopedStage& operator=(const ScopedStage&) = delete;
};

}  // namespace gearfilm
