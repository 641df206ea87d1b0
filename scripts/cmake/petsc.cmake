# What gearfilm needs of PETSc's own configuration: real numbers in double precision.
include(CheckSymbolExists)
set(CMAKE_REQUIRED_INCLUDES ${PETSC_INCLUDE_DIRS})
foreach(symbol PETSC_USE_COMPLEX PETSC_USE_REAL_DOUBLE)
  unset(${symbol} CACHE)  # another PETSc may have come since
  check_symbol_exists(${symbol} petscconf.h ${symbol})
endforeach()
unset(CMAKE_REQUIRED_INCLUDES)

if(PETSC_USE_COMPLEX)
  set(wrong "is built for complex numbers; give one for real numbers")
elseif(NOT PETSC_USE_REAL_DOUBLE)
  set(wrong "is not built for double precision; give one that is")
endif()
if(wrong)
  message(FATAL_ERROR "The PETSc in ${PETSC_PREFIX} ${wrong}: -DCMAKE_PREFIX_PATH=..., or PKG_CONFIG_PATH in the "
                      "environment (Debian: petsc-dev, not petsc64-dev or the complex ones).")
endif()
