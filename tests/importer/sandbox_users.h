// Who tries what the sandbox refuses, and whether it can refuse it here.
#pragma once

#ifdef __linux__
#include "app/importer/call_filter.h"

#include <QTest>

#include <grp.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace hairpaint::test {

inline constexpr const char* kNoFilter = "Built without libseccomp, or the kernel has no filters.";

inline bool filtersCalls()
{
    return !importer::allowedCalls().empty() && ::prctl(PR_GET_SECCOMP, 0, 0, 0, 0) >= 0;
}

/// Who tries: whoever runs the test and, where that is root, nobody, too.
inline constexpr uid_t kNobody = 65534;
inline void addUsers()
{
    QTest::addColumn<bool>("asNobody");
    QTest::newRow("as who runs this") << false;
    if (::geteuid() == 0)
        QTest::newRow("as nobody") << true;
}
inline void becomeNobody()
{
    if (::setgroups(0, nullptr) != 0 || ::setresgid(kNobody, kNobody, kNobody) != 0 ||
        ::setresuid(kNobody, kNobody, kNobody) != 0)
        ::_exit(2);
}

} // namespace hairpaint::test
#endif
