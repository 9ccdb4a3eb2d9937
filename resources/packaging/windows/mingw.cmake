# Windows on x86-64 with Debian's mingw-w64 (g++-mingw-w64-x86-64-posix); HAIRPAINT_WINDOWS_ROOT holds what was built for it.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_VERSION 10.0)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_ASM_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

# Windows aligns the stack to 16 bytes, and GCC takes it for aligned to 32 (GCC bug 54412): what AVX spills there would crash. The
# assembler makes an unaligned move of each aligned one. Qt, OpenImageIO and the kernels have more sections than a plain object holds.
set(flags "-Wa,-muse-unaligned-vector-move -Wa,-mbig-obj")
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT "${flags}")

set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32 $ENV{HAIRPAINT_WINDOWS_ROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
