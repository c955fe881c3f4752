# The target manual: pages and reference in the build folder.
add_executable(mesopix_manual_writer manual/main.cpp)
target_link_libraries(mesopix_manual_writer PRIVATE mesopix_manual mesopix_evidence mesopix_options)

set(manual ${PROJECT_BINARY_DIR}/manual)
set(scene ${PROJECT_SOURCE_DIR}/data/two_aggregates.toml)
add_custom_command(OUTPUT ${manual}/written
  COMMAND mesopix_manual_writer ${manual} ${scene}
  COMMAND ${CMAKE_COMMAND} -E touch ${manual}/written
  DEPENDS mesopix_manual_writer ${scene}
  COMMENT "Writing manual pages and the reference")
add_custom_target(manual ALL DEPENDS ${manual}/written)
