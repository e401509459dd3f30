# SPDX-License-Identifier: Apache-2.0
# Finds a Qwt that links Qt 6 and defines Qwt::Qwt.
#   QWT_ROOT (variable or environment): prefix that scripts/setup built, or one's own.
# Otherwise pkg-config's Qt6Qwt6, libqwt-qt6 or libqwt; a Qwt that links Qt 5 is refused.
if(NOT QWT_ROOT AND DEFINED ENV{QWT_ROOT})
  set(QWT_ROOT $ENV{QWT_ROOT})
endif()
if(NOT QWT_ROOT)
  if(DEFINED ENV{XDG_CACHE_HOME})
    set(_qwt_cache $ENV{XDG_CACHE_HOME})
  else()
    set(_qwt_cache $ENV{HOME}/.cache)
  endif()
  if(EXISTS ${_qwt_cache}/syncline/qwt/include/qwt.h)
    set(QWT_ROOT ${_qwt_cache}/syncline/qwt)
  endif()
endif()

if(QWT_ROOT)
  find_path(Qwt_INCLUDE_DIR qwt_plot.h PATHS ${QWT_ROOT}/include PATH_SUFFIXES qwt NO_DEFAULT_PATH)
  find_library(Qwt_LIBRARY NAMES qwt qwt-qt6 PATHS ${QWT_ROOT}/lib NO_DEFAULT_PATH)
else()
  find_package(PkgConfig QUIET)
  foreach(_name Qt6Qwt6 libqwt-qt6 libqwt)
    if(NOT Qwt_LIBRARY)
      pkg_check_modules(_QWT QUIET ${_name})
      if(_QWT_FOUND AND NOT "${_QWT_LINK_LIBRARIES};${_QWT_INCLUDE_DIRS}" MATCHES "[Qq]t5")
        find_path(Qwt_INCLUDE_DIR qwt_plot.h PATHS ${_QWT_INCLUDE_DIRS} NO_DEFAULT_PATH)
        find_library(Qwt_LIBRARY NAMES ${_QWT_LIBRARIES} PATHS ${_QWT_LIBRARY_DIRS} /usr/lib /usr/lib64)
      endif()
    endif()
  endforeach()
endif()

if(Qwt_INCLUDE_DIR AND EXISTS ${Qwt_INCLUDE_DIR}/qwt_global.h)
  file(STRINGS ${Qwt_INCLUDE_DIR}/qwt_global.h _line REGEX "QWT_VERSION_STR")
  string(REGEX REPLACE ".*\"(.*)\".*" "\\1" Qwt_VERSION "${_line}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Qwt REQUIRED_VARS Qwt_LIBRARY Qwt_INCLUDE_DIR VERSION_VAR Qwt_VERSION
  REASON_FAILURE_MESSAGE "No Qwt for Qt 6 found: run scripts/setup or set QWT_ROOT.")
if(Qwt_FOUND AND NOT TARGET Qwt::Qwt)
  add_library(Qwt::Qwt UNKNOWN IMPORTED)
  set_target_properties(Qwt::Qwt PROPERTIES
    IMPORTED_LOCATION ${Qwt_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${Qwt_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "Qt6::Widgets;Qt6::Svg")
endif()
