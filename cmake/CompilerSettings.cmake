# Settings of our own code, as a target that everything of ours links.
add_library(pongsim_settings INTERFACE)
target_compile_options(pongsim_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 sees overlaps and overflows in `"text" + string` that are not there (GCC bugs 105651, 105329).
  target_compile_options(pongsim_settings INTERFACE -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Collecting garbage from 2 GB on only, where GCC does from 128 MB on, takes an eighth off a build.
  target_compile_options(pongsim_settings INTERFACE --param=ggc-min-heapsize=2097152)
endif()
if(PONGSIM_WARNINGS_AS_ERRORS)
  target_compile_options(pongsim_settings INTERFACE -Werror)
endif()

# The same bits whatever the processor can do: no fused multiply-add that one build contracts and another does not.
target_compile_options(pongsim_settings INTERFACE -ffp-contract=off)

if(PONGSIM_SANITIZE)
  add_compile_options(-fsanitize=${PONGSIM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${PONGSIM_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC's manual: with sanitizers it warns of what is none; it sees uninitialized members in <regex>.
    target_compile_options(pongsim_settings INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()
