// Ordinary files and others.
#include "app/importer/plain_files.h"

#include <filesystem>
#include <system_error>

namespace hairpaint::importer {

namespace {

/// Assimp's names are UTF-8.
std::filesystem::path pathOf(const char* file)
{
    return reinterpret_cast<const char8_t*>(file);
}

bool isOrdinary(const char* file)
{
    std::error_code problem;
    return std::filesystem::is_regular_file(pathOf(file), problem);
}

} // namespace

bool PlainFiles::Exists(const char* file) const
{
    return isOrdinary(file) && DefaultIOSystem::Exists(file);
}

Assimp::IOStream* PlainFiles::Open(const char* file, const char* mode)
{
    if (isOrdinary(file))
        return DefaultIOSystem::Open(file, mode);
    const std::u8string name = pathOf(file).filename().u8string();
    m_missing.assign(name.begin(), name.end());
    return nullptr;
}

} // namespace hairpaint::importer
