# Installs the packages of package.json into CLIENTS, and bundles gzweb's sources and Foxglove's player for rosbridge for node,
# unless that is up to date. If it fails, writes the reason to CLIENTS/why, or for the player alone to CLIENTS/why_no_player, for
# the tests to report.
set(isOld FALSE)
file(GLOB parts ${CMAKE_CURRENT_LIST_DIR}/package*.json ${CMAKE_CURRENT_LIST_DIR}/gzweb.mjs ${CMAKE_CURRENT_LIST_DIR}/set_up.cmake
                ${CMAKE_CURRENT_LIST_DIR}/foxglove_player/*)
foreach(part ${parts})
  if(${part} IS_NEWER_THAN ${CLIENTS}/tried)
    set(isOld TRUE)
  endif()
endforeach()
if(NOT isOld)
  return()
endif()
set(esbuild node_modules/.bin/esbuild --bundle --preserve-symlinks --platform=node --format=esm --log-level=error)
set(banner "--banner:js=import { createRequire } from 'module'; const require = createRequire(import.meta.url);")
file(REMOVE ${CLIENTS}/why ${CLIENTS}/why_no_player)
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error WORKING_DIRECTORY ${CLIENTS}
                RESULT_VARIABLE failed ERROR_VARIABLE why OUTPUT_VARIABLE why)
if(NOT failed)
  execute_process(COMMAND ${esbuild} "${banner}" gzweb.mjs --outfile=gzweb_bundle.mjs
                  WORKING_DIRECTORY ${CLIENTS} RESULT_VARIABLE failed ERROR_VARIABLE why OUTPUT_VARIABLE why)
endif()
if(failed)
  file(WRITE ${CLIENTS}/why "${why}")
  message(WARNING "the tests with clients of others are skipped: ${why}")
  file(TOUCH ${CLIENTS}/tried)
  return()
endif()

# The package with the player has 180 MB, of which these four files are used, so it is not among those of package.json.
set(studio ${CLIENTS}/node_modules/@foxglove/studio-base)
set(archive ${CLIENTS}/foxglove-studio-base-1.48.0.tgz)
set(sum 2878122698e967c8e6abc2c8aca1a1005e5cd92ecd06d79bd451ab6e311e7df0)
execute_process(COMMAND ${NPM} pack @foxglove/studio-base@1.48.0 --loglevel=error WORKING_DIRECTORY ${CLIENTS}
                RESULT_VARIABLE failed ERROR_VARIABLE why OUTPUT_VARIABLE why)
if(NOT failed)
  file(SHA256 ${archive} found)
  if(NOT found STREQUAL sum)
    set(failed TRUE)
    set(why "its package is another one: ${found}")
  endif()
endif()
if(NOT failed)
  file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${CLIENTS}/unpacked
       PATTERNS package/src/players/RosbridgePlayer.js package/src/players/PlayerProblemManager.js package/src/players/types.js
                package/src/util/bagConnectionsHelper.js)
  file(REMOVE_RECURSE ${studio})
  file(RENAME ${CLIENTS}/unpacked/package ${studio})
  execute_process(COMMAND ${esbuild} "${banner}" foxglove_player/player.mjs --outfile=foxglove_player_bundle.mjs
                          "--define:__dirname='player'"
                          --alias:@foxglove/den/async=./foxglove_player/den.mjs
                          --alias:@foxglove/den/collection=./foxglove_player/den.mjs
                          --alias:@foxglove/log=./foxglove_player/log.mjs
                  WORKING_DIRECTORY ${CLIENTS} RESULT_VARIABLE failed ERROR_VARIABLE why OUTPUT_VARIABLE why)
endif()
file(REMOVE ${archive})
if(failed)
  file(WRITE ${CLIENTS}/why_no_player "${why}")
  message(WARNING "the test with Foxglove's player for rosbridge is skipped: ${why}")
endif()
file(TOUCH ${CLIENTS}/tried)
