# Packages of one commit are the same to the last bit: every file in them is as old as the commit. cpack reads this first.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND git -C ${CPACK_MESOPIX_SOURCE_DIR} log -1 --format=%ct
    OUTPUT_VARIABLE commit_date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(commit_date)
    set(ENV{SOURCE_DATE_EPOCH} ${commit_date})
  endif()
endif()
