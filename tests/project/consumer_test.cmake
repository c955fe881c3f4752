# Installs each library of the built tree alone, and builds and runs a project that knows nothing but that prefix, while
# nothing can be found that only the other library needs. Then both together, and what is said of mistakes.
# Needs: BUILD_DIR (of mesopix), SHARED (whether its libraries are), SOURCE_DIR (of the consumer), WORK_DIR, COMPILER,
# BUILD_TYPE
file(REMOVE_RECURSE ${WORK_DIR})
set(ENV{DESTDIR})
set(only_specimen_needs PNG JPEG TIFF OpenCVParts)  # none of which the other may look for
set(only_mpm_needs Eigen3)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(install prefix)
  foreach(component IN LISTS ARGN)
    run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/${prefix} --component ${component})
  endforeach()
endfunction()

# configure(folder prefix components result [option...]) sets result to the exit status and output to what was said.
function(configure folder prefix components result)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/${folder} -G Ninja
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_PREFIX_PATH=${WORK_DIR}/${prefix}
    -DCMAKE_FIND_PACKAGE_NO_PACKAGE_REGISTRY=ON "-DCOMPONENTS=${components}" ${ARGN}
    RESULT_VARIABLE met OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  set(${result} ${met} PARENT_SCOPE)
  set(output "${said}" PARENT_SCOPE)
endfunction()

function(expect_use folder prefix components libraries)
  configure(${folder} ${prefix} "${components}" result ${ARGN})
  if(NOT result EQUAL 0 OR NOT output MATCHES "Libraries: ${libraries}")
    message(FATAL_ERROR "'${components}' of ${prefix}, with ${ARGN}: not '${libraries}' alone, but: ${output}")
  endif()
endfunction()

function(expect_refusal prefix components text)
  configure(refused ${prefix} "${components}" result ${ARGN})
  if(result EQUAL 0 OR NOT output MATCHES "${text}")
    message(FATAL_ERROR "'${components}' of ${prefix}, with ${ARGN}: no word of '${text}' in: ${output}")
  endif()
  file(REMOVE_RECURSE ${WORK_DIR}/refused)
endfunction()

function(build_and_run folder program)
  run(${CMAKE_COMMAND} --build ${WORK_DIR}/${folder} --target ${program})
  execute_process(COMMAND ${WORK_DIR}/${folder}/${program} WORKING_DIRECTORY ${WORK_DIR} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(expect_no_file prefix pattern)
  file(GLOB_RECURSE files RELATIVE ${WORK_DIR}/${prefix} ${WORK_DIR}/${prefix}/*)
  list(LENGTH files count)
  list(FILTER files INCLUDE REGEX "${pattern}")
  if(files OR count LESS 8)
    message(FATAL_ERROR "${prefix}: of ${count} files these are of the other library: ${files}")
  endif()
endfunction()

# Each library alone.
install(specimen common specimen specimen_runtime)  # which is empty where the library is not shared
install(mpm common mpm mpm_runtime)
expect_no_file(specimen "mpm")
expect_no_file(mpm "specimen|OpenCV")
list(TRANSFORM only_mpm_needs REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON" OUTPUT_VARIABLE no_mpm)
list(TRANSFORM only_specimen_needs REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON" OUTPUT_VARIABLE no_specimen)
expect_use(use_specimen specimen specimen "mesopix::specimen " ${no_mpm})
expect_use(use_mpm mpm mpm "mesopix::mpm " ${no_specimen})
expect_use(use_those_that_are_there mpm "" "mesopix::mpm " ${no_specimen})
build_and_run(use_specimen use_specimen)
build_and_run(use_mpm use_mpm)

# What is said of mistakes.
expect_refusal(specimen fracture "there is no component 'fracture'; there are: specimen, mpm")
expect_refusal(specimen "specimen;mpm" "the component 'mpm' is not installed in .*libmesopix-mpm-dev")
if(NOT SHARED)
  expect_refusal(specimen specimen "the component 'specimen' needs TIFF, which was not found"
    -DCMAKE_DISABLE_FIND_PACKAGE_TIFF=ON)
endif()
expect_refusal(mpm mpm "the component 'mpm' needs Eigen3, which was not found" -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)

# All that is installed.
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/all)
expect_use(use_all all "specimen;mpm" "mesopix::specimen;mesopix::mpm ")
build_and_run(use_all use_both)
run(${WORK_DIR}/all/bin/mesopix --version)
