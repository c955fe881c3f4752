# What Debian wants in every package: copyright and changelogs, compressed texts, static libraries without what debuggers
# read. cpack runs this when the files of all components lie in a folder each.
cmake_policy(VERSION 3.25)
set(source ${CPACK_MESOPIX_SOURCE_DIR})
set(readable PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The licence as machines read it, https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
function(write_copyright file)
  file(READ ${source}/LICENSE license)
  string(REGEX MATCH "Copyright \\(c\\) ([^\n]+)\n+(.*)" found "${license}")
  set(holder ${CMAKE_MATCH_1})
  string(STRIP "${CMAKE_MATCH_2}" terms)
  string(REPLACE "\n\n" "\n.\n" terms "${terms}")
  string(REPLACE "\n" "\n " terms "${terms}")
  file(WRITE ${file} "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: mesopix

Files: *
Copyright: ${holder}
License: Expat
 ${terms}
")
endfunction()

function(write_changelogs folder)
  file(COPY_FILE ${source}/CHANGELOG.md ${folder}/changelog)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
  file(WRITE ${folder}/changelog.Debian "mesopix (${version}) unstable; urgency=medium

  * Packages of mesopix ${CPACK_PACKAGE_VERSION}; what is new in it is in changelog.gz.

 -- ${contact}  ${date}
")
  run(gzip -9nf ${folder}/changelog ${folder}/changelog.Debian)
endfunction()

set(contact "${CPACK_PACKAGE_CONTACT}")
if(NOT contact MATCHES "<.*>")  # without which a changelog is none
  string(APPEND contact " <>")
endif()
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr)
  set(papers ${root}/share/doc/${package})
  file(MAKE_DIRECTORY ${papers})
  file(REMOVE ${papers}/LICENSE)
  write_copyright(${papers}/copyright)
  write_changelogs(${papers})
  file(GLOB manuals ${root}/share/man/man*/*.[0-9])
  file(GLOB_RECURSE archives ${root}/lib/*.a)
  if(manuals)
    run(gzip -9nf ${manuals})
  endif()
  if(archives)
    run(strip --strip-debug --enable-deterministic-archives ${archives})
  endif()
  file(MAKE_DIRECTORY ${root}/share/lintian/overrides)
  file(COPY_FILE ${source}/.packaging/debian/lintian-overrides ${root}/share/lintian/overrides/${package})
  file(GLOB_RECURSE files LIST_DIRECTORIES false ${root}/share/*)
  file(CHMOD ${files} ${readable})
  file(GLOB_RECURSE all LIST_DIRECTORIES true ${root}/*)
  foreach(folder IN LISTS all root)
    if(IS_DIRECTORY ${folder})
      file(CHMOD ${folder} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    endif()
  endforeach()
endforeach()
