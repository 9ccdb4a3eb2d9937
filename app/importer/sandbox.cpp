// The layers, one after the other: files first, since the filter refuses the calls that confine them.
#include "app/importer/sandbox.h"

#include "app/importer/call_filter.h"
#include "app/importer/file_confinement.h"

#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace hairpaint::importer {

void closeInherited()
{
#if defined(__linux__) && defined(SYS_close_range)
    constexpr unsigned kFirst = 3;
    (void)::syscall(SYS_close_range, kFirst, ~0U, 0); // Linux 5.9 and later.
#endif
}

Confinement enterSandbox([[maybe_unused]] const std::string& file)
{
    Confinement layers;
#ifdef __linux__
    // Without it neither layer may be entered by an ordinary user.
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        return layers;
    layers.landlockVersion = confineFiles(file);
    layers.filtersCalls = filterCalls();
#endif
    return layers;
}

} // namespace hairpaint::importer
