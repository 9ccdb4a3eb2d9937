# What each entry of the tests is, and which speed runs what.
#
#   logic    sim, model, readers and writers, without a window
#   window   a window or one of its areas, driven by mouse and keys
#   program  the program started from outside, as a script or a user does
#   hair     seconds of moving hair, a style made anew, or the built-in heads measured
#   gpu      pictures, by either renderer
#   fault    disks, memory, files or processes that fail
#   memory   for the address sanitizer, too, though of a kind that it leaves out: the command line, a walk of the window
#   threads  several threads at work, for the thread sanitizer

# A build runs the entries that have one of its labels, and compiles no other tests.
set(hairpaint_labels_of_release logic window program hair gpu fault)
set(hairpaint_labels_of_asan logic fault memory)
set(hairpaint_labels_of_tsan threads)

# The first row whose expression matches FOLDER.NAME counts.
set(hairpaint_label_rows
    # These start no thread.
    "sim\\.(deterministic|ellipsoid|frame_pool|head_warp|mesh_openings|mesh_subdivision|natural_stream|neck_motion)" "logic"
    "sim\\.(skin|skin_frame|stiffness|strand_curve|tiled_raster)" "logic"
    "sim\\..*" "logic threads"
    "background\\.(jobs|journal_thread)" "fault threads"
    "background\\.seen_race" "threads"
    "background\\.render_thread" "gpu threads"
    "background\\..*" "logic threads"
    "heads\\..*" "hair"
    "fuzz\\..*" "fault"
    "importer\\..*" "fault"

    "model\\.(built_in_styles|bust_motion|face_hair|fallen_hair|group_cut|hair_handles|held_tips|hold|scissors_cut|stroke_grooms|style_mix|style_transfer)" "hair"
    "model\\.(export_faults|faults|hostile_project|repair|want_of_memory)" "fault"
    "model\\..*" "logic"

    "rendering\\..*" "gpu"
    "view\\.(gl_presenter|head_view|head_view_still|head_view_without_gl)" "window gpu"
    "view\\..*" "window"

    "app\\.(commands|declarations|interruption|layering|readmes|settings_store|starter|translations)" "logic"
    "app\\.(lie|skin_contact|style_measures|style_outlines)" "hair"
    "app\\.(built_in_pictures|drawn_pictures|kept_pictures|style_pictures)" "gpu"
    "app\\.monkey" "window memory"
    "app\\.(broken_files|ended_window|error_sentences|killed_window|long_work|odd_clock|recovery_trouble|repair_damage)" "fault"
    "app\\.(open_file|silent_disk|silent_exchange)" "window"
    # The memory of `new` is command_line's and broken_files' to watch: they make projects with its options, and fail to;
    # that of the exports is model's, whose writers they call, and that of recovered work recovery_trouble's.
    "app\\.(characters|command_line|render_command)" "program memory"
    "app\\.(avatar_command|bounds|drawn_images|export_command|installed|new_command|odd_names|unwritable_paths)" "program"
    "app\\..*" "window"
)

# hairpaint_row(ROWS ENTRY VARIABLE): what stands beside the first expression of these rows that matches; empty where none does.
function(hairpaint_row rows entry variable)
    set(${variable} "" PARENT_SCOPE)
    while(rows)
        list(POP_FRONT rows pattern value)
        if(entry MATCHES "^(${pattern})$")
            set(${variable} "${value}" PARENT_SCOPE)
            return()
        endif()
    endwhile()
endfunction()

# hairpaint_labels(ENTRY VARIABLE): its labels; empty where this build does not run it.
function(hairpaint_labels entry variable)
    set(${variable} "" PARENT_SCOPE)
    hairpaint_row("${hairpaint_label_rows}" ${entry} labels)
    if(NOT labels)
        message(FATAL_ERROR "No row of tests/labels.cmake says what ${entry} is")
    endif()
    separate_arguments(labels)
    foreach(label IN LISTS labels)
        if(label IN_LIST hairpaint_labels_of_${HAIRPAINT_TESTS})
            set(${variable} "${labels}" PARENT_SCOPE)
        endif()
    endforeach()
endfunction()

# What an entry wants that Windows, or wine, does not have. It is left out there.
set(hairpaint_lacks_on_windows
    "app\\.installed" "installs as Linux does"
    "app\\.translations" "runs this machine's lupdate"
    "fuzz\\..*" "its targets are clang's"
    "model\\.(faults|export_faults)|importer\\.map_faults" "has a disk fail on order, which takes the calls of Linux' C library"
)

# hairpaint_lacks(ENTRY VARIABLE): what it lacks on Windows; empty where that is nothing.
function(hairpaint_lacks entry variable)
    hairpaint_row("${hairpaint_lacks_on_windows}" ${entry} lack)
    set(${variable} "${lack}" PARENT_SCOPE)
endfunction()
