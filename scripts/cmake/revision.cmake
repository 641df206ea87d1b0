# Writes version.hpp where it has changed: the version and, in a checkout, the revision, with a mark for changes that are
# not committed.   cmake -DGIT= -DSOURCE= -DVERSION= -DHEADER= -P revision.cmake
set(GEARFILM_VERSION_TEXT ${VERSION})
if(GIT AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty --exclude=* OUTPUT_VARIABLE revision
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(revision)
    string(APPEND GEARFILM_VERSION_TEXT "+${revision}")
  endif()
endif()
configure_file(${SOURCE}/include/gearfilm/version.hpp.in ${HEADER} @ONLY)
