# Builds SystemC from source, once for each (source, options, compiler, standard), into a cache.
#
# The source is REPOUSSE_SYSTEMC_SOURCE (a folder, a tarball or a URL), by default Debian's source
# package. Tarballs are checked by SHA-256.
include_guard(GLOBAL)

set(REPOUSSE_SYSTEMC_SOURCE "" CACHE STRING
    "SystemC's source: a folder, a tarball or a URL; empty: Debian's source package")
set(REPOUSSE_SYSTEMC_SHA256 83ef55e30cf18b02f9405c9252c86f3b34e0b96be051c0def9fc8e57a0653dfb
    CACHE STRING "SHA-256 of SystemC's tarball; the default is Debian's systemc_2.3.4.orig.tar.gz")

if(DEFINED ENV{REPOUSSE_CACHE_DIR})
  set(cache_default "$ENV{REPOUSSE_CACHE_DIR}")
elseif(DEFINED ENV{HOME})
  set(cache_default "$ENV{HOME}/.cache/repousse")
else()
  set(cache_default ${PROJECT_BINARY_DIR}/cache)
endif()
set(REPOUSSE_CACHE_DIR ${cache_default} CACHE PATH "Where SystemC is built and kept")

# Static beats shared by a third in a method's activation; QuickThreads is SystemC's default where
# it exists; the tracing of phase callbacks costs in every delta cycle and is used by nobody here.
set(REPOUSSE_SYSTEMC_OPTIONS -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF
    -DENABLE_PTHREADS=OFF -DENABLE_PHASE_CALLBACKS_TRACING=OFF -DDISABLE_COPYRIGHT_MESSAGE=ON
    -DCMAKE_POLICY_VERSION_MINIMUM=3.5)

set(other_ways "Other ways: -DREPOUSSE_SYSTEMC_SOURCE=<SystemC 2.3.4 as a folder, tarball or URL>, \
or -DREPOUSSE_SYSTEMC_PREFIX=<an installed one>.")

# The tarball's path in OUT, downloaded if need be, with the right SHA-256 or not at all.
function(repousse_systemc_tarball out)
  set(downloads ${REPOUSSE_CACHE_DIR}/downloads)
  set(tarball ${downloads}/systemc-${REPOUSSE_SYSTEMC_SHA256}.tar.gz)
  if(EXISTS "${REPOUSSE_SYSTEMC_SOURCE}")
    set(tarball ${REPOUSSE_SYSTEMC_SOURCE})
  elseif(NOT EXISTS ${tarball})
    file(MAKE_DIRECTORY ${downloads})
    string(RANDOM suffix)
    set(fetched ${tarball}.${suffix})
    if(REPOUSSE_SYSTEMC_SOURCE MATCHES "^[a-z]+://")
      message(STATUS "SystemC: downloading ${REPOUSSE_SYSTEMC_SOURCE}")
      file(DOWNLOAD ${REPOUSSE_SYSTEMC_SOURCE} ${fetched} STATUS status INACTIVITY_TIMEOUT 30)
      list(POP_FRONT status code reason)
    elseif(REPOUSSE_SYSTEMC_SOURCE)
      message(FATAL_ERROR "REPOUSSE_SYSTEMC_SOURCE=${REPOUSSE_SYSTEMC_SOURCE} is neither a folder, "
                          "nor a file, nor a URL.")
    else()
      message(STATUS "SystemC: fetching Debian's source package")
      execute_process(COMMAND sh ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fetch_systemc.sh ${fetched}
                      RESULT_VARIABLE code OUTPUT_VARIABLE reason ERROR_VARIABLE reason)
    endif()
    if(code OR NOT EXISTS ${fetched})
      file(REMOVE ${fetched})
      string(STRIP "${reason}" reason)
      message(FATAL_ERROR "SystemC's source could not be fetched: ${reason}\n${other_ways}")
    endif()
    set(tarball_is_new TRUE)
    set(kept ${tarball})
    set(tarball ${fetched})
  endif()
  file(SHA256 ${tarball} sha)
  if(NOT sha STREQUAL REPOUSSE_SYSTEMC_SHA256)
    if(tarball_is_new)
      file(REMOVE ${tarball})
    endif()
    message(FATAL_ERROR "SystemC's source ${REPOUSSE_SYSTEMC_SOURCE} has SHA-256 ${sha}, expected "
                        "${REPOUSSE_SYSTEMC_SHA256}. If it is the one that you mean, configure "
                        "with -DREPOUSSE_SYSTEMC_SHA256=${sha}.")
  endif()
  if(tarball_is_new)
    file(RENAME ${tarball} ${kept})
    set(tarball ${kept})
  endif()
  set(${out} ${tarball} PARENT_SCOPE)
endfunction()

# A hash of all files' contents and names: a folder has no other identity.
function(repousse_hash_folder folder out)
  file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${folder}
       ${folder}/CMakeLists.txt ${folder}/cmake/* ${folder}/src/*)
  set(all "")
  foreach(name IN LISTS files)
    file(SHA256 ${folder}/${name} sha)
    string(APPEND all "${name} ${sha}\n")
  endforeach()
  string(SHA256 all "${all}")
  set(${out} ${all} PARENT_SCOPE)
endfunction()

# Runs one step of the build with its output in LOG, and stops with the log's end if it fails.
function(repousse_systemc_step log)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  file(APPEND ${log} "${text}")
  if(code)
    string(LENGTH "${text}" length)
    math(EXPR start "${length} > 2000 ? ${length} - 2000 : 0")
    string(SUBSTRING "${text}" ${start} -1 text)
    message(FATAL_ERROR "SystemC could not be built; the log is ${log} and ends so:\n${text}")
  endif()
endfunction()

# The prefix of the built SystemC in OUT. Built beside its place and renamed, under a lock, so an
# interrupted build leaves nothing that looks finished and two builds at once do not meet.
function(repousse_build_systemc out)
  if(IS_DIRECTORY "${REPOUSSE_SYSTEMC_SOURCE}")
    repousse_hash_folder(${REPOUSSE_SYSTEMC_SOURCE} source_hash)
  else()
    set(source_hash ${REPOUSSE_SYSTEMC_SHA256})
  endif()
  string(SHA256 key "${source_hash};${REPOUSSE_SYSTEMC_OPTIONS};${CMAKE_CXX_COMPILER_ID};\
${CMAKE_CXX_COMPILER_VERSION};${CMAKE_SYSTEM_PROCESSOR};${CMAKE_CXX_FLAGS};${CMAKE_CXX_STANDARD}")
  string(SUBSTRING ${key} 0 16 key)
  set(prefix ${REPOUSSE_CACHE_DIR}/systemc-${key})
  set(${out} ${prefix} PARENT_SCOPE)
  if(EXISTS ${prefix})
    return()
  endif()

  file(MAKE_DIRECTORY ${REPOUSSE_CACHE_DIR})
  file(LOCK ${prefix}.lock GUARD FUNCTION TIMEOUT 0 RESULT_VARIABLE busy)
  if(busy)
    message(STATUS "SystemC: another build of it is under way, waiting for it")
    file(LOCK ${prefix}.lock GUARD FUNCTION TIMEOUT 1800)
  endif()
  if(EXISTS ${prefix})  # somebody else built it while we waited
    return()
  endif()
  set(work ${prefix}.building)
  file(REMOVE_RECURSE ${work})
  file(MAKE_DIRECTORY ${work})
  if(IS_DIRECTORY "${REPOUSSE_SYSTEMC_SOURCE}")
    set(source ${REPOUSSE_SYSTEMC_SOURCE})
  else()
    repousse_systemc_tarball(tarball)
    file(ARCHIVE_EXTRACT INPUT ${tarball} DESTINATION ${work}/source)
    file(GLOB source ${work}/source/*/CMakeLists.txt)
    cmake_path(GET source PARENT_PATH source)
  endif()

  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  message(STATUS "SystemC: building it as C++${CMAKE_CXX_STANDARD}, once, into ${prefix}; "
                 "this takes about two minutes of processor time, on ${cores} cores")
  set(log ${work}/build.log)
  # It would enter its build folder, which is soon gone, into the user's registry of packages.
  repousse_systemc_step(${log} ${CMAKE_COMMAND} -S ${source} -B ${work}/build
    -G ${CMAKE_GENERATOR} -DCMAKE_MAKE_PROGRAM=${CMAKE_MAKE_PROGRAM}
    -DCMAKE_EXPORT_NO_PACKAGE_REGISTRY=ON
    -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_CXX_STANDARD=${CMAKE_CXX_STANDARD}
    -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
    -DCMAKE_INSTALL_PREFIX=${prefix} -DCMAKE_INSTALL_LIBDIR=lib ${REPOUSSE_SYSTEMC_OPTIONS})
  repousse_systemc_step(${log} ${CMAKE_COMMAND} --build ${work}/build --parallel ${cores})
  repousse_systemc_step(${log} ${CMAKE_COMMAND} -E env DESTDIR=${work}/stage
                        ${CMAKE_COMMAND} --install ${work}/build)
  file(RENAME ${work}/stage${prefix} ${prefix})
  file(REMOVE_RECURSE ${work})
endfunction()
