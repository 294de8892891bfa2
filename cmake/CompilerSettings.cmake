include(CheckCXXCompilerFlag)

# Settings for our own code, as a target that all of it links.
add_library(pongsim_settings INTERFACE)
target_compile_options(pongsim_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 wrongly reports overlaps and overflows in `"text" + string` (GCC bugs 105651, 105329).
  target_compile_options(pongsim_settings INTERFACE -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC collects garbage from 2 GB on instead of 128 MB, which makes a build an eighth faster.
  target_compile_options(pongsim_settings INTERFACE --param=ggc-min-heapsize=2097152)
endif()
if(PONGSIM_WARNINGS_AS_ERRORS)
  target_compile_options(pongsim_settings INTERFACE -Werror)
endif()

# Hardening, as Debian builds its packages: no writable table of functions, a check of each stack frame with an array and of
# the library calls whose sizes are known, indirect branches to marked places only. A run costs 1 % more at most
# (docs/security.md).
target_compile_options(pongsim_settings INTERFACE -fstack-protector-strong)
check_cxx_compiler_flag(-fcf-protection PONGSIM_HAS_CF_PROTECTION)
if(PONGSIM_HAS_CF_PROTECTION)
  target_compile_options(pongsim_settings INTERFACE -fcf-protection)
endif()
if(NOT PONGSIM_SANITIZE)
  # needs optimization, and does not go with the sanitizers' own checks
  target_compile_options(pongsim_settings INTERFACE $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-U_FORTIFY_SOURCE$<SEMICOLON>-D_FORTIFY_SOURCE=2>)
endif()
add_link_options(LINKER:-z,relro LINKER:-z,now)

# The same bits on every processor: no fused multiply-add, which one build would use and another not.
target_compile_options(pongsim_settings INTERFACE -ffp-contract=off)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  # where Eigen asks for them by name
  target_include_directories(pongsim_settings SYSTEM BEFORE INTERFACE ${CMAKE_CURRENT_LIST_DIR}/aarch64)
endif()

if(PONGSIM_SANITIZE)
  add_compile_options(-fsanitize=${PONGSIM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${PONGSIM_SANITIZE})
  if(PONGSIM_SANITIZE STREQUAL "thread")
    include_directories(SYSTEM BEFORE ${CMAKE_CURRENT_LIST_DIR}/tsan)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # With sanitizers GCC gives false warnings, as its manual says: here about uninitialized members in <regex>.
    target_compile_options(pongsim_settings INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()
