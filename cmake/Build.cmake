# How our own code is compiled, and the one function that makes a library out of a folder.
include_guard(GLOBAL)

# ---- configuration ----------------------------------------------------------------------------
if(PROJECT_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug or RelWithDebInfo" FORCE)
  endif()
  # -O2 is the level that the speed figures are stated for; -O3 stands in no file without a
  # measurement beside it.
  string(REPLACE "-O3" "-O2" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)  # clang-tidy and editors
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  if(NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    find_program(CCACHE_PROGRAM ccache)
    mark_as_advanced(CCACHE_PROGRAM)
    if(CCACHE_PROGRAM)
      set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
    endif()
  endif()
endif()

# The static libraries may end up in somebody's shared object, an engine or a platform. Hidden
# symbols keep a position-independent function inlinable, so this costs nothing.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

if(REPOUSSE_NATIVE)
  add_compile_options(-march=native)
endif()
if(REPOUSSE_SANITIZE)
  add_compile_options(-fsanitize=${REPOUSSE_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${REPOUSSE_SANITIZE})
endif()

# ---- warnings ---------------------------------------------------------------------------------
set(REPOUSSE_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                      -Wcast-qual -Wformat=2 -Wundef -Wunused)
if(REPOUSSE_WERROR)
  list(APPEND REPOUSSE_WARNINGS -Werror)
endif()
# The device is arithmetic on raw integers of stated widths: a conversion that loses bits silently
# is a defect there, so it must be written out.
set(REPOUSSE_DEVICE_WARNINGS -Wconversion -Wdouble-promotion)

# Warnings are ours alone: the headers of others are imported targets and so SYSTEM includes.
function(repousse_compile_like_ours target)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(${target} PRIVATE ${REPOUSSE_WARNINGS})
endfunction()

# repousse_sources(OUT [RECURSE] [EXCLUDE regex] pattern...): the files of this folder that match,
# watched, so that a new file is found by the next build.
function(repousse_sources out)
  cmake_parse_arguments(PARSE_ARGV 1 arg "RECURSE" "EXCLUDE" "")
  set(mode GLOB)
  if(arg_RECURSE)
    set(mode GLOB_RECURSE)
  endif()
  list(TRANSFORM arg_UNPARSED_ARGUMENTS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  file(${mode} files CONFIGURE_DEPENDS LIST_DIRECTORIES false ${arg_UNPARSED_ARGUMENTS})
  if(arg_EXCLUDE)
    list(FILTER files EXCLUDE REGEX "${arg_EXCLUDE}")
  endif()
  set(${out} ${files} PARENT_SCOPE)
endfunction()

# repousse_library(NAME [DEVICE] SOURCES ... [DEPENDS ...] [PRIVATE_DEPENDS ...])
# A static library with the alias repousse::NAME; one without sources is an interface library, so
# headers alone make a library too. DEVICE adds the device's warnings and installs the library.
function(repousse_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "DEVICE" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS")
  set(target repousse_${name})
  set(scope INTERFACE)
  if(arg_SOURCES)
    set(scope PUBLIC)
    add_library(${target} STATIC ${arg_SOURCES})
    repousse_compile_like_ours(${target})
    target_link_libraries(${target} PRIVATE ${arg_PRIVATE_DEPENDS})
    if(arg_DEVICE)
      target_compile_options(${target} PRIVATE ${REPOUSSE_DEVICE_WARNINGS})
    endif()
  else()
    add_library(${target} INTERFACE)
  endif()
  add_library(repousse::${name} ALIAS ${target})
  target_link_libraries(${target} ${scope} ${arg_DEPENDS})
  target_compile_features(${target} ${scope} cxx_std_17)
  # Includes are written from the repository's root, also by those who use the installed package.
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                $<INSTALL_INTERFACE:include/repousse>)
  if(arg_DEVICE)
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    set_property(GLOBAL APPEND PROPERTY REPOUSSE_INSTALLED ${target})
  endif()
endfunction()
