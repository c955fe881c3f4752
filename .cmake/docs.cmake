# The pages of docs/ and the reference as a site to read without a network:
#   cmake --build build/release --target docs     makes build/release/docs/site/index.html
find_program(MESOPIX_MKDOCS_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH
  DOC "Python that has mkdocs: on Debian the one of the system")
if(MESOPIX_MKDOCS_PYTHON)
  add_custom_target(docs
    COMMAND ${MESOPIX_MKDOCS_PYTHON} ${PROJECT_SOURCE_DIR}/docs/site/build.py ${PROJECT_BINARY_DIR}/manual/reference
      ${PROJECT_BINARY_DIR}/docs
    COMMENT "Building the site of the documentation" VERBATIM)
  if(TARGET manual)
    add_dependencies(docs manual)
  endif()
endif()
