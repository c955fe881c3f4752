# OpenCV's core and imgproc alone. (Debian's packages of single modules bring no OpenCVConfig.cmake.)
# Imported targets: opencv::core, opencv::imgproc
find_path(OPENCV_INCLUDE_DIR opencv2/imgproc.hpp PATH_SUFFIXES opencv4)
find_library(OPENCV_CORE_LIBRARY opencv_core)
find_library(OPENCV_IMGPROC_LIBRARY opencv_imgproc)
mark_as_advanced(OPENCV_INCLUDE_DIR OPENCV_CORE_LIBRARY OPENCV_IMGPROC_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCVParts
  REQUIRED_VARS OPENCV_CORE_LIBRARY OPENCV_IMGPROC_LIBRARY OPENCV_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "Debian: apt-get install libopencv-core-dev libopencv-imgproc-dev")

if(OpenCVParts_FOUND AND NOT TARGET opencv::core)
  add_library(opencv::core UNKNOWN IMPORTED)
  set_target_properties(opencv::core PROPERTIES IMPORTED_LOCATION ${OPENCV_CORE_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OPENCV_INCLUDE_DIR})
  add_library(opencv::imgproc UNKNOWN IMPORTED)
  set_target_properties(opencv::imgproc PROPERTIES IMPORTED_LOCATION ${OPENCV_IMGPROC_LIBRARY}
    INTERFACE_LINK_LIBRARIES opencv::core)
endif()
