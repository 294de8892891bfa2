# Installs the packages of package.json into CLIENTS, and bundles gzweb's sources for node, unless that is up to date. If it
# fails, writes the reason to CLIENTS/why for the tests to report.
set(isOld FALSE)
foreach(part package.json package-lock.json gzweb.mjs set_up.cmake)
  if(${CMAKE_CURRENT_LIST_DIR}/${part} IS_NEWER_THAN ${CLIENTS}/tried)
    set(isOld TRUE)
  endif()
endforeach()
if(NOT isOld)
  return()
endif()
file(REMOVE ${CLIENTS}/why)
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error WORKING_DIRECTORY ${CLIENTS}
                RESULT_VARIABLE failed ERROR_VARIABLE why OUTPUT_VARIABLE why)
if(NOT failed)
  execute_process(COMMAND node_modules/.bin/esbuild gzweb.mjs --bundle --preserve-symlinks --platform=node --format=esm
                          --log-level=error --outfile=gzweb_bundle.mjs
                          "--banner:js=import { createRequire } from 'module'; const require = createRequire(import.meta.url);"
                  WORKING_DIRECTORY ${CLIENTS} RESULT_VARIABLE failed ERROR_VARIABLE why OUTPUT_VARIABLE why)
endif()
if(failed)
  file(WRITE ${CLIENTS}/why "${why}")
  message(WARNING "the tests with clients of others are skipped: ${why}")
endif()
file(TOUCH ${CLIENTS}/tried)
