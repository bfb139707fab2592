# cmake --install: the engine, for find_package(cairn) and for pkg-config; the program and its scenes, if they are
# built. Components: library (libcairn_c), development (files for compiling programs), program. No installed file
# contains a path of this machine: the installed tree may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(cairn_package ${CMAKE_INSTALL_LIBDIR}/cmake/cairn)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
install(TARGETS cairn EXPORT cairn ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/cairn DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# While the major version is 0, compatibility is decided by the minor version.
install(EXPORT cairn NAMESPACE cairn:: FILE cairn-targets.cmake DESTINATION ${cairn_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cairn-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/cairn-config.cmake ${PROJECT_SOURCE_DIR}/cmake/glm.cmake
              ${PROJECT_BINARY_DIR}/cairn-config-version.cmake DESTINATION ${cairn_package})

# Some systems lack GLM's pkg-config file; there its headers are in the compiler's default path.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(cairn_glm QUIET glm)
endif()
if(cairn_glm_FOUND)
    set(cairn_requires "Requires: glm")
endif()
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
           OUTPUT_VARIABLE cairn_prefix)
file(RELATIVE_PATH cairn_includedir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
file(RELATIVE_PATH cairn_libdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
configure_file(${PROJECT_SOURCE_DIR}/cmake/cairn.pc.in ${PROJECT_BINARY_DIR}/cairn.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/cairn.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# The C API: a package of its own, which needs neither C++ nor GLM.
if(CAIRN_C_API)
    set(cairn_c_package ${CMAKE_INSTALL_LIBDIR}/cmake/cairn_c)
    install(TARGETS cairn_c EXPORT cairn_c
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
            INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT cairn_c NAMESPACE cairn:: FILE cairn_c-config.cmake DESTINATION ${cairn_c_package})
    write_basic_package_version_file(${PROJECT_BINARY_DIR}/cairn_c-config-version.cmake COMPATIBILITY SameMinorVersion)
    install(FILES ${PROJECT_BINARY_DIR}/cairn_c-config-version.cmake DESTINATION ${cairn_c_package})
    configure_file(${PROJECT_SOURCE_DIR}/cmake/cairn_c.pc.in ${PROJECT_BINARY_DIR}/cairn_c.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/cairn_c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

if(CAIRN_APP)
    # The program searches for its scenes in ../share relative to its own folder.
    set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
    install(TARGETS cairn_cli RUNTIME DESTINATION bin)
    if(TARGET cairn_ranks) # loaded by the program under mpirun
        install(TARGETS cairn_ranks LIBRARY DESTINATION lib/cairn COMPONENT ranks)
    endif()
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_SOURCE_DIR}/docs DESTINATION share/cairn)
    if(NOT CMAKE_CROSSCOMPILING) # the program generates them
        set(pages ${PROJECT_BINARY_DIR}/pages)
        install(FILES ${pages}/cairn.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
        install(FILES ${pages}/cairn DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
        install(FILES ${pages}/_cairn DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
        install(FILES ${pages}/cairn.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
    endif()
endif()
