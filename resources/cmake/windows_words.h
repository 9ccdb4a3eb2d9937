// Included before all else on Windows: its headers, which Qt's for OpenGL include, take these words for macros of their
// own. They are given back once, so that sources that are compiled as one unit read alike whatever stands before them.
#pragma once

#include <windows.h>

#undef far
#undef interface
#undef near
#undef small
