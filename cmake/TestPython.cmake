# pongsim_test_python(GROUP PYTHON VENV [NEEDED]): a virtual environment with the requirements.txt of this folder, set up by
# the test GROUP.setup, so that the build does not wait for downloads. Tests use it with `FIXTURES_REQUIRED GROUP_python`.
function(pongsim_test_python group python venv)
  cmake_parse_arguments(PARSE_ARGV 3 arg "NEEDED" "" "")
  add_test(NAME ${group}.setup
           COMMAND ${CMAKE_COMMAND} -DVENV=${venv} -DREQUIREMENTS=${CMAKE_CURRENT_SOURCE_DIR}/requirements.txt
                   -DPYTHON=${python} -DNEEDED=${arg_NEEDED} -P ${CMAKE_SOURCE_DIR}/cmake/PythonVenv.cmake)
  set_tests_properties(${group}.setup PROPERTIES TIMEOUT 1800 FIXTURES_SETUP ${group}_python)
endfunction()
