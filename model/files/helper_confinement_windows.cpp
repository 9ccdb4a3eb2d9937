// A job object around the helper, and no handle of the program's in it but those of its three streams.
#include "model/files/helper_confinement.h"

#include <QProcess>

#ifdef Q_OS_WIN

#include <windows.h>

#include <array>
#include <cstddef>
#include <memory>

namespace hairpaint::model {

namespace {

/// More than the greatest request and its encoded answer need together.
constexpr SIZE_T kMostMemoryBytes = 1'900'000'000;

std::shared_ptr<void> makeJob(int timeoutMs)
{
    HANDLE const job = CreateJobObjectW(nullptr, nullptr);
    if (job == nullptr)
        return nullptr;
    constexpr LONGLONG kUnitsPerMs = 10'000;
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_PROCESS_MEMORY | JOB_OBJECT_LIMIT_ACTIVE_PROCESS |
                                              JOB_OBJECT_LIMIT_JOB_TIME | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION |
                                              JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
    limits.BasicLimitInformation.ActiveProcessLimit = 1;
    // Two cores may be at work.
    limits.BasicLimitInformation.PerJobUserTimeLimit.QuadPart = 2 * (timeoutMs + 2000) * kUnitsPerMs;
    limits.ProcessMemoryLimit = kMostMemoryBytes;
    SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof(limits));
    return {job, CloseHandle};
}

/// What a process is started with when it is to inherit only the streams that it is given.
class InheritedStreams
{
public:
    InheritedStreams() = default;
    InheritedStreams(const InheritedStreams&) = delete;
    InheritedStreams& operator=(const InheritedStreams&) = delete;
    ~InheritedStreams()
    {
        if (m_list)
            DeleteProcThreadAttributeList(list());
    }

    void applyTo(QProcess::CreateProcessArguments& arguments)
    {
        static_assert(sizeof(Q_STARTUPINFO) == sizeof(STARTUPINFOW));
        SIZE_T bytes = 0;
        InitializeProcThreadAttributeList(nullptr, 1, 0, &bytes);
        m_list = std::make_unique<std::byte[]>(bytes);
        if (bytes == 0 || InitializeProcThreadAttributeList(list(), 1, 0, &bytes) == FALSE) {
            m_list.reset();
            return;
        }
        m_start.StartupInfo = *reinterpret_cast<const STARTUPINFOW*>(arguments.startupInfo);
        m_start.StartupInfo.cb = sizeof(m_start);
        m_start.lpAttributeList = list();
        m_handles = {m_start.StartupInfo.hStdInput, m_start.StartupInfo.hStdOutput, m_start.StartupInfo.hStdError};
        if (UpdateProcThreadAttribute(list(), 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, m_handles.data(), sizeof(m_handles),
                                      nullptr, nullptr) == FALSE)
            return; // It inherits as any child of Qt's does.
        arguments.startupInfo = reinterpret_cast<Q_STARTUPINFO*>(&m_start);
        arguments.flags |= EXTENDED_STARTUPINFO_PRESENT | CREATE_NO_WINDOW;
    }

private:
    [[nodiscard]] LPPROC_THREAD_ATTRIBUTE_LIST list() const
    {
        return reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(m_list.get());
    }

    std::unique_ptr<std::byte[]> m_list;
    std::array<HANDLE, 3> m_handles{};
    STARTUPINFOEXW m_start{};
};

} // namespace

HelperConfinement::HelperConfinement(QProcess& process, int timeoutMs) : m_process(process), m_job(makeJob(timeoutMs))
{
    process.setCreateProcessArgumentsModifier(
        [streams = std::make_shared<InheritedStreams>()](QProcess::CreateProcessArguments* arguments) {
            streams->applyTo(*arguments);
        });
}

void HelperConfinement::started()
{
    // Until it is sent a request it waits, so nothing that it decodes runs outside of the job.
    HANDLE const process =
        OpenProcess(PROCESS_SET_QUOTA | PROCESS_TERMINATE, FALSE, static_cast<DWORD>(m_process.processId()));
    if (process == nullptr)
        return;
    if (m_job)
        AssignProcessToJobObject(m_job.get(), process);
    CloseHandle(process);
}

void HelperConfinement::kill()
{
    if (m_job)
        TerminateJobObject(m_job.get(), 1);
    m_process.kill();
}

} // namespace hairpaint::model

#endif
