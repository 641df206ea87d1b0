# What is installed: the program with its manual page and completion, and the library with what finds it
# (docs/examples/README.md).
include(CMakePackageConfigHelpers)
set(GEARFILM_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/gearfilm)

# The interface of the library: the headers in include. None of them includes one that lies beside its sources.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/gearfilm DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT headers FILES_MATCHING PATTERN *.hpp)

# One archive of all rooms but those of the program itself; how they are built is no concern of those who link it.
set(objects "")
foreach(room gear lubricant roughness algebra contact train parallel numerics grid elasticity stress fatigue rating film solver traction mesh
             dynamics orbits input output results interface)
  list(APPEND objects $<TARGET_OBJECTS:gearfilm_${room}>)
endforeach()
add_library(gearfilm_library STATIC ${objects})
set_target_properties(gearfilm_library PROPERTIES OUTPUT_NAME gearfilm EXPORT_NAME gearfilm LINKER_LANGUAGE CXX)
target_include_directories(gearfilm_library INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(gearfilm_library INTERFACE cxx_std_20)
target_compile_definitions(gearfilm_library INTERFACE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
target_link_libraries(gearfilm_library INTERFACE PkgConfig::SLEPC PkgConfig::PETSC MPI::MPI_C PkgConfig::FFTW
                                                 PkgConfig::FFTWF ${GEARFILM_YAML_CPP} ${GEARFILM_HDF5_LIBRARIES}
                                                 Threads::Threads)
install(TARGETS gearfilm_library EXPORT gearfilm ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT gearfilm NAMESPACE gearfilm:: FILE gearfilmTargets.cmake DESTINATION ${GEARFILM_CMAKE_DIR})

configure_package_config_file(${PROJECT_SOURCE_DIR}/scripts/cmake/gearfilmConfig.cmake.in
  ${PROJECT_BINARY_DIR}/gearfilmConfig.cmake INSTALL_DESTINATION ${GEARFILM_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gearfilmConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gearfilmConfig.cmake ${PROJECT_BINARY_DIR}/gearfilmConfigVersion.cmake
        DESTINATION ${GEARFILM_CMAKE_DIR})

# pkg-config finds the folders from where its own file is, so that the prefix may be chosen when installing. It knows no
# MPI, whose flags are written out.
file(RELATIVE_PATH GEARFILM_PC_TO_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" GEARFILM_PC_TO_PREFIX ${GEARFILM_PC_TO_PREFIX})
set(GEARFILM_MPI_CFLAGS ${MPI_C_INCLUDE_DIRS})
list(TRANSFORM GEARFILM_MPI_CFLAGS PREPEND -I)
list(JOIN GEARFILM_MPI_CFLAGS " " GEARFILM_MPI_CFLAGS)
list(JOIN MPI_C_LIBRARIES " " GEARFILM_MPI_LIBS)
list(JOIN GEARFILM_HDF5_LIBRARIES " " GEARFILM_HDF5_LIBS)
configure_file(${PROJECT_SOURCE_DIR}/scripts/cmake/gearfilm.pc.in ${PROJECT_BINARY_DIR}/gearfilm.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/gearfilm.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# The Python package of the results, which draws their figures too.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scripts/gearfilm DESTINATION ${CMAKE_INSTALL_DATADIR}/gearfilm/scripts
        FILES_MATCHING PATTERN "*.py" PATTERN "renamed.py" EXCLUDE PATTERN "__pycache__" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/scripts/pyproject.toml DESTINATION ${CMAKE_INSTALL_DATADIR}/gearfilm/scripts)

# The manual page and the completion are made of what the program says of itself, where it runs: not when built for another
# machine, and not where MPI starts nowhere but in jobs.
if(NOT CMAKE_CROSSCOMPILING)
  install(CODE "
    foreach(text IN ITEMS man completion)
      execute_process(COMMAND python3 -B \"${PROJECT_SOURCE_DIR}/scripts/packaging/manual.py\" \${text} \"$<TARGET_FILE:gearfilm>\"
                      OUTPUT_FILE \"${PROJECT_BINARY_DIR}/gearfilm.\${text}\"
                      ERROR_QUIET RESULT_VARIABLE status TIMEOUT 60)
      if(NOT status EQUAL 0)
        file(REMOVE \"${PROJECT_BINARY_DIR}/gearfilm.\${text}\")
        message(WARNING \"gearfilm or python3 does not run here; its \${text} is not installed\")
      endif()
    endforeach()")
  install(FILES ${PROJECT_BINARY_DIR}/gearfilm.man DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME gearfilm.1 OPTIONAL)
  install(FILES ${PROJECT_BINARY_DIR}/gearfilm.completion
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME gearfilm OPTIONAL)
endif()
