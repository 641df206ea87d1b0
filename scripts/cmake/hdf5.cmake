# A parallel HDF5, as the target HDF5::parallel: Debian's own for Open MPI, or whatever find_package finds, first beside
# PETSc. Where PETSc has one it must be the same: a program cannot have two. GEARFILM_HDF5_LIBRARIES: its files, for
# programs that link the installed library.
pkg_check_modules(HDF5_OPENMPI QUIET IMPORTED_TARGET hdf5-openmpi)
add_library(HDF5::parallel INTERFACE IMPORTED)
if(HDF5_OPENMPI_FOUND AND NOT HDF5_ROOT)
  find_library(HDF5_HL_LIBRARY hdf5_hl HINTS ${HDF5_OPENMPI_LIBRARY_DIRS} NO_DEFAULT_PATH REQUIRED)  # no .pc names it
  target_link_libraries(HDF5::parallel INTERFACE ${HDF5_HL_LIBRARY} PkgConfig::HDF5_OPENMPI)
  set(GEARFILM_HDF5_LIBRARIES ${HDF5_HL_LIBRARY} ${HDF5_OPENMPI_LINK_LIBRARIES})
else()
  set(HDF5_PREFER_PARALLEL ON)
  list(APPEND CMAKE_PREFIX_PATH ${PETSC_PREFIX})
  find_package(HDF5 COMPONENTS C HL)
  if(NOT HDF5_FOUND)
    message(FATAL_ERROR "No HDF5 found; give the one that PETSc uses, or another one built with MPI, with -DHDF5_ROOT=...")
  endif()
  if(NOT HDF5_IS_PARALLEL)
    message(FATAL_ERROR "The HDF5 ${HDF5_VERSION} in ${HDF5_INCLUDE_DIRS} is not parallel; give the one that PETSc uses, or "
                        "another one built with MPI, with -DHDF5_ROOT=...")
  endif()
  target_include_directories(HDF5::parallel INTERFACE ${HDF5_C_INCLUDE_DIRS})
  target_link_libraries(HDF5::parallel INTERFACE ${HDF5_C_HL_LIBRARIES} ${HDF5_C_LIBRARIES})
  target_compile_definitions(HDF5::parallel INTERFACE ${HDF5_C_DEFINITIONS})
  set(GEARFILM_HDF5_LIBRARIES ${HDF5_C_HL_LIBRARIES} ${HDF5_C_LIBRARIES})
endif()
