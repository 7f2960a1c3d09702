# Provides SystemC::systemc, in this order:
#   REPOUSSE_SYSTEMC_PREFIX   an installed SystemC (CMake's or autotools' layout)
#   REPOUSSE_SYSTEMC_FIND=ON  an installed SystemC that CMAKE_PREFIX_PATH or the system offers
#   otherwise                 SystemC built from source, once, into a cache (SystemCBuild.cmake)
# Whichever it is, it must have been compiled with our C++ standard: SystemC encodes the standard in
# the symbol sc_api_version_V_cxxS, so a mixture is a link error with a long name. Here it is a
# sentence.
include_guard(GLOBAL)

set(REPOUSSE_SYSTEMC_PREFIX "" CACHE PATH "An installed SystemC to use")
option(REPOUSSE_SYSTEMC_FIND "Use the SystemC that CMAKE_PREFIX_PATH or the system offers" OFF)
option(REPOUSSE_SYSTEMC_ONLY "Get or check SystemC and configure nothing else" OFF)

# What __cplusplus is for the standards that a SystemC can have been compiled with.
function(repousse_standard_name year_month out)
  set(names 199711 98 201103 11 201402 14 201703 17 202002 20 202302 23)
  list(FIND names ${year_month} index)
  set(${out} ${year_month} PARENT_SCOPE)
  if(index GREATER_EQUAL 0)
    math(EXPR index "${index} + 1")
    list(GET names ${index} name)
    set(${out} ${name} PARENT_SCOPE)
  endif()
endfunction()

# Reads version, standard and coroutine kind out of the library's symbols, which no configuration
# file can contradict; refuses another standard, warns of pthreads. LIBRARY is the .a or .so.
# Sets REPOUSSE_SYSTEMC_API, such as "2.3.4 C++17".
function(repousse_check_systemc library)
  file(STRINGS ${library} symbol LIMIT_COUNT 1 REGEX "sc_api_version_[0-9_]+_cxx[0-9]+L")
  if(NOT symbol MATCHES "sc_api_version_([0-9_]+)_cxx([0-9]+)L")
    message(FATAL_ERROR "${library} is no SystemC library: it has no symbol sc_api_version_*. "
                        "Give -DREPOUSSE_SYSTEMC_PREFIX=<an installed SystemC 2.3.4>, or leave it "
                        "away to have SystemC built from source.")
  endif()
  string(REPLACE "_" "." version ${CMAKE_MATCH_1})
  repousse_standard_name(${CMAKE_MATCH_2} standard)
  if(NOT standard STREQUAL CMAKE_CXX_STANDARD)
    message(FATAL_ERROR
      "The SystemC ${version} in ${library} was compiled as C++${standard}, but this build is "
      "C++${CMAKE_CXX_STANDARD}, and the two do not link. Configure with "
      "-DCMAKE_CXX_STANDARD=${standard}, or with -DREPOUSSE_SYSTEMC_PREFIX= naming a SystemC that "
      "was compiled as C++${CMAKE_CXX_STANDARD}, or without PREFIX and FIND to have such a one "
      "built from source.")
  endif()
  file(STRINGS ${library} pthreads LIMIT_COUNT 1 REGEX "sc_cor_pkg_pthread")
  if(pthreads)
    message(WARNING "The SystemC in ${library} switches threads through pthreads, which is about "
                    "100 times slower than QuickThreads (14 us a switch, not 0.05). It works, but "
                    "build it without ENABLE_PTHREADS, or let it be built from source here.")
  endif()
  set(REPOUSSE_SYSTEMC_API "${version} C++${standard}" PARENT_SCOPE)
endfunction()

# find_package() for PREFIX alone; a prefix that autotools filled has no CMake files, so its target
# is made by hand.
macro(repousse_use_systemc_prefix prefix)
  unset(SystemCLanguage_DIR CACHE)  # another prefix may have been used before
  find_package(SystemCLanguage CONFIG QUIET NO_DEFAULT_PATH PATHS ${prefix})
  if(NOT SystemCLanguage_FOUND)
    find_path(systemc_headers systemc PATHS ${prefix}/include NO_DEFAULT_PATH NO_CACHE)
    find_library(systemc_library systemc PATHS ${prefix}
                 PATH_SUFFIXES lib lib64 lib-linux64 lib-linuxaarch64 NO_DEFAULT_PATH NO_CACHE)
    if(NOT systemc_headers OR NOT systemc_library)
      message(FATAL_ERROR "There is no installed SystemC in ${prefix}: neither SystemCLanguage's "
                          "CMake files nor include/systemc with lib*/libsystemc. Name the folder "
                          "that SystemC was installed to, or leave REPOUSSE_SYSTEMC_PREFIX away.")
    endif()
    find_package(Threads REQUIRED)
    add_library(SystemC::systemc UNKNOWN IMPORTED)
    set_target_properties(SystemC::systemc PROPERTIES
      IMPORTED_LOCATION ${systemc_library} INTERFACE_INCLUDE_DIRECTORIES ${systemc_headers}
      INTERFACE_LINK_LIBRARIES Threads::Threads)
  endif()
endmacro()

if(REPOUSSE_SYSTEMC_PREFIX)
  repousse_use_systemc_prefix(${REPOUSSE_SYSTEMC_PREFIX})
elseif(REPOUSSE_SYSTEMC_FIND)
  find_package(SystemCLanguage CONFIG QUIET)
  if(NOT SystemCLanguage_FOUND)
    message(FATAL_ERROR "No installed SystemC was found. Name its folder in CMAKE_PREFIX_PATH or "
                        "REPOUSSE_SYSTEMC_PREFIX, or leave REPOUSSE_SYSTEMC_FIND away to have it "
                        "built from source.")
  endif()
else()
  include(SystemCBuild)
  repousse_build_systemc(built_prefix)
  repousse_use_systemc_prefix(${built_prefix})
endif()

# A package may install several configurations; any one of them tells the standard.
get_target_property(systemc_library SystemC::systemc LOCATION)
repousse_check_systemc(${systemc_library})
message(STATUS "SystemC ${REPOUSSE_SYSTEMC_API}: ${systemc_library}")
