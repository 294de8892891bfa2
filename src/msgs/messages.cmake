# Message types that the installed ignition-msgs lacks, in a separate library, because protobuf allows only one copy of a
# type per process. The others come from ignition-msgs.
find_path(ignition_msgs_proto_dir ignition/msgs/entity.proto PATHS ${ignition_msgs_INCLUDE_DIRS} NO_DEFAULT_PATH
          REQUIRED)
set(folder ${CMAKE_BINARY_DIR}/messages)
file(MAKE_DIRECTORY ${folder})
set(sources)
foreach(name air_speed attach_detach_request dataframe dvl_beam_state dvl_kinematic_estimate dvl_range_estimate
        dvl_tracking_target dvl_velocity_tracking entity_wrench odometry_with_covariance pose_with_covariance result
        twist_with_covariance wheel_slip_parameters_cmd)
  if(EXISTS ${ignition_msgs_proto_dir}/ignition/msgs/${name}.proto)
    continue()
  endif()
  set(proto ${CMAKE_CURRENT_SOURCE_DIR}/proto/ignition/msgs/${name}.proto)
  set(files ${folder}/ignition/msgs/${name}.pb.cc ${folder}/ignition/msgs/${name}.pb.h)
  add_custom_command(OUTPUT ${files} DEPENDS ${proto} VERBATIM
    COMMAND protobuf::protoc --proto_path=${CMAKE_CURRENT_SOURCE_DIR}/proto
            --proto_path=${ignition_msgs_proto_dir} --cpp_out=${folder} ${proto})
  list(APPEND sources ${files})
endforeach()

if(sources)
  add_library(pongsim_messages SHARED ${sources})
  # Generated files can't be compiled as one. A precompiled header would hide what they export: types in it are hidden.
  set_target_properties(pongsim_messages PROPERTIES UNITY_BUILD OFF)
  target_compile_options(pongsim_messages PRIVATE -w)
  set_target_properties(pongsim_messages PROPERTIES OUTPUT_NAME pongsim-messages CXX_VISIBILITY_PRESET default
    VISIBILITY_INLINES_HIDDEN OFF VERSION ${PROJECT_VERSION} SOVERSION ${PONGSIM_SOVERSION})
  set(scope PUBLIC)
else()
  add_library(pongsim_messages INTERFACE)
  set(scope INTERFACE)
endif()
target_link_libraries(pongsim_messages ${scope} PkgConfig::ignition_msgs)
target_include_directories(pongsim_messages SYSTEM ${scope}
  $<BUILD_INTERFACE:${folder}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/pongsim/messages>)
install(TARGETS pongsim_messages EXPORT pongsim LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${folder}/ignition DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pongsim/messages
        FILES_MATCHING PATTERN "*.pb.h")

# The types as files: one with comments, for `pongsim msg -i`, and one with only what reading and writing messages needs,
# for programs that do not contain the classes.
file(GLOB installed ${ignition_msgs_proto_dir}/ignition/msgs/*.proto)
file(GLOB own ${CMAKE_CURRENT_SOURCE_DIR}/proto/ignition/msgs/*.proto)
foreach(proto ${own})
  get_filename_component(name ${proto} NAME)
  if(EXISTS ${ignition_msgs_proto_dir}/ignition/msgs/${name})
    list(REMOVE_ITEM own ${proto})
  endif()
endforeach()
set(types)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/pongsim)
foreach(name message_types message_comments)
  set(file ${CMAKE_BINARY_DIR}/share/pongsim/${name})
  set(with_source_info $<$<STREQUAL:${name},message_comments>:--include_source_info>)
  add_custom_command(OUTPUT ${file} DEPENDS ${installed} ${own} VERBATIM COMMAND_EXPAND_LISTS
    COMMAND protobuf::protoc --proto_path=${CMAKE_CURRENT_SOURCE_DIR}/proto --proto_path=${ignition_msgs_proto_dir}
            --include_imports ${with_source_info} --descriptor_set_out=${file} ${installed} ${own})
  list(APPEND types ${file})
endforeach()
add_custom_target(pongsim_message_types ALL DEPENDS ${types})
install(FILES ${types} DESTINATION ${CMAKE_INSTALL_DATADIR}/pongsim)
