// A disk that is full on order: while it lives, files of this process and those that it starts grow no further than
// `room` bytes. A limit on a file's size fails writes as a full disk does.
#pragma once

#include <QtGlobal>

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/resource.h>

namespace hairpaint::test {

class FullDisk
{
public:
    explicit FullDisk(qint64 room)
    {
        getrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit most{.rlim_cur = static_cast<rlim_t>(room), .rlim_max = m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &most);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &m_before); }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit m_before{};
};

} // namespace hairpaint::test
#endif
