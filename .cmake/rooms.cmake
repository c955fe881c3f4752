# Rooms: a folder is a room, and a library whose headers are included by the path of the folder. Which room may include
# which is held by tests/project/layering_test.py.

# All files of a room are compiled as one, in a fraction of the time. MESOPIX_TOGETHER=OFF compiles each alone, as the
# step tidy of ./check reads them; who works on one file for long builds sooner so.
option(MESOPIX_TOGETHER "Compile the files of a room as one" ON)

# compile_together(TARGET [APART FILE...]): files that others cannot be seen with stay alone.
function(compile_together target)
  cmake_parse_arguments(PARSE_ARGV 1 together "" "" "APART")
  if(MESOPIX_TOGETHER)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    set_source_files_properties(${together_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# add_library_room(LIBRARY FOLDER [LINK TARGET...] SOURCES FILE...): a room of a library that is installed. Its objects are
# added to the variable objects; the room itself is a target that is never installed.
function(add_library_room library folder)
  cmake_parse_arguments(PARSE_ARGV 2 room "" "" "LINK;SOURCES")
  list(TRANSFORM room_SOURCES PREPEND ${folder}/)
  string(REPLACE / _ room ${library}_${folder})
  add_library(${room} OBJECT ${room_SOURCES})
  target_include_directories(${room} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${room} PRIVATE ${room_LINK} mesopix_options)
  compile_together(${room})
  set(objects ${objects} $<TARGET_OBJECTS:${room}> PARENT_SCOPE)
endfunction()

# add_room(FOLDER [LINK TARGET...] [APART FILE...] SOURCES FILE...): a room of the program, with the rooms that it includes.
function(add_room folder)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "" "LINK;APART;SOURCES")
  foreach(list SOURCES APART)
    foreach(file IN LISTS room_${list})
      cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/${folder})
      list(APPEND ${list} ${file})
    endforeach()
  endforeach()
  add_library(mesopix_${folder} STATIC ${SOURCES})
  target_include_directories(mesopix_${folder} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_options(mesopix_${folder} PRIVATE ${MESOPIX_HASTY})
  target_link_libraries(mesopix_${folder} PUBLIC mesopix::specimen mesopix::mpm ${room_LINK}
    PRIVATE fmt::fmt nlohmann_json::nlohmann_json mesopix_options)
  compile_together(mesopix_${folder} APART ${APART})
  share_headers(mesopix_${folder})
endfunction()

# What nearly every room of the program includes is compiled once, with the first of them.
function(share_headers target)
  if(NOT MESOPIX_TOGETHER)
    return()
  endif()
  get_property(first GLOBAL PROPERTY MESOPIX_ROOM_WITH_HEADERS)
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    set_property(GLOBAL PROPERTY MESOPIX_ROOM_WITH_HEADERS ${target})
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map>
      <memory> <optional> <set> <sstream> <string> <variant> <vector> <Eigen/Core> <fmt/format.h> <nlohmann/json.hpp>)
  endif()
endfunction()
