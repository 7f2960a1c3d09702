# Turns tlm/config/profiles/*.toml into a source that defines shipped_profiles(), declared in
# tlm/config/shipped_profiles.h, so that the program needs no file beside it.
include_guard(GLOBAL)

# Appends the written source to the list of sources VAR. Done at configure time; a changed or new
# profile makes the next build configure again.
function(repousse_embed_profiles var)
  repousse_sources(profiles config/profiles/*.toml)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${profiles})
  set(default_file ${CMAKE_CURRENT_SOURCE_DIR}/config/profiles/default.toml)
  if(default_file IN_LIST profiles)  # the default stands first
    list(REMOVE_ITEM profiles ${default_file})
    list(PREPEND profiles ${default_file})
  endif()
  set(entries "")
  foreach(profile IN LISTS profiles)
    cmake_path(GET profile STEM name)
    file(READ ${profile} text)
    string(APPEND entries "    {\"${name}\", R\"REPOUSSE(${text})REPOUSSE\"},\n")
  endforeach()
  set(source ${PROJECT_BINARY_DIR}/generated/tlm/config/shipped_profiles.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT
"#include \"tlm/config/shipped_profiles.h\"

namespace repousse {
namespace {

constexpr ShippedProfile kProfiles[] = {
${entries}};

}  // namespace

Span<const ShippedProfile> shipped_profiles() { return kProfiles; }

}  // namespace repousse
")
  set(${var} ${${var}} ${source} PARENT_SCOPE)
endfunction()
