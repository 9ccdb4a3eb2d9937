// Confines a decoder, so that a hostile file that takes it over can reach almost nothing.
#pragma once

#include <string>

namespace hairpaint::importer {

/// The layers of confinement that are in force.
struct Confinement
{
    int landlockVersion = 0;   ///< 0: files are not confined.
    bool filtersCalls = false; ///< By the list in call_filter.cpp.
};

/// Closes what the process that started this one had open besides standard input, output and error: writing to what is
/// open stays allowed. Call first.
void closeInherited();

/// From now on this process, and whatever threads it starts, may read `file` (also behind a link), those in
/// its folder and those the system's libraries come from, and no others; it may write to what
/// is open already and create nothing; it may start no program, open no connection and look into no other process.
/// `file`: empty where none is read at all.
///
/// Linux: Landlock for files (file_confinement.h), a seccomp filter for everything that a process asks the kernel for
/// (call_filter.h), each where the kernel has it; without them it goes on as it is. Elsewhere nothing happens here
/// (Windows: a job object, see resource_limits.h).
Confinement enterSandbox(const std::string& file);

} // namespace hairpaint::importer
