# SPDX-License-Identifier: LGPL-2.1-or-later
# What `cmake --install` puts where: header, library, and what pkg-config and find_package(hexcon) look for.
include(CMakePackageConfigHelpers)

install(TARGETS hexcon EXPORT hexcon)
install(FILES include/hexcon.h TYPE INCLUDE)

set(HEXCON_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/hexcon)
install(EXPORT hexcon NAMESPACE hexcon:: FILE hexconTargets.cmake DESTINATION ${HEXCON_PACKAGE})
configure_package_config_file(cmake/hexconConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/hexconConfig.cmake
                              INSTALL_DESTINATION ${HEXCON_PACKAGE})
# Before 1.0, a minor version may change calls.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/hexconConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/hexconConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/hexconConfigVersion.cmake
        DESTINATION ${HEXCON_PACKAGE})

# A static library's users link what it needs themselves, also without --static.
set(HEXCON_LINKED "-pthread -lm")
set(HEXCON_LIBS "-lhexcon ${HEXCON_LINKED}")
set(HEXCON_LIBS_PRIVATE)
if(BUILD_SHARED_LIBS)
  set(HEXCON_LIBS -lhexcon)
  set(HEXCON_LIBS_PRIVATE ${HEXCON_LINKED})
endif()
file(RELATIVE_PATH HEXCON_PREFIX_FROM_PC ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/hexcon.pc.in ${CMAKE_CURRENT_BINARY_DIR}/hexcon.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/hexcon.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
