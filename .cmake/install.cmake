# cmake --install: the program, both libraries with their headers, and the CMake package "mesopix". The components are
# program; specimen and mpm, each of use without the other; and common, which both libraries need.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/mesopix)

# What a project must find that is linked with a library: all that a static one uses, of a shared one what its headers
# include.
if(BUILD_SHARED_LIBS)
  set(specimen_needs)
  set(mpm_needs Eigen3)
else()
  set(specimen_needs HDF5C OpenSSL PNG JPEG TIFF OpenCVParts Threads)
  set(mpm_needs Eigen3 HDF5C OpenSSL Threads)
endif()

if(MESOPIX_PROGRAM)
  install(TARGETS mesopix RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  install(DIRECTORY data/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT program
    PATTERN __pycache__ EXCLUDE)
  install(FILES LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
  set(completions apps/command/completions)
  install(FILES ${completions}/mesopix.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME mesopix COMPONENT program)
  install(FILES ${completions}/_mesopix DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
  install(FILES ${completions}/mesopix.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
    COMPONENT program)
endif()

# Shared libraries are found wherever the folder is moved; under /usr they are found as all others there.
set(rpath_of_libraries "")
if(BUILD_SHARED_LIBS AND NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set(rpath_of_libraries "$ORIGIN")
  if(MESOPIX_PROGRAM)
    set_target_properties(mesopix PROPERTIES INSTALL_RPATH "$ORIGIN/${to_libraries}")
  endif()
endif()

# What runs needs of a shared library is a component of its own, specimen_runtime or mpm_runtime.
function(install_library component)
  set_target_properties(${component} PROPERTIES VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "${rpath_of_libraries}")
  install(TARGETS ${component} EXPORT mesopix-${component}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component}_runtime NAMELINK_COMPONENT ${component}
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mesopix COMPONENT ${component})
  install(EXPORT mesopix-${component}-targets NAMESPACE mesopix:: DESTINATION ${package_dir} COMPONENT ${component})
endfunction()
if(MESOPIX_SPECIMEN)
  install_library(specimen)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/FindOpenCVParts.cmake DESTINATION ${package_dir} COMPONENT specimen)
endif()
if(MESOPIX_MPM)
  install_library(mpm)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/mesopixConfig.cmake.in
  ${PROJECT_BINARY_DIR}/mesopixConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mesopixConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/mesopixConfig.cmake ${PROJECT_BINARY_DIR}/mesopixConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindHDF5C.cmake DESTINATION ${package_dir} COMPONENT common)

# The Python package where Debian's own python3 looks; pip and other systems take the component wheel.
if(MESOPIX_PROGRAM AND MESOPIX_PYTHON)
  set(python_dir lib/python3/dist-packages/mesopix)
  install(TARGETS mesopix_python LIBRARY DESTINATION ${python_dir} COMPONENT python EXCLUDE_FROM_ALL)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/python/mesopix/ DESTINATION ${python_dir} COMPONENT python EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed PATTERN __pycache__ EXCLUDE)
endif()

if(TARGET manual)  # optional: who builds the target mesopix alone may install without a manual
  set(manual ${PROJECT_BINARY_DIR}/manual)
  foreach(section 1 5)
    install(DIRECTORY ${manual}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section} COMPONENT program OPTIONAL
      FILES_MATCHING PATTERN "*.${section}")
  endforeach()
endif()
