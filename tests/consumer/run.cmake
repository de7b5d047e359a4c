# Builds the project in app/ against the library, taken in the way that HOW names.
cmake_minimum_required(VERSION 3.25)

function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
set(common -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX})
set(app ${common} -DHOW=${HOW} -DROOT=${ROOT})
if(HOW STREQUAL find_package OR HOW STREQUAL pkg_config)
    run(${CMAKE_COMMAND} -S ${ROOT} -B ${WORK}/library ${common}
        -DDRIVECODEC_BUILD_TESTS=OFF -DDRIVECODEC_BUILD_EXAMPLES=OFF)
    run(${CMAKE_COMMAND} --install ${WORK}/library --prefix ${WORK}/prefix)
    list(APPEND app -DCMAKE_PREFIX_PATH=${WORK}/prefix)
    set(ENV{PKG_CONFIG_PATH} ${WORK}/prefix/share/pkgconfig)
endif()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/app -B ${WORK}/app ${app})
run(${CMAKE_COMMAND} --build ${WORK}/app)
run(${WORK}/app/app)
