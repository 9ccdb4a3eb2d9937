// The system calls that a process may still make, by a seccomp filter: only those on a list of what decoders need.
#pragma once

#include <cstdint>
#include <vector>

namespace hairpaint::importer {

/// Holds where (argument & mask) == value.
struct ArgumentLimit
{
    unsigned argument = 0; ///< Index, from 0 on.
    std::uint64_t mask = 0;
    std::uint64_t value = 0;
};

/// A system call that is allowed if all its limits hold. One that is in several rows is allowed if one of the rows
/// allows it.
struct AllowedCall
{
    int number = 0;
    std::vector<ArgumentLimit> limits;
};

/// The list, for the process that asks. Empty where the program was built without libseccomp.
[[nodiscard]] std::vector<AllowedCall> allowedCalls();

/// From now on every thread of this process makes allowed calls only. What is refused fails with ENOSYS, as on a kernel
/// that lacks the call: libraries must live with that, and fall back on an older call where they know one, so that a
/// newer C library costs no head. Killing would tell of an attack, but also end the decoding of a good file by a
/// library that only asked. Calls by another machine's numbers (32 bits, x32) are made by no library: those do kill.
/// False where the kernel has no filters or the program was built without libseccomp.
[[nodiscard]] bool filterCalls();

} // namespace hairpaint::importer
