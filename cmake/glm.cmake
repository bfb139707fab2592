# Defines glm::glm: an existing target, or the library installed for the target platform; otherwise the host's headers,
# as GLM is header-only. When cross-compiling these headers are used through a folder of their own, because /usr/include
# as a whole belongs to the host. Used by Cairn's own build and by find_package(cairn). Defines no target if GLM is
# missing.
if(NOT TARGET glm::glm)
    find_package(glm QUIET)
endif()
if(NOT TARGET glm::glm)
    find_path(CAIRN_GLM_FOLDER glm/glm.hpp NO_CMAKE_FIND_ROOT_PATH PATHS /usr/include DOC "Folder that has glm/glm.hpp")
    if(CAIRN_GLM_FOLDER)
        set(cairn_glm_folder ${CAIRN_GLM_FOLDER})
        if(CMAKE_CROSSCOMPILING)
            set(cairn_glm_folder ${CMAKE_BINARY_DIR}/glm_include)
            file(MAKE_DIRECTORY ${cairn_glm_folder})
            file(CREATE_LINK ${CAIRN_GLM_FOLDER}/glm ${cairn_glm_folder}/glm SYMBOLIC)
        endif()
        add_library(glm::glm INTERFACE IMPORTED)
        set_target_properties(glm::glm PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${cairn_glm_folder})
    endif()
endif()
