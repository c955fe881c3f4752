# cmake --install: the program, both libraries with their headers, and the CMake package "mesopix".
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/mesopix)

if(BUILD_SHARED_LIBS)  # the installed program finds its libraries wherever the folder is moved
  file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(mesopix PROPERTIES INSTALL_RPATH "$ORIGIN/${to_libraries}")
  set_target_properties(specimen mpm PROPERTIES VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "$ORIGIN")
endif()

install(TARGETS mesopix RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(component specimen mpm)
  install(TARGETS ${component} EXPORT mesopix-${component}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mesopix)
  install(EXPORT mesopix-${component}-targets NAMESPACE mesopix:: DESTINATION ${package_dir})
endforeach()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/mesopixConfig.cmake.in
  ${PROJECT_BINARY_DIR}/mesopixConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mesopixConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/mesopixConfig.cmake ${PROJECT_BINARY_DIR}/mesopixConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindHDF5C.cmake ${CMAKE_CURRENT_LIST_DIR}/FindOpenCVParts.cmake DESTINATION ${package_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(TARGET manual)  # optional: who builds the target mesopix alone may install without a manual
  set(manual ${PROJECT_BINARY_DIR}/manual)
  foreach(section 1 5)
    install(DIRECTORY ${manual}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section} COMPONENT program OPTIONAL
      FILES_MATCHING PATTERN "*.${section}")
  endforeach()
  install(FILES ${manual}/completions/mesopix.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME mesopix COMPONENT program OPTIONAL)
  install(FILES ${manual}/completions/_mesopix DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
    COMPONENT program OPTIONAL)
  install(FILES ${manual}/completions/mesopix.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
    COMPONENT program OPTIONAL)
endif()
