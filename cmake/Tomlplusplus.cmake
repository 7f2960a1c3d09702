# repousse::toml: toml++ as headers only, without exceptions.
#
# Errors are values in this project, and the shared library that Debian ships is compiled with
# exceptions, which is another set of symbols; so the library is left aside. It also means that an
# installed repousse needs no toml++.
include_guard(GLOBAL)
find_package(tomlplusplus REQUIRED)
add_library(repousse_toml INTERFACE)
add_library(repousse::toml ALIAS repousse_toml)
get_target_property(folders tomlplusplus::tomlplusplus INTERFACE_INCLUDE_DIRECTORIES)
target_include_directories(repousse_toml SYSTEM INTERFACE ${folders})
target_compile_definitions(repousse_toml INTERFACE TOML_HEADER_ONLY=1 TOML_EXCEPTIONS=0)
