// Attaching, and opening what leads nowhere.
#include "app/cli/console.h"

#ifdef _WIN32

#include <windows.h>

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <initializer_list>
#include <io.h>

namespace hairpaint::app {

namespace {

UINT codePageBefore = 0;

void giveBackCodePage()
{
    SetConsoleOutputCP(codePageBefore);
}

bool leadsNowhere(std::FILE* stream, DWORD which)
{
    HANDLE const handle = GetStdHandle(which);
    return handle == nullptr || handle == INVALID_HANDLE_VALUE || _fileno(stream) < 0;
}

} // namespace

void joinConsole()
{
    const bool isAttached = AttachConsole(ATTACH_PARENT_PROCESS) != FALSE || GetConsoleWindow() != nullptr;
    if (isAttached) {
        if (leadsNowhere(stdout, STD_OUTPUT_HANDLE))
            (void)std::freopen("CONOUT$", "wb", stdout);
        if (leadsNowhere(stderr, STD_ERROR_HANDLE))
            (void)std::freopen("CONOUT$", "wb", stderr);
        codePageBefore = GetConsoleOutputCP();
        if (codePageBefore != 0 && codePageBefore != CP_UTF8 && SetConsoleOutputCP(CP_UTF8) != FALSE)
            (void)std::atexit(giveBackCodePage); // It is the shell's, too.
    }
    for (std::FILE* stream : std::initializer_list<std::FILE*>{stdout, stderr})
        if (const int descriptor = _fileno(stream); descriptor >= 0)
            (void)_setmode(descriptor, _O_BINARY);
}

} // namespace hairpaint::app

#else

namespace hairpaint::app {

void joinConsole() {}

} // namespace hairpaint::app

#endif
