// Forking, waiting, and telling that a request is served.
#include "app/importer/request_service.h"

#include "model/files/wire_format.h"

#if defined(__unix__) || defined(__APPLE__)
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <csignal>
#include <sys/prctl.h>
#endif
#endif

namespace hairpaint::importer {

#if defined(__unix__) || defined(__APPLE__)

namespace {

constexpr int kNotServed = 2;

/// False where no request can come any more.
bool awaitRequest()
{
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    int ready = -1;
    do {
        ready = ::poll(&input, 1, -1);
    } while (ready < 0 && errno == EINTR);
    return ready > 0 && (input.revents & POLLIN) != 0;
}

/// What decoders print leads nowhere from now on, nor can they say that a request is served.
bool closeErrors()
{
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    return nowhere >= 0 && ::dup2(nowhere, STDOUT_FILENO) >= 0 && ::dup2(nowhere, STDERR_FILENO) >= 0 &&
           ::close(nowhere) == 0;
}

/// Makes this process, a fork, end with `parent`; false where `parent` is gone already.
bool endWith([[maybe_unused]] pid_t parent)
{
#ifdef __linux__
    return ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && ::getppid() == parent;
#else
    return true;
#endif
}

int codeOf(pid_t fork)
{
    int status = 0;
    while (::waitpid(fork, &status, 0) < 0)
        if (errno != EINTR)
            return kNotServed;
    return WIFEXITED(status) ? WEXITSTATUS(status) : kNotServed;
}

bool tellServed()
{
    return ::write(STDERR_FILENO, wire::kServed.data(), wire::kServed.size()) ==
           static_cast<ssize_t>(wire::kServed.size());
}

} // namespace

int serveEach(const std::function<int()>& serve)
{
    while (awaitRequest()) {
        const pid_t parent = ::getpid();
        const pid_t fork = ::fork();
        if (fork < 0)
            return closeErrors() ? serve() : kNotServed;
        // What libraries would do at the end belongs to the process that loaded them.
        if (fork == 0)
            std::_Exit(endWith(parent) && closeErrors() ? serve() : kNotServed);
        if (const int code = codeOf(fork); code != 0)
            return code;
        if (!tellServed())
            return kNotServed;
    }
    return 0;
}

#else

int serveEach(const std::function<int()>& serve)
{
    return serve();
}

#endif

} // namespace hairpaint::importer
