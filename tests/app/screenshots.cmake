# Each step of each lesson is a test of its own, app.screenshot.SLUG-STEP. Configured again when a lesson changes.
# One that these lines do not find fails the test "every step of the course is registered".
add_executable(test_screenshots test_screenshots.cpp golden.cpp)
target_link_libraries(test_screenshots PRIVATE halfdisk_app_testing)
target_compile_definitions(test_screenshots PRIVATE HALFDISK_DIFFERENCES="${CMAKE_CURRENT_BINARY_DIR}/screenshots")

# The maintainers' way to make the golden pictures: ninja -C build goldens
add_executable(make_goldens make_goldens.cpp golden.cpp rig.cpp driver.cpp)
target_link_libraries(make_goldens PRIVATE halfdisk_app)
target_compile_definitions(make_goldens PRIVATE HALFDISK_ROOT="${PROJECT_SOURCE_DIR}")
add_custom_target(goldens COMMAND make_goldens USES_TERMINAL)

file(GLOB lessons CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lessons/[0-9]*.toml)
set(registered "")
foreach(lesson ${lessons})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${lesson})
    get_filename_component(name ${lesson} NAME_WE)
    string(REGEX REPLACE "^[0-9]+-" "" slug ${name})
    file(STRINGS ${lesson} steps REGEX "^\\[\\[step\\]\\]")
    list(LENGTH steps count)
    foreach(step RANGE 1 ${count})
        if(count EQUAL 0)
            break()
        endif()
        set(test app.screenshot.${slug}-${step})
        add_test(NAME ${test} COMMAND test_screenshots "--test-case=a step looks like its golden picture")
        set_tests_properties(${test} PROPERTIES LABELS screenshot TIMEOUT 120
            ENVIRONMENT "HALFDISK_STEP=${slug}:${step}")
        list(APPEND registered ${slug}:${step})
    endforeach()
endforeach()
list(JOIN registered " " registered)
add_test(NAME app.screenshots COMMAND test_screenshots "--test-case-exclude=a step looks like its golden picture")
set_tests_properties(app.screenshots PROPERTIES LABELS screenshot TIMEOUT 120
    ENVIRONMENT "HALFDISK_REGISTERED_STEPS=${registered}")
