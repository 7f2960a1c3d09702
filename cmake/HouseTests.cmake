# Tests of the house itself: include rules, format, how SystemC is found, the installed package.
# Included by testbench/tests, whose repousse_add_test() they use.
include_guard(GLOBAL)
set(here ${CMAKE_CURRENT_LIST_DIR})

repousse_add_test(include_rules house bash ${here}/check_includes.sh)
repousse_add_test(include_rules_self_test house bash ${here}/check_includes.sh --self-test)

find_program(CLANG_FORMAT_PROGRAM clang-format)
mark_as_advanced(CLANG_FORMAT_PROGRAM)
if(CLANG_FORMAT_PROGRAM)
  repousse_add_test(format house sh ${here}/format.sh --check)
endif()

set(sanitize "")
if(REPOUSSE_SANITIZE)
  set(sanitize -fsanitize=${REPOUSSE_SANITIZE})
endif()
# Both configure small projects with this build's compiler and generator.
set(same_tools -DGENERATOR=${CMAKE_GENERATOR} -DMAKE_PROGRAM=${CMAKE_MAKE_PROGRAM}
               -DCOMPILER=${CMAKE_CXX_COMPILER} -DSOURCE=${PROJECT_SOURCE_DIR}
               -DWORK=${PROJECT_BINARY_DIR}/house)
repousse_add_test(systemc_choice house ${CMAKE_COMMAND} ${same_tools}
                  -P ${here}/tests/systemc_choice.cmake)
repousse_add_test(installed_package house ${CMAKE_COMMAND} ${same_tools}
                  -DBUILD=${PROJECT_BINARY_DIR} -DSTANDARD=${CMAKE_CXX_STANDARD}
                  -DFLAGS=${sanitize}
                  -P ${here}/tests/installed_package.cmake)
