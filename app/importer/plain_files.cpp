// Ordinary files and others.
#include "app/importer/plain_files.h"

#include <filesystem>
#include <string_view>
#include <system_error>

namespace hairpaint::importer {

namespace {

/// Assimp's names are UTF-8.
std::filesystem::path pathOf(const char* file)
{
    return reinterpret_cast<const char8_t*>(file);
}

std::string withoutOtherEnding(const char* file)
{
    std::string name(file);
    if (name.ends_with(PlainFiles::kOtherEnding))
        name.resize(name.size() - std::string_view(PlainFiles::kOtherEnding).size());
    return name;
}

bool isOrdinary(const char* file)
{
    std::error_code problem;
    return std::filesystem::is_regular_file(pathOf(file), problem);
}

} // namespace

bool PlainFiles::Exists(const char* file) const
{
    const std::string own = withoutOtherEnding(file);
    return isOrdinary(own.c_str()) && DefaultIOSystem::Exists(own.c_str());
}

Assimp::IOStream* PlainFiles::Open(const char* file, const char* mode)
{
    const std::string own = withoutOtherEnding(file);
    if (isOrdinary(own.c_str()))
        return DefaultIOSystem::Open(own.c_str(), mode);
    const std::u8string name = pathOf(own.c_str()).filename().u8string();
    m_missing.assign(name.begin(), name.end());
    return nullptr;
}

} // namespace hairpaint::importer
