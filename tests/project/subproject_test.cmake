# A project that takes one library of mesopix by its sources (FetchContent), while nothing can be found that only the other
# library or the program needs. With -DBUILD=ON it is built too, which takes minutes.
# Needs: MESOPIX_DIR, SOURCE_DIR (of the consumer), WORK_DIR, COMPILER
file(REMOVE_RECURSE ${WORK_DIR})
set(only_specimen_needs PNG JPEG TIFF OpenCVParts)
set(only_mpm_needs Eigen3)
set(only_program_needs Boost CLI11 fmt nlohmann_json tomlplusplus ZLIB GTest pybind11)

function(use library)
  set(without ${ARGN} ${only_program_needs})
  if(library STREQUAL specimen)  # FindPNG looks for it
    list(REMOVE_ITEM without ZLIB)
  endif()
  list(TRANSFORM without REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON")
  set(folder ${WORK_DIR}/${library})
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${folder} -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_BUILD_TYPE=Release -DCOMPONENTS=${library} -DMESOPIX_SOURCE_DIR=${MESOPIX_DIR} ${without}
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${folder} --prefix ${folder}/prefix COMMAND_ERROR_IS_FATAL ANY)
  if(EXISTS ${folder}/prefix)
    message(FATAL_ERROR "${library}: what is installed of the project that uses it holds mesopix too")
  endif()
  if(BUILD)
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder} --target use_${library} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${folder}/use_${library} WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)
  endif()
endfunction()

use(specimen ${only_mpm_needs})
use(mpm ${only_specimen_needs})
