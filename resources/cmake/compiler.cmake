# Warnings, sanitizers, precompiled headers and the compiler cache, for every target of ours.

find_program(HAIRPAINT_CCACHE ccache)
if(HAIRPAINT_CCACHE)
    # Precompiled headers are cached too, and checkouts side by side share what is the same. Dependencies are the
    # compiler's own: preprocessing for the cache alone would be a tenth of a first build.
    set(launcher ${CMAKE_COMMAND} -E env CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros
        CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${HAIRPAINT_CCACHE})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
    set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
    endif()
endif()
find_program(HAIRPAINT_LLD ld.lld)
if(HAIRPAINT_LLD AND NOT WIN32)
    add_link_options(-fuse-ld=lld)
endif()

# What nearly every file of a target includes. Sources still name all they use: tests/run --tidy reads them without.
set(HAIRPAINT_STD_HEADERS <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <span> <string>
    <utility> <vector> <glm/glm.hpp>)
set(HAIRPAINT_QT_HEADERS ${HAIRPAINT_STD_HEADERS} <tl/expected.hpp> <QByteArray> <QColor> <QFile> <QFileInfo> <QImage>
    <QJsonObject> <QList> <QObject> <QPointF> <QRectF> <QString> <QStringList> <QUndoStack>)
set(HAIRPAINT_WIDGET_HEADERS ${HAIRPAINT_QT_HEADERS} <QAction> <QApplication> <QBoxLayout> <QDialog> <QEvent> <QLabel>
    <QMouseEvent> <QPainter> <QTimer> <QWidget>)

add_library(hairpaint_options INTERFACE)
target_include_directories(hairpaint_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_definitions(hairpaint_options INTERFACE QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII
    QT_NO_URL_CAST_FROM_STRING QT_NO_KEYWORDS GLM_FORCE_SILENT_WARNINGS)
if(WIN32)
    target_compile_definitions(hairpaint_options INTERFACE NOMINMAX WIN32_LEAN_AND_MEAN _WIN32_WINNT=0x0A00) # Windows 10 and later.
endif()
if(MSVC)
    # UTF-8 sources, and exact floating point: sim promises the same bytes everywhere.
    target_compile_options(hairpaint_options INTERFACE /W4 /WX /utf-8 /fp:precise /permissive- /Zc:__cplusplus)
else()
    # Contraction would fuse a multiply and an add on some machines and not on others.
    target_compile_options(hairpaint_options INTERFACE -Wall -Wextra -Wconversion -Werror -ffp-contract=off
        $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>) # GCC's -Wconversion leaves that out in C++.
endif()
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Where several sources are compiled as one, a source's own types look like a header's.
    target_compile_options(hairpaint_options INTERFACE -Wno-subobject-linkage)
endif()
if(HAIRPAINT_SANITIZE)
    # Compilers tell of it under names of their own.
    if(HAIRPAINT_SANITIZE MATCHES "address")
        add_compile_definitions(HAIRPAINT_ASAN)
    elseif(HAIRPAINT_SANITIZE MATCHES "thread")
        add_compile_definitions(HAIRPAINT_TSAN)
    endif()
    # -O1 of RelWithDebInfo's -O2: a quarter less to wait for the compiler, and stacks that name every function.
    add_compile_options(-O1 -fsanitize=${HAIRPAINT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -g1)
    add_link_options(-fsanitize=${HAIRPAINT_SANITIZE})
    # What these see the address sanitizer sees as soon as it is used, and they are half of what the compiler works at.
    if(HAIRPAINT_SANITIZE MATCHES "undefined" AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
        add_compile_options(-fno-sanitize=null,object-size,pointer-overflow)
    endif()
    # Instrumented code confuses these two in GCC 12; the plain builds check them.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(hairpaint_options INTERFACE -Wno-array-bounds -Wno-maybe-uninitialized)
    endif()
endif()

# hairpaint_fuzzed(TARGET...): they read bytes that fuzz targets make up, which the fuzzer is to see the branches of.
function(hairpaint_fuzzed)
    if(HAIRPAINT_FUZZERS)
        foreach(target IN LISTS ARGN)
            target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
        endforeach()
    endif()
endfunction()

# hairpaint_kernels(SOURCE...): Highway compiles a kernel's source once for each instruction set, so that it can share no unit
# with another. For the sanitizers one set does; it is named, since without one Clang's baseline is Highway's emulation, which
# takes minutes to compile and to run.
function(hairpaint_kernels)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    if(HAIRPAINT_SANITIZE AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
        set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "-msse4.2;-maes;-mpclmul"
            COMPILE_DEFINITIONS HWY_COMPILE_ONLY_STATIC)
    endif()
endfunction()
