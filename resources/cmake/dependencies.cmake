# Every library the project uses, found in one place. The README's table gives the reason for each.

find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(glm REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(TBB REQUIRED COMPONENTS tbb)
find_package(tl-expected REQUIRED)
find_package(OpenEXR CONFIG REQUIRED)

# Highway and nanoflann ship CMake packages in vcpkg; Debian's carry pkg-config files.
find_package(hwy CONFIG QUIET)
if(NOT TARGET hwy::hwy)
    pkg_check_modules(HWY REQUIRED IMPORTED_TARGET libhwy)
    add_library(hwy::hwy ALIAS PkgConfig::HWY)
endif()
find_package(nanoflann CONFIG QUIET)
if(NOT TARGET nanoflann::nanoflann)
    pkg_check_modules(NANOFLANN REQUIRED IMPORTED_TARGET nanoflann)
    add_library(nanoflann::nanoflann ALIAS PkgConfig::NANOFLANN)
endif()

find_package(ZLIB REQUIRED)
# pkg-config first: Debian's CMake package names tools that live in other packages, and stops without them.
pkg_check_modules(LIBZIP QUIET IMPORTED_TARGET libzip)
if(LIBZIP_FOUND)
    add_library(libzip::zip ALIAS PkgConfig::LIBZIP)
else()
    find_package(libzip CONFIG REQUIRED)
endif()

find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets Test)
qt_standard_project_setup()

if(NOT HAIRPAINT_THREADS_ONLY)
    find_package(Qt6 6.4 REQUIRED COMPONENTS OpenGL OpenGLWidgets Svg LinguistTools)
    pkg_check_modules(EPOXY REQUIRED IMPORTED_TARGET epoxy)
    find_package(assimp REQUIRED)
    find_package(OpenImageIO REQUIRED)
    # Debian's target lists an include folder of OpenCV that is not installed.
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${OpenImageIO_INCLUDE_DIRS}")
endif()

if(HAIRPAINT_BENCHMARKS)
    find_package(benchmark REQUIRED)
endif()
