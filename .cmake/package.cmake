# cpack -G DEB: Debian packages, one a component, in the build folder. The preset "debian" builds what belongs there.
set(CPACK_PACKAGE_NAME mesopix)
set(CPACK_PACKAGE_VENDOR "The mesopix authors")
set(CPACK_PACKAGE_CONTACT "The mesopix authors" CACHE STRING "Who passes the packages on: name and <address>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE mesopix)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/specimen ${PROJECT_BINARY_DIR}/libmpm)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ${BUILD_SHARED_LIBS})
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/package_date.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian_papers.cmake)
set(CPACK_MESOPIX_SOURCE_DIR ${PROJECT_SOURCE_DIR})

# What Debian calls the packages that hold what find_package(NAME) finds.
set(debian_HDF5C libhdf5-dev)
set(debian_OpenSSL libssl-dev)
set(debian_PNG libpng-dev)
set(debian_JPEG libjpeg-dev)
set(debian_TIFF libtiff-dev)
set(debian_OpenCVParts libopencv-core-dev libopencv-imgproc-dev)
set(debian_Eigen3 libeigen3-dev)
set(debian_Threads libc6-dev)

# debian_package(component name section description [KEY text]...): KEY as in CPACK_DEBIAN_<COMPONENT>_PACKAGE_KEY.
macro(debian_package component name section description)
  string(TOUPPER ${component} upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
  set(more ${ARGN})
  while(more)
    list(POP_FRONT more key text)
    set(CPACK_DEBIAN_${upper}_PACKAGE_${key} "${text}")
  endwhile()
endmacro()

set(same_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

# The package of a library: to build with, and if it is shared, to run with.
macro(debian_library component summary text)
  set(depends "libmesopix-common-dev ${same_version}")
  if(BUILD_SHARED_LIBS)
    set(runtime libmesopix-${component}${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    debian_package(${component}_runtime ${runtime} libs "${summary}\n${text}" SHLIBDEPS ON
      CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/.packaging/debian/triggers)
    string(APPEND depends ", ${runtime} ${same_version}")
    list(APPEND runtime_packages "${runtime} ${same_version}")
  endif()
  foreach(need IN LISTS ${component}_needs)
    foreach(package IN LISTS debian_${need})
      string(APPEND depends ", ${package}")
    endforeach()
  endforeach()
  debian_package(${component} libmesopix-${component}-dev libdevel "${summary} (development files)\n${text}\n\
The CMake package is mesopix, with the component ${component}." DEPENDS "${depends}" SUGGESTS cmake)
endmacro()

set(CPACK_COMPONENTS_ALL)
set(runtime_packages)
if(MESOPIX_SPECIMEN)
  debian_library(specimen "labelled specimens of concrete from pictures"
    "A C++20 library that makes a mask of aggregate, mortar, voids and interfacial\n\
transition zone out of a picture or a random packing of ellipses.")
endif()
if(MESOPIX_MPM)
  debian_library(mpm "material points that break, on a background grid"
    "A C++20 library that breaks heterogeneous specimens of concrete with an\n\
explicit material point method and Weibull-distributed strengths.")
endif()
debian_package(common libmesopix-common-dev libdevel "what the libraries of mesopix share as a CMake package\n\
What find_package(mesopix) reads first. The libraries are in the packages\n\
libmesopix-specimen-dev and libmesopix-mpm-dev.")
set(from_picture_to_break "\
Turns a picture, a label map or a random packing of ellipses into a specimen\n\
of aggregate, mortar, voids and interfacial transition zone, one material\n\
point a pixel, and breaks it in tension or compression with an explicit\n\
material point method and Weibull-distributed strengths.")
list(JOIN runtime_packages ", " runtime_packages)
if(MESOPIX_PROGRAM)
  set(depends fonts-dejavu-core ${runtime_packages})  # for the charts and pictures
  list(JOIN depends ", " depends)
  debian_package(program mesopix science "from a picture of concrete to a broken specimen\n${from_picture_to_break}\n\
A run leaves a folder with the stress-strain curve, pictures of the damage, all\n\
numbers, and a report to open in a browser." SHLIBDEPS ON DEPENDS "${depends}")
endif()
if(MESOPIX_PROGRAM AND MESOPIX_PYTHON)
  get_target_property(suffix mesopix_python SUFFIX)  # what is compiled is for one version of Python
  string(REGEX MATCH "cpython-3([0-9]+)" found "${suffix}")
  set(python ${CMAKE_MATCH_1})
  math(EXPR next_python "${python} + 1")
  set(depends "python3 (>= 3.${python}~)" "python3 (<< 3.${next_python})" python3-numpy fonts-dejavu-core ${runtime_packages})
  list(JOIN depends ", " depends)
  debian_package(python python3-mesopix python "from a picture of concrete to a broken specimen (Python)\n\
${from_picture_to_break}\nThis is the Python package: settings of the program, pictures and results as\n\
NumPy arrays." SHLIBDEPS ON DEPENDS "${depends}" RECOMMENDS python3-matplotlib)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/.packaging/debian/postinst
    ${PROJECT_SOURCE_DIR}/.packaging/debian/prerm)
endif()

include(CPack)
