# What `cmake --install` brings: libraries, headers, and files by which CMake's find_package and pkg-config find them. All of
# it may be moved elsewhere afterwards.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

install(TARGETS fixcast fixcast_panel EXPORT fixcast
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
set_target_properties(fixcast_panel PROPERTIES EXPORT_NAME panel)
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/include/fixcast DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
if(TARGET fixcast_simulator)
  install(TARGETS fixcast_simulator RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/fixcast)
install(EXPORT fixcast FILE fixcast-config.cmake NAMESPACE fixcast:: DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fixcast-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fixcast-config-version.cmake DESTINATION ${package})

# Paths from the file itself on, so that the directory can be moved.
file(RELATIVE_PATH FIXCAST_PC_TO_PREFIX /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
foreach(name fixcast fixcast-panel)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
