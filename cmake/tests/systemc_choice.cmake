# How cmake/SystemC.cmake answers to what it may be given: each case configures the project with
# REPOUSSE_SYSTEMC_ONLY and looks for a sentence. The SystemC that is read is a text file with the
# symbols that matter, which is all that the check looks at.
set(failures "")

# An installed SystemC in the way that autotools lays it out.
function(fake_prefix name symbols)
  file(MAKE_DIRECTORY ${WORK}/${name}/include/systemc)
  file(WRITE ${WORK}/${name}/include/systemc/header "")
  file(WRITE ${WORK}/${name}/lib-linux64/libsystemc.a "${symbols}\n")
endfunction()

# expect(CASE ok|refused SENTENCE option...): CMake breaks its messages into lines, so blanks of
# any kind count as one.
function(expect case outcome sentence)
  file(REMOVE_RECURSE ${WORK}/configure)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env REPOUSSE_CACHE_DIR=${WORK}/cache
            ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/configure -G ${GENERATOR}
            -DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -DCMAKE_CXX_COMPILER=${COMPILER}
            -DREPOUSSE_SYSTEMC_ONLY=ON ${ARGN}
    RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  string(REGEX REPLACE "[ \n]+" " " text "${text}")
  set(was ok)
  if(code)
    set(was refused)
  endif()
  string(FIND "${text}" "${sentence}" position)
  if(NOT was STREQUAL outcome OR position EQUAL -1)
    message("${case}: ${was}, expected ${outcome} with \"${sentence}\"; it said:\n${text}\n")
    set(failures ${failures} ${case} PARENT_SCOPE)
  else()
    message(STATUS "${case}: ${outcome}, as it should be")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK}/choice)
set(WORK ${WORK}/choice)

fake_prefix(quick17 "_ZN7sc_core31sc_api_version_2_3_4_cxx201703LIX _ZN7sc_core13sc_cor_pkg_qtD2Ev")
fake_prefix(threads17 "sc_api_version_2_3_4_cxx201703L sc_cor_pkg_pthread")
fake_prefix(none "nothing")
file(WRITE ${WORK}/junk.tar.gz "not SystemC\n")

expect(same_standard ok "SystemC 2.3.4 C++17" -DREPOUSSE_SYSTEMC_PREFIX=${WORK}/quick17)
string(CONCAT other_standard "was compiled as C++17, but this build is C++20, and the two do not "
                             "link. Configure with -DCMAKE_CXX_STANDARD=17")
expect(other_standard refused "${other_standard}"
       -DREPOUSSE_SYSTEMC_PREFIX=${WORK}/quick17 -DCMAKE_CXX_STANDARD=20)
expect(pthreads ok "about 100 times slower" -DREPOUSSE_SYSTEMC_PREFIX=${WORK}/threads17)
expect(no_systemc refused "is no SystemC library" -DREPOUSSE_SYSTEMC_PREFIX=${WORK}/none)
expect(empty_prefix refused "There is no installed SystemC in"
       -DREPOUSSE_SYSTEMC_PREFIX=${WORK}/configure)
expect(wrong_tarball refused "If it is the one that you mean"
       -DREPOUSSE_SYSTEMC_SOURCE=${WORK}/junk.tar.gz)
expect(no_such_source refused "is neither a folder, nor a file, nor a URL"
       -DREPOUSSE_SYSTEMC_SOURCE=${WORK}/absent)
expect(old_standard refused "repousse needs C++17 or newer" -DCMAKE_CXX_STANDARD=14)

if(failures)
  message(FATAL_ERROR "failed: ${failures}")
endif()
