# glm::glm: as installed for the target; else, GLM being headers only, those of this machine, in a folder of their own,
# because /usr/include as a whole is not the target's.
find_package(glm QUIET)
if(NOT TARGET glm::glm)
    if(NOT CMAKE_CROSSCOMPILING)
        message(FATAL_ERROR "GLM is missing (Debian: libglm-dev)")
    endif()
    find_path(CAIRN_GLM_FOLDER glm/glm.hpp REQUIRED NO_CMAKE_FIND_ROOT_PATH PATHS /usr/include
              DOC "Folder that has glm/glm.hpp")
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/glm_include)
    file(CREATE_LINK ${CAIRN_GLM_FOLDER}/glm ${CMAKE_BINARY_DIR}/glm_include/glm SYMBOLIC)
    add_library(glm::glm INTERFACE IMPORTED)
    set_target_properties(glm::glm PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_BINARY_DIR}/glm_include)
endif()
