// What the sandbox's filter says to system calls, asked of the kernel without making any of them.
#pragma once

#if defined(__linux__) && defined(__x86_64__)
#define HAIRPAINT_HAS_FILTER_PROBE

#include <QMetaType>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace hairpaint::test {

struct Call
{
    long number = 0;
    std::array<unsigned long, 5> arguments{};
};

enum class Verdict : unsigned char
{
    NotAsked,
    Allowed,
    Refused, ///< As a call that the kernel does not have.
    Other
};

/// A child becomes another user by `become` (empty: stays who it is), enters the sandbox and makes each call with a
/// mark as its sixth argument. A filter of the test's own, put below the sandbox's, hands marked calls to this process,
/// but only those that the sandbox lets through, for its refusals weigh more; none is carried out. None where the child
/// ends early.
[[nodiscard]] std::optional<std::vector<Verdict>> probe(const std::vector<Call>& calls,
                                                        const std::function<void()>& become);

} // namespace hairpaint::test

Q_DECLARE_METATYPE(hairpaint::test::Call)
#endif
