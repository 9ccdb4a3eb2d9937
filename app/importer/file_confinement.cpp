// Landlock by its system calls: the C library has no functions for them.
#include "app/importer/file_confinement.h"

#if defined(__linux__) && __has_include(<linux/landlock.h>)
#define HAIRPAINT_HAS_LANDLOCK
#include <array>
#include <cstdint>
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace hairpaint::importer {

#ifdef HAIRPAINT_HAS_LANDLOCK

namespace {

/// As the newest kernels have it; older ones take it as long as what they don't know is 0.
struct Ruleset
{
    std::uint64_t files = 0;
    std::uint64_t network = 0;
    std::uint64_t scopes = 0;
};

constexpr std::uint64_t kRead = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;

/// What a version of Landlock can refuse that the one before could not. Debian 12's headers name the first two.
struct Rights
{
    int since;
    Ruleset refused;
};
constexpr std::array<Rights, 6> kRights = {{
    {1,
     {.files = kRead | LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
               LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR |
               LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
               LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM}},
    {2, {.files = 1ULL << 13U}},               // Moving between folders.
    {3, {.files = 1ULL << 14U}},               // Truncating.
    {4, {.network = 1ULL << 0U | 1ULL << 1U}}, // TCP, binding and connecting.
    {5, {.files = 1ULL << 15U}},               // Commands to devices.
    {6, {.scopes = 1ULL << 0U | 1ULL << 1U}},  // Abstract sockets and signals, to those outside.
}};

Ruleset rulesetOf(int version)
{
    Ruleset ruleset;
    for (const Rights& rights : kRights) {
        if (rights.since > version)
            break;
        ruleset.files |= rights.refused.files;
        ruleset.network |= rights.refused.network;
        ruleset.scopes |= rights.refused.scopes;
    }
    return ruleset;
}

/// A folder and what lies in it, or one file.
void allowReading(int rules, const char* path)
{
    const int file = ::open(path, O_PATH | O_CLOEXEC);
    if (file < 0)
        return;
    struct stat found = {};
    landlock_path_beneath_attr beneath{};
    const bool isFolder = ::fstat(file, &found) == 0 && S_ISDIR(found.st_mode);
    beneath.allowed_access = isFolder ? kRead : std::uint64_t{LANDLOCK_ACCESS_FS_READ_FILE};
    beneath.parent_fd = file;
    ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0);
    ::close(file);
}

std::string folderOf(const std::string& file)
{
    const std::size_t slash = file.rfind('/');
    if (slash == std::string::npos)
        return ".";
    return slash == 0 ? "/" : file.substr(0, slash);
}

} // namespace

int confineFiles(const std::string& file)
{
    const auto version =
        static_cast<int>(::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION));
    if (version < 1)
        return 0;
    const Ruleset ruleset = rulesetOf(version);
    const auto rules = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &ruleset, sizeof ruleset, 0));
    if (rules < 0)
        return 0;
    for (const char* library : {"/usr", "/lib", "/lib64"})
        allowReading(rules, library);
    // Threads ask how many processors there are.
    allowReading(rules, "/sys/devices/system/cpu");
    allowReading(rules, "/sys/fs/cgroup");
    if (!file.empty()) {
        allowReading(rules, folderOf(file).c_str());
        allowReading(rules, file.c_str());
    }
    const bool isConfined = ::syscall(SYS_landlock_restrict_self, rules, 0) == 0;
    ::close(rules);
    return isConfined ? version : 0;
}

#else

int confineFiles(const std::string& /*file*/)
{
    return 0;
}

#endif

} // namespace hairpaint::importer
