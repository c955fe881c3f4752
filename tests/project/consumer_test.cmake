# Installs the built tree under a prefix, and builds and runs a project that knows nothing but that prefix.
# Needs: BUILD_DIR (of mesopix), SOURCE_DIR (of the consumer), WORK_DIR, COMPILER, BUILD_TYPE
file(REMOVE_RECURSE ${WORK_DIR})
set(ENV{DESTDIR})
foreach(step
    "--install;${BUILD_DIR};--prefix;${WORK_DIR}/prefix"
    "-S;${SOURCE_DIR};-B;${WORK_DIR}/build;-G;Ninja;-DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix;-DCMAKE_CXX_COMPILER=${COMPILER};-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
    "--build;${WORK_DIR}/build")
  execute_process(COMMAND ${CMAKE_COMMAND} ${step} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${WORK_DIR}/build/consumer WORKING_DIRECTORY ${WORK_DIR} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK_DIR}/prefix/bin/mesopix --version COMMAND_ERROR_IS_FATAL ANY)
