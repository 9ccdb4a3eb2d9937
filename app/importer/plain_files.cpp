// Ordinary files and others.
#include "app/importer/plain_files.h"

#include <algorithm>
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

/// Without its folders.
std::string nameOf(const std::string& file)
{
    const std::u8string name = pathOf(file.c_str()).filename().u8string();
    return {name.begin(), name.end()};
}

} // namespace

PlainFiles::PlainFiles(const std::string& model) : m_model(model)
{
    std::error_code problem;
    const std::filesystem::path folder = pathOf(model.c_str()).parent_path();
    m_folder = std::filesystem::canonical(folder.empty() ? "." : folder, problem);
}

bool PlainFiles::isInside(const std::string& file) const
{
    std::error_code problem;
    const std::filesystem::path real = std::filesystem::weakly_canonical(pathOf(file.c_str()), problem);
    // What can't be told is left to the sandbox.
    return problem || m_folder.empty() || std::ranges::mismatch(m_folder, real).in1 == m_folder.end();
}

bool PlainFiles::mayBeRead(const std::string& file) const
{
    if (file == m_model || isInside(file))
        return true; // The model itself may be a link.
    m_outside = nameOf(file);
    return false;
}

bool PlainFiles::Exists(const char* file) const
{
    const std::string own = withoutOtherEnding(file);
    return isOrdinary(own.c_str()) && mayBeRead(own) && DefaultIOSystem::Exists(own.c_str());
}

Assimp::IOStream* PlainFiles::Open(const char* file, const char* mode)
{
    const std::string own = withoutOtherEnding(file);
    if (!mayBeRead(own))
        return nullptr;
    if (isOrdinary(own.c_str()))
        return DefaultIOSystem::Open(own.c_str(), mode);
    // Its readers put the model's folder before a whole path, too.
    const std::size_t whole = own.find("//");
    const bool isElsewhere = whole != std::string::npos && isOrdinary(own.c_str() + whole + 1);
    (isElsewhere ? m_outside : m_missing) = nameOf(own);
    return nullptr;
}

} // namespace hairpaint::importer
