// Ordinary files and others.
#include "app/importer/plain_files.h"

#include <filesystem>
#include <system_error>

namespace hairpaint::importer {

namespace {

bool isOrdinary(const char* file)
{
    std::error_code problem;
    // Assimp's names are UTF-8.
    return std::filesystem::is_regular_file(std::filesystem::path(reinterpret_cast<const char8_t*>(file)), problem);
}

} // namespace

bool PlainFiles::Exists(const char* file) const
{
    return isOrdinary(file) && DefaultIOSystem::Exists(file);
}

Assimp::IOStream* PlainFiles::Open(const char* file, const char* mode)
{
    return isOrdinary(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
}

} // namespace hairpaint::importer
