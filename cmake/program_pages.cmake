# cmake -DPROGRAM=... -DFOLDER=... -P program_pages.cmake: writes the program's generated pages (manual, completions) to
# files.
file(MAKE_DIRECTORY ${FOLDER})
function(page file)
    execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${FOLDER}/${file} RESULT_VARIABLE code)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "${PROGRAM} ${ARGN}: exit status ${code}")
    endif()
endfunction()
page(cairn.1 manual)
page(cairn completion bash)
page(_cairn completion zsh)
page(cairn.fish completion fish)
