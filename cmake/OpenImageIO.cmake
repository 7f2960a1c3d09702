# OpenImageIO as Debian packages it, with the two faults of its CMake files mended.
include_guard(GLOBAL)

# 1. Its target list names the command-line tools, which are a package of their own; without that
#    package find_package() ends in an error about /usr/bin/iconvert that helps nobody.
find_program(OPENIMAGEIO_TOOL oiiotool)
mark_as_advanced(OPENIMAGEIO_TOOL)
if(NOT OPENIMAGEIO_TOOL)
  message(FATAL_ERROR "OpenImageIO's CMake files need its command-line tools: install the package "
                      "openimageio-tools beside libopenimageio-dev.")
endif()
set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)  # its dependencies talk about Python files that nobody needs
find_package(OpenImageIO REQUIRED)
unset(CMAKE_MESSAGE_LOG_LEVEL)

# 2. Its include path names /usr/include/opencv4, which need not exist; generation would fail.
foreach(target IN ITEMS OpenImageIO::OpenImageIO OpenImageIO::OpenImageIO_Util)
  get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
  if(folders)
    list(FILTER folders EXCLUDE REGEX "opencv4")
    set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${folders}")
  endif()
endforeach()
