// Which files a process may still open, by Landlock.
#pragma once

#include <string>

namespace hairpaint::importer {

/// `file` (empty: none), those in its folder and those that libraries come from can be read, and nothing else can be
/// done to any file by its path. Threads that are there already stay as they are. Returns the version of the kernel's
/// Landlock, of which 3 and later refuse truncating, 4 connections, 5 commands to devices, 6 signals and abstract
/// sockets; 0 where it has none.
[[nodiscard]] int confineFiles(const std::string& file);

} // namespace hairpaint::importer
