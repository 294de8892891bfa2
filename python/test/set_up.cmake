# Makes the virtual environment VENV with REQUIREMENTS. Leaves VENV/why where that can't be, for the tests to say.
file(REMOVE_RECURSE ${VENV})
execute_process(COMMAND ${PYTHON} -m venv ${VENV} RESULT_VARIABLE failed ERROR_VARIABLE why OUTPUT_VARIABLE why)
if(NOT failed)
  execute_process(COMMAND ${VENV}/bin/pip install --quiet --disable-pip-version-check --requirement ${REQUIREMENTS}
                  RESULT_VARIABLE failed ERROR_VARIABLE why OUTPUT_VARIABLE why)
endif()
cmake_path(REPLACE_FILENAME REQUIREMENTS requirements_ray.txt OUTPUT_VARIABLE ray)
if(NOT failed AND EXISTS ${ray})
  # The cluster of the tests is large: where it can't be had its own tests are skipped, and no others.
  execute_process(COMMAND ${VENV}/bin/pip install --quiet --disable-pip-version-check --requirement ${ray}
                  RESULT_VARIABLE noRay ERROR_VARIABLE whyNoRay OUTPUT_VARIABLE whyNoRay)
  if(noRay)
    message(WARNING "the tests of Ray are skipped: ${whyNoRay}")
  endif()
endif()
file(MAKE_DIRECTORY ${VENV})
if(failed)
  file(WRITE ${VENV}/why "${why}")
  message(WARNING "the tests of Python are skipped: ${why}")
endif()
file(TOUCH ${VENV}/tried)
