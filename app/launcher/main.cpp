// hairpaint.com: Windows' shells wait only for programs of the console, which the editor is not. They take NAME.com
// before NAME.exe where NAME is typed: this one starts hairpaint.exe beside it with the same line, streams and console,
// and ends as it ended.
#include <windows.h>

#include <cstdio>
#include <string>

namespace {

/// 32,767 characters are the longest path there is.
std::wstring ownPath()
{
    std::wstring path(32'768, L'\0');
    path.resize(GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size())));
    return path;
}

/// What follows the program in a command line, which ends its name as the system does.
const wchar_t* argumentsOf(const wchar_t* line)
{
    bool isQuoted = false;
    for (; *line != L'\0' && (isQuoted || (*line != L' ' && *line != L'\t')); ++line)
        if (*line == L'"')
            isQuoted = !isQuoted;
    return line;
}

HANDLE inherited(DWORD stream)
{
    HANDLE const handle = GetStdHandle(stream);
    if (handle != nullptr && handle != INVALID_HANDLE_VALUE)
        SetHandleInformation(handle, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
    return handle;
}

BOOL WINAPI leaveToProgram(DWORD /*event*/)
{
    return TRUE; // It is of the same console, and told as well.
}

} // namespace

int main()
{
    constexpr int kNotStarted = 1;
    std::wstring program = ownPath();
    const std::size_t ending = program.rfind(L'.');
    if (ending == std::wstring::npos)
        return kNotStarted;
    program.replace(ending, std::wstring::npos, L".exe");
    std::wstring line = L'"' + program + L'"' + argumentsOf(GetCommandLineW());
    STARTUPINFOW start{};
    start.cb = sizeof(start);
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdInput = inherited(STD_INPUT_HANDLE);
    start.hStdOutput = inherited(STD_OUTPUT_HANDLE);
    start.hStdError = inherited(STD_ERROR_HANDLE);
    PROCESS_INFORMATION process{};
    SetConsoleCtrlHandler(leaveToProgram, TRUE);
    if (CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr, &start, &process) ==
        FALSE) {
        std::fprintf(stderr, "hairpaint.exe could not be started (error %lu); install Hair Paint again\n",
                     GetLastError());
        return kNotStarted;
    }
    WaitForSingleObject(process.hProcess, INFINITE);
    DWORD code = kNotStarted;
    GetExitCodeProcess(process.hProcess, &code);
    return static_cast<int>(code);
}
